#pragma once
/// The same sections told differently.

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "../../arrangement/sections.h"

namespace crossloft::test {

/// Planes, vertices and edges shuffled, edges reversed, normals flipped.
inline Sections shuffled(Sections s, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto shuffle = [&](auto& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random() % i]);
  };
  shuffle(s.planes);
  for (PlaneSection& plane : s.planes) {
    if (random() % 2 != 0) plane.normal = -plane.normal, plane.offset = -plane.offset;
    std::vector<std::uint32_t> order(plane.vertices.size()), number(plane.vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    shuffle(order);
    std::vector<Vec3> moved(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) moved[i] = plane.vertices[order[i]], number[order[i]] = i;
    plane.vertices = moved;
    for (ContourEdge& e : plane.edges) {
      e.a = number[e.a], e.b = number[e.b];
      if (random() % 2 != 0) std::swap(e.a, e.b), std::swap(e.material_a, e.material_b);
    }
    shuffle(plane.edges);
  }
  return s;
}

}  // namespace crossloft::test
