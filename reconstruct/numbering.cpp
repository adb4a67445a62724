#include "numbering.h"

#include <algorithm>

namespace crossloft {

namespace {

/// A split or sample of a face.
struct AddedVertex {
  LatticePoint point;
  std::uint32_t face, local;
};

std::vector<AddedVertex> added_vertices(std::span<const FaceTriangulation> faces) {
  std::vector<AddedVertex> list;
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (std::uint32_t s = 0; s < faces[f].added.size(); ++s)
      list.push_back({faces[f].added[s], f, static_cast<std::uint32_t>(faces[f].vertices.size()) + s});
  std::sort(list.begin(), list.end(), [](const AddedVertex& x, const AddedVertex& y) {
    return compare_lex(x.point, y.point) < 0;
  });
  return list;
}

}  // namespace

/// Merges: the vertices of the graph are in order already.
Numbering number_vertices(const SectionGraph& graph, std::span<const FaceTriangulation> faces) {
  const std::vector<AddedVertex> added = added_vertices(faces);
  Numbering numbering;
  numbering.points.reserve(graph.size() + added.size());
  numbering.graph_vertex.reserve(graph.size() + added.size());
  numbering.of_graph.resize(graph.size());
  numbering.of_face.resize(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    numbering.of_face[f].resize(faces[f].vertices.size() + faces[f].added.size());
  const auto take = [&](const LatticePoint& point, std::uint32_t graph_vertex) {
    numbering.points.push_back(point);
    numbering.graph_vertex.push_back(graph_vertex);
    return static_cast<std::uint32_t>(numbering.points.size() - 1);
  };
  auto next = added.begin();
  const auto take_added = [&] {
    numbering.of_face[next->face][next->local] = take(next->point, kNone);
    ++next;
  };
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    while (next != added.end() && compare_lex(next->point, graph.points[v]) < 0) take_added();
    numbering.of_graph[v] = take(graph.points[v], v);
  }
  while (next != added.end()) take_added();
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
