#pragma once
/// Inputs for predicates, by distribution: what the benchmarks time and the tests check the strategies on.
/// All are functions of a seed, the same on every machine.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../geom/lattice.h"
#include "../geom/strategies/extent.h"
#include "../geom/vec2.h"
#include "../geom/weighted_point.h"

namespace crossloft::bench {

using PlanarCase = std::array<Vec2, 4>;
using SpaceCase = std::array<WeightedPoint, 5>;
struct LatticeCase {
  LatticePlane plane;                    ///< holds all of in_plane
  std::array<LatticePoint, 4> in_plane;  ///< for orient2d and incircle
  std::array<LatticePoint, 5> points;    ///< for orient3d, insphere and side_of_plane
  std::array<LatticePlane, 4> planes;    ///< for side_of_meet
};

template <class Case>
struct CaseSet {
  std::string name;
  std::vector<Case> cases;
};

inline void include_case(strategies::ExtentBuilder& builder, const PlanarCase& c) {
  for (const Vec2& p : c) builder.include(p);
}
inline void include_case(strategies::ExtentBuilder& builder, const SpaceCase& c) {
  for (const WeightedPoint& p : c) builder.include(p);
}
inline void include_case(strategies::ExtentBuilder& builder, const LatticeCase& c) {
  builder.include(c.plane);
  for (const LatticePoint& p : c.in_plane) builder.include(p);
  for (const LatticePoint& p : c.points) builder.include(p);
  for (const LatticePlane& p : c.planes) builder.include(p);
}

template <class Case>
strategies::Extent extent_of(const std::vector<Case>& cases) {
  strategies::ExtentBuilder builder;
  for (const Case& c : cases) include_case(builder, c);
  return builder.extent();
}

/// Named distributions of `count` cases each. Points of different cases may be the same.
std::vector<CaseSet<PlanarCase>> planar_cases(std::size_t count, std::uint64_t seed);
/// Weights are small multiples of a like size to the coordinates' squares; `contours` are points in the order
/// of their contours, empty for none.
std::vector<CaseSet<SpaceCase>> space_cases(std::size_t count, std::uint64_t seed,
                                            const std::vector<Vec3>& contours);
/// Rational points live in `store`.
std::vector<CaseSet<LatticeCase>> lattice_cases(std::size_t count, std::uint64_t seed,
                                                LatticePointStore& store);

}  // namespace crossloft::bench
