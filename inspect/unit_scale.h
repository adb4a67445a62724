#pragma once
/// Measuring at size 1: products of coordinates leave the range of doubles long before coordinates do.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../geom/bounds.h"
#include "../geom/unit_plane.h"
#include "../reconstruct/surface.h"

namespace crossloft {

/// Of the points that triangles use: others are no part of the surface, wherever they are. Triangles that
/// name a point that is not there are left out.
inline Bounds bounds_of_triangles(const Surface& surface) {
  Bounds box;
  for (const auto& t : surface.triangles) {
    if (std::max({t[0], t[1], t[2]}) >= surface.points.size()) continue;
    for (const std::uint32_t v : t) box.add(surface.points[v]);
  }
  return box;
}

/// The power of two that brings the largest coordinate of a box to [0.5, 1), or as near that as it and its
/// inverse are doubles: what sums, products and roots say of the scaled points, scaled back, is bit by bit
/// what they say of the points themselves, where that is in the range of doubles.
class UnitScale {
 public:
  UnitScale() = default;
  explicit UnitScale(const Bounds& box) {
    const auto [lx, ly, lz] = box.low;
    const auto [hx, hy, hz] = box.high;
    const double largest = std::max({-lx, -ly, -lz, hx, hy, hz});
    if (box.empty() || !std::isfinite(largest)) return;
    std::frexp(largest, &exponent_);
    exponent_ = std::clamp(exponent_, -1021, 1021);
    factor_ = std::ldexp(1.0, -exponent_);
  }

  Vec3 to_unit(const Vec3& p) const { return factor_ * p; }
  Surface to_unit(Surface surface) const {
    for (Vec3& p : surface.points) p = to_unit(p);
    return surface;
  }
  /// One that passes the box by far stays finite and still does. REQUIRES: finite, the normal not 0.
  UnitPlane to_unit(const Vec3& normal, double offset) const {
    UnitPlane plane = unit_plane(normal, offset);
    plane.offset = std::clamp(factor_ * plane.offset, -kBeyond, kBeyond);
    return plane;
  }

  Vec3 point(const Vec3& at_unit) const { return {length(at_unit.x), length(at_unit.y), length(at_unit.z)}; }
  double length(double at_unit) const { return std::ldexp(at_unit, exponent_); }
  double area(double at_unit) const { return std::ldexp(at_unit, 2 * exponent_); }
  double volume(double at_unit) const { return std::ldexp(at_unit, 3 * exponent_); }

 private:
  /// Further from the origin than any scaled point.
  static constexpr double kBeyond = 0x1p10;

  int exponent_ = 0;
  double factor_ = 1;
};

}  // namespace crossloft
