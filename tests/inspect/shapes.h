#pragma once
/// Small meshes that several tests use.

#include <cmath>
#include <vector>

#include "../../inspect/solids.h"

namespace crossloft::test {

/// Appends b's triangles with their own points.
inline void append(Surface& a, const Surface& b) {
  const auto shift = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
}

inline Surface cube(double low = 0, double high = 1) {
  Bounds box;
  box.add({low, low, low});
  box.add({high, high, high});
  return box_mesh(box);
}

inline Surface moved(Surface mesh, const Vec3& by) {
  for (Vec3& p : mesh.points) p = p + by;
  return mesh;
}

/// Times 2^exponent.
inline Vec3 scaled(const Vec3& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}
inline Surface scaled(Surface mesh, int exponent) {
  for (Vec3& p : mesh.points) p = scaled(p, exponent);
  return mesh;
}

inline Surface inside_out(Surface mesh) {
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

/// The tetrahedron with these corners, det(b-a, c-a, d-a) > 0, seen counter-clockwise from outside.
inline Surface tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// Points of equal coordinates made one.
inline Surface welded(const Surface& mesh) {
  Surface out;
  std::vector<std::uint32_t> number;
  for (const Vec3& p : mesh.points) {
    std::uint32_t k = 0;
    while (k < out.points.size() && out.points[k] != p) ++k;
    if (k == out.points.size()) out.points.push_back(p);
    number.push_back(k);
  }
  for (const auto& t : mesh.triangles) out.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return out;
}

}  // namespace crossloft::test
