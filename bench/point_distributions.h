#pragma once
/// Point sets that benchmarks share: each by its name, the same on every machine.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "../geom/lattice.h"
#include "../geom/vec3.h"

namespace crossloft::bench {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  std::int64_t integer(std::int64_t limit) {
    return static_cast<std::int64_t>(engine_() % (2 * static_cast<std::uint64_t>(limit) + 1)) - limit;
  }
  template <class T>
  void shuffle(std::vector<T>& values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[engine_() % i]);
  }

 private:
  std::mt19937_64 engine_;
};

/// Uniform in the unit cube.
inline std::vector<Vec3> uniform_cube(std::size_t count) {
  Draw draw(1);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p.x = draw.unit(), p.y = draw.unit(), p.z = draw.unit();
  return points;
}

/// Uniform on a sphere, rounded to doubles.
inline std::vector<Vec3> sphere(std::size_t count, double radius) {
  Draw draw(2);
  std::vector<Vec3> points;
  while (points.size() < count) {
    const Vec3 p{draw.between(-1, 1), draw.between(-1, 1), draw.between(-1, 1)};
    const double square = dot(p, p);
    if (square <= 1 && square > 0.01) points.push_back((radius / std::sqrt(square)) * p);
  }
  return points;
}

/// The same rounded to integers.
inline std::vector<Vec3> integer_sphere(std::size_t count, double radius) {
  std::vector<Vec3> points = sphere(count, radius);
  for (Vec3& p : points) p = {std::round(p.x), std::round(p.y), std::round(p.z)};
  return points;
}

/// Integer points 0..side-1 in three directions, shuffled.
inline std::vector<Vec3> grid(std::size_t side) {
  std::vector<Vec3> points;
  for (std::size_t x = 0; x < side; ++x)
    for (std::size_t y = 0; y < side; ++y)
      for (std::size_t z = 0; z < side; ++z)
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  Draw(3).shuffle(points);
  return points;
}

/// A smooth closed curve in the unit disk: a circle with three waves on it, some way from the centre.
struct WavyCircle {
  double centre_u, centre_v, radius;
  std::array<double, 3> waves, phases;

  explicit WavyCircle(Draw& draw)
      : centre_u(draw.between(-0.6, 0.6)), centre_v(draw.between(-0.6, 0.6)), radius(draw.between(0.1, 0.3)) {
    for (double& w : waves) w = draw.between(0, 0.15);
    for (double& p : phases) p = draw.between(0, 2 * std::numbers::pi);
  }
  std::array<double, 2> at(double angle) const {
    double r = 1;
    for (std::size_t k = 0; k < 3; ++k)
      r += waves[k] * std::cos(static_cast<double>(k + 2) * angle + phases[k]);
    return {centre_u + radius * r * std::cos(angle), centre_v + radius * r * std::sin(angle)};
  }
};

/// Integer points exactly on `planes` lattice planes in general position, in the order of the curves: five
/// smooth closed curves of `per_curve` points on each plane.
inline std::vector<Vec3> curves_on_planes(std::size_t planes, std::size_t per_curve) {
  constexpr std::int64_t kStep = 1 << 10;
  constexpr double kScale = 0x1p+26;  // of the unit disk in steps of e1 and e2
  Draw draw(4);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < planes; ++i) {
    const auto vector = [&](std::int64_t limit) {
      return LatticeVector{draw.integer(limit), draw.integer(limit), draw.integer(limit)};
    };
    const LatticeVector o = vector(std::int64_t{1} << 34), e1 = vector(kStep), e2 = vector(kStep);
    for (int curve = 0; curve < 5; ++curve) {
      const WavyCircle circle(draw);
      for (std::size_t k = 0; k < per_curve; ++k) {
        const auto at = circle.at(2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(per_curve));
        const auto u = std::llround(at[0] * kScale), v = std::llround(at[1] * kScale);
        const auto coordinate = [&](std::size_t axis) {
          return static_cast<double>(o[axis] + u * e1[axis] + v * e2[axis]);
        };
        points.push_back({coordinate(0), coordinate(1), coordinate(2)});
      }
    }
  }
  return points;
}

}  // namespace crossloft::bench
