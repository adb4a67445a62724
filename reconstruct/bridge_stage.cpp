/// Bridges where no cell holds a section together.

#include <algorithm>
#include <array>
#include <map>

#include "../prune/disjoint_sets.h"
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

/// The section triangles at one edge and which of them the solid connects there.
class EdgeRing {
 public:
  EdgeRing(std::span<const SectionSide> sides, std::span<const Source> sources,
           std::span<const CellState> cells)
      : sides_(sides), connected_(sides.size()) {
    for (std::uint32_t i = 0; i < sides.size(); ++i)
      for (std::uint32_t j = 0; j < i; ++j)
        for (const CellId cell : sides[i].cells)
          if ((cell == sides[j].cells[0] || cell == sides[j].cells[1]) &&
              is_whole(cell.value, sources, cells))
            connected_.join(i, j);
  }

  bool is_connected() {
    for (std::uint32_t i = 1; i < sides_.size(); ++i)
      if (connected_.find(i) != connected_.find(0)) return false;
    return true;
  }

  /// False if the two triangles were connected already.
  bool connect(const std::array<std::pair<std::uint32_t, std::uint32_t>, 2>& triangles) {
    const std::uint32_t a = connected_.find(place(triangles[0])), b = connected_.find(place(triangles[1]));
    connected_.join(a, b);
    return a != b;
  }

 private:
  /// Whether the fan of a cell at the edge is kept as a whole.
  static bool is_whole(std::uint32_t cell, std::span<const Source> sources,
                       std::span<const CellState> cells) {
    return cells[cell].report.tets_r0 != 0 &&
           std::none_of(sources.begin(), sources.end(), [&](const Source& s) { return s.cell == cell; });
  }

  std::uint32_t place(const std::pair<std::uint32_t, std::uint32_t>& triangle) const {
    const auto found = std::find_if(sides_.begin(), sides_.end(), [&](const SectionSide& s) {
      return s.face == triangle.first && s.triangle == triangle.second;
    });
    return static_cast<std::uint32_t>(found - sides_.begin());
  }

  std::span<const SectionSide> sides_;
  DisjointSets connected_;
};

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
        if (v >= kFirstBridgePoint) v = numbers.at({c, v});
      cells[c].tets.push_back(piece);
    }
}

}  // namespace

/// Edge by edge: what whole fans leave unconnected is connected by the smallest bridges.
void Pipeline::build_bridges() {
  const std::vector<Source> sources = broken_edges(cells_);
  const std::vector<SectionSide> sides = section_sides(faces_, numbering_, *arrangement_, sources);
  TopologyReport& report = result_.report.topology;
  std::vector<BuiltBridges> built(cells_.size());
  for (std::size_t first = 0; first < sources.size();) {
    const std::span<const Source> here = of_edge(sources, sources[first].edge);
    first += here.size();
    EdgeRing ring(of_edge(sides, here[0].edge), here, cells_);
    if (ring.is_connected()) continue;
    bool helped = false;
    for (const Source& s : here) {
      const Bridge& bridge = cells_[s.cell].bridges.bridges[s.bridge];
      if (bridge.pieces.empty() || !built[s.cell].fits(bridge)) continue;
      const std::vector<FaceId> ids = inner_faces(CellId{s.cell});
      if (!ring.connect({{{ids[bridge.ground[0].face].value, bridge.ground[0].triangle},
                          {ids[bridge.ground[1].face].value, bridge.ground[1].triangle}}}))
        continue;
      built[s.cell].add(bridge);
      std::vector<GroundTriangle>& ground = cells_[s.cell].ground;
      ground.insert(ground.end(), bridge.ground.begin(), bridge.ground.end());
      helped = true;
    }
    report.bridges += helped ? 1U : 0U;
    report.open_edges += ring.is_connected() ? 0U : 1U;
  }
  add_pieces(built, number_points(built, cells_, numbering_), cells_);
}

}  // namespace crossloft
