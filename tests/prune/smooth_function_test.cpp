// The function through samples of the sections around, and where the samples are.
#include "prune/smooth_function.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

namespace {

using namespace crossloft;

/// The plane { z = height } with a square of half width 1 around (x, 0).
FieldPlane square_at(double x, double height) {
  FieldPlane plane{{{0, 0, 1}, -height}, {}};
  const Vec3 corner[] = {{x - 1, -1, height}, {x + 1, -1, height}, {x + 1, 1, height}, {x - 1, 1, height}};
  for (int k = 0; k < 4; ++k) plane.contour.push_back({corner[k], corner[(k + 1) % 4]});
  return plane;
}

/// Signed, in the plane of the square at x = 0: positive inside.
double distance_to_square(Vec3 p) {
  const double dx = std::fabs(p.x) - 1, dy = std::fabs(p.y) - 1;
  if (dx <= 0 && dy <= 0) return -std::max(dx, dy);
  return -std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
}

}  // namespace

TEST_CASE("the function has the samples' values, and is linear where they are") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<FieldSample> bent, linear;
  for (int i = 0; i < 60; ++i) {
    const Vec3 p{5 + uniform(random), uniform(random), uniform(random)};
    bent.push_back({p, uniform(random)});
    linear.push_back({p, 0.5 + p.x - 2 * p.y + 3 * p.z});
  }
  const double unit = 2;
  const auto f = SmoothFunction::through(bent, {5, 0, 0}, unit);
  const auto g = SmoothFunction::through(linear, {5, 0, 0}, unit);
  REQUIRE(f);
  REQUIRE(g);
  for (std::size_t i = 1; i < bent.size(); ++i) {
    const auto values = f->at(bent[i - 1].at, bent[i].at);
    CHECK(values[0] == doctest::Approx(bent[i - 1].distance / unit).epsilon(1e-6));
    CHECK(values[1] == doctest::Approx(bent[i].distance / unit).epsilon(1e-6));
    const Vec3 p{5 + 2 * uniform(random), 2 * uniform(random), 2 * uniform(random)};
    CHECK(g->at(p, p)[0] == doctest::Approx((0.5 + p.x - 2 * p.y + 3 * p.z) / unit).epsilon(1e-6));
  }
}

TEST_CASE("samples in one plane determine no function") {
  std::vector<FieldSample> samples;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) samples.push_back({{1.0 * i, 1.0 * j, 2}, 0.1 * i * j});
  CHECK_FALSE(SmoothFunction::through(samples, {2, 2, 2}, 3));
  CHECK_FALSE(SmoothFunction::through({}, {2, 2, 2}, 3));
  samples.push_back({{0, 0, 1}, 1});
  CHECK(SmoothFunction::through(samples, {2, 2, 2}, 3));
}

TEST_CASE("samples have the distances to the nearest contour, of any plane, and keep apart") {
  const SectionField alone({square_at(0, 0)});
  const SectionField field({square_at(0, 0), square_at(0, 0.25)});
  for (const double radius : {0.5, 1.5, 4.0}) {
    CAPTURE(radius);
    const Vec3 centre{0.7, 0.2, 0.1};
    const auto samples = alone.samples(centre, radius);
    CHECK(samples.size() > 20);
    CHECK(samples.size() <= SectionField::kMostSamples);
    for (const FieldSample& s : samples) {
      CHECK(std::fabs(s.at.z) < 1e-12);
      CHECK(norm(s.at - centre) <= radius * (1 + 1e-12));
      CHECK(s.distance == doctest::Approx(distance_to_square(s.at)).epsilon(1e-9));
    }
    double nearest = radius;
    for (std::size_t i = 0; i < samples.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, norm(samples[i].at - samples[j].at));
    CHECK(nearest > radius / 20);
    int planes[2] = {0, 0};
    for (const FieldSample& s : field.samples(centre, radius)) ++planes[s.at.z > 0.125 ? 1 : 0];
    CHECK(planes[0] > 5);
    CHECK(planes[1] > 5);
  }
}

TEST_CASE("between two squares the function goes on as they lie: straight or leaning") {
  for (const double lean : {0.0, 1.0}) {
    CAPTURE(lean);
    const SectionField field(
        {square_at(-lean, -1), square_at(0, 0), square_at(lean, 1), square_at(2 * lean, 2)});
    const Vec3 centre{lean / 2, 0, 0.5};
    const auto f = SmoothFunction::through(field.samples(centre, 3), centre, 3);
    REQUIRE(f);
    const auto axis = f->at(centre, centre + Vec3{2.2, 0, 0});
    CHECK(axis[0] > 0);
    CHECK(axis[1] < 0);
  }
}
