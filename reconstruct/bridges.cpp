#include "bridges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "../geom/disjoint_sets.h"
#include "../prune/broken_fans.h"
#include "../prune/link_parts.h"
#include "../prune/star.h"

namespace crossloft {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Tet = std::array<std::uint32_t, 4>;

/// Weight of what is not the edge in a point of a bridge: the smaller, the thinner the bridge.
constexpr double kThickness = 0.125;

bool is_end(std::uint32_t v, const Edge& edge) { return v == edge[0] || v == edge[1]; }

/// The triangle of a piece opposite vertex i, ascending.
Triangle side_of(const Tet& piece, std::size_t i) {
  Triangle t{piece[(i + 1) % 4], piece[(i + 2) % 4], piece[(i + 3) % 4]};
  std::sort(t.begin(), t.end());
  return t;
}

class BridgeFinder {
 public:
  BridgeFinder(const BuiltCell& cell, const Ground& ground, const std::vector<std::uint8_t>& kept)
      : cell_(cell), fans_(broken_fans(cell.complex, ground, kept)) {
    if (std::any_of(fans_.begin(), fans_.end(), has_wedges)) parts_.emplace(cell.complex, ground, kept);
  }

  CellBridges run() {
    for (const BrokenFan& fan : fans_)
      for (const GapTet& gap : fan.gaps) edges_[gap.tet].push_back(fan.edge);
    for (const BrokenFan& fan : fans_)
      for (const GapTet& gap : fan.gaps) {
        centres_[centre_key(gap.tet, fan.edge)] = kNone;
        if (!gap.is_first) claim(facet_vertices(cell_.complex.mesh, gap.tet, gap.from), fan.edge);
      }
    for (auto& [key, number] : centres_)
      number = add_point(cell_.complex.mesh.vertices[key.first], key.second);
    for (auto& [triangle, claimed] : facet_points_) claimed.number = add_point(triangle, claimed.edge);
    for (const BrokenFan& fan : fans_) add_bridge(fan);
    return std::move(result_);
  }

 private:
  /// A facet's point, to come near the smallest edge of those whose bridges have it: whatever their order.
  struct Claimed {
    Edge edge{};
    std::uint32_t number = kNone;
  };

  void claim(const Triangle& facet, const Edge& edge) {
    const auto [place, is_new] = facet_points_.try_emplace(facet, Claimed{edge, kNone});
    if (!is_new) place->second.edge = std::min(place->second.edge, edge);
  }

  /// A tetrahedron's centre for bridges at an edge, by the edge that it is close to. Edges that share a facet
  /// where a gap ends share the piece there, so they need one centre. Two that face each other have none in
  /// common: one centre for both would join their bridges.
  std::pair<std::uint32_t, Edge> centre_key(std::uint32_t tet, const Edge& edge) const {
    const std::vector<Edge>& all = edges_.find(tet)->second;
    const bool facing = all.size() == 2 && !is_end(all[0][0], all[1]) && !is_end(all[0][1], all[1]);
    if (facing) return {tet, edge};
    return {tet, *std::min_element(all.begin(), all.end())};
  }

  const LatticePoint& point(std::uint32_t number) const {
    if (number >= kFirstBridgePoint) return result_.points[number - kFirstBridgePoint];
    const auto place = std::lower_bound(cell_.vertices.begin(), cell_.vertices.end(), number);
    return cell_.points[static_cast<std::size_t>(place - cell_.vertices.begin())];
  }

  /// A weighted mean of the corners, mostly of the edge's ends; rounded to the grid.
  template <std::size_t N>
  std::uint32_t add_point(std::array<std::uint32_t, N> corners, const Edge& edge) {
    std::sort(corners.begin(), corners.end());
    Vec3 sum{0, 0, 0};
    for (const std::uint32_t v : corners) {
      const LatticePoint& p = cell_.points[v];
      const bool at_edge = is_end(v, edge);
      sum = sum +
            (at_edge ? (1 - kThickness) / 2 : kThickness / static_cast<double>(N - 2)) * Vec3{p.x, p.y, p.z};
    }
    const auto rounded = [](double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); };
    result_.points.push_back(make_point(LatticeVector{rounded(sum.x), rounded(sum.y), rounded(sum.z)}));
    return kFirstBridgePoint + static_cast<std::uint32_t>(result_.points.size() - 1);
  }

  Tet numbers_of(std::uint32_t t) const {
    Tet numbers = cell_.complex.mesh.vertices[t];
    for (std::uint32_t& v : numbers) v = cell_.vertices[v];
    return numbers;
  }

  bool is_positive(const Tet& t) const {
    return orient3d(point(t[0]), point(t[1]), point(t[2]), point(t[3])) > 0;
  }

  /// The tetrahedron's part between facet i and its centre for an edge.
  Tet part_at(std::uint32_t t, std::uint8_t i, const Edge& edge) const {
    Tet part = numbers_of(t);
    part[i] = centres_.find(centre_key(t, edge))->second;
    return part;
  }

  /// Whether the centres for two edges that face each other keep their bridges apart: seen along any other
  /// edge, each is on its own edge's side.
  bool are_centres_apart(std::uint32_t t, const Edge& edge) const {
    const auto& v = cell_.complex.mesh.vertices[t];
    for (const Edge& other : edges_.find(t)->second)
      for (std::size_t i = 0; i < 4 && centre_key(t, other) != centre_key(t, edge); ++i)
        for (std::size_t j = 0; j < 4; ++j) {
          if (!is_end(v[i], edge) || !is_end(v[j], other)) continue;
          Tet between = numbers_of(t);
          between[i] = centres_.find(centre_key(t, edge))->second,
          between[j] = centres_.find(centre_key(t, other))->second;
          if (!is_positive(between)) return false;
        }
    return true;
  }

  /// One third of such a part, at a facet with a point: without the vertex in slot j.
  static Tet third_of(Tet part, std::uint32_t facet_point, std::size_t j) {
    part[j] = facet_point;
    return part;
  }

  /// A side of the section triangle on the line of another plane, whose section disagrees and does not have
  /// it.
  bool has_side_outside(const GapTet& gap, std::uint8_t i) const {
    const auto& kinds = cell_.complex.edges[gap.tet];
    for (unsigned e = 0; e < kinds.size(); ++e)
      if (kinds[e] == EdgeKind::external && facet_contains(i, 4 + e)) return true;
    return false;
  }

  /// What a bridge takes of the part at facet i; false if the centre or the facet's point lies wrongly, or a
  /// side of the facet is outside of a section.
  bool add_part(const GapTet& gap, std::uint8_t i, bool divided, Bridge& bridge) const {
    const Tet whole = part_at(gap.tet, i, bridge.edge);
    if (!is_positive(whole)) return false;
    if (!divided) {
      if (has_side_outside(gap, i)) return false;
      bridge.pieces.push_back(whole);
      return true;
    }
    const std::uint32_t p = facet_points_.find(facet_vertices(cell_.complex.mesh, gap.tet, i))->second.number;
    const auto& local = cell_.complex.mesh.vertices[gap.tet];
    for (const std::uint8_t j : kFacetSlots[i]) {
      const Tet part = third_of(whole, p, j);
      if (!is_positive(part)) return false;
      if (!is_end(local[j], bridge.edge)) bridge.pieces.push_back(part);
    }
    return true;
  }

  static bool has_wedges(const BrokenFan& fan) {
    return std::count_if(fan.gaps.begin(), fan.gaps.end(), [](const GapTet& g) { return g.is_last; }) > 1;
  }

  std::vector<Wedge> wedges_of(const BrokenFan& fan) const {
    if (!has_wedges(fan)) return {};
    const auto& [a, b] = fan.edge;
    const std::uint32_t g = fan.ground[0];
    std::vector<Wedge> wedges{
        {{parts_->of_ground(g, a), parts_->of_ground(g, b)}, parts_->body_of_ground(g)}};
    for (std::size_t i = 0; i + 1 < fan.gaps.size(); ++i) {
      if (!fan.gaps[i].is_last) continue;
      const std::uint32_t t = cell_.complex.mesh.neighbours[fan.gaps[i].tet][fan.gaps[i].to];
      wedges.push_back({{parts_->of_tet(t, a), parts_->of_tet(t, b)}, parts_->body_of_tet(t)});
    }
    return wedges;
  }

  void add_bridge(const BrokenFan& fan) {
    Bridge bridge;
    bridge.edge = fan.edge;
    bridge.wedges = wedges_of(fan);
    for (const GapTet& gap : fan.gaps) {
      bool good = are_centres_apart(gap.tet, fan.edge);
      for (std::uint8_t f = 0; f < 4; ++f) good = good && is_positive(part_at(gap.tet, f, fan.edge));
      good = good && add_part(gap, gap.from, !gap.is_first, bridge) &&
             add_part(gap, gap.to, !gap.is_last, bridge);
      if (good) continue;
      bridge.pieces.clear();
      break;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      bridge.ground[k] = cell_.ground[fan.ground[k]];
      bridge.edge[k] = cell_.vertices[fan.edge[k]];
    }
    result_.bridges.push_back(std::move(bridge));
  }

  const BuiltCell& cell_;
  const std::vector<BrokenFan> fans_;
  std::optional<LinkParts> parts_;                                   ///< if a fan has several gaps
  std::map<std::uint32_t, std::vector<Edge>> edges_;                 ///< by tetrahedron: whose gaps it is in
  std::map<std::pair<std::uint32_t, Edge>, std::uint32_t> centres_;  ///< by centre_key(): number
  std::map<Triangle, Claimed> facet_points_;                         ///< by local vertices, ascending
  CellBridges result_;
};

}  // namespace

CellBridges find_bridges(const BuiltCell& cell, const Ground& ground, const std::vector<std::uint8_t>& kept) {
  return BridgeFinder(cell, ground, kept).run();
}

bool BuiltBridges::is_apart(const Bridge& bridge) const {
  for (const Tet& piece : bridge.pieces)
    for (std::size_t i = 0; i < 4 && pieces_.count(piece) == 0; ++i) {
      const bool at_edge = !is_end(piece[i], bridge.edge);
      if (!at_edge && sides_.count(side_of(piece, i)) != 0) return false;
    }
  return true;
}

std::uint32_t BuiltBridges::root_of(std::uint32_t part) const {
  for (auto next = joined_.find(part); next != joined_.end(); next = joined_.find(part)) part = next->second;
  return part;
}

std::optional<std::uint32_t> BuiltBridges::handles_of(const Bridge& bridge) const {
  if (!is_apart(bridge)) return {};
  const std::vector<Wedge>& wedges = bridge.wedges;
  if (wedges.empty()) return 0;
  DisjointSets tied(wedges.size());
  std::size_t parts = 0;
  for (std::size_t end = 0; end < 2; ++end)
    for (std::uint32_t i = 0; i < wedges.size(); ++i) {
      std::uint32_t first = 0;
      while (root_of(wedges[first].parts[end]) != root_of(wedges[i].parts[end])) ++first;
      parts += first == i ? 1U : 0U;
      tied.join(first, i);
    }
  const std::uint32_t disks = tied.count();
  const bool one_body =
      std::all_of(wedges.begin(), wedges.end(), [&](const Wedge& w) { return w.body == wedges[0].body; });
  if (parts != wedges.size() + disks || !one_body) return {};
  return disks - 1;
}

void BuiltBridges::add(const Bridge& bridge) {
  for (const Tet& piece : bridge.pieces) {
    pieces_.insert(piece);
    for (std::size_t i = 0; i < 4; ++i) sides_.insert(side_of(piece, i));
  }
  for (const Wedge& wedge : bridge.wedges)
    for (std::size_t end = 0; end < 2; ++end) {
      const auto [low, high] = std::minmax({root_of(bridge.wedges[0].parts[end]), root_of(wedge.parts[end])});
      if (low != high) joined_[high] = low;
    }
}

void renumber(CellBridges& bridges, std::span<const std::uint32_t> number) {
  for (Bridge& bridge : bridges.bridges) {
    for (std::uint32_t& v : bridge.edge) v = number[v];
    for (auto& piece : bridge.pieces)
      for (std::uint32_t& v : piece)
        if (v < kFirstBridgePoint) v = number[v];
  }
}

}  // namespace crossloft
