#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "triangulation.h"

namespace crossloft {
namespace {

/// Vertices ascending by exchanges of two, neighbours along with them; an odd number of exchanges is made even.
template <std::size_t N>
void sort_slots(std::array<std::uint32_t, N>& vertices, std::array<std::uint32_t, N>& neighbours) {
  bool odd = false;
  const auto exchange = [&](std::size_t a, std::size_t b) {
    std::swap(vertices[a], vertices[b]);
    std::swap(neighbours[a], neighbours[b]);
    odd = !odd;
  };
  for (std::size_t k = 1; k < N; ++k)
    for (std::size_t at = k; at > 0 && vertices[at] < vertices[at - 1]; --at) exchange(at, at - 1);
  if (odd) exchange(N - 2, N - 1);
}

/// The simplices in the order of their vertices: counted by the first, sorted among few.
template <std::size_t N>
std::vector<std::uint32_t> sorted(const std::vector<std::array<std::uint32_t, N>>& vertices,
                                  std::size_t vertex_count) {
  std::vector<std::uint32_t> begin(vertex_count + 1, 0), at(vertices.size());
  for (const auto& v : vertices) ++begin[v[0] + 1];
  for (std::size_t k = 1; k <= vertex_count; ++k) begin[k] += begin[k - 1];
  for (std::uint32_t s = 0; s < vertices.size(); ++s) at[begin[vertices[s][0]]++] = s;
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return vertices[a] < vertices[b]; };
  std::size_t from = 0;
  for (std::size_t k = 0; k < vertex_count; ++k) {  // begin[k] is by now where the next vertex begins
    std::sort(at.begin() + static_cast<std::ptrdiff_t>(from), at.begin() + begin[k], before);
    from = begin[k];
  }
  return at;
}

template <std::size_t N>
void sort_mesh(std::vector<std::array<std::uint32_t, N>>& vertices,
               std::vector<std::array<std::uint32_t, N>>& neighbours, std::size_t vertex_count) {
  for (std::size_t s = 0; s < vertices.size(); ++s) sort_slots(vertices[s], neighbours[s]);
  std::vector<std::uint32_t> number(vertices.size());
  {
    const std::vector<std::uint32_t> at = sorted(vertices, vertex_count);
    for (std::uint32_t k = 0; k < at.size(); ++k) number[at[k]] = k;
  }
  for (auto& simplex : neighbours)
    for (std::uint32_t& n : simplex)
      if (n != kNone) n = number[n];
  for (std::uint32_t s = 0; s < number.size(); ++s)  // each exchange brings one simplex home
    while (number[s] != s) {
      const std::uint32_t home = number[s];
      std::swap(vertices[s], vertices[home]);
      std::swap(neighbours[s], neighbours[home]);
      std::swap(number[s], number[home]);
    }
}

}  // namespace

void sort_simplices(Triangulation& triangulation) {
  const std::size_t count = triangulation.kept.size();
  sort_mesh(triangulation.tets.vertices, triangulation.tets.neighbours, count);
  sort_mesh(triangulation.triangles.vertices, triangulation.triangles.neighbours, count);
}

}  // namespace crossloft
