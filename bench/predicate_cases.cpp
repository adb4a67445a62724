#include "predicate_cases.h"

#include <cmath>
#include <functional>
#include <random>
#include <utility>

namespace crossloft::bench {
namespace {

/// By remainder and bits, since the standard distributions differ between libraries.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::size_t index(std::size_t size) { return engine_() % size; }
  std::int64_t integer(std::int64_t limit) {
    return static_cast<std::int64_t>(engine_() % (2 * static_cast<std::uint64_t>(limit) + 1)) - limit;
  }
  double whole(std::int64_t limit) { return static_cast<double>(integer(limit)); }
  /// In [-1, 1).
  double real() { return static_cast<double>(engine_() >> 10) * 0x1p-53 - 1; }
  Vec3 vec() {
    const double x = real(), y = real(), z = real();
    return {x, y, z};
  }
  /// Within two ulps.
  double nudged(double v) {
    for (std::size_t steps = index(3); steps > 0; --steps) v = std::nextafter(v, 2 * v);
    for (std::size_t steps = index(3); steps > 0; --steps) v = std::nextafter(v, 0);
    return v;
  }
  Vec3 on_sphere() {
    for (;;) {
      const Vec3 v = vec();
      const double length = norm(v);
      if (length > 0.1 && length <= 1) return 1 / length * v;
    }
  }
  LatticeVector vector(std::int64_t limit) {
    const std::int64_t x = integer(limit), y = integer(limit), z = integer(limit);
    return {x, y, z};
  }

 private:
  std::mt19937_64 engine_;
};

template <class Case, class Draw>
CaseSet<Case> filled(std::string name, std::size_t count, const Draw& draw) {
  CaseSet<Case> set{std::move(name), {}};
  for (std::size_t i = 0; i < count; ++i) {
    Case c{};
    for (auto& p : c) p = draw();
    set.cases.push_back(c);
  }
  return set;
}

constexpr double kMillion = 1e6;

/// Integer points on the sphere of radius 10^6: with m^2 + n^2 + p^2 + q^2 = s, the point (m^2 + n^2 - p^2 -
/// q^2, 2 (m q + n p), 2 (n q - m p)) has length s (Euler), here s = 5^6, and 64 times it 10^6.
std::vector<Vec3> million_sphere(std::size_t count, Random& random) {
  constexpr std::int64_t kS = 15625;
  std::vector<Vec3> points;
  while (points.size() < count) {
    const std::int64_t m = random.integer(125), n = random.integer(125), p = random.integer(125);
    const std::int64_t rest = kS - m * m - n * n - p * p;
    if (rest < 0) continue;
    const auto q = static_cast<std::int64_t>(std::lround(std::sqrt(static_cast<double>(rest))));
    if (q * q != rest) continue;
    const auto at = [](std::int64_t v) { return static_cast<double>(64 * v); };
    points.push_back({at(m * m + n * n - p * p - q * q), at(2 * (m * q + n * p)), at(2 * (n * q - m * p))});
  }
  return points;
}

/// Integer points on the circle of radius 5^4 * 13^2 * 17 about the origin, as powers of Gaussian integers.
std::vector<Vec2> integer_circle() {
  using Gauss = std::pair<std::int64_t, std::int64_t>;
  const auto times = [](const Gauss& a, const Gauss& b) {
    return Gauss{a.first * b.first - a.second * b.second, a.first * b.second + a.second * b.first};
  };
  std::vector<Gauss> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (const auto& [prime, power] : {std::pair<Gauss, int>{{2, 1}, 8}, {{3, 2}, 4}, {{4, 1}, 2}}) {
    std::vector<Gauss> next;
    for (const Gauss& p : points)
      for (int k = 0; k <= power; ++k) {
        Gauss g = p;
        for (int i = 0; i < power; ++i) g = times(g, i < k ? prime : Gauss{prime.first, -prime.second});
        next.push_back(g);
      }
    points = next;
  }
  std::vector<Vec2> circle;
  for (const Gauss& g : points)
    circle.push_back({static_cast<double>(g.first), static_cast<double>(g.second)});
  return circle;
}

SpaceCase weighted(const std::array<Vec3, 5>& points, const std::function<double()>& weight) {
  SpaceCase c;
  for (std::size_t i = 0; i < 5; ++i) c[i] = {points[i], weight()};
  return c;
}

template <class Draw>
CaseSet<SpaceCase> space_set(std::string name, std::size_t count, double size, Random& random,
                             const Draw& draw) {
  CaseSet<SpaceCase> set{std::move(name), {}};
  for (std::size_t i = 0; i < count; ++i) {
    std::array<Vec3, 5> points;
    for (Vec3& p : points) p = draw();
    // Half the cases have equal weights, so that ties of the sphere stay ties.
    const double base = i % 2 == 0 ? 0 : 0.25 * size * size;
    set.cases.push_back(
        weighted(points, [&] { return base == 0 ? 1 : std::floor(8 * random.real()) * base; }));
  }
  return set;
}

CaseSet<SpaceCase> contour_set(std::size_t count, const std::vector<Vec3>& contours, Random& random) {
  CaseSet<SpaceCase> set{"contour data", {}};
  for (std::size_t i = 0; i < count; ++i) {
    // Four of a neighbourhood along the contours and one from anywhere.
    const std::size_t at = random.index(contours.size());
    std::array<Vec3, 5> points;
    for (Vec3& p : points) p = contours[(at + random.index(40)) % contours.size()];
    points[3] = contours[random.index(contours.size())];
    set.cases.push_back(weighted(points, [] { return 0.0; }));
  }
  return set;
}

LatticePlane random_plane(Random& random) {
  for (;;) {
    const LatticePlane p =
        make_lattice_plane(random.vector(kLatticeLimit), random.vector(1 << 19), random.vector(1 << 19));
    if (p.normal != LatticeVector{0, 0, 0}) return p;
  }
}

/// origin + u e1 + v e2 within the limit.
LatticePoint point_of(const LatticePlane& plane, Random& random) {
  for (;;) {
    const std::int64_t u = random.integer(1 << 28), v = random.integer(1 << 28);
    LatticeVector p;
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = plane.origin[k] + u * plane.e1[k] + v * plane.e2[k];
      inside = inside && p[k] <= kLatticeLimit && p[k] >= -kLatticeLimit;
    }
    if (inside) return make_point(p);
  }
}

/// The point of `plane` on another one, at an integer coordinate or on a third plane.
LatticePoint rational_of(const LatticePlane& plane, bool on_line, Random& random, LatticePointStore& store) {
  for (;;) {
    const LatticePlane other = random_plane(random);
    const LatticePlane third =
        on_line ? make_axis_plane(static_cast<int>(random.index(3)), random.integer(kLatticeLimit))
                : random_plane(random);
    LatticePoint p;
    if (store.meet(plane, other, third, p)) return p;
  }
}

enum class Kind { integral, on_line, vertex, mixed };

CaseSet<LatticeCase> lattice_set(std::string name, std::size_t count, Kind kind, bool coplanar,
                                 Random& random, LatticePointStore& store) {
  CaseSet<LatticeCase> set{std::move(name), {}};
  const auto point = [&](const LatticePlane& plane) {
    const bool rational = kind != Kind::integral && (kind != Kind::mixed || random.index(2) == 0);
    return rational ? rational_of(plane, kind == Kind::on_line, random, store) : point_of(plane, random);
  };
  for (std::size_t i = 0; i < count; ++i) {
    LatticeCase c;
    c.plane = random_plane(random);
    for (LatticePlane& p : c.planes) p = coplanar && i % 2 == 0 ? c.plane : random_plane(random);
    for (LatticePoint& p : c.in_plane) p = point(c.plane);
    for (LatticePoint& p : c.points) p = point(coplanar ? c.plane : random_plane(random));
    set.cases.push_back(c);
  }
  return set;
}

}  // namespace

std::vector<CaseSet<PlanarCase>> planar_cases(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto set = [&](const char* name, const auto& draw) { return filled<PlanarCase>(name, count, draw); };
  const std::vector<Vec2> circle = integer_circle();
  std::vector<CaseSet<PlanarCase>> sets;
  sets.push_back(set("random", [&] {
    const double x = random.real();
    return Vec2{x, random.real()};
  }));
  sets.push_back(set("near-collinear, ulps", [&] {
    const double x = random.real();
    return Vec2{x, random.nudged(x / 3 + 0.7)};
  }));
  sets.push_back(set("collinear, y = const", [&] { return Vec2{random.real(), 0.7}; }));
  sets.push_back(set("collinear, oblique", [&] {
    const double t = random.whole(1 << 20);
    return Vec2{3 * t + 1, 7 * t - 5};
  }));
  sets.push_back(set("integer grid", [&] {
    const double x = random.whole(5);
    return Vec2{x, random.whole(5)};
  }));
  sets.push_back(set("cocircular integers", [&] { return circle[random.index(circle.size())]; }));
  sets.push_back(set("near-cocircular doubles", [&] {
    const double x = random.real(), y = std::sqrt(1 - x * x);
    return Vec2{x, random.index(2) == 0 ? y : -y};
  }));
  return sets;
}

std::vector<CaseSet<SpaceCase>> space_cases(std::size_t count, std::uint64_t seed,
                                            const std::vector<Vec3>& contours) {
  Random random(seed);
  const auto set = [&](const char* name, double size, const auto& draw) {
    return space_set(name, count, size, random, draw);
  };
  const std::vector<Vec3> sphere = million_sphere(1000, random);
  std::vector<CaseSet<SpaceCase>> sets;
  sets.push_back(set("random", 1, [&] { return random.vec(); }));
  sets.push_back(set("near-coplanar, ulps", 1, [&] {
    const double x = random.real(), y = random.real();
    return Vec3{x, y, random.nudged(x / 3 + y / 7 + 1.7)};
  }));
  sets.push_back(set("coplanar, z = const", 1, [&] {
    const double x = random.real();
    return Vec3{x, random.real(), 0.7};
  }));
  sets.push_back(set("coplanar, oblique", kMillion, [&] {
    const double x = random.whole(1'000'000), y = random.whole(1'000'000);
    return Vec3{x, y, 2 * x - 3 * y + 5};
  }));
  sets.push_back(set("integer grid", 5, [&] {
    const double x = random.whole(5), y = random.whole(5);
    return Vec3{x, y, random.whole(5)};
  }));
  sets.push_back(set("cospherical integers", kMillion, [&] { return sphere[random.index(sphere.size())]; }));
  sets.push_back(set("near-cospherical doubles", 1, [&] { return random.on_sphere(); }));
  if (!contours.empty()) sets.push_back(contour_set(count, contours, random));
  return sets;
}

std::vector<CaseSet<LatticeCase>> lattice_cases(std::size_t count, std::uint64_t seed,
                                                LatticePointStore& store) {
  Random random(seed);
  const auto set = [&](const char* name, Kind kind, bool coplanar) {
    return lattice_set(name, count, kind, coplanar, random, store);
  };
  std::vector<CaseSet<LatticeCase>> sets;
  sets.push_back(set("explicit", Kind::integral, false));
  sets.push_back(set("explicit, coplanar", Kind::integral, true));
  sets.push_back(set("line points", Kind::on_line, false));
  sets.push_back(set("arrangement vertices", Kind::vertex, false));
  sets.push_back(set("mixed", Kind::mixed, false));
  sets.push_back(set("mixed, coplanar", Kind::mixed, true));
  return sets;
}

}  // namespace crossloft::bench
