#include "section_judge.h"

#include <algorithm>

#include "../../geom/box_tree.h"
#include "../../geom/tetrahedron_meeting.h"

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
  for (Tet tet : solid) {
    if (orient3d(points_[tet[0]], points_[tet[1]], points_[tet[2]], points_[tet[3]]) <= 0)
      complain("a tetrahedron is flat or inside out");
    std::sort(tet.begin(), tet.end());
    tets_.insert(tet);
    for (std::size_t p = 0; p < planes_.size(); ++p) judge(tet, p);
  }
  if (bare_) judge_plates();
  for (std::size_t p = 0; p < planes_.size(); ++p)
    for (const auto& [triangle, covered] : sections_[p].covered) {
      section_area[p] += area(triangle);
      if (covered) continue;
      flat_area[p] += area(triangle);
      widest_flat = std::max(widest_flat, width(triangle));
    }
}

/// Nothing is gone for plates, and no tetrahedron of theirs is in another one.
void SectionJudge::judge_plates() {
  if (!std::includes(tets_.begin(), tets_.end(), bare_->tets_.begin(), bare_->tets_.end()))
    complain("the solid without plates is not in the solid");
  const auto corners = [&](const Tet& t) {
    return LatticeTet{points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]};
  };
  std::vector<LatticeTet> all;
  std::vector<Bounds> boxes;
  for (const Tet& tet : tets_) {
    all.push_back(corners(tet));
    Bounds& box = boxes.emplace_back();
    for (const LatticePoint& p : all.back())
      box.add({p.x - 1, p.y - 1, p.z - 1}), box.add({p.x + 1, p.y + 1, p.z + 1});
  }
  const BoxTree tree(boxes);
  std::uint32_t self = kNone;
  for (const Tet& tet : tets_) {
    ++self;
    if (bare_->tets_.count(tet) != 0) continue;
    tree.for_overlaps(boxes[self], [&](std::uint32_t other) {
      if (other != self && overlap(all[self], all[other])) complain("a plate overlaps what is there");
    });
  }
}

void SectionJudge::judge(const Tet& tet, std::size_t plane) {
  std::vector<std::uint32_t> v;
  for (const std::uint32_t corner : tet)
    if (on_[plane][corner]) v.push_back(corner);
  Section& section = sections_[plane];
  if (v.size() == 2 && section.edges.count({v[0], v[1]}) == 0) {
    if (is_side_of_plate(tet, {v[0], v[1]}, plane))
      ++plate_edges_outside;
    else
      complain("plane " + std::to_string(plane) + ": an edge of the solid lies outside of the section");
  }
  if (v.size() != 3) return;
  const auto at = section.covered.find({v[0], v[1], v[2]});
  if (at != section.covered.end())
    at->second = true;
  else
    complain("plane " + std::to_string(plane) + ": a triangle of the solid lies outside of the section");
}

/// Of a tetrahedron that only plates can have brought, on a triangle of another plane that was flat.
bool SectionJudge::is_side_of_plate(const Tet& tet, const Edge& edge, std::size_t plane) const {
  if (!bare_ || bare_->tets_.count(tet) != 0) return false;
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    if (p == plane || !on_[p][edge[0]] || !on_[p][edge[1]]) continue;
    Triangle base{};
    std::size_t corners = 0;
    for (const std::uint32_t v : tet)
      if (on_[p][v] && corners < 3) base[corners++] = v;
    const auto flat = bare_->sections_[p].covered.find(base);
    if (corners == 3 && flat != bare_->sections_[p].covered.end() && !flat->second)
      return !has_part_of(edge, plane, p);
  }
  return false;
}

/// Whether the section on a plane has a part of an edge on its line with the other.
bool SectionJudge::has_part_of(const Edge& edge, std::size_t plane, std::size_t other) const {
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return compare_lex(points_[a], points_[b]) < 0;
  };
  const auto ends = std::minmax(edge[0], edge[1], before);  // into the edge
  return std::any_of(sections_[plane].edges.begin(), sections_[plane].edges.end(), [&](const Edge& e) {
    if (!on_[other][e[0]] || !on_[other][e[1]]) return false;
    const auto [from, to] = std::minmax(e[0], e[1], before);
    return before(from, ends.second) && before(ends.first, to);
  });
}

double SectionJudge::area(const Triangle& t) const {
  const Vec3 p = grid_.from_lattice(points_[t[0]]);
  return 0.5 * norm(cross(grid_.from_lattice(points_[t[1]]) - p, grid_.from_lattice(points_[t[2]]) - p));
}

double SectionJudge::width(const Triangle& t) const {
  const auto at = [&](std::size_t i) { return Vec3{points_[t[i]].x, points_[t[i]].y, points_[t[i]].z}; };
  const Vec3 a = at(1) - at(0), b = at(2) - at(0);
  return norm(cross(a, b)) / std::max({norm(a), norm(b), norm(b - a)});
}

}  // namespace crossloft::test
