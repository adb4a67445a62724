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
  // One draw a statement: compilers differ in the order in which they evaluate factors.
  const Vec3 aside = random.direction();
  const Vec3 shift = random.uniform(0, size) * aside;
  const double stretch = random.uniform(-size, size) / radius;
  const Vec3 wave = random.direction(), along = random.direction();
  const Vec3 sway = random.uniform(0, size) * along;
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

/// Set k of an endless series: four solids; sweeps, planes of two directions, pencils with parallel planes
/// and 14 to 20 random planes; disturbed by 3e-4 to 3 % of the diagonal. Empty if the planes can't be cut.
inline Sections disturbed_set(std::uint64_t k) {
  const Surface solid = k % 4 == 0   ? genus2_solid(24)
                        : k % 4 == 1 ? nested_shells(24)
                        : k % 4 == 2 ? demo_solid(24)
                                     : trefoil_solid(24);
  const Bounds box = bounds_of(solid.points);
  const auto n = static_cast<std::uint32_t>(k);
  std::vector<CuttingPlane> planes, others;
  switch (k / 4 % 4) {
    case 0:
      planes = fan_planes(box, 10 + n % 7, k);
      break;
    case 1:
      planes = parallel_planes(box, 4 + n % 4), others = parallel_planes(box, 4 + n % 3, {1, 0, 0});
      break;
    case 2:
      planes = rotational_planes(box, 4 + n % 5), others = parallel_planes(box, 3 + n % 3);
      break;
    default:
      planes = random_planes(box, 14 + n % 7, k);
  }
  planes.insert(planes.end(), others.begin(), others.end());
  const auto sections = slice(solid, planes);
  constexpr double kFractions[]{3e-4, 3e-3, 0.01, 0.03};
  return sections ? jittered(*sections, k, kFractions[k / 16 % 4]) : Sections{};
}

}  // namespace crossloft::test
