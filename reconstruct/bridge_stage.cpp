/// Bridges where no cell holds a section together.

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "../geom/disjoint_sets.h"
#include "pipeline.h"

namespace crossloft {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// A section triangle at an edge, with the cells on its two sides.
struct SectionSide {
  Edge edge{};
  std::uint32_t face = 0, triangle = 0;
  std::array<CellId, 2> cells{};
};

/// Where a broken fan comes from: bridge b of cell c.
struct Source {
  Edge edge{};
  std::uint32_t pieces = 0, cell = 0, bridge = 0;
  friend auto operator<=>(const Source&, const Source&) = default;
};

/// A bridge of fewer pieces comes first.
std::vector<Source> broken_edges(std::span<const CellState> cells) {
  std::vector<Source> sources;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (std::uint32_t b = 0; b < cells[c].bridges.bridges.size(); ++b) {
      const Bridge& bridge = cells[c].bridges.bridges[b];
      sources.push_back({bridge.edge, static_cast<std::uint32_t>(bridge.pieces.size()), c, b});
    }
  std::sort(sources.begin(), sources.end());
  return sources;
}

bool is_source(std::span<const Source> sources, const Edge& edge) {
  const auto place = std::lower_bound(sources.begin(), sources.end(), Source{edge, 0, 0, 0});
  return place != sources.end() && place->edge == edge;
}

/// Part of a list sorted by edge.
template <class T>
std::span<const T> of_edge(const std::vector<T>& list, const Edge& edge) {
  const auto by_edge = [](const T& x, const Edge& e) { return x.edge < e; };
  const auto first = std::lower_bound(list.begin(), list.end(), edge, by_edge);
  auto last = first;
  while (last != list.end() && last->edge == edge) ++last;
  return {first, last};
}

std::vector<SectionSide> section_sides(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                       const Arrangement& arrangement, std::span<const Source> sources) {
  std::vector<SectionSide> sides;
  if (sources.empty()) return sides;
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (std::uint32_t t = 0; t < faces[f].triangles.size(); ++t)
      for (std::size_t i = 0; i < 3 && faces[f].internal[t] != 0; ++i) {
        const auto& v = faces[f].triangles[t];
        const auto [a, b] = std::minmax(numbering.of_face[f][v[i]], numbering.of_face[f][v[(i + 1) % 3]]);
        const Edge edge{a, b};
        if (!is_source(sources, edge)) continue;
        const auto& cells = arrangement.cells_of(FaceId{f});
        sides.push_back({edge, f, t, {cells[0], cells[1]}});
      }
  std::sort(sides.begin(), sides.end(), [](const SectionSide& x, const SectionSide& y) {
    return std::tie(x.edge, x.face, x.triangle) < std::tie(y.edge, y.face, y.triangle);
  });
  return sides;
}

/// A bridge point by its cell and its number there.
using PointName = std::pair<std::uint32_t, std::uint32_t>;

/// Final numbers of the points that the pieces use, after all others and in lexicographic order.
std::map<PointName, std::uint32_t> number_points(std::span<const BuiltBridges> built,
                                                 std::span<const CellState> cells, Numbering& numbering) {
  std::map<PointName, std::uint32_t> numbers;
  for (std::uint32_t c = 0; c < built.size(); ++c)
    for (const auto& piece : built[c].pieces())
      for (const std::uint32_t v : piece)
        if (v >= kFirstBridgePoint) numbers[{c, v}] = 0;
  std::vector<PointName> order;
  for (const auto& [name, unused] : numbers) order.push_back(name);
  const auto point = [&](const PointName& name) -> const LatticePoint& {
    return cells[name.first].bridges.points[name.second - kFirstBridgePoint];
  };
  std::sort(order.begin(), order.end(),
            [&](const PointName& x, const PointName& y) { return compare_lex(point(x), point(y)) < 0; });
  numbering.bridge_begin = numbering.points.size();
  for (const PointName& name : order) {
    numbers[name] = static_cast<std::uint32_t>(numbering.points.size());
    numbering.points.push_back(point(name));
    numbering.graph_vertex.push_back(kNone);
  }
  return numbers;
}

void add_pieces(std::span<const BuiltBridges> built, const std::map<PointName, std::uint32_t>& numbers,
                std::vector<CellState>& cells) {
  for (std::uint32_t c = 0; c < built.size(); ++c)
    for (auto piece : built[c].pieces()) {
      for (std::uint32_t& v : piece)
        if (v >= kFirstBridgePoint) v = numbers.find({c, v})->second;
      cells[c].bridge_tets.push_back(piece);
    }
}

}  // namespace

/// The section triangles at one edge and which of them the solid connects there. Each cell at the edge has
/// two of them, or fewer.
class EdgeRing {
 public:
  EdgeRing(std::span<const SectionSide> sides, std::span<const Source> sources,
           std::span<const CellState> cells)
      : sides_(sides), connected_(sides.size()) {
    std::vector<std::uint32_t> broken;
    for (const Source& s : sources) broken.push_back(s.cell);
    std::sort(broken.begin(), broken.end());
    std::vector<std::array<std::uint32_t, 2>> seen;  // cell, side
    for (std::uint32_t i = 0; i < sides.size(); ++i)
      for (const CellId cell : sides[i].cells) seen.push_back({cell.value, i});
    std::sort(seen.begin(), seen.end());
    for (std::size_t i = 1; i < seen.size(); ++i) {
      const std::uint32_t cell = seen[i][0];
      const bool whole =
          cells[cell].report.tets_r0 != 0 && !std::binary_search(broken.begin(), broken.end(), cell);
      if (cell == seen[i - 1][0] && whole) connected_.join(seen[i][1], seen[i - 1][1]);
    }
  }

  bool is_connected() {
    for (std::uint32_t i = 1; i < sides_.size(); ++i)
      if (connected_.find(i) != connected_.find(0)) return false;
    return true;
  }

  using SectionTriangle = std::pair<std::uint32_t, std::uint32_t>;  ///< face, triangle
  /// False if the two were connected already. REQUIRES: they are at the edge.
  bool connect(const SectionTriangle& a, const SectionTriangle& b) {
    const std::uint32_t x = connected_.find(place(a)), y = connected_.find(place(b));
    connected_.join(x, y);
    return x != y;
  }

 private:
  std::uint32_t place(const SectionTriangle& triangle) const {
    std::uint32_t i = 0;
    while (i + 1 < sides_.size() &&
           (sides_[i].face != triangle.first || sides_[i].triangle != triangle.second))
      ++i;
    return i;
  }

  std::span<const SectionSide> sides_;
  DisjointSets connected_;
};

struct OpenEdge {
  std::span<const Source> sources;
  EdgeRing ring;
  bool helped = false;
};

namespace {

/// Those that are to be looked at, again if there is something new at one of their ends.
class DueEdges {
 public:
  explicit DueEdges(std::span<const OpenEdge> open) : count_(open.size()) {
    for (std::size_t i = 0; i < open.size(); ++i) {
      due_.insert(due_.end(), i);
      for (const std::uint32_t end : open[i].sources[0].edge) at_.emplace_back(end, i);
    }
    std::sort(at_.begin(), at_.end());
  }

  /// The first one; the number of all if there is none.
  std::size_t next() {
    if (due_.empty()) return count_;
    const std::size_t first = *due_.begin();
    due_.erase(due_.begin());
    return first;
  }

  void add_around(const Edge& edge) {
    for (const std::uint32_t end : edge)
      for (auto at = std::lower_bound(at_.begin(), at_.end(), std::pair{end, std::size_t{0}});
           at != at_.end() && at->first == end; ++at)
        due_.insert(at->second);
  }

 private:
  std::size_t count_;
  std::set<std::size_t> due_;
  std::vector<std::pair<std::uint32_t, std::size_t>> at_;  ///< by end of an edge
};

}  // namespace

/// If it connects what is not connected yet, and fits to the others of its cell.
bool Pipeline::build_bridge(std::uint32_t cell, std::uint32_t number, bool may_make_handles, EdgeRing& ring,
                            BuiltBridges& built) {
  const Bridge& bridge = cells_[cell].bridges.bridges[number];
  if (bridge.pieces.empty()) return false;
  const auto handles = built.handles_of(bridge);
  if (!handles || (*handles > 0 && !may_make_handles)) return false;
  const std::vector<FaceId> ids = inner_faces(CellId{cell});
  const auto& [g, h] = bridge.ground;
  if (!ring.connect({ids[g.face].value, g.triangle}, {ids[h.face].value, h.triangle})) return false;
  built.add(bridge);
  result_.report.topology.bridge_handles += *handles;
  std::vector<GroundTriangle>& ground = cells_[cell].bridge_ground;
  ground.insert(ground.end(), {g, h});
  return true;
}

/// What whole fans leave unconnected is connected by the smallest bridges.
void Pipeline::build_bridges() {
  const std::vector<Source> sources = broken_edges(cells_);
  const std::vector<SectionSide> sides = section_sides(faces_, numbering_, *arrangement_, sources);
  std::vector<BuiltBridges> built(cells_.size());
  std::vector<OpenEdge> open;
  for (std::size_t first = 0; first < sources.size();) {
    const std::span<const Source> here = of_edge(sources, sources[first].edge);
    first += here.size();
    EdgeRing ring(of_edge(sides, here[0].edge), here, cells_);
    if (!ring.is_connected()) open.push_back({here, std::move(ring), false});
  }
  close_edges(open, built);
  TopologyReport& report = result_.report.topology;
  for (OpenEdge& edge : open) {
    report.bridges += edge.helped ? 1U : 0U;
    report.open_edges += edge.ring.is_connected() ? 0U : 1U;
  }
  add_pieces(built, number_points(built, cells_, numbering_), cells_);
}

/// Edge by edge, again where a bridge may fit once others are built. Where none fits a slit through the
/// section would stay, as good as a handle: there a bridge may make one, and those beside it may close
/// without.
void Pipeline::close_edges(std::span<OpenEdge> open, std::vector<BuiltBridges>& built) {
  DueEdges due(open);
  for (std::size_t next = 0; next < open.size();) {
    const std::size_t i = due.next();
    const bool none_fits = i == open.size();
    OpenEdge& edge = open[none_fits ? next++ : i];
    if (build_at(edge, none_fits, built)) due.add_around(edge.sources[0].edge);
  }
}

/// Whether there is one more.
bool Pipeline::build_at(OpenEdge& open, bool may_make_handles, std::vector<BuiltBridges>& built) {
  bool more = false;
  for (const Source& s : open.sources)
    more |= build_bridge(s.cell, s.bridge, may_make_handles, open.ring, built[s.cell]);
  open.helped |= more;
  return more;
}

void Pipeline::remove_bridges() {
  for (CellState& cell : cells_) {
    cell.bridge_tets.clear();
    cell.bridge_ground.clear();
  }
  numbering_.points.resize(numbering_.bridge_begin);
  numbering_.graph_vertex.resize(numbering_.bridge_begin);
  TopologyReport& report = result_.report.topology;
  report.bridges = report.bridge_handles = report.open_edges = 0;
}

}  // namespace crossloft
