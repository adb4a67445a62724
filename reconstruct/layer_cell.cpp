#include "layer_cell.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "../delaunay/between_planes.h"

namespace crossloft {
namespace {

using FacePair = std::array<std::uint32_t, 2>;

std::optional<FacePair> two_faces(std::span<const CellFace> faces) {
  FacePair pair{};
  std::size_t count = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (faces[f].numbers.empty()) continue;
    if (count == 2 || faces[f].triangulation->triangles.empty()) return std::nullopt;
    pair[count++] = f;
  }
  return count == 2 ? std::optional(pair) : std::nullopt;
}

class LayerBuilder {
 public:
  LayerBuilder(std::span<const CellFace> faces, const FacePair& pair) : faces_(faces), pair_(pair) {}
  std::optional<BuiltCell> run(std::span<const LatticePoint> points);

 private:
  bool merge_vertices(std::span<const LatticePoint> points);
  void classify(std::span<const std::array<std::uint32_t, 2>> edges);
  void classify_triangles(std::size_t side, std::uint32_t base);

  const FaceTriangulation& face(std::size_t side) const { return *faces_[pair_[side]].triangulation; }
  /// Seen from within the cell.
  bool is_clockwise(std::size_t side) const { return faces_[pair_[side]].side == 0; }

  std::span<const CellFace> faces_;
  FacePair pair_;
  BuiltCell cell_;
  std::array<std::vector<std::uint32_t>, 2>
      numbers_;  ///< by local vertex of the face: its vertex in the cell
};

/// Local vertices by their numbers; nothing if they are in that order, as most are but for splits and
/// samples.
std::vector<std::uint32_t> order_of(std::span<const std::uint32_t> numbers) {
  std::vector<std::uint32_t> order;
  if (std::is_sorted(numbers.begin(), numbers.end())) return order;
  order.resize(numbers.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return numbers[a] < numbers[b]; });
  return order;
}

/// False if the faces share one.
bool LayerBuilder::merge_vertices(std::span<const LatticePoint> points) {
  const std::array<std::span<const std::uint32_t>, 2> lists{faces_[pair_[0]].numbers,
                                                            faces_[pair_[1]].numbers};
  const std::array<std::vector<std::uint32_t>, 2> orders{order_of(lists[0]), order_of(lists[1])};
  const auto local = [&](std::size_t side, std::size_t at) {
    return orders[side].empty() ? static_cast<std::uint32_t>(at) : orders[side][at];
  };
  const std::size_t size = lists[0].size() + lists[1].size();
  CellComplex& complex = cell_.complex;
  complex.vertex_count = static_cast<std::uint32_t>(size);
  complex.words = static_cast<std::uint32_t>((faces_.size() + 63) / 64);
  complex.face_masks.assign(size * complex.words, 0);
  cell_.vertices.reserve(size);
  cell_.points.reserve(size);
  for (std::size_t side = 0; side < 2; ++side) numbers_[side].resize(lists[side].size());
  std::array<std::size_t, 2> at{};
  const auto next = [&](std::size_t side) {
    return at[side] < lists[side].size() ? lists[side][local(side, at[side])] : kNone;
  };
  for (std::uint32_t v = 0; v < size; ++v) {
    const std::uint32_t first = next(0), second = next(1);
    if (first == second) return false;
    const std::size_t side = first < second ? 0 : 1, f = pair_[side];
    numbers_[side][local(side, at[side]++)] = v;
    complex.face_masks[std::size_t{v} * complex.words + f / 64] = std::uint64_t{1} << (f % 64);
    cell_.vertices.push_back(std::min(first, second));
  }
  // By itself, as each is a miss of the cache: they don't wait for each other so.
  for (const std::uint32_t number : cell_.vertices) cell_.points.push_back(points[number]);
  return true;
}

/// Those that stand on a face's triangles.
void LayerBuilder::classify_triangles(std::size_t side, std::uint32_t base) {
  const FaceTriangulation& from = face(side);
  const bool turned = is_clockwise(side);
  for (std::uint32_t i = 0; i < from.triangles.size(); ++i) {
    const bool inside = from.internal[i] != 0;
    cell_.complex.facets[base + i][3] = inside ? FacetKind::internal : FacetKind::external;
    if (inside) cell_.ground.push_back({pair_[side], i});
    const auto& sides = from.sides[i];
    auto& kinds = cell_.complex.edges[base + i];
    kinds[0] = from.edges[sides[turned ? 1 : 2]].kind;  // corners 0 and 1, opposite to the last one
    kinds[1] = from.edges[sides[turned ? 2 : 1]].kind;
    kinds[3] = from.edges[sides[0]].kind;
  }
}

void LayerBuilder::classify(std::span<const std::array<std::uint32_t, 2>> edges) {
  CellComplex& complex = cell_.complex;
  complex.facets.assign(complex.mesh.size(), {});
  complex.edges.assign(complex.mesh.size(), {});
  classify_triangles(0, 0);
  const auto first = static_cast<std::uint32_t>(face(0).triangles.size());
  classify_triangles(1, first);
  std::size_t t = first + face(1).triangles.size();
  for (const auto& pair : edges) {
    complex.edges[t][0] = face(0).edges[pair[0]].kind;
    complex.edges[t++][5] = face(1).edges[pair[1]].kind;
  }
}

std::optional<BuiltCell> LayerBuilder::run(std::span<const LatticePoint> points) {
  if (!merge_vertices(points)) return std::nullopt;
  std::array<PlaneSide, 2> planes;
  for (std::size_t side = 0; side < 2; ++side)
    planes[side] = {face(side).triangles, face(side).sides,
                    static_cast<std::uint32_t>(face(side).edges.size()), numbers_[side], is_clockwise(side)};
  BetweenPlanes between;
  if (!delaunay_between_planes(cell_.points, planes, between)) return std::nullopt;
  cell_.complex.mesh = std::move(between.mesh);
  classify(between.edges);
  return std::move(cell_);
}

}  // namespace

std::optional<BuiltCell> build_layer_cell(std::span<const CellFace> faces,
                                          std::span<const LatticePoint> points) {
  const auto pair = two_faces(faces);
  if (!pair) return std::nullopt;
  return LayerBuilder(faces, *pair).run(points);
}

}  // namespace crossloft
