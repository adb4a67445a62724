#include "static_bounds.h"

#include <array>

#include "aligned_doubles.h"
#include "small_integers.h"

namespace crossloft {
namespace {

using namespace filters;

/// The box of points; NaN in `size` if one of them is not finite.
struct Box {
  Vec3 low{StaticBounds::kNone, StaticBounds::kNone, StaticBounds::kNone};
  Vec3 high = -low;
  double zero = 0;  ///< NaN once a coordinate is not finite

  void include(double v, double& least, double& most) {
    least = v < least ? v : least;
    most = v > most ? v : most;
    zero += v - v;
  }
  void include(const Vec3& p) {
    include(p.x, low.x, high.x), include(p.y, low.y, high.y), include(p.z, low.z, high.z);
  }
  /// Its largest differences, as rounded, and lift, as rounded.
  Estimate largest() const {
    const Vec3 size = (high - low) + Vec3{zero, zero, zero};
    return {0, size.x, size.y, size.z, dot(size, size)};
  }
  double largest_coordinate() const {
    return std::max(filters::largest(low.x, low.y, low.z), filters::largest(high.x, high.y, high.z));
  }
};

Vec3 position(const Vec3& p) { return p; }
Vec3 position(const LatticePoint& p) { return {p.x, p.y, p.z}; }
Vec3 position(const WeightedPoint& p) { return p.position; }

template <class Point>
Box box_of(std::span<const Point> points) {
  Box box;
  for (const Point& p : points) box.include(position(p));
  return box;
}

double volume(const Estimate& e) { return e.x * e.y * e.z; }

/// Narrows `scale`, a power of two, until it makes v an integer; false if that takes it out of 2^+-100 or
/// makes the largest coordinate more than 2^50.
bool include_in_scale(double v, double largest, double& scale) {
  const double scaled = v * scale;
  const bool vanishes = scaled == 0 && v != 0;  // below the range of doubles: no integer
  if (!vanishes && small_integers::distance_to_integer(scaled) == 0) return true;
  const int exponent = aligned::parts_of(v).exponent - 1075;
  if (exponent > 100 || exponent < -100) return false;
  scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  return largest * scale <= 0x1p50;
}

/// The scale of StaticBounds.
template <class Point>
double scale_of(std::span<const Point> points, double largest) {
  double scale = 0x1p-100;
  for (const Point& point : points) {
    const Vec3 p = position(point);
    for (const double v : {p.x, p.y, p.z})
      if (!include_in_scale(v, largest, scale)) return 0;
  }
  return largest * scale <= 0x1p50 ? scale : 0;
}

/// Every value on the way to orient3d is an integer of at most 6 X Y Z for the largest differences in units
/// of 1 / scale, on the way to insphere of at most 24 X Y Z L; each X >= 1, so that no part exceeds the
/// whole. Up to 2^53 they are exact; the room of 2 is for the rounding of the product here.
void exact_where_small(const Estimate& e, StaticBounds& bounds) {
  const auto units = [&](double d) { return std::max(1.0, d * bounds.scale); };
  const double x = units(e.x), y = units(e.y), z = units(e.z);
  if (6 * x * y * z <= 0x1p52) bounds.orient3d = 0;
  if (24 * x * y * z * (x * x + y * y + z * z) <= 0x1p52) bounds.insphere = 0;
}

}  // namespace

StaticBounds static_bounds(std::span<const Vec3> points) {
  const Box box = box_of(points);
  const Estimate e = box.largest();
  StaticBounds bounds;
  if (in_range(e.x, e.y, e.z)) {
    bounds.orient3d = kRoundedOrient3dError * volume(e);
    bounds.insphere = kRoundedInsphereError * e.size();
  }
  if (!(box.largest_coordinate() <= kLargest)) return bounds;
  bounds.scale = scale_of(points, box.largest_coordinate());
  if (bounds.scale != 0) exact_where_small(e, bounds);
  return bounds;
}

StaticBounds static_bounds(std::span<const LatticePoint> points) {
  Estimate e = box_of(points).largest();
  StaticBounds bounds{kOrient3dError * volume(e), kInsphereError * e.size(), 0};
  bool all_explicit = true;
  for (const LatticePoint& p : points) all_explicit &= p.is_explicit();
  if (all_explicit) {
    bounds.scale = 1;
    exact_where_small(e, bounds);
  } else {
    bounds.orient3d += blur_orient3d(e);
    bounds.insphere += blur_insphere(e);
  }
  return bounds;
}

StaticBounds static_bounds(std::span<const WeightedPoint> points) {
  const Estimate e = box_of(points).largest();
  double least = StaticBounds::kNone, most = -least, zero = 0;
  for (const WeightedPoint& p : points) {
    least = std::min(least, p.weight), most = std::max(most, p.weight);
    zero += p.weight - p.weight;
  }
  // Of computed sizes |d|^2 + |v|, v the difference of two weights.
  const double lift = e.lift + ((most - least) + zero);
  StaticBounds bounds;
  if (!in_range(e.x, e.y, e.z) || !(lift <= kLargestLift)) return bounds;
  bounds.orient3d = kRoundedOrient3dError * volume(e);
  bounds.insphere = kPower3dError * (volume(e) * lift);
  return bounds;
}

}  // namespace crossloft
