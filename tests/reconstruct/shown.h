#pragma once
/// What an observer sees of a run, kept for tests of bridges, and the scenes that they share.

#include <array>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "../../reconstruct/observer.h"
#include "scenes.h"

namespace crossloft::test {

using Tet = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::array<std::uint32_t, 2>;

template <std::size_t N>
std::array<std::uint32_t, N> ascending(std::array<std::uint32_t, N> s) {
  std::sort(s.begin(), s.end());
  return s;
}

inline Triangle facet_of(const Tet& t, unsigned i) {
  return ascending(Triangle{t[kFacetSlots[i][0]], t[kFacetSlots[i][1]], t[kFacetSlots[i][2]]});
}

inline Edge edge_of(const Tet& t, unsigned e) {
  return ascending(Edge{t[kEdgeSlots[e][0]], t[kEdgeSlots[e][1]]});
}

template <std::size_t N>
bool has(const std::array<std::uint32_t, N>& simplex, const Edge& edge) {
  return std::count(simplex.begin(), simplex.end(), edge[0]) == 1 &&
         std::count(simplex.begin(), simplex.end(), edge[1]) == 1;
}

class Groups {
 public:
  explicit Groups(std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) group_.push_back(i);
  }
  void put_together(std::size_t a, std::size_t b) {
    const std::size_t low = std::min(group_[a], group_[b]), high = std::max(group_[a], group_[b]);
    std::replace(group_.begin(), group_.end(), high, low);
  }
  std::size_t of(std::size_t x) const { return group_[x]; }
  std::size_t count() const { return std::set<std::size_t>(group_.begin(), group_.end()).size(); }

 private:
  std::vector<std::size_t> group_;
};

/// What an observer sees of the faces, all cells, and the solid. Points are alive only during the call.
struct Shown {
  std::vector<FaceTriangulation> faces;
  std::vector<std::vector<std::uint32_t>> face_numbers;
  std::vector<BuiltCell> cells;
  std::vector<std::vector<std::uint8_t>> kept;
  std::vector<Tet> solid;
  std::span<const LatticePoint> points;

  /// Calls visit(triangle, kinds of its sides by edge) for the section triangles, by final numbers.
  template <class Visit>
  void for_section_triangles(Visit&& visit) const {
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t t = 0; t < faces[f].triangles.size(); ++t) {
        const auto& v = faces[f].triangles[t];
        const auto& n = face_numbers[f];
        if (faces[f].internal[t] != 0) visit(ascending(Triangle{n[v[0]], n[v[1]], n[v[2]]}));
      }
  }
  /// The edges inside sections, on the lines of planes too.
  std::set<Edge> inner_edges() const {
    std::set<Edge> edges;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const FaceEdge& e : faces[f].edges)
        if (e.kind == EdgeKind::internal)
          edges.insert(ascending(Edge{face_numbers[f][e.a], face_numbers[f][e.b]}));
    return edges;
  }
};

class Watcher : public Observer {
 public:
  explicit Watcher(std::function<void(const Shown&)> check) : check_(std::move(check)) {}
  void on_face(const FaceTriangulation& face, const Numbering& numbering) override {
    shown_.faces.push_back(face);
    shown_.face_numbers.push_back(numbering.of_face[face.face.value]);
  }
  void on_cell(CellId, const BuiltCell& cell, const PruneResult& pruned) override {
    shown_.cells.push_back(cell);
    shown_.kept.push_back(pruned.kept);
  }
  void on_solid(std::span<const Tet> solid, const Numbering& numbering) override {
    shown_.solid.assign(solid.begin(), solid.end());
    shown_.points = numbering.points;
    check_(shown_);
  }

 private:
  std::function<void(const Shown&)> check_;
  Shown shown_;
};

inline Reconstruction run(const Sections& sections, const std::function<void(const Shown&)>& check = {},
                          const Options& options = {}) {
  Watcher watcher(check);
  auto r = reconstruct(sections, options, {}, check ? &watcher : nullptr);
  REQUIRE(r.ok());
  return std::move(r).value();
}

struct Scene {
  std::string name;
  Sections sections;
  Options options = {};
};

inline Sections cut(const Surface& mesh, std::vector<CuttingPlane> planes) {
  auto sections = slice(mesh, planes);
  REQUIRE(sections.ok());
  return std::move(sections).value();
}

inline Sections cut_randomly(const Surface& mesh, std::uint32_t count, std::uint64_t seed) {
  return cut(mesh, random_planes(bounds_of(mesh.points), count, seed));
}

inline std::vector<Scene> small_scenes() {
  return {{"fig18", load("figures/fig18.contour")},
          {"fig20", load("figures/fig20.contour")},
          {"link", load("topology/link.contour")},
          {"torus by 8", cut_randomly(torus(1, 0.4, 20, 10), 8, 1)},
          {"vessel by 9", cut_randomly(vessel_solid(14), 9, 3)},
          {"genus 2 by 7 about a line",
           cut(genus2_solid(14), rotational_planes(bounds_of(genus2_solid(14).points), 7))}};
}

}  // namespace crossloft::test
