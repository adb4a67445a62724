#pragma once
/// The final vertex numbers: section graph vertices, splits and samples of all faces in one lexicographic
/// order.

#include <cstdint>
#include <span>
#include <vector>

#include "face_triangulation.h"

namespace crossloft {

struct Numbering {
  /// By final number: vertices of faces, in lexicographic order; then points inside cells round by round,
  /// those of bridges, and those of roofs, first on the positive side of planes, each lot in lexicographic
  /// order.
  std::vector<LatticePoint> points;
  std::size_t bridge_begin = 0;                     ///< where those of bridges begin, once these are built
  std::vector<std::uint32_t> graph_vertex;          ///< by final number, kNone for a split or sample
  std::vector<std::uint32_t> of_graph;              ///< final number by section graph vertex
  std::vector<std::vector<std::uint32_t>> of_face;  ///< [face][local vertex]: final number
};

/// `faces` by arrangement face. REQUIRES: the graph's points are in lexicographic order, as in a finished
/// graph.
Numbering number_vertices(const SectionGraph& graph, std::span<const FaceTriangulation> faces);

/// By number in `before`: the number in `after`. REQUIRES: faces have kept their local numbers and may have
/// gained vertices.
std::vector<std::uint32_t> renumbering(const Numbering& before, const Numbering& after);

}  // namespace crossloft
