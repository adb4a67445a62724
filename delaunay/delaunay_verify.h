#pragma once
/// The invariants of a triangulation, for the plane and for space.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "delaunay_core.h"

namespace crossloft::detail {

/// The facet's vertices as a set: sorted.
template <std::size_t D>
std::array<std::uint32_t, D> facet_vertices(const SimplexStore<D>& cells, Facet f) {
  std::array<std::uint32_t, D> facet{};
  std::size_t size = 0;
  for (std::size_t slot = 0; slot <= D; ++slot)
    if (slot != f.slot()) facet[size++] = cells.vertices(f.cell())[slot];
  std::sort(facet.begin(), facet.end());
  return facet;
}

template <std::size_t D, class P>
const char* broken_facet(const DelaunayCore<D, P>& core, Facet f) {
  const auto& cells = core.cells();
  const Facet back = cells.across(f);
  if (back.cell() >= cells.size() || cells.is_free(back.cell())) return "neighbour is no cell";
  if (cells.across(back) != f) return "neighbours are not symmetric";
  if (facet_vertices(cells, f) != facet_vertices(cells, back)) return "neighbours share no facet";
  const std::uint32_t apex = cells.vertices(f.cell())[f.slot()];
  if (apex != kGhost && core.in_conflict(back.cell(), apex)) return "facet is not locally Delaunay";
  return nullptr;
}

template <std::size_t D, class P>
const char* broken_cell(const DelaunayCore<D, P>& core, std::uint32_t cell) {
  const auto& v = core.cells().vertices(cell);
  for (std::size_t slot = 0; slot < D; ++slot)
    if (v[slot] == kGhost) return "ghost out of its slot";
  if (v[D] != kGhost && orient(core.predicates(), v) <= 0) return "cell is not positive";
  for (std::size_t slot = 0; slot <= D; ++slot)
    if (const char* broken = broken_facet(core, {cell, slot})) return broken;
  return nullptr;
}

/// Every hidden site is above the hull. REQUIRES: the rest is sound.
template <std::size_t D, class P>
std::string wrongly_hidden(const DelaunayCore<D, P>& core) {
  for (std::uint32_t i = 0; i < core.predicates().size(); ++i)
    if (core.kept(i) == kNone && !core.is_hidden(i)) return "site " + std::to_string(i) + ": wrongly hidden";
  return "";
}

template <std::size_t D, class P>
std::string verify(const DelaunayCore<D, P>& core) {
  if (core.dimension() < static_cast<int>(D))
    return core.cells().size() ? "cells without full dimension" : "";
  std::vector<bool> seen;
  std::uint32_t count = 0;
  for (std::uint32_t cell = 0; cell < core.cells().size(); ++cell) {
    if (core.cells().is_free(cell)) continue;
    if (const char* broken = broken_cell(core, cell)) return "cell " + std::to_string(cell) + ": " + broken;
    for (const std::uint32_t v : core.cells().vertices(cell)) {
      if (v == kGhost) continue;
      if (v >= seen.size()) seen.resize(std::size_t{v} + 1);
      count += !seen[v];
      seen[v] = true;
    }
  }
  seen.resize(core.predicates().size());
  for (std::uint32_t i = 0; i < seen.size(); ++i)
    if (core.kept(i) == i && !seen[i]) return "point " + std::to_string(i) + " is no vertex";
  if (count != core.vertex_count()) return "vertices are miscounted";
  if constexpr (HasHeights<P>) return wrongly_hidden(core);
  return "";
}

}  // namespace crossloft::detail
