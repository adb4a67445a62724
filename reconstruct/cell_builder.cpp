#include "cell_builder.h"

#include <algorithm>
#include <numeric>

#include "../prune/star.h"
#include "grounded_table.h"
#include "rising_search.h"

namespace crossloft {

namespace {

class CellBuilder {
 public:
  CellBuilder(std::span<const CellFace> faces, const LineEdges& line_edges,
              std::span<const std::uint32_t> graph_vertex_of)
      : faces_(faces), line_edges_(line_edges), graph_vertex_of_(graph_vertex_of) {}
  Result<BuiltCell> run(const CellTriangulation& triangulation);

 private:
  void sort_vertices(const CellTriangulation& triangulation);
  void number_faces();
  GroundedTable fill_table() const;
  bool classify_facet(std::uint32_t t, std::size_t i, const GroundedTable& table);
  void classify_other_edges();
  bool classify(const GroundedTable& table);
  /// Number of faces that all the given local vertices share, at most 2.
  template <class... V>
  int shared_faces(V... v) const {
    int count = 0;
    for (std::uint32_t w = 0; w < cell_.complex.words; ++w)
      count += __builtin_popcountll((cell_.complex.faces_of(v)[w] & ...));
    return count;
  }
  EdgeKind edge_kind(std::uint32_t a, std::uint32_t b) const;

  std::span<const CellFace> faces_;
  const LineEdges& line_edges_;
  std::span<const std::uint32_t> graph_vertex_of_;
  BuiltCell cell_;
  std::vector<std::vector<std::uint32_t>> numbers_;  ///< by face: its vertices in the cell
  std::vector<std::uint32_t> triangle_base_;         ///< by face: number of its first triangle in the cell
  std::uint32_t grounded_ = 0;                       ///< hull facets on faces
};

/// Puts vertices into the order of their final numbers; samples came last.
void CellBuilder::sort_vertices(const CellTriangulation& triangulation) {
  const CellVertices& from = triangulation.vertices();
  CellComplex& complex = cell_.complex;
  complex.vertex_count = from.size();
  complex.words = from.words;
  complex.mesh = triangulation.mesh();
  if (std::is_sorted(from.numbers.begin(), from.numbers.end())) {
    cell_.vertices = from.numbers;
    cell_.points = from.points;
    complex.face_masks = from.face_masks;
    return;
  }
  std::vector<std::uint32_t> order(from.size()), place(from.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return from.numbers[a] < from.numbers[b]; });
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    cell_.vertices.push_back(from.numbers[order[k]]);
    cell_.points.push_back(from.points[order[k]]);
    for (std::uint32_t w = 0; w < from.words; ++w) complex.face_masks.push_back(from.mask(order[k], w));
  }
  for (auto& tet : complex.mesh.vertices)
    for (std::uint32_t& v : tet) v = place[v];
}

void CellBuilder::number_faces() {
  for (const CellFace& face : faces_) {
    std::vector<std::uint32_t>& numbers = numbers_.emplace_back();
    numbers.reserve(face.numbers.size());
    RisingSearch search(cell_.vertices);
    for (const std::uint32_t v : face.numbers)
      numbers.push_back(static_cast<std::uint32_t>(search.lower_bound(v)));
  }
}

GroundedTable CellBuilder::fill_table() const {
  std::vector<GroundedTable::Key> keys;
  keys.reserve(triangle_base_.back());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const std::vector<std::uint32_t>& number = numbers_[f];
    for (const auto& v : faces_[f].triangulation->triangles)
      keys.push_back({number[v[0]], number[v[1]], number[v[2]]});
  }
  return {cell_.vertices.size(), keys};
}

/// Between vertices of a face without triangles: there is no such edge in a face's triangulation.
EdgeKind CellBuilder::edge_kind(std::uint32_t a, std::uint32_t b) const {
  const int shared = shared_faces(a, b);
  if (shared == 0) return EdgeKind::free;
  return shared >= 2
             ? line_edges_.kind(graph_vertex_of_[cell_.vertices[a]], graph_vertex_of_[cell_.vertices[b]])
             : EdgeKind::external;
}

/// Kind and triangle of facet i of t, if it is on a face; false if the face has no such triangle.
bool CellBuilder::classify_facet(std::uint32_t t, std::size_t i, const GroundedTable& table) {
  CellComplex& complex = cell_.complex;
  const auto& v = complex.mesh.vertices[t];
  const auto& s = kFacetSlots[i];
  if (shared_faces(v[s[0]], v[s[1]], v[s[2]]) == 0) return true;
  const std::uint32_t number = table.find({v[s[0]], v[s[1]], v[s[2]]});
  if (number == kNone) return false;
  ++grounded_;
  const auto above = std::upper_bound(triangle_base_.begin(), triangle_base_.end(), number);
  const auto f = static_cast<std::uint32_t>(above - triangle_base_.begin() - 1);
  const std::uint32_t triangle = number - triangle_base_[f];
  const FaceTriangulation& face = *faces_[f].triangulation;
  const bool inside = face.internal[triangle] != 0;
  complex.facets[t][i] = inside ? FacetKind::internal : FacetKind::external;
  if (inside) cell_.ground.push_back({f, triangle});
  const auto& corners = face.triangles[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const unsigned corner = kEdgeCorner[s[k]][s[(k + 1) % 3]];
    EdgeKind& kind = complex.edges[t][corner - 4];
    if (kind != EdgeKind::free) continue;  // known from the hull facet on its other side
    const std::uint32_t opposite = v[s[(k + 2) % 3]];
    const std::size_t side = numbers_[f][corners[0]] == opposite   ? 0
                             : numbers_[f][corners[1]] == opposite ? 1
                                                                   : 2;
    kind = face.edges[face.sides[triangle][side]].kind;
    visit_around_edge(complex.mesh, t, corner,
                      [&, kind](std::uint32_t n, unsigned at) { complex.edges[n][at - 4] = kind; });
  }
  return true;
}

/// Between vertices of a face without triangles, which no hull facet leads to.
void CellBuilder::classify_other_edges() {
  CellComplex& complex = cell_.complex;
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    for (std::size_t e = 0; e < 6; ++e) {
      const auto& v = complex.mesh.vertices[t];
      EdgeKind& kind = complex.edges[t][e];
      if (kind == EdgeKind::free) kind = edge_kind(v[kEdgeSlots[e][0]], v[kEdgeSlots[e][1]]);
    }
}

/// False if the hull facets on the faces are not the faces' triangles. Edges are looked up once, from the
/// hull, and told to all tetrahedra around them.
bool CellBuilder::classify(const GroundedTable& table) {
  CellComplex& complex = cell_.complex;
  const std::uint32_t n = complex.mesh.size();
  complex.facets.assign(n, {});
  complex.edges.assign(n, {});
  for (std::uint32_t t = 0; t < n; ++t)
    for (std::size_t i = 0; i < 4; ++i)
      if (complex.mesh.neighbours[t][i] == kNone && !classify_facet(t, i, table)) return false;
  const bool spans_area = std::all_of(faces_.begin(), faces_.end(), [](const CellFace& face) {
    return !face.triangulation->triangles.empty() || face.numbers.size() < 2;
  });
  if (!spans_area) classify_other_edges();
  return grounded_ == triangle_base_.back();
}

Result<BuiltCell> CellBuilder::run(const CellTriangulation& triangulation) {
  if (triangulation.dimension() < 3) return std::move(cell_);
  sort_vertices(triangulation);
  triangle_base_.push_back(0);
  for (const CellFace& face : faces_)
    triangle_base_.push_back(triangle_base_.back() +
                             static_cast<std::uint32_t>(face.triangulation->triangles.size()));
  number_faces();
  if (!classify(fill_table()))
    return make_error(ErrorCode::internal, "a cell's hull differs from its face triangulations");
  return std::move(cell_);
}

}  // namespace

std::vector<TetKinds> kinds_of(const CellComplex& complex) {
  std::vector<TetKinds> kinds(complex.mesh.size());
  for (std::uint32_t t = 0; t < kinds.size(); ++t) {
    const auto& v = complex.mesh.vertices[t];
    std::array<std::size_t, 4> slots{0, 1, 2, 3};
    std::sort(slots.begin(), slots.end(), [&](std::size_t i, std::size_t j) { return v[i] < v[j]; });
    for (std::size_t i = 0; i < 4; ++i) {
      kinds[t].name[i] = v[slots[i]];
      kinds[t].facets[i] = complex.facets[t][slots[i]];
    }
    for (std::size_t e = 0; e < 6; ++e)
      kinds[t].edges[e] =
          complex.edges[t][kEdgeCorner[slots[kEdgeSlots[e][0]]][slots[kEdgeSlots[e][1]]] - 4U];
  }
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

Result<BuiltCell> build_cell(std::span<const CellFace> faces, const CellTriangulation& triangulation,
                             const LineEdges& line_edges, std::span<const std::uint32_t> graph_vertex_of) {
  return CellBuilder(faces, line_edges, graph_vertex_of).run(triangulation);
}

}  // namespace crossloft
