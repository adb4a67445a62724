#include "surface_topology.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "../geom/disjoint_sets.h"
#include "../geom/ids.h"

namespace crossloft {
namespace {

constexpr std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }

/// One side of a triangle. `low < high` are its vertices, `corner` the position 3 * t + k of the first.
struct HalfEdge {
  std::uint32_t low = 0, high = 0;
  std::uint32_t corner = 0;
  bool forward = false;  // runs from low to high
};

class TopologyCheck {
 public:
  TopologyCheck(const Surface& surface, CheckReport& report) : surface_(surface), report_(report) {}

  SurfaceTopology run() {
    report_.points = static_cast<std::uint32_t>(surface_.points.size());
    report_.triangles = static_cast<std::uint32_t>(surface_.triangles.size());
    select_triangles();
    list_half_edges();
    label_components();
    visit_edges();
    visit_vertices();
    finish_components();
    return std::move(topology_);
  }

 private:
  const std::array<std::uint32_t, 3>& triangle(std::uint32_t listed) const {
    return surface_.triangles[topology_.triangles[listed]];
  }
  std::uint32_t vertex(std::uint32_t corner) const { return triangle(corner / 3)[corner % 3]; }
  std::uint32_t listed_count() const { return static_cast<std::uint32_t>(topology_.triangles.size()); }
  ComponentReport& component_of(std::uint32_t corner) {
    return report_.components[topology_.component[corner / 3]];
  }

  void select_triangles() {
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      const auto& [a, b, c] = surface_.triangles[t];
      if (std::max({a, b, c}) >= surface_.points.size())
        ++report_.bad_indices;
      else if (a == b || b == c || c == a)
        ++report_.repeated_indices;
      else
        topology_.triangles.push_back(t);
    }
  }

  void list_half_edges() {
    half_edges_.reserve(3 * std::size_t{listed_count()});
    for (std::uint32_t i = 0; i < listed_count(); ++i)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle(i)[k], b = triangle(i)[next(k)];
        half_edges_.push_back({std::min(a, b), std::max(a, b), 3 * i + k, a < b});
      }
    std::sort(half_edges_.begin(), half_edges_.end(), [](const HalfEdge& x, const HalfEdge& y) {
      return std::tie(x.low, x.high, x.corner) < std::tie(y.low, y.high, y.corner);
    });
  }

  void label_components() {
    DisjointSets sets(surface_.points.size());
    for (const HalfEdge& e : half_edges_) sets.join(e.low, e.high);
    std::vector<std::uint32_t> label(surface_.points.size(), kNone);
    for (std::uint32_t i = 0; i < listed_count(); ++i) {
      std::uint32_t& c = label[sets.find(triangle(i)[0])];
      if (c == kNone) {
        c = static_cast<std::uint32_t>(report_.components.size());
        report_.components.push_back({});
        report_.components.back().first_triangle = topology_.triangles[i];
        report_.components.back().manifold = true;
      }
      topology_.component.push_back(c);
      ++report_.components[c].triangles;
    }
  }

  void visit_edges() {
    crowded_.assign(surface_.points.size(), false);
    DisjointSets fans(3 * std::size_t{listed_count()});
    for (std::size_t i = 0, j = 0; i < half_edges_.size(); i = j) {
      while (j < half_edges_.size() && half_edges_[j].low == half_edges_[i].low &&
             half_edges_[j].high == half_edges_[i].high)
        ++j;
      const std::span<const HalfEdge> sides(&half_edges_[i], j - i);
      judge_edge(sides);
      join_fans(sides, fans);
    }
    fan_of_corner_.resize(3 * std::size_t{listed_count()});
    for (std::uint32_t c = 0; c < fan_of_corner_.size(); ++c) fan_of_corner_[c] = fans.find(c);
  }

  void judge_edge(std::span<const HalfEdge> sides) {
    ComponentReport& component = component_of(sides[0].corner);
    ++component.edges;
    const bool turned = sides.size() == 2 && sides[0].forward == sides[1].forward;
    report_.open_edges += sides.size() == 1;
    report_.crowded_edges += sides.size() > 2;
    report_.misoriented_edges += turned;
    if (sides.size() != 2 || turned) component.manifold = false;
    if (sides.size() > 2) crowded_[sides[0].low] = crowded_[sides[0].high] = true;
  }

  /// Triangles around an edge are neighbours in the fans of both its ends.
  void join_fans(std::span<const HalfEdge> sides, DisjointSets& fans) const {
    for (std::size_t i = 1; i < sides.size(); ++i) {
      fans.join(corner_at(sides[0], true), corner_at(sides[i], true));
      fans.join(corner_at(sides[0], false), corner_at(sides[i], false));
    }
  }

  static std::uint32_t corner_at(const HalfEdge& e, bool low) {
    const std::uint32_t k = e.corner % 3;
    return e.forward == low ? e.corner : e.corner - k + next(k);
  }

  void visit_vertices() {
    std::vector<std::uint32_t> fan(surface_.points.size(), kNone);
    std::vector<bool> pinched = crowded_;
    for (std::uint32_t c = 0; c < fan_of_corner_.size(); ++c) {
      std::uint32_t& known = fan[vertex(c)];
      if (known == kNone) {
        known = fan_of_corner_[c];
        ++component_of(c).vertices;
      } else if (known != fan_of_corner_[c]) {
        pinched[vertex(c)] = true;
        component_of(c).manifold = false;
      }
    }
    report_.unused_points = static_cast<std::uint32_t>(std::count(fan.begin(), fan.end(), kNone));
    report_.nonmanifold_vertices =
        static_cast<std::uint32_t>(std::count(pinched.begin(), pinched.end(), true));
  }

  void finish_components() {
    for (ComponentReport& c : report_.components) {
      c.euler = std::int64_t{c.vertices} - std::int64_t{c.edges} + std::int64_t{c.triangles};
      if (c.manifold) c.genus = 1 - c.euler / 2;
      report_.genus += c.genus;
    }
  }

  const Surface& surface_;
  CheckReport& report_;
  SurfaceTopology topology_;
  std::vector<HalfEdge> half_edges_;          // grouped by edge
  std::vector<std::uint32_t> fan_of_corner_;  // smallest corner of its fan
  std::vector<bool> crowded_;                 // vertex of an edge with more than two triangles
};

}  // namespace

SurfaceTopology check_topology(const Surface& surface, CheckReport& report) {
  return TopologyCheck(surface, report).run();
}

}  // namespace crossloft
