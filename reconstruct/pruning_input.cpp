#include "pruning_input.h"

#include <algorithm>

#include "rising_search.h"

namespace crossloft {
namespace {

Vec3 as_vector(const LatticeVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// `inward`: the side of the plane's normal that the cell is on.
FacePlane face_plane(const LatticePlane& plane, double inward) {
  const Vec3 normal = as_vector(plane.normal);
  const Vec3 unit = inward / norm(normal) * normal;
  return {unit, -dot(unit, as_vector(plane.origin))};
}

/// Vertices by local numbers instead of final ones.
template <std::size_t n>
void to_local(const BuiltCell& cell, std::array<std::uint32_t, n>& name) {
  for (std::uint32_t& v : name)
    v = static_cast<std::uint32_t>(std::lower_bound(cell.vertices.begin(), cell.vertices.end(), v) -
                                   cell.vertices.begin());
}

}  // namespace

CellShape cell_shape(const Arrangement& arrangement, CellId id, std::span<const FaceId> faces,
                     const BuiltCell& cell) {
  CellShape shape;
  shape.points.reserve(cell.points.size());
  for (const LatticePoint& p : cell.points) shape.points.push_back({p.x, p.y, p.z});
  const auto add = [&](FaceId f) {
    const double inward = arrangement.cells_of(f)[0] == id ? -1 : 1;
    shape.faces.push_back(face_plane(arrangement.plane(arrangement.plane_of(f)), inward));
  };
  for (const FaceId f : faces) add(f);
  for (const FaceId f : arrangement.faces_of(id))
    if (arrangement.on_box(f)) add(f);
  return shape;
}

SectionField section_field(const SectionGraph& graph) {
  std::vector<FieldPlane> planes;
  for (std::size_t p = 0; p < graph.planes.size(); ++p) {
    FieldPlane& plane = planes.emplace_back(FieldPlane{face_plane(graph.planes[p], 1), {}});
    for (const Wall& wall : graph.walls[p]) {
      const LatticePoint &a = graph.points[wall.a], &b = graph.points[wall.b];
      plane.contour.push_back({Vec3{a.x, a.y, a.z}, Vec3{b.x, b.y, b.z}});
    }
  }
  return SectionField(std::move(planes));
}

CellRequests by_local_numbers(CellRequests requests, const BuiltCell& cell) {
  for (TetName& body : requests.joined) to_local(cell, body);
  for (OpenRequest& open : requests.opened) to_local(cell, open.from), to_local(cell, open.to);
  for (TetName& spike : requests.dropped) to_local(cell, spike);
  return requests;
}

SecondThoughts by_local_numbers(SecondThoughts questions, const BuiltCell& cell) {
  for (auto& names : questions.bodies)
    for (TetName& name : names) to_local(cell, name);
  for (auto& facets : questions.cavities)
    for (Triangle& facet : facets) to_local(cell, facet);
  return questions;
}

Answers by_final_numbers(Answers answers, std::span<const FaceId> faces, const BuiltCell& cell) {
  const auto translate = [&](TetName& name) {
    for (std::uint32_t& v : name)
      if (v != kNone) v = cell.vertices[v];
  };
  for (BodyAnswer& body : answers.bodies) translate(body.target);
  for (auto& parts : answers.cavities)
    for (CavityAnswer& part : parts) {
      if (part.opening == Opening::hole) part.face = faces[part.face].value;
      if (part.can_open) translate(part.from), translate(part.to);
    }
  return answers;
}

CellContours::CellContours(std::span<const CellFace> faces) {
  for (const CellFace& face : faces)
    for (const auto& walls : {std::span(face.triangulation->walls), std::span(face.triangulation->border)})
      for (const Wall& wall : walls)
        for (const std::uint32_t v : {wall.a, wall.b})
          vertices_.push_back({wall.source_plane, wall.contour, face.numbers[v]});
  std::sort(vertices_.begin(), vertices_.end());
  vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
}

std::span<const ContourVertex> CellContours::vertices(std::uint32_t plane, std::uint32_t contour) const {
  const auto first = std::lower_bound(vertices_.begin(), vertices_.end(), ContourVertex{plane, contour, 0});
  const auto last = std::upper_bound(first, vertices_.end(), ContourVertex{plane, contour, kNone});
  return {first, last};
}

std::vector<JoinWish> cell_wishes(std::span<const JoinRequest> requests, std::span<const CellFace> faces,
                                  const BuiltCell& cell) {
  std::vector<JoinWish> wishes;
  if (requests.empty()) return wishes;
  const CellContours contours(faces);
  const auto local = [&](std::span<const ContourVertex> list) {
    std::vector<std::uint32_t> vertices;
    RisingSearch search(cell.vertices);
    for (const ContourVertex& v : list)
      vertices.push_back(static_cast<std::uint32_t>(search.lower_bound(v.vertex)));
    return vertices;
  };
  for (const JoinRequest& request : requests) {
    const auto a = contours.vertices(request.plane_a, request.contour_a),
               b = contours.vertices(request.plane_b, request.contour_b);
    if (!a.empty() && !b.empty()) wishes.push_back({local(a), local(b), request.join});
  }
  return wishes;
}

}  // namespace crossloft
