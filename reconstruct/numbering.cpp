#include "numbering.h"

#include <algorithm>

namespace crossloft {

Numbering number_vertices(const SectionGraph& graph, std::span<const FaceTriangulation> faces) {
  struct Item {
    LatticePoint point;
    std::uint32_t graph_vertex, face, local;
  };
  std::vector<Item> items;
  for (std::uint32_t v = 0; v < graph.size(); ++v) items.push_back({graph.points[v], v, kNone, kNone});
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (std::uint32_t s = 0; s < faces[f].added.size(); ++s)
      items.push_back(
          {faces[f].added[s], kNone, f, static_cast<std::uint32_t>(faces[f].vertices.size()) + s});
  std::sort(items.begin(), items.end(),
            [](const Item& x, const Item& y) { return compare_lex(x.point, y.point) < 0; });
  Numbering numbering;
  numbering.of_graph.resize(graph.size());
  numbering.of_face.resize(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    numbering.of_face[f].resize(faces[f].vertices.size() + faces[f].added.size());
  for (const Item& item : items) {
    const auto number = static_cast<std::uint32_t>(numbering.points.size());
    numbering.points.push_back(item.point);
    numbering.graph_vertex.push_back(item.graph_vertex);
    if (item.graph_vertex != kNone)
      numbering.of_graph[item.graph_vertex] = number;
    else
      numbering.of_face[item.face][item.local] = number;
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t v = 0; v < faces[f].vertices.size(); ++v)
      numbering.of_face[f][v] = numbering.of_graph[faces[f].vertices[v]];
  return numbering;
}

std::vector<std::uint32_t> renumbering(const Numbering& before, const Numbering& after) {
  std::vector<std::uint32_t> number(before.points.size(), kNone);
  for (std::size_t v = 0; v < before.of_graph.size(); ++v) number[before.of_graph[v]] = after.of_graph[v];
  for (std::size_t f = 0; f < before.of_face.size(); ++f)
    for (std::size_t v = 0; v < before.of_face[f].size(); ++v)
      number[before.of_face[f][v]] = after.of_face[f][v];
  return number;
}

}  // namespace crossloft
