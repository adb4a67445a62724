#pragma once
/// Points and planes for the predicate tests: every kind, every size up to the limits, and degenerate sets.

#include <cstdint>
#include <random>
#include <vector>

#include "../../geom/lattice.h"

namespace crossloft::samples {

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in -limit..limit, by remainder: the standard distributions differ between libraries.
  std::int64_t integer(std::int64_t limit) {
    return static_cast<std::int64_t>(engine_() % (2 * static_cast<std::uint64_t>(limit) + 1)) - limit;
  }
  std::size_t index(std::size_t size) { return engine_() % size; }
  bool chance(unsigned percent) { return engine_() % 100 < percent; }
  LatticeVector vector(std::int64_t limit) { return {integer(limit), integer(limit), integer(limit)}; }

  /// Normals up to `normal_limit` in every component; origin within the limit of coordinates.
  LatticePlane plane(std::int64_t normal_limit, std::int64_t coordinate_limit) {
    std::int64_t edge = 1;  // a component of the normal is at most 2 edge^2
    while (2 * (edge * 2) * (edge * 2) <= normal_limit) edge *= 2;
    while (2 * (edge + (edge >> 6)) * (edge + (edge >> 6)) <= normal_limit && edge >= 64) edge += edge >> 6;
    for (;;) {
      const LatticePlane p = make_lattice_plane(vector(coordinate_limit), vector(edge), vector(edge));
      if (p.normal != LatticeVector{0, 0, 0}) return p;
    }
  }

  /// The common point of three planes, or of two and { x_k = t }.
  LatticePoint rational(LatticePointStore& store, std::int64_t normal_limit, std::int64_t coordinate_limit) {
    for (;;) {
      const LatticePlane a = plane(normal_limit, coordinate_limit), b = plane(normal_limit, coordinate_limit);
      const LatticePlane c = chance(50)
                                 ? plane(normal_limit, coordinate_limit)
                                 : make_axis_plane(static_cast<int>(index(3)), integer(coordinate_limit));
      LatticePoint p;
      if (store.meet(a, b, c, p)) return p;
    }
  }

  /// Any kind of point.
  LatticePoint point(LatticePointStore& store, std::int64_t normal_limit, std::int64_t coordinate_limit,
                     unsigned rational_percent) {
    if (chance(rational_percent)) return rational(store, normal_limit, coordinate_limit);
    return make_point(vector(coordinate_limit));
  }

 private:
  std::mt19937_64 engine_;
};

/// A plane near a corner of the lattice's cube, where rounded coordinates are half a unit in the last place
/// off, and points whose ties with it can't be told from these.
class NearPlane {
 public:
  NearPlane(Generator& generator, LatticePointStore& store)
      : generator_(generator), store_(store), around_(corner()) {
    limit_ = generator_.chance(40) ? kNormalLimit : generator_.chance(50) ? std::int64_t{1} << 20 : 20;
    plane_ = around(1);
  }

  const LatticePlane& plane() const { return plane_; }
  /// Rational, on the plane.
  LatticePoint on_plane() { return meet(plane_); }
  /// Rational, on the plane or on one that is parallel to it within two units; or explicit and close by.
  LatticePoint point() {
    if (generator_.chance(33)) {
      const LatticeVector by = generator_.vector(3);
      return make_point({around_[0] + by[0], around_[1] + by[1], around_[2] + 300 * by[2]});
    }
    if (generator_.chance(50)) return on_plane();
    LatticePlane parallel = plane_;
    for (std::size_t k = 0; k < 3; ++k) parallel.origin[k] += generator_.integer(2);
    return meet(parallel);
  }

 private:
  LatticeVector corner() {
    const std::int64_t far = kLatticeLimit - 2000;
    LatticeVector v;
    for (std::int64_t& c : v) c = generator_.chance(50) ? far : -far;
    return v;
  }
  LatticePlane around(std::int64_t origin_limit) {
    LatticePlane p = generator_.plane(limit_, origin_limit);
    for (std::size_t k = 0; k < 3; ++k) p.origin[k] += around_[k];
    return p;
  }
  LatticePoint meet(const LatticePlane& plane) {
    for (;;) {
      LatticePoint p;
      if (store_.meet(plane, around(100), around(100), p)) return p;
    }
  }

  Generator& generator_;
  LatticePointStore& store_;
  LatticeVector around_;
  std::int64_t limit_ = 0;
  LatticePlane plane_;
};

/// Integer points on the sphere of squared radius 3 * 5^2 * 7^2 * 11^2 around `centre`, times `scale`: plenty
/// of exactly cospherical points. Coordinates relative to the centre stay below 668 * scale.
inline std::vector<LatticePoint> cospherical(const LatticeVector& centre, std::int64_t scale) {
  std::vector<LatticePoint> points;
  const std::int64_t square = 3 * 25 * 49 * 121;
  for (std::int64_t x = -667; x <= 667; x += 7)
    for (std::int64_t y = -667; y <= 667; ++y) {
      const std::int64_t rest = square - x * x - y * y;
      if (rest < 0) continue;
      std::int64_t z = 0;
      while (z * z < rest) ++z;
      if (z * z != rest) continue;
      points.push_back(make_point({centre[0] + scale * x, centre[1] + scale * y, centre[2] + scale * z}));
      points.push_back(make_point({centre[0] + scale * x, centre[1] + scale * y, centre[2] - scale * z}));
    }
  return points;
}

}  // namespace crossloft::samples
