#include <cmath>

#include "circle.h"
#include "random.h"
#include "slice.h"

namespace crossloft {
namespace {

CuttingPlane plane_through(const Vec3& point, const Vec3& normal) { return {normal, -dot(normal, point)}; }

/// REQUIRES: finite, not 0; of any length.
Vec3 unit(const Vec3& direction) {
  int exponent = 0;
  const Vec3 d = to_unit_size(direction, exponent);
  return (1 / norm(d)) * d;
}

/// Half the extent of the box along a direction.
double half_extent(const Bounds& box, const Vec3& direction) {
  const Vec3 h = 0.5 * (box.high - box.low);
  return std::abs(direction.x) * h.x + std::abs(direction.y) * h.y + std::abs(direction.z) * h.z;
}

/// A unit vector orthogonal to `axis`.
Vec3 any_orthogonal(const Vec3& axis) {
  const double x = std::abs(axis.x), y = std::abs(axis.y), z = std::abs(axis.z);
  const Vec3 other = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 u = cross(axis, other);
  return (1 / norm(u)) * u;
}

/// Position of the i-th of k equal parts' middle in [-1, 1].
double middle(std::uint32_t i, std::uint32_t k) { return (2.0 * i + 1) / k - 1; }

}  // namespace

std::vector<CuttingPlane> parallel_planes(const Bounds& box, std::uint32_t k, Vec3 direction) {
  std::vector<CuttingPlane> planes;
  if (box.empty() || direction == Vec3{}) return planes;
  const Vec3 n = unit(direction);
  for (std::uint32_t i = 0; i < k; ++i)
    planes.push_back(plane_through(box.center() + middle(i, k) * half_extent(box, n) * n, n));
  return planes;
}

std::vector<CuttingPlane> random_planes(const Bounds& box, std::uint32_t k, std::uint64_t seed) {
  std::vector<CuttingPlane> planes;
  if (box.empty()) return planes;
  Random random(seed);
  const double radius = 0.5 * box.diagonal();
  for (std::uint32_t i = 0; i < k; ++i) {
    const Vec3 n = random.direction();
    planes.push_back(plane_through(box.center() + random.uniform(-0.6, 0.6) * radius * n, n));
  }
  return planes;
}

std::vector<CuttingPlane> rotational_planes(const Bounds& box, std::uint32_t k, Vec3 axis) {
  std::vector<CuttingPlane> planes;
  if (box.empty() || axis == Vec3{}) return planes;
  const Vec3 w = unit(axis), u = any_orthogonal(w), v = cross(w, u);
  for (std::uint32_t i = 0; i < k; ++i) {
    const SineCosine angle = circle(0.5 * i / k);
    planes.push_back(plane_through(box.center(), angle.cosine * u + angle.sine * v));
  }
  return planes;
}

std::vector<CuttingPlane> fan_planes(const Bounds& box, std::uint32_t k, std::uint64_t seed) {
  std::vector<CuttingPlane> planes;
  if (box.empty()) return planes;
  Random random(seed);
  const double half = 0.5 * (box.high.x - box.low.x), jitter = 0.4 / k;
  for (std::uint32_t i = 0; i < k; ++i) {
    const double place = middle(i, k) + random.uniform(-jitter, jitter);
    const SineCosine tilt = circle(25.0 / 360 * (middle(i, k) + random.uniform(-jitter, jitter)));
    const SineCosine turn = circle(random.uniform(-jitter, jitter) / 8);
    const Vec3 n{tilt.cosine * turn.cosine, tilt.cosine * turn.sine, tilt.sine};
    planes.push_back(plane_through(box.center() + Vec3{place * half, 0, 0}, n));
  }
  return planes;
}

}  // namespace crossloft
