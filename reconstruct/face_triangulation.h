#pragma once
/// One face of the arrangement: the planar Delaunay triangulation of its section vertices, conforming to the
/// contours and told into inside and outside. Its triangles are the hull facets, on this face, of the cells
/// on both sides (README, "Invariants": all section vertices of a cell lie on its boundary).

#include <array>
#include <cstdint>
#include <vector>

#include "../arrangement/section_graph.h"
#include "../prune/cell_complex.h"
#include "plane_locators.h"

namespace crossloft {

/// An edge of the triangulation, local vertices a < b.
struct FaceEdge {
  std::uint32_t a = 0, b = 0;
  EdgeKind kind = EdgeKind::free;
};

struct FaceTriangulation {
  FaceId face;
  std::uint32_t plane = 0;
  std::vector<std::uint32_t> vertices;  ///< of the section graph, ascending: local 0..vertices.size()-1,
  std::vector<LatticePoint> added;      ///< then splits and samples, explicit and strictly inside the face
  std::uint32_t samples = 0;  ///< how many of those are samples of the branching and cutting diagrams
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< local, counter-clockwise from the positive side
  std::vector<std::uint8_t> internal;                   ///< by triangle: 1 inside the section
  std::vector<FaceEdge> edges;  ///< of the triangles; those on lines get their kind from LineEdges
  std::vector<std::array<std::uint32_t, 3>> sides;   ///< by triangle: its edges, each opposite to a vertex
  std::vector<Wall> walls;                           ///< contour pieces inside the face, local ends
  std::vector<Wall> border;                          ///< on its edges, where they bound the section on it
  std::array<std::vector<std::uint8_t>, 2> covered;  ///< by triangle: 1 if a kept tetrahedron of the cell on
                                                     ///< the negative / positive side stands on it

  /// Inside the section, and nothing stands on it. REQUIRES: `covered` filled by all cells.
  bool is_flat(std::size_t triangle) const {
    return internal[triangle] != 0 && covered[0][triangle] == 0 && covered[1][triangle] == 0;
  }
};

/// The edges, local vertices a < b, in holes of the section: outside, where contours are all around. O(n).
std::vector<std::array<std::uint32_t, 2>> edges_in_holes(const FaceTriangulation& face);

/// What the triangulation of a face is made from.
struct FaceInput {
  FaceId face;
  std::vector<std::uint32_t> vertices;  ///< all section vertices on the closed face, ascending
  std::vector<Wall> walls;              ///< in the open face; ends by place in `vertices`
  std::vector<Wall> border;             ///< on its edges, of the face's own plane; likewise
};

/// The inputs of all faces that are not on the box, by face.
std::vector<FaceInput> face_inputs(const SectionGraph& graph, const Arrangement& arrangement,
                                   const Context& context);

/// Triangulates; without area in its vertices the face has no triangles. Independent of other faces: may run
/// in parallel. Error too_thin (with plane and contour) if a contour edge could not be recovered.
Result<FaceTriangulation> triangulate_face(const SectionGraph& graph, const Arrangement& arrangement,
                                           const PlaneLocators& locators, const FaceInput& input);
/// Triangulates the face anew with samples inside its section; what `coarse` has keeps its local number. Its
/// walls may be split further, so that they are edges again. REQUIRES: samples are distinct lattice points
/// strictly inside the face and its section, and no vertices of `coarse`.
Result<FaceTriangulation> refine_face(const SectionGraph& graph, const Arrangement& arrangement,
                                      const PlaneLocators& locators, const FaceInput& input,
                                      const FaceTriangulation& coarse, std::span<const LatticePoint> samples);

/// Which edges on plane-plane lines are in the closed section of every plane through them: decided once, for
/// all cells. An edge is in the closed section of a plane iff an internal triangle of that plane stands at
/// it.
class LineEdges {
 public:
  explicit LineEdges(const SectionGraph& graph) : graph_(&graph) {}
  void add(const FaceTriangulation& face);
  void finish();
  /// Kind of the edge between section graph vertices u, v that share two or more planes.
  EdgeKind kind(std::uint32_t u, std::uint32_t v) const;
  /// True iff u and v share two or more planes.
  bool on_line(std::uint32_t u, std::uint32_t v) const { return shared_planes(u, v) >= 2; }
  /// Flags by vertex of the graph in the face (local numbers): on a plane-plane line at all. Empty if fewer
  /// than two are, as in a stack of slices: then no edge of the face is on a line.
  std::vector<std::uint8_t> vertices_on_lines(const FaceTriangulation& face) const;

 private:
  /// REQUIRES: they share one.
  std::uint32_t shared_planes(std::uint32_t u, std::uint32_t v) const;

  struct Entry {
    std::uint32_t u, v, plane;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  const SectionGraph* graph_;
  std::vector<Entry> inside_;                          ///< edge uv has an internal triangle of the plane
  std::vector<std::array<std::uint32_t, 2>> contour_;  ///< edges that are walls
};

}  // namespace crossloft
