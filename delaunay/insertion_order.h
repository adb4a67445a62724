#pragma once
/// The order in which points are inserted.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/vec3.h"

namespace crossloft {

/// A biased randomised insertion order: rounds that grow by a factor of 8, points drawn by a fixed hash of
/// their index, each round along a Hilbert curve, every other one backwards. Rounds keep the cells made about
/// as many as in a random order for any input; the curve keeps walks and cache misses short, in clusters far
/// smaller than the whole, too: where many points share one of its 2^16 cells an axis, it goes on through a
/// box of their own. Also a good order to store points in. REQUIRES: finite coordinates. Linear time for each
/// factor 2^16 between the sizes of clusters within clusters. Source: Amenta, Choi, Rote, Incremental
/// constructions con BRIO (2003).
std::vector<std::uint32_t> insertion_order(std::span<const std::array<double, 2>> points);
std::vector<std::uint32_t> insertion_order(std::span<const std::array<double, 3>> points);
/// By several threads.
std::vector<std::uint32_t> insertion_order(std::span<const Vec3> points, unsigned threads = 1);

}  // namespace crossloft
