#pragma once
/// Axis-parallel bounding boxes.

#include <limits>
#include <span>

#include "vec3.h"

namespace crossloft {

/// The closed box [low, high]; empty (low > high) until a point is added.
struct Bounds {
  Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};

  bool empty() const { return low.x > high.x; }
  Vec3 center() const { return 0.5 * (low + high); }
  /// Length from low to high, 0 if empty.
  double diagonal() const { return empty() ? 0 : norm(high - low); }
  void add(const Vec3& p) {
    low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
    high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
  }
  void join(const Bounds& b) {
    if (!b.empty()) {
      add(b.low);
      add(b.high);
    }
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();
};

inline Bounds bounds_of(std::span<const Vec3> points) {
  Bounds box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

}  // namespace crossloft
