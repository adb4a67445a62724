#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "section_conventions.h"
#include "section_grammar.h"

namespace crossloft {
namespace {

void read_edges(TokenReader& in, std::uint32_t count, PlaneSection& plane) {
  constexpr std::size_t kLeastBytes = 8;  // "0 1 1 0 "
  const auto vertices = static_cast<std::uint32_t>(plane.vertices.size());
  plane.edges.reserve(in.room_for(count, kLeastBytes));
  for (std::uint32_t e = 0; e < count && in.ok(); ++e) {
    ContourEdge edge;
    edge.a = in.index("the first vertex of an edge", vertices);
    edge.line = in.line();
    edge.b = in.index("the second vertex of an edge", vertices);
    edge.material_a = in.integer("a material of an edge");
    edge.material_b = in.integer("a material of an edge");
    plane.edges.push_back(edge);
  }
}

/// Vertices with an odd number of edges are ends of chains, or vertices where materials meet. Those with
/// equal coordinates are made one, the first of them.
void join_ends(PlaneSection& plane) {
  std::vector<std::uint32_t> degree(plane.vertices.size(), 0), ends;
  for (const ContourEdge& edge : plane.edges) ++degree[edge.a], ++degree[edge.b];
  for (std::uint32_t v = 0; v < degree.size(); ++v) {
    if (degree[v] % 2 != 0) ends.push_back(v);
  }
  if (ends.empty()) return;

  const auto key = [&](std::uint32_t v) { return plane.vertices[v]; };
  std::sort(ends.begin(), ends.end(),
            [&](std::uint32_t v, std::uint32_t w) { return std::pair(key(v), v) < std::pair(key(w), w); });
  std::vector<std::uint32_t> joined(plane.vertices.size());
  std::iota(joined.begin(), joined.end(), 0u);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (key(ends[i]) == key(ends[i - 1])) joined[ends[i]] = joined[ends[i - 1]];
  }
  for (ContourEdge& edge : plane.edges) edge.a = joined[edge.a], edge.b = joined[edge.b];
}

void number_contours(PlaneSection& plane) {
  DisjointSets components(plane.vertices.size());
  for (const ContourEdge& edge : plane.edges) components.join(edge.a, edge.b);
  std::vector<std::uint32_t> number(plane.vertices.size(), kNone);
  std::uint32_t contours = 0;
  for (ContourEdge& edge : plane.edges) {
    std::uint32_t& contour = number[components.find(edge.a)];
    if (contour == kNone) contour = contours++;
    edge.contour = contour;
  }
}

ParsedPlane read_plane(TokenReader& in, std::uint32_t) {
  ParsedPlane parsed;
  PlaneSection& plane = parsed.section;
  read_plane_equation(in, plane);
  plane.line = in.line();
  const std::uint32_t vertices = in.count("the number of vertices");
  const std::uint32_t edges = in.count("the number of edges");
  read_vertices(in, vertices, plane);
  read_edges(in, edges, plane);
  if (in.ok()) {
    join_ends(plane);
    number_contours(plane);
  }
  return parsed;
}

std::uint32_t read_header(TokenReader& in) {
  const std::uint32_t planes = in.count("the number of planes");
  if (planes == 0) in.fail(ErrorCode::no_plane, "the file has no cutting plane");
  return planes;
}

}  // namespace

const SectionGrammar& contour_grammar() {
  static constexpr SectionGrammar kGrammar{read_header, read_plane};
  return kGrammar;
}

}  // namespace crossloft
