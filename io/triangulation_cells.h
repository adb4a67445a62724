#pragma once
/// The simplices of a triangulation of any dimension, one after the other, seen where they are stored.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "../delaunay/triangulation.h"

namespace crossloft {

/// The points (K = 1) or the edges (K = 2) along a chain of vertices.
template <std::size_t K>
struct ChainCells {
  std::span<const std::uint32_t> chain;

  std::size_t size() const { return chain.size() < K ? 0 : chain.size() - (K - 1); }
  std::array<std::uint32_t, K> operator[](std::size_t i) const {
    std::array<std::uint32_t, K> corners{};
    for (std::size_t k = 0; k < K; ++k) corners[k] = chain[i + k];
    return corners;
  }
};

/// visit(cells) with the tetrahedra, triangles, edges or the one point of the triangulation, by its dimension
/// (no points for -1). cells.size() is their number, cells[i] an array of their vertices.
template <class Visit>
auto visit_cells(const Triangulation& triangulation, Visit&& visit) {
  if (triangulation.dimension == 3) return visit(std::span(triangulation.tets.vertices));
  if (triangulation.dimension == 2) return visit(std::span(triangulation.triangles.vertices));
  if (triangulation.dimension == 1) return visit(ChainCells<2>{triangulation.chain});
  return visit(ChainCells<1>{triangulation.chain});
}

}  // namespace crossloft
