#include "../../delaunay/conform.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "../../delaunay/lattice_predicates.h"
#include "point_sets.h"

using namespace crossloft;
using Segments = std::vector<std::array<std::uint32_t, 2>>;

namespace {

constexpr std::int64_t kUnit = std::int64_t{1} << 40;
const LatticePlane kFloor = make_axis_plane(2, 0);

std::int64_t nearest(double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); }

/// Points and segments of the plane z = 0; splits are rounded to integers.
struct Scene {
  std::vector<LatticePoint> points;
  Segments segments;

  std::uint32_t add(double x, double y) {
    points.push_back(make_point({nearest(x), nearest(y), 0}));
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  void polygon(const std::vector<std::array<double, 2>>& corners) {
    const auto first = static_cast<std::uint32_t>(points.size()),
               n = static_cast<std::uint32_t>(corners.size());
    for (const auto& c : corners) add(c[0], c[1]);
    for (std::uint32_t k = 0; k < n; ++k) segments.push_back({first + k, first + (k + 1) % n});
  }
  std::uint32_t split(const SplitRequest& r) {
    const LatticePoint &p = points[r.from], &q = points[r.to];
    return add(p.x + r.t * (q.x - p.x), p.y + r.t * (q.y - p.y));
  }
};

/// Star-shaped around the origin, radii within [low, high] of the unit.
void add_star(Scene& scene, std::size_t n, double low, double high, std::mt19937_64& random) {
  std::vector<std::array<double, 2>> corners;
  for (std::size_t k = 0; k < n; ++k) {
    const double radius = low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(n);
    corners.push_back({kUnit * radius * std::cos(angle), kUnit * radius * std::sin(angle)});
  }
  scene.polygon(corners);
}

Scene nested_stars(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Scene scene;
  add_star(scene, 40, 0.7, 1.0, random);
  add_star(scene, 60, 0.4, 0.69, random);
  add_star(scene, 15, 0.01, 0.35, random);
  return scene;
}

/// Spokes of different lengths, `degrees` apart.
Scene fan(std::size_t spokes, double degrees) {
  Scene scene;
  const std::uint32_t hub = scene.add(0, 0);
  for (std::size_t k = 0; k < spokes; ++k) {
    const double angle = degrees * static_cast<double>(k) * 0.017453292519943295;
    const double radius = kUnit * (1 + 0.37 * static_cast<double>(k * 3 % 5));
    scene.segments.push_back({hub, scene.add(radius * std::cos(angle), radius * std::sin(angle))});
  }
  return scene;
}

/// Three parallel segments, the middle one the longest.
Scene close_bars(double distance) {
  Scene scene;
  for (int k = 0; k < 3; ++k) {
    const double y = kUnit * distance * k, shift = k == 1 ? 0 : 0.13;
    const std::uint32_t left = scene.add(kUnit * shift, y), right = scene.add(kUnit * (1 - shift), y);
    scene.segments.push_back({left, right});
  }
  return scene;
}

/// A long segment between two rows of n points at a distance of a fiftieth of their spacing.
Scene between_rows(int n) {
  Scene scene;
  const std::uint32_t left = scene.add(0, 0), right = scene.add(kUnit, 0);
  scene.segments.push_back({left, right});
  const double spacing = static_cast<double>(kUnit) / n;
  for (int k = 0; k < n; ++k)
    for (const double side : {-0.02, 0.02}) scene.add(spacing * (k + 0.5 + side), spacing * side);
  return scene;
}

/// The pieces of each segment form a chain between its ends.
void check_chains(const Segments& before, const Segments& pieces, const std::vector<std::uint32_t>& source) {
  REQUIRE(source.size() == pieces.size());
  std::size_t k = 0;
  for (std::uint32_t s = 0; s < before.size(); ++s) {
    std::uint32_t at = before[s][0];
    for (; k < pieces.size() && source[k] == s; ++k) {
      CHECK(pieces[k][0] == at);
      at = pieces[k][1];
    }
    CHECK(at == before[s][1]);
  }
  CHECK(k == pieces.size());
}

std::set<std::array<double, 2>> coordinates(const std::vector<LatticePoint>& points) {
  std::set<std::array<double, 2>> set;
  for (const LatticePoint& p : points) set.insert({p.x, p.y});
  return set;
}

ConformResult conform_scene(Scene& scene, std::uint32_t limit = 100000) {
  const LatticePredicates2 predicates(kFloor, scene.points);
  Delaunay2 triangulation(predicates);
  triangulation.build();
  const Segments before = scene.segments;
  const ConformResult result = conform(
      triangulation, scene.segments, [&](const SplitRequest& r) { return scene.split(r); }, limit);
  CHECK(triangulation.verify() == "");
  check_chains(before, scene.segments, result.source);
  std::set<std::uint32_t> failed(result.failed.begin(), result.failed.end());
  for (std::uint32_t k = 0; k < scene.segments.size(); ++k)
    CHECK(triangulation.has_edge(scene.segments[k][0], scene.segments[k][1]) == !failed.count(k));
  return result;
}

void check_recovers(Scene scene) {
  Scene other = scene;
  const ConformResult result = conform_scene(scene);
  CHECK(result.failed.empty());
  CHECK_FALSE(result.limit_reached);
  MESSAGE(result.source.size() << " pieces after " << result.splits << " splits");

  // The same geometry in another order and direction is split at the same points.
  std::vector<std::uint32_t> name(other.points.size());
  for (std::uint32_t k = 0; k < name.size(); ++k) name[k] = static_cast<std::uint32_t>(name.size()) - 1 - k;
  std::reverse(other.points.begin(), other.points.end());
  std::reverse(other.segments.begin(), other.segments.end());
  for (auto& [a, b] : other.segments) std::tie(a, b) = std::pair(name[b], name[a]);
  conform_scene(other);
  CHECK(coordinates(scene.points) == coordinates(other.points));
}

}  // namespace

TEST_CASE("polygons become chains of edges") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    check_recovers(nested_stars(seed));
  }
}

TEST_CASE("fans of acute segments end on common shells") {
  check_recovers(fan(9, 1));
  check_recovers(fan(40, 9));
  check_recovers(fan(5, 0.1));
  check_recovers(fan(6, 60));
}

TEST_CASE("parallel close segments") {
  check_recovers(close_bars(1e-1));
  check_recovers(close_bars(1e-3));
}

TEST_CASE("a segment along close points is split as often as they ask for") {
  Scene scene = between_rows(300);
  const ConformResult result = conform_scene(scene);
  CHECK(result.failed.empty());
  CHECK(result.splits >= 300);
  CHECK(result.splits < 3000);
  check_recovers(between_rows(50));
}

TEST_CASE("a limit, a refusal and a split without progress are reported") {
  Scene scene = close_bars(1e-3);
  const ConformResult limited = conform_scene(scene, 10);
  CHECK(limited.limit_reached);
  CHECK(limited.splits == 10);
  CHECK_FALSE(limited.failed.empty());

  for (const bool refuse : {true, false}) {
    Scene bars = close_bars(1e-1);
    const LatticePredicates2 predicates(kFloor, bars.points);
    Delaunay2 triangulation(predicates);
    triangulation.build();
    const ConformResult result = conform(
        triangulation, bars.segments,
        [&](const SplitRequest& r) {
          return refuse ? kNone : bars.add(bars.points[r.from].x, bars.points[r.from].y);
        },
        1000);
    CHECK(result.splits == 0);
    CHECK_FALSE(result.failed.empty());
    CHECK_FALSE(result.limit_reached);
  }
}

TEST_CASE("shells are powers of two near the middle") {
  for (const double length : {1.0, 1.3, 1.42, 1.9, 1e-9, 12345.0}) {
    const double t = detail::shell_fraction(length);
    CHECK(t > 0.353);
    CHECK(t < 0.708);
    CHECK(std::exp2(std::round(std::log2(t * length))) == doctest::Approx(t * length).epsilon(1e-12));
  }
}
