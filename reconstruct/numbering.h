#pragma once
/// The final vertex numbers: section graph vertices, splits and samples of all faces in one lexicographic
/// order.

#include <cstdint>
#include <span>
#include <vector>

#include "face_triangulation.h"

namespace crossloft {

struct Numbering {
  std::vector<LatticePoint> points;                 ///< by final number, lexicographic; then points inside
                                                    ///< cells, of bridges, and of roofs, each lot by itself
  std::size_t bridge_begin = 0;                     ///< number of the first of these, once there are some
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
