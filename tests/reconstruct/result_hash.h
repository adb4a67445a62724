#pragma once
/// A hash by which two results can be told apart; for tests and benchmarks.

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "../../reconstruct/reconstruct.h"

namespace crossloft::test {

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

}  // namespace crossloft::test
