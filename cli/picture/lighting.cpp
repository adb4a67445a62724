#include "lighting.h"

#include <map>
#include <numbers>

namespace crossloft::cli {
namespace {

constexpr Rgb kKeyColour{1.50f, 1.44f, 1.34f};
constexpr Rgb kSkyColour{0.62f, 0.68f, 0.78f};
constexpr Rgb kGroundColour{0.34f, 0.31f, 0.28f};
constexpr double kCrease = 0.64;  // cosine of 50 degrees

Vec3 unit(const Vec3& v) {
  const double length = norm(v);
  return length > 0 ? (1 / length) * v : Vec3{0, 0, 1};
}

/// Point k of n spread evenly over the sphere along a spiral.
Vec3 spiral(int k, int n) {
  const double z = 1 - (2 * k + 1.0) / n, radius = std::sqrt(1 - z * z);
  const double turn = k * std::numbers::pi * (3 - std::sqrt(5.0));
  return {radius * std::cos(turn), radius * std::sin(turn), z};
}

Rgb sky_colour(const Vec3& direction) {
  const float high = static_cast<float>(0.5 + 0.5 * direction.z);
  return high * kSkyColour + (1 - high) * kGroundColour;
}

Vec3 normal_of(const Surface& s, const std::array<std::uint32_t, 3>& t) {
  return cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
}

}  // namespace

ShadowMap::ShadowMap(const Surface& surface, Vec3 toward_light, Vec3 center, double radius)
    : view_(view_from(toward_light)), depth_(static_cast<std::size_t>(kSize) * kSize, -INFINITY) {
  view_.center = center;
  view_.scale = 0.5 * kSize / radius;
  view_.x = view_.y = 0.5 * kSize;
  for (const auto& t : surface.triangles) {
    const Spot a = view_(surface.points[t[0]]), b = view_(surface.points[t[1]]),
               c = view_(surface.points[t[2]]);
    scan_triangle(a, b, c, kSize, kSize, [&](int x, int y, double wa, double wb, double wc) {
      float& depth = depth_[static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)];
      depth = std::max(depth, static_cast<float>(wa * a.depth + wb * b.depth + wc * c.depth));
    });
  }
}

bool ShadowMap::lights(const Vec3& point, double slack) const {
  const Spot spot = view_(point);
  if (!(spot.x >= 0 && spot.y >= 0 && spot.x < kSize && spot.y < kSize)) return true;
  const std::size_t i = static_cast<std::size_t>(spot.y) * kSize + static_cast<std::size_t>(spot.x);
  return spot.depth + view_.scale * slack >= static_cast<double>(depth_[i]);
}

Vec3 Lighting::key() { return unit({-0.42, -0.62, 0.82}); }

Lighting::Lighting(const Surface& surface, Vec3 center, double radius) : slack_(0.012 * radius) {
  for (int k = 0; k < kShares * kKeyLights; ++k) {
    const Vec3 direction = unit(key() + 0.13 * spiral(k, kShares * kKeyLights));
    key_[static_cast<std::size_t>(k % kShares)].emplace_back(surface, direction, center, radius);
  }
  for (int k = 0; k < kShares * kSkyLights; ++k) {
    const Vec3 direction = unit(spiral(k, kShares * kSkyLights) + Vec3{1e-4, 2e-4, 0});
    sky_[static_cast<std::size_t>(k % kShares)].emplace_back(surface, direction, center, radius);
  }
}

Rgb Lighting::at(const Vec3& point, const Vec3& normal, int share) const {
  const Vec3 lifted = point + slack_ * normal;
  Rgb sum;
  for (const ShadowMap& map : key_[static_cast<std::size_t>(share)]) {
    const double facing = dot(normal, map.toward_light());
    if (facing > 0 && map.lights(lifted, slack_))
      sum = sum + static_cast<float>(facing / kKeyLights) * kKeyColour;
  }
  for (const ShadowMap& map : sky_[static_cast<std::size_t>(share)]) {
    const double facing = dot(normal, map.toward_light());
    if (facing <= 0 || !map.lights(lifted, slack_)) continue;
    sum = sum + static_cast<float>(4 * facing / kSkyLights) * sky_colour(map.toward_light());
  }
  return (1 / 2.0f) * sum;
}

std::vector<std::array<Vec3, 3>> corner_normals(const Surface& surface) {
  std::map<Vec3, std::vector<std::uint32_t>> around;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    for (std::uint32_t v : surface.triangles[t]) around[surface.points[v]].push_back(t);
  }
  std::vector<Vec3> normals;
  for (const auto& t : surface.triangles) normals.push_back(normal_of(surface, t));
  std::vector<std::array<Vec3, 3>> corners(surface.triangles.size());
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const Vec3 own = unit(normals[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 sum = 1e-9 * own;
      for (std::uint32_t other : around[surface.points[surface.triangles[t][k]]]) {
        if (dot(unit(normals[other]), own) > kCrease) sum = sum + normals[other];
      }
      corners[t][k] = unit(sum);
    }
  }
  return corners;
}

}  // namespace crossloft::cli
