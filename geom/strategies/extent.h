#pragma once
/// How far the data of a strategy reach: what a static filter computes its bounds from, once.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "../lattice.h"
#include "../vec2.h"
#include "../weighted_point.h"

namespace crossloft::strategies {

/// Upper bounds over all data that the strategy will see; infinite where nothing is known.
struct Extent {
  static constexpr double kAny = std::numeric_limits<double>::infinity();
  Vec3 difference{kAny, kAny, kAny};  ///< of two coordinates along each axis, rounded up
  double weight = kAny;               ///< of two weights
  Vec3 normal{kAny, kAny, kAny};      ///< |N_x|, |N_y|, |N_z| of the planes
  bool rational = true;               ///< some lattice points are not explicit
};

/// Collects points, then gives their Extent.
class ExtentBuilder {
 public:
  void include(const Vec3& p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
    finite_ = finite_ && is_finite(p);
  }
  void include(Vec2 p) { include(Vec3{p.x, p.y, 0}); }
  void include(const WeightedPoint& p) {
    include(p.position);
    heaviest_ = std::max(heaviest_, std::fabs(p.weight));
    finite_ = finite_ && std::isfinite(p.weight);
  }
  void include(const LatticePoint& p) {
    include(Vec3{p.x, p.y, p.z});
    rational_ = rational_ || !p.is_explicit();
  }
  void include(const LatticePlane& plane) {
    include(make_point(plane.origin));
    const auto larger = [&](double v, std::size_t k) {
      return std::max(v, std::fabs(static_cast<double>(plane.normal[k])));
    };
    normal_ = {larger(normal_.x, 0), larger(normal_.y, 1), larger(normal_.z, 2)};
  }

  Extent extent() const {
    if (!finite_) return {};
    const auto up = [](double v) { return v * (1 + 0x1p-52) + 0x1p-1074; };  // above what v was rounded from
    const Vec3 d = high_ - low_;
    return {{up(d.x), up(d.y), up(d.z)}, up(2 * heaviest_), normal_, rational_};
  }

 private:
  Vec3 low_{Extent::kAny, Extent::kAny, Extent::kAny}, high_ = -low_, normal_{};
  double heaviest_ = 0;
  bool finite_ = true, rational_ = false;
};

template <class Datum>
Extent extent_of(std::span<const Datum> data) {
  ExtentBuilder builder;
  for (const Datum& d : data) builder.include(d);
  return builder.extent();
}

}  // namespace crossloft::strategies
