#include "section_judge.h"

#include <algorithm>

namespace crossloft::test {

void SectionJudge::on_sections(const FramedSections& framed, const Arrangement&, const SectionGraph& graph) {
  grid_ = framed.grid;
  planes_ = graph.planes;
  sections_.resize(planes_.size());
  section_area.assign(planes_.size(), 0);
  flat_area.assign(planes_.size(), 0);
}

void SectionJudge::on_face(const FaceTriangulation& face, const Numbering& numbering) {
  const auto& number = numbering.of_face[face.face.value];
  Section& section = sections_[face.plane];
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    if (face.internal[t] == 0) continue;
    Triangle v{number[face.triangles[t][0]], number[face.triangles[t][1]], number[face.triangles[t][2]]};
    std::sort(v.begin(), v.end());
    section.covered[v] = false;
    section.edges.insert({Edge{v[0], v[1]}, Edge{v[0], v[2]}, Edge{v[1], v[2]}});
  }
}

void SectionJudge::on_solid(std::span<const std::array<std::uint32_t, 4>> solid, const Numbering& numbering) {
  points_ = numbering.points;
  for (const LatticePlane& plane : planes_) {
    std::vector<bool>& on = on_.emplace_back();
    for (const LatticePoint& p : points_) on.push_back(side_of_plane(plane, p) == 0);
  }
  for (const auto& tet : solid) {
    if (orient3d(points_[tet[0]], points_[tet[1]], points_[tet[2]], points_[tet[3]]) <= 0)
      complaint_ = "a tetrahedron is flat or inside out";
    for (std::size_t p = 0; p < planes_.size(); ++p) judge(tet, p);
  }
  for (std::size_t p = 0; p < planes_.size(); ++p)
    for (const auto& [triangle, covered] : sections_[p].covered) {
      section_area[p] += area(triangle);
      if (!covered) flat_area[p] += area(triangle);
    }
}

void SectionJudge::judge(const std::array<std::uint32_t, 4>& tet, std::size_t plane) {
  std::vector<std::uint32_t> v;
  for (const std::uint32_t corner : tet)
    if (on_[plane][corner]) v.push_back(corner);
  std::sort(v.begin(), v.end());
  Section& section = sections_[plane];
  if (v.size() == 2 && section.edges.count({v[0], v[1]}) == 0)
    complaint_ = "plane " + std::to_string(plane) + ": an edge of the solid lies outside of the section";
  if (v.size() != 3) return;
  const auto at = section.covered.find({v[0], v[1], v[2]});
  if (at != section.covered.end())
    at->second = true;
  else
    complaint_ = "plane " + std::to_string(plane) + ": a triangle of the solid lies outside of the section";
}

double SectionJudge::area(const Triangle& t) const {
  const Vec3 p = grid_.from_lattice(points_[t[0]]);
  return 0.5 * norm(cross(grid_.from_lattice(points_[t[1]]) - p, grid_.from_lattice(points_[t[2]]) - p));
}

}  // namespace crossloft::test
