#pragma once
/// Space divided among threads that insert into one triangulation.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "simplex_store.h"

namespace crossloft::detail {

/// Boxes with about equally many points each: space is cut at quantiles of a sample, box by box, along the
/// longest side of those that were cut least often before: so divisions one after the other have their
/// borders elsewhere.
class Division {
 public:
  /// By box and axis: how often it was cut.
  using Cuts = std::vector<std::array<unsigned, 3>>;

  /// REQUIRES: some points, parts >= 1; `cuts` empty or those of divisions into as many parts.
  template <class P>
  Division(const P& points, const std::vector<std::uint32_t>& of, std::uint32_t parts, Cuts& cuts);

  template <class P>
  std::uint32_t part_of(const P& points, std::uint32_t i) const {
    std::uint32_t node = 0;
    while (nodes_[node].parts > 1) {
      const Node& n = nodes_[node];
      node = n.low + (points.coordinate(i, n.axis) < n.at ? 0 : 1);
    }
    return nodes_[node].first_part;
  }

 private:
  static constexpr std::size_t kSample = 4096;

  /// A box: a part, or cut in two, below and above `at`.
  struct Node {
    std::uint32_t first_part, parts;
    std::size_t begin, end;  ///< its points of the sample
    std::uint32_t low = 0;   ///< the lower half, followed by the upper one
    int axis = 0;
    double at = 0;
  };
  template <class P>
  void cut(const P& points, std::vector<std::uint32_t>& sample, std::uint32_t node,
           std::array<unsigned, 3>& cuts);

  std::vector<Node> nodes_;
};

template <class P>
Division::Division(const P& points, const std::vector<std::uint32_t>& of, std::uint32_t parts, Cuts& cuts) {
  std::vector<std::uint32_t> sample;
  const std::size_t step = std::max<std::size_t>(1, of.size() / kSample);
  for (std::size_t k = 0; k < of.size(); k += step) sample.push_back(of[k]);
  nodes_.push_back({0, parts, 0, sample.size()});
  cuts.resize(2 * std::size_t{parts});
  for (std::uint32_t node = 0; node < nodes_.size(); ++node)
    if (nodes_[node].parts > 1) cut(points, sample, node, cuts[node]);
}

template <class P>
void Division::cut(const P& points, std::vector<std::uint32_t>& sample, std::uint32_t node,
                   std::array<unsigned, 3>& cuts) {
  Node& n = nodes_[node];
  const auto begin = sample.begin() + static_cast<std::ptrdiff_t>(n.begin);
  const auto end = sample.begin() + static_cast<std::ptrdiff_t>(n.end);
  std::array<int, 3> axes{0, 1, 2};
  std::array<double, 3> side{};
  for (const int axis : axes) {
    double low = 0, high = 0;
    for (auto i = begin; i != end; ++i) {
      const double c = points.coordinate(*i, axis) / 2;  // halves: no overflow
      low = i == begin ? c : std::min(low, c);
      high = i == begin ? c : std::max(high, c);
    }
    side[static_cast<std::size_t>(axis)] = high - low;
  }
  n.axis = *std::min_element(axes.begin(), axes.end(), [&](int first, int second) {
    const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
    return cuts[a] != cuts[b] ? cuts[a] < cuts[b] : side[a] > side[b];
  });
  ++cuts[static_cast<std::size_t>(n.axis)];
  const std::uint32_t low_parts = n.parts / 2;
  const std::size_t middle = n.begin + (n.end - n.begin) * low_parts / n.parts;
  if (begin != end) {
    const auto at = sample.begin() + static_cast<std::ptrdiff_t>(middle);
    std::nth_element(begin, at, end, [&](std::uint32_t a, std::uint32_t b) {
      return points.coordinate(a, n.axis) < points.coordinate(b, n.axis);
    });
    n.at = points.coordinate(*at, n.axis);
  }
  n.low = static_cast<std::uint32_t>(nodes_.size());
  const Node low{n.first_part, low_parts, n.begin, middle};
  const Node high{n.first_part + low_parts, n.parts - low_parts, middle, n.end};
  nodes_.push_back(low);
  nodes_.push_back(high);
}

/// What one inserter may change while others are at work: the cells whose vertices all belong to its part.
///
/// *Why no two inserters meet.* A cell is owned by at most one inserter, for as long as the parts stay as
/// they are, since its vertices never change. An inserter reads the vertices of the cells around those that
/// it owns; they share two finite vertices with an owned one, so they are not wholly another's: nobody
/// changes their vertices or marks. It writes into such a cell only the neighbour across a facet of an owned
/// cell, and reads of it only the neighbour across the hull facet of a ghost (Inserter::in_conflict), behind
/// which two vertices are its own.
struct Territory {
  static constexpr bool kBounded = true;
  const std::vector<std::uint16_t>* part_of = nullptr;  ///< by vertex
  std::uint16_t mine = 0;

  bool owns(std::uint32_t vertex) const { return vertex == kGhost || (*part_of)[vertex] == mine; }
  template <std::size_t N>
  bool owns(const std::array<std::uint32_t, N>& vertices) const {
    return std::all_of(vertices.begin(), vertices.end(), [this](std::uint32_t v) { return owns(v); });
  }
};

}  // namespace crossloft::detail
