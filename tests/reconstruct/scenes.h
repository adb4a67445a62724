#pragma once
/// What the tests of the pipeline share: scenes of the examples, rearrangements that must not matter.

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

#include "../../io/read_sections.h"
#include "../../reconstruct/reconstruct.h"
#include "result_hash.h"

namespace crossloft::test {

/// By its path below the source tree's examples/.
inline Sections load(const std::string& name, const std::string& folder = "/examples/") {
  auto sections = read_sections(CROSSLOFT_SOURCE_DIR + folder + name);
  REQUIRE(sections.ok());
  return std::move(sections).value();
}

/// The same sections told differently: planes, vertices and edges shuffled, edges reversed, normals flipped.
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
