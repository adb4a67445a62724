#include "section_conventions.h"

#include <cmath>
#include <string>

#include "../arrangement/normalise.h"
#include "../geom/unit_plane.h"

namespace crossloft {
namespace {

/// Sum over the vertices of |n.x + sign D| / |n|.
double residual(const PlaneSection& plane, double sign) {
  const UnitPlane unit = unit_plane(plane.normal, sign * plane.offset);
  double sum = 0;
  for (const Vec3& x : plane.vertices) sum += std::abs(unit.height(x));
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

void SectionConventions::observe(const ParsedPlane& plane) {
  residual_ += residual(plane.section, 1);
  residual_negated_ += residual(plane.section, -1);
  has_outside_label_ = has_outside_label_ || plane.has_outside_label;
  for (const ContourEdge& edge : plane.section.edges)
    for (const std::int32_t material : {edge.material_a, edge.material_b})
      if (material != 0) materials_.insert(material);
}

void SectionConventions::tell(const Context& context) const {
  if (has_outside_label_)
    context.warn("components with a label below 1, which names the outside, are taken as 1");
  if (is_negated())
    context.note("the planes of the file are n.x = D, not n.x + D = 0: the sign of D was changed");
  if (materials_.size() > 1) context.note(note_of_materials(materials_.size()));
}

void SectionConventions::apply(PlaneSection& plane) const {
  if (is_negated()) plane.offset = -plane.offset;
}

}  // namespace crossloft
