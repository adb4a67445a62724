#include "planar_lattice.h"

#include <algorithm>
#include <cmath>

#include "../geom/fixed_int.h"

namespace crossloft {
namespace {

constexpr int sign(std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// The normal with its first component that is not 0 positive.
Vec3 canonical(Vec3 n) { return n < Vec3{} ? -n : n; }

/// A unit vector of the plane, along the axis that is nearest to it.
Vec3 first_axis(Vec3 n) {
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 along = axis - dot(axis, n) * n;
  return (1 / norm(along)) * along;
}

std::int64_t to_step(double length, double step) {
  const double limit = static_cast<double>(kPlanarLimit);
  return static_cast<std::int64_t>(std::clamp(std::floor(length / step + 0.5), -limit, limit));
}

/// The integer nearest to p + d num / den, half way upwards, |d| < 2^30, |num| <= den < 2^62.
std::int64_t rounded(std::int64_t p, std::int64_t d, std::int64_t num, std::int64_t den) {
  // From doubles first, then right by exact tests: x is too large if (2 (x - p) - 1) den > 2 d num.
  std::int64_t x =
      p + static_cast<std::int64_t>(std::floor(
              static_cast<double>(d) * (static_cast<double>(num) / static_cast<double>(den)) + 0.5));
  const auto beyond = [&](std::int64_t candidate) {
    const FixedInt<32> left(2 * (candidate - p) - 1);
    const auto difference = left * FixedInt<62>(den) - FixedInt<32>(2 * d) * FixedInt<62>(num);
    return difference.sign() > 0;
  };
  while (beyond(x)) --x;
  while (!beyond(x + 1)) ++x;
  return x;
}

}  // namespace

PlaneChart::PlaneChart(Vec3 normal, double offset, Vec3 middle, double diagonal) {
  const Vec3 n = canonical(normal);
  const double d = n == normal ? offset : -offset;
  origin_ = middle - (dot(n, middle) + d) * n;
  u_ = first_axis(n);
  v_ = cross(n, u_);
  step_ = diagonal / static_cast<double>(kPlanarLimit);
}

PlanarPoint PlaneChart::to_grid(Vec3 p) const {
  const Vec3 d = p - origin_;
  return {to_step(dot(u_, d), step_), to_step(dot(v_, d), step_)};
}

Vec3 PlaneChart::to_space(PlanarPoint p) const {
  return origin_ + (static_cast<double>(p.x) * step_) * u_ + (static_cast<double>(p.y) * step_) * v_;
}

bool cross(PlanarPoint a, PlanarPoint b, PlanarPoint c, PlanarPoint d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) return false;
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

bool is_above(PlanarPoint a, PlanarPoint b, PlanarPoint doubled) {
  if (a.x > b.x) std::swap(a, b);
  if (!(2 * a.x <= doubled.x && doubled.x < 2 * b.x)) return false;
  return turn({2 * a.x, 2 * a.y}, {2 * b.x, 2 * b.y}, doubled) < 0;
}

bool passes(PlanarPoint a, PlanarPoint b, PlanarPoint h) {
  // In half steps the corners are integers. The sides that do not belong to the square are moved in by an
  // infinitesimal.
  const PlanarPoint p{2 * a.x, 2 * a.y}, q{2 * b.x, 2 * b.y};
  const PlanarPoint low{2 * h.x - 1, 2 * h.y - 1}, high{2 * h.x + 1, 2 * h.y + 1};
  if (std::max(p.x, q.x) < low.x || std::min(p.x, q.x) >= high.x) return false;
  if (std::max(p.y, q.y) < low.y || std::min(p.y, q.y) >= high.y) return false;
  const auto side = [&](bool right, bool top) {
    const std::int64_t exact = turn(p, q, {right ? high.x : low.x, top ? high.y : low.y});
    return exact != 0 ? sign(exact) : sign((right ? q.y - p.y : 0) - (top ? q.x - p.x : 0));
  };
  const int s = side(false, false), t = side(true, true), u = side(false, true), v = side(true, false);
  return !(s > 0 && t > 0 && u > 0 && v > 0) && !(s < 0 && t < 0 && u < 0 && v < 0);
}

PlanarPoint crossing_point(PlanarPoint a, PlanarPoint b, PlanarPoint c, PlanarPoint d) {
  std::int64_t num = turn(c, d, a), den = num - turn(c, d, b);
  if (den < 0) num = -num, den = -den;
  return {rounded(a.x, b.x - a.x, num, den), rounded(a.y, b.y - a.y, num, den)};
}

}  // namespace crossloft
