#pragma once
/// What the tests of the pipeline share: scenes of the examples, rearrangements that must not matter, hashes of results.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <string>

#include "../../io/read_sections.h"
#include "../../reconstruct/reconstruct.h"

namespace crossloft::test {

/// By its path below the source tree's examples/.
inline Sections load(const std::string& name, const std::string& folder = "/examples/") {
  auto sections = read_sections(CROSSLOFT_SOURCE_DIR + folder + name);
  REQUIRE(sections.ok());
  return std::move(sections).value();
}

/// FNV-1a over the bytes of numbers.
class Hash {
 public:
  template <class T>
  void add(const T& value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char b : bytes) state_ = (state_ ^ b) * 0x100000001B3ull;
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xCBF29CE484222325ull;
};

/// Of everything geometric in a result: surface, solid and sections, bit by bit.
inline std::uint64_t hash(const Reconstruction& r) {
  Hash h;
  const auto point = [&](const Vec3& p) { h.add(p.x), h.add(p.y), h.add(p.z); };
  std::for_each(r.surface.points.begin(), r.surface.points.end(), point);
  for (const auto& t : r.surface.triangles) h.add(t);
  std::for_each(r.solid.points.begin(), r.solid.points.end(), point);
  for (const auto& t : r.solid.tets) h.add(t);
  for (const PlaneSection& p : r.sections.planes) {
    std::for_each(p.vertices.begin(), p.vertices.end(), point);
    for (const ContourEdge& e : p.edges) h.add(e.a), h.add(e.b);
  }
  return h.value();
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
