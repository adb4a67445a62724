#pragma once
/// Sections of solids whose planes have each been disturbed on their own, for the tests of agreement.

#include <cmath>
#include <vector>

#include "../../inspect/random.h"
#include "../../inspect/slice.h"
#include "../../inspect/solids.h"

namespace crossloft::test {

inline Bounds box_of(const Sections& sections) {
  Bounds box;
  for (const PlaneSection& p : sections.planes)
    for (const Vec3& v : p.vertices) box.add(v);
  return box;
}

/// Moves the vertices of a plane within it: a shift, a stretch about the middle and a slow wave, each up to
/// `size` in input units.
inline void jitter(PlaneSection& plane, Random& random, double size) {
  if (plane.vertices.empty()) return;
  const Vec3 n = (1 / norm(plane.normal)) * plane.normal;
  const Vec3 middle = bounds_of(plane.vertices).center();
  const double radius = bounds_of(plane.vertices).diagonal() / 2;
  const Vec3 shift = random.uniform(0, size) * random.direction();
  const double stretch = random.uniform(-size, size) / radius;
  const Vec3 wave = random.direction(), sway = random.uniform(0, size) * random.direction();
  for (Vec3& v : plane.vertices) {
    const double phase = 3 * dot(wave, v - middle) / radius;
    Vec3 d = shift + stretch * (v - middle) + std::sin(phase) * sway;
    d = d - dot(n, d) * n;
    v = v + d;
  }
}

inline Sections jittered(Sections sections, std::uint64_t seed, double fraction) {
  Random random(seed);
  const double size = fraction * box_of(sections).diagonal();
  for (PlaneSection& p : sections.planes) jitter(p, random, size);
  return sections;
}

}  // namespace crossloft::test
