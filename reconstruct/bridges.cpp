#include "bridges.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "../prune/broken_fans.h"

namespace crossloft {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Tet = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;

/// Weight of what is not the edge in a point of a bridge: the smaller, the thinner the bridge.
constexpr double kThickness = 0.125;

class BridgeFinder {
 public:
  BridgeFinder(const BuiltCell& cell, const std::vector<std::uint8_t>& kept,
               std::span<const LatticePoint> points)
      : cell_(cell),
        points_(points),
        ground_(cell.complex),
        fans_(broken_fans(cell.complex, ground_, kept)) {}

  CellBridges run() {
    for (const BrokenFan& fan : fans_)
      for (std::size_t i = 0; i < fan.gap.size(); ++i) {
        claim(centres_, fan.gap[i].tet, fan.edge);
        if (i > 0) claim(facet_points_, facet_key(fan.gap[i]), fan.edge);
      }
    for (auto& [tet, claimed] : centres_)
      claimed.number = add_point(cell_.complex.mesh.vertices[tet], claimed.edge);
    for (auto& [triangle, claimed] : facet_points_) claimed.number = add_point(triangle, claimed.edge);
    for (const BrokenFan& fan : fans_) add_bridge(fan);
    return std::move(result_);
  }

 private:
  /// A point to come near the smallest edge of those whose bridges it is part of: whatever their order.
  struct Claimed {
    Edge edge{};
    std::uint32_t number = kNone;
  };

  template <class Map, class Key>
  static void claim(Map& map, const Key& key, const Edge& edge) {
    const auto [place, is_new] = map.try_emplace(key, Claimed{edge, kNone});
    if (!is_new) place->second.edge = std::min(place->second.edge, edge);
  }

  /// The facet through which one comes to a tetrahedron of a gap, by its vertices.
  Triangle facet_key(const GapTet& gap) const {
    Triangle key{};
    for (std::size_t k = 0; k < 3; ++k)
      key[k] = cell_.complex.mesh.vertices[gap.tet][kFacetSlots[gap.from][k]];
    std::sort(key.begin(), key.end());
    return key;
  }

  const LatticePoint& point(std::uint32_t number) const {
    return number < kFirstBridgePoint ? points_[number] : result_.points[number - kFirstBridgePoint];
  }

  /// A weighted mean of the corners, mostly of the edge's ends; rounded to the grid.
  template <std::size_t N>
  std::uint32_t add_point(std::array<std::uint32_t, N> corners, const Edge& edge) {
    std::sort(corners.begin(), corners.end());
    Vec3 sum{0, 0, 0};
    for (const std::uint32_t v : corners) {
      const LatticePoint& p = points_[cell_.vertices[v]];
      const bool at_edge = v == edge[0] || v == edge[1];
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

  /// The tetrahedron's part between facet i and its centre.
  Tet part_at(std::uint32_t t, std::uint8_t i) const {
    Tet part = numbers_of(t);
    part[i] = centres_.at(t).number;
    return part;
  }

  /// The same for a facet with a point: one third of it, without the vertex in slot j.
  Tet part_at(const GapTet& gap, std::uint8_t i, std::uint32_t facet_point, std::size_t j) const {
    Tet part = part_at(gap.tet, i);
    part[j] = facet_point;
    return part;
  }

  /// What a bridge takes of the part at facet i; false if the centre or the facet's point lies wrongly.
  bool add_part(const GapTet& gap, std::uint8_t i, bool divided, Bridge& bridge) const {
    const Tet whole = part_at(gap.tet, i);
    if (!is_positive(whole)) return false;
    if (!divided) {
      bridge.pieces.push_back(whole);
      return true;
    }
    GapTet across = gap;
    across.from = i;
    const std::uint32_t p = facet_points_.at(facet_key(across)).number;
    const auto& local = cell_.complex.mesh.vertices[gap.tet];
    for (const std::uint8_t j : kFacetSlots[i]) {
      const Tet part = part_at(gap, i, p, j);
      if (!is_positive(part)) return false;
      if (local[j] != bridge.edge[0] && local[j] != bridge.edge[1]) bridge.pieces.push_back(part);
    }
    return true;
  }

  void add_bridge(const BrokenFan& fan) {
    Bridge bridge;
    bridge.edge = fan.edge;
    for (std::size_t i = 0; i < fan.gap.size(); ++i) {
      const GapTet& gap = fan.gap[i];
      bool good = true;
      for (std::uint8_t f = 0; f < 4; ++f) good = good && is_positive(part_at(gap.tet, f));
      good = good && add_part(gap, gap.from, i > 0, bridge) &&
             add_part(gap, gap.to, i + 1 < fan.gap.size(), bridge);
      if (good) continue;
      bridge.pieces.clear();
      break;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const Facet& f = ground_.facet(fan.ground[k]);
      bridge.ground[k] = cell_.ground[f.tet][f.facet];
      bridge.edge[k] = cell_.vertices[fan.edge[k]];
    }
    result_.bridges.push_back(std::move(bridge));
  }

  const BuiltCell& cell_;
  std::span<const LatticePoint> points_;
  const Ground ground_;
  const std::vector<BrokenFan> fans_;
  std::map<std::uint32_t, Claimed> centres_;  ///< by tetrahedron
  std::map<Triangle, Claimed> facet_points_;  ///< by local vertices, ascending
  CellBridges result_;
};

}  // namespace

CellBridges find_bridges(const BuiltCell& cell, const std::vector<std::uint8_t>& kept,
                         std::span<const LatticePoint> points) {
  return BridgeFinder(cell, kept, points).run();
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
