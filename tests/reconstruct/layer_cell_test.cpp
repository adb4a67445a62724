#include "../../reconstruct/layer_cell.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "../../prune/verify.h"
#include "../../reconstruct/observer.h"
#include "../../reconstruct/reconstruct.h"

using namespace crossloft;

namespace {

/// All that cells are built from.
struct Faces : Observer {
  void on_face(const FaceTriangulation& face, const Numbering& all) override {
    if (face.triangles.empty()) return;
    numbering = all;
    faces.push_back(face);
  }
  std::vector<FaceTriangulation> faces;
  Numbering numbering;
};

/// The triangles under the internal facets, by vertices of the cell.
std::map<Triangle, std::array<std::uint32_t, 2>> ground_of(const BuiltCell& cell) {
  std::map<Triangle, std::array<std::uint32_t, 2>> ground;
  std::size_t next = 0;
  for (std::uint32_t t = 0; t < cell.complex.mesh.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      if (cell.complex.facets[t][i] != FacetKind::internal) continue;
      const auto& v = cell.complex.mesh.vertices[t];
      Triangle name{v[kFacetSlots[i][0]], v[kFacetSlots[i][1]], v[kFacetSlots[i][2]]};
      std::sort(name.begin(), name.end());
      REQUIRE(next < cell.ground.size());
      ground[name] = {cell.ground[next].face, cell.ground[next].triangle};
      ++next;
    }
  CHECK(next == cell.ground.size());
  return ground;
}

/// Which side of the face the other one is on.
std::uint32_t side_of(const FaceTriangulation& face, std::span<const std::uint32_t> numbers,
                      std::uint32_t other, const Numbering& numbering) {
  const auto at = [&](std::size_t i) { return numbering.points[numbers[face.triangles[0][i]]]; };
  return orient3d(at(0), at(1), at(2), numbering.points[other]) > 0 ? 1 : 0;
}

Sections stack(double from, double to, int count) {
  std::vector<CuttingPlane> planes;
  for (int i = 0; i < count; ++i) planes.push_back({{0, 0, 1}, -(from + (to - from) * i / (count - 1))});
  auto sections = slice(trefoil_solid(24), planes);
  REQUIRE(sections.ok());
  return std::move(sections).value();
}

}  // namespace

TEST_CASE("cells of a stack are those of their triangulations") {
  Faces seen;
  REQUIRE(reconstruct(stack(-0.35, 0.35, 9), {}, {}, &seen).ok());
  REQUIRE(seen.faces.size() > 4);
  const LineEdges no_lines{SectionGraph{}};
  for (std::size_t f = 0; f + 1 < seen.faces.size(); ++f) {
    const std::array pair{&seen.faces[f], &seen.faces[f + 1]};
    const auto numbers = [&](std::size_t k) -> const auto& {
      return seen.numbering.of_face[pair[k]->face.value];
    };
    FaceTriangulation empty;
    std::vector<CellFace> faces{{&empty, {}, 0}};
    for (std::size_t k = 0; k < 2; ++k)
      faces.push_back(
          {pair[k], numbers(k), side_of(*pair[k], numbers(k), numbers(1 - k)[0], seen.numbering)});
    const auto layer = build_layer_cell(faces, seen.numbering.points);
    REQUIRE(layer);
    CHECK(verify(layer->complex));
    CellTriangulation triangulation(faces.size());
    REQUIRE(triangulation.add(faces, seen.numbering.points).ok());
    const auto built = build_cell(faces, triangulation, no_lines, seen.numbering.graph_vertex);
    REQUIRE(built.ok());
    CHECK(layer->vertices == built->vertices);
    REQUIRE(layer->points.size() == built->points.size());
    for (std::size_t v = 0; v < built->points.size(); ++v) CHECK(equal(layer->points[v], built->points[v]));
    CHECK(layer->complex.face_masks == built->complex.face_masks);
    CHECK(kinds_of(layer->complex) == kinds_of(built->complex));
    CHECK(ground_of(*layer) == ground_of(*built));
  }
}

TEST_CASE("kinds tell cells apart, but the order of tetrahedra and of their vertices does not") {
  CellComplex cell;
  cell.mesh.vertices = {{0, 1, 2, 3}, {4, 3, 2, 1}};
  cell.facets = {{FacetKind::internal, FacetKind::free, FacetKind::free, FacetKind::free}, {}};
  cell.edges.resize(2);
  cell.edges[1][4] = EdgeKind::contour;  // between 3 and 1
  CellComplex same;
  same.mesh.vertices = {{3, 1, 4, 2}, {2, 0, 3, 1}};
  same.facets = {{}, {FacetKind::free, FacetKind::internal, FacetKind::free, FacetKind::free}};
  same.edges.resize(2);
  same.edges[0][0] = EdgeKind::contour;
  CHECK(kinds_of(cell) == kinds_of(same));
  same.edges[0][0] = EdgeKind::external;
  CHECK(kinds_of(cell) != kinds_of(same));
  same.edges[0][0] = EdgeKind::contour;
  same.facets[1][1] = FacetKind::external;
  CHECK(kinds_of(cell) != kinds_of(same));
}

TEST_CASE("layer cells: only two faces, without a common vertex, that span areas") {
  Faces seen;
  REQUIRE(reconstruct(stack(-0.3, 0.3, 3), {}, {}, &seen).ok());
  REQUIRE(seen.faces.size() == 3);
  std::vector<CellFace> faces;
  for (const FaceTriangulation& face : seen.faces)
    faces.push_back({&face, seen.numbering.of_face[face.face.value], 0});
  const auto& points = seen.numbering.points;
  CHECK_FALSE(build_layer_cell(faces, points));
  CHECK_FALSE(build_layer_cell(std::vector{faces[0]}, points));
  CHECK_FALSE(build_layer_cell(std::vector{faces[0], faces[0]}, points));
  FaceTriangulation bare;
  CHECK_FALSE(build_layer_cell(std::vector{faces[0], CellFace{&bare, faces[1].numbers, 0}}, points));
}
