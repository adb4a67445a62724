#include "cell_triangulation.h"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "../geom/disjoint_sets.h"
#include "rising_search.h"
#include "self_check.h"

namespace crossloft {
namespace {

/// REQUIRES: `sorted` ascending. Most faces have their vertices in order, and then those that were added.
void merge_into(std::vector<std::uint32_t>& sorted, std::span<const std::uint32_t> numbers) {
  const auto size = static_cast<std::ptrdiff_t>(sorted.size());
  sorted.insert(sorted.end(), numbers.begin(), numbers.end());
  const auto middle = sorted.begin() + size;
  const auto added = std::is_sorted_until(middle, sorted.end());
  std::sort(added, sorted.end());
  std::inplace_merge(middle, added, sorted.end());
  std::inplace_merge(sorted.begin(), middle, sorted.end());
}

}  // namespace

bool CellPredicates::collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  int shared = 0;
  for (std::uint32_t w = 0; w < v_->words; ++w)
    shared += __builtin_popcountll(v_->mask(a, w) & v_->mask(b, w) & v_->mask(c, w));
  return shared >= 2 || crossloft::collinear(v_->points[a], v_->points[b], v_->points[c]);
}

/// What has come since there were `first` vertices.
Result<Done> CellTriangulation::insert_from(std::uint32_t first) {
  predicates_.see_vertices();
  if (first == 0)
    delaunay_.build();
  else
    delaunay_.extend(first);
  return self_check("Delaunay of a cell", [&] { return delaunay_.verify(); });
}

Result<Done> CellTriangulation::add(std::span<const CellFace> faces, std::span<const LatticePoint> points) {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::uint32_t> known = vertices_.numbers, wanted, added;
  std::sort(known.begin(), known.end());
  for (const CellFace& face : faces) merge_into(wanted, face.numbers);
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  std::set_difference(wanted.begin(), wanted.end(), known.begin(), known.end(), std::back_inserter(added));
  const std::uint32_t first = vertices_.size();
  for (const std::uint32_t number : added) {
    vertices_.numbers.push_back(number);
    vertices_.points.push_back(points[number]);
  }
  vertices_.face_masks.resize(vertices_.numbers.size() * vertices_.words, 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    RisingSearch search(added);
    for (const std::uint32_t number : faces[f].numbers) {
      const std::size_t at = search.lower_bound(number);
      if (at == added.size() || added[at] != number) continue;
      const auto v = first + at;
      vertices_.face_masks[v * vertices_.words + f / 64] |= std::uint64_t{1} << (f % 64);
    }
  }
  auto done = insert_from(first);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return done;
}

Result<Done> CellTriangulation::add_inside(std::span<const LatticePoint> points,
                                           std::span<const std::uint32_t> numbers) {
  if (points.empty()) return Done{};
  const auto begin = std::chrono::steady_clock::now();
  inside_count_ += points.size();
  const std::uint32_t first = vertices_.size();
  vertices_.first_interior = std::min(vertices_.first_interior, numbers.front());
  vertices_.numbers.insert(vertices_.numbers.end(), numbers.begin(), numbers.end());
  vertices_.points.insert(vertices_.points.end(), points.begin(), points.end());
  vertices_.face_masks.resize(vertices_.numbers.size() * vertices_.words, 0);
  auto done = insert_from(first);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return done;
}

void CellTriangulation::renumber(std::span<const std::uint32_t> new_number) {
  assert(inside_count_ == 0);
  for (std::uint32_t& number : vertices_.numbers) number = new_number[number];
}

bool has_section(std::span<const CellFace> faces) {
  return std::any_of(faces.begin(), faces.end(), [](const CellFace& face) {
    const auto& internal = face.triangulation->internal;
    return std::find(internal.begin(), internal.end(), 1) != internal.end();
  });
}

std::uint32_t section_components(const FaceTriangulation& face) {
  DisjointSets sets(face.vertices.size() + face.added.size());
  std::vector<std::uint8_t> in_section(face.vertices.size() + face.added.size(), 0);
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    if (face.internal[t] == 0) continue;
    const auto& v = face.triangles[t];
    sets.join(v[0], v[1]);
    sets.join(v[0], v[2]);
    for (const std::uint32_t corner : v) in_section[corner] = 1;
  }
  std::uint32_t components = 0;
  for (std::uint32_t v = 0; v < in_section.size(); ++v) components += in_section[v] & sets.is_root(v);
  return components;
}

bool is_somewhere_bare(std::span<const CellFace> faces) {
  for (const CellFace& face : faces)
    for (std::size_t t = 0; t < face.triangulation->internal.size(); ++t)
      if (face.triangulation->internal[t] != 0 && !face.covers(t)) return true;
  return false;
}

}  // namespace crossloft
