#pragma once
/// Stacks of circles: a column, and bodies that end beside it.

#include <cmath>
#include <cstdint>

#include "../../arrangement/sections.h"

namespace crossloft::test {

inline constexpr double kApart = 3;  ///< planes of column_and_short_one()

inline void add_circle(PlaneSection& plane, double x, double radius, std::uint32_t corners,
                       std::uint32_t contour) {
  const auto first = static_cast<std::uint32_t>(plane.vertices.size());
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    plane.vertices.push_back({x + radius * std::cos(angle), radius * std::sin(angle), -plane.offset});
    plane.edges.push_back({first + i, first + (i + 1) % corners, 1, 0, contour});
  }
}

/// A column by some planes, and beside it, at x, a thin one in those from `first` to `last`.
inline Sections column_and_short_one(double x, std::uint32_t first, std::uint32_t last,
                                     std::uint32_t planes = 8) {
  Sections sections;
  for (std::uint32_t k = 0; k < planes; ++k) {
    PlaneSection plane;
    plane.normal = {0, 0, 1};
    plane.offset = -kApart * k;
    add_circle(plane, 0, 20, 60, 0);
    if (k >= first && k <= last) add_circle(plane, x, 2, 12, 1);
    sections.planes.push_back(plane);
  }
  return sections;
}

/// Far above: the branching diagram between the two gives samples.
inline void add_ring_and_disk(Sections& sections, double x) {
  const double high = 39 - sections.planes.back().offset;
  for (const bool disk : {false, true}) {
    PlaneSection plane;
    plane.normal = {0, 0, 1};
    plane.offset = disk ? -high - 2 : -high;
    add_circle(plane, x, disk ? 18 : 20, 90, 0);
    if (!disk) add_circle(plane, x, 8, 90, 1);
    sections.planes.push_back(plane);
  }
}

}  // namespace crossloft::test
