#include "sort_quadruples.h"

#include <algorithm>
#include <vector>

#include "../geom/parallel.h"
#include "../geom/unset_vector.h"

namespace crossloft {
namespace {

using Quadruple = std::array<std::uint32_t, 4>;

/// First numbers that are told apart together: what they have, some four items each, stays in a cache.
constexpr unsigned kFirstsBits = 10;
constexpr std::size_t kFirsts = std::size_t{1} << kFirstsBits;
/// Items that are counted and put into place by one task.
constexpr std::size_t kPart = std::size_t{1} << 16;

/// Of the same first number.
bool is_before(const Quadruple& t, const Quadruple& u) {
  const auto both = [](const Quadruple& x) { return std::uint64_t{x[1]} << 32 | x[2]; };
  return both(t) != both(u) ? both(t) < both(u) : t[3] < u[3];
}

/// [part][block] to where the part's first item of the block goes in that block; returns how many each has.
std::vector<std::uint32_t> counts_to_places(std::vector<std::uint32_t>& counts, std::size_t blocks) {
  std::vector<std::uint32_t> size(blocks, 0);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const std::uint32_t count = counts[k];
    counts[k] = size[k % blocks];
    size[k % blocks] += count;
  }
  return size;
}

/// From one block into order at another place.
void sort_block(std::span<const Quadruple> from, std::span<Quadruple> to) {
  const auto key = [](const Quadruple& t) { return t[0] & (kFirsts - 1); };
  std::array<std::uint32_t, kFirsts> end{};
  for (const Quadruple& t : from) ++end[key(t)];
  std::uint32_t sum = 0;
  for (std::uint32_t& e : end) {
    const std::uint32_t count = e;
    e = sum;
    sum += count;
  }
  for (const Quadruple& t : from) to[end[key(t)]++] = t;
  std::uint32_t first = 0;
  for (const std::uint32_t last : end) {
    std::sort(to.begin() + first, to.begin() + last, is_before);
    first = last;
  }
}

}  // namespace

/// By blocks of first numbers, then by first numbers, then the few of each by the rest: straight away by
/// first numbers each step would be a miss of the cache, which took several times as long. Each block has
/// memory of its own: there is enough of that size, given back by cells, but one array would be new.
void sort_quadruples(std::span<Quadruple> items, std::size_t firsts, const Context& context) {
  const std::size_t count = (firsts >> kFirstsBits) + 1, parts = (items.size() + kPart - 1) / kPart;
  std::vector<std::uint32_t> places(parts * count, 0);
  const auto for_parts = [&](const auto& work) {
    return parallel_for(parts, context, "gluing", [&](std::size_t p) {
      std::uint32_t* const of_part = places.data() + p * count;
      for (const Quadruple& t : items.subspan(p * kPart, std::min(kPart, items.size() - p * kPart)))
        work(t, of_part, t[0] >> kFirstsBits);
    });
  };
  if (!for_parts([](const Quadruple&, std::uint32_t* counts, std::size_t b) { ++counts[b]; })) return;
  const std::vector<std::uint32_t> size = counts_to_places(places, count);
  std::vector<UnsetVector<Quadruple>> blocks(count);
  std::vector<std::size_t> begin(count + 1, 0);
  for (std::size_t b = 0; b < count; ++b) blocks[b].resize(size[b]), begin[b + 1] = begin[b] + size[b];
  const auto put = [&](const Quadruple& t, std::uint32_t* place, std::size_t b) {
    blocks[b][place[b]++] = t;
  };
  if (!for_parts(put)) return;
  parallel_for(count, context, "gluing", [&](std::size_t b) {
    sort_block(blocks[b], items.subspan(begin[b], size[b]));
    blocks[b] = {};
  });
}

}  // namespace crossloft
