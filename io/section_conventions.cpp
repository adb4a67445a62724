#include "section_conventions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace crossloft {
namespace {

/// Sum over the vertices of |n.x + sign D| / |n|.
double residual(const PlaneSection& plane, double sign) {
  // Scaled by the largest component, which can neither over- nor underflow when squared.
  const Vec3 n = plane.normal;
  const double scale = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  const Vec3 unit{n.x / scale, n.y / scale, n.z / scale};
  const double offset = sign * plane.offset / scale;
  double sum = 0;
  for (const Vec3& x : plane.vertices) sum += std::abs(dot(unit, x) + offset);
  return sum / norm(unit);
}

double residual(const Sections& sections, double sign) {
  double sum = 0;
  for (const PlaneSection& plane : sections.planes) sum += residual(plane, sign);
  return sum;
}

}  // namespace

void read_plane_equation(TokenReader& in, PlaneSection& plane) {
  plane.normal = in.point("a plane's normal");
  plane.offset = in.real("a plane's offset");
  if (in.ok() && plane.normal == Vec3{}) in.fail(ErrorCode::zero_normal, "the normal of the plane is zero");
}

void read_vertices(TokenReader& in, std::uint32_t count, PlaneSection& plane) {
  constexpr std::size_t kLeastBytes = 6;  // "0 0 0 "
  plane.vertices.reserve(in.room_for(count, kLeastBytes));
  for (std::uint32_t v = 0; v < count && in.ok(); ++v)
    plane.vertices.push_back(in.point("a vertex coordinate"));
}

void settle_sign_of_offset(Sections& sections, const Context& context) {
  const bool negated = residual(sections, -1) < residual(sections, 1);
  if (!negated) return;
  for (PlaneSection& plane : sections.planes) plane.offset = -plane.offset;
  context.note("the planes of the file are n.x = D, not n.x + D = 0: the sign of D was changed");
}

void note_materials(const Sections& sections, const Context& context) {
  std::set<std::int32_t> materials;
  for (const PlaneSection& plane : sections.planes) {
    for (const ContourEdge& edge : plane.edges) materials.insert({edge.material_a, edge.material_b});
  }
  materials.erase(0);
  if (materials.size() < 2) return;
  context.note("the file has " + std::to_string(materials.size()) + " materials: inside is any of them");
}

}  // namespace crossloft
