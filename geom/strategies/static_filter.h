#pragma once
/// Strategy: a filter whose bounds are computed once, from the Extent of the data. The first and cheapest
/// filter where points are spread over their extent; it knows nothing of small tetrahedra in a large box.
///
/// The bounds of difference_filters.h, double_filters.h, weighted_filters.h, lattice_filters.h and
/// meet_filter.h hold with any values above the largest differences of a call: here those of all data, a lift
/// of at most X^2 + Y^2 + Z^2 (three roundings upwards: kRoom). Lattice and doubles may come to one strategy:
/// the constants for rounded differences cover exact ones, the blur of rational points is added if there are
/// any. Differences of the data outside filters::kSmallest..kLargest are raised to the former, which makes
/// bounds larger, or give infinite bounds: nothing is decided then.

#include <algorithm>

#include "../double_filters.h"
#include "../lattice_filters.h"
#include "../weighted_filters.h"
#include "meet_filter.h"
#include "strategy.h"

namespace crossloft::strategies {

class StaticFilter {
 public:
  static constexpr std::string_view kName = "static";
  static constexpr Guarantee kGuarantee = Guarantee::filter;

  StaticFilter() : StaticFilter(Extent{}) {}
  explicit StaticFilter(const Extent& extent) : normal_(extent.normal) {
    using namespace filters;
    const auto up = [](double v) { return std::max(v, kSmallest); };
    const Vec3 d{up(extent.difference.x), up(extent.difference.y), up(extent.difference.z)};
    size_ = largest(d.x, d.y, d.z);
    if (!(size_ <= kLargest)) return;
    const double flat_lift = (d.x * d.x + d.y * d.y) * kRoom, lift = dot(d, d) * kRoom;
    const double area = d.x * d.y * kRoom, volume = area * d.z * kRoom;
    orient2d_ = kRoundedOrient2dError * area;
    orient3d_ = kRoundedOrient3dError * volume;
    incircle_ = kRoundedIncircleError * area * flat_lift;
    insphere_ = kRoundedInsphereError * volume * lift;
    if (extent.weight <= kLargestLift / 2) power_ = kPower3dError * volume * (lift + extent.weight) * kRoom;
    lattice(d, lift, extent.rational);
  }

  Verdict orient2d(Vec2 a, Vec2 b, Vec2 c) const {
    return verdict(filters::orient2d(b - a, c - a).det, orient2d_);
  }
  Verdict orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    return verdict(det3(b - a, c - a, d - a), orient3d_);
  }
  Verdict incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) const {
    const Vec2 p = a - d, q = b - d, r = c - d;
    return verdict(filters::incircle(p, q, r, dot(p, p), dot(q, q), dot(r, r)).det, incircle_);
  }
  Verdict insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) const {
    return verdict(filters::insphere(a - e, b - e, c - e, d - e).det, insphere_);
  }
  Verdict power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                     const WeightedPoint& d, const WeightedPoint& e) const {
    const auto p = filters::lifted(a, e), q = filters::lifted(b, e);
    const auto r = filters::lifted(c, e), s = filters::lifted(d, e);
    return verdict(filters::insphere(p.d, q.d, r.d, s.d, p.lift, q.lift, r.lift, s.lift, 0).det, power_);
  }

  Verdict orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d) const {
    using filters::difference;
    return verdict(det3(difference(b, a), difference(c, a), difference(d, a)), lattice_orient3d_);
  }
  Verdict insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e) const {
    using filters::difference;
    return verdict(
        filters::insphere(difference(a, e), difference(b, e), difference(c, e), difference(d, e)).det,
        lattice_insphere_);
  }
  Verdict orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c) const {
    const filters::Projection pr = filters::projection(plane.normal);
    const double det = filters::orient2d(project(pr, b, a), project(pr, c, a)).det;
    return verdict(pr.sign * det, lattice_orient2d_);
  }
  Verdict incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d) const {
    using filters::squared_distance;
    const filters::Projection pr = filters::projection(plane.normal);
    const double det =
        filters::incircle(project(pr, a, d), project(pr, b, d), project(pr, c, d), squared_distance(a, d),
                          squared_distance(b, d), squared_distance(c, d))
            .det;
    return verdict(pr.sign * det, lattice_incircle_);
  }
  Verdict side_of_plane(const LatticePlane& plane, const LatticePoint& p) const {
    const auto n = normal_row<DoubleArithmetic>(plane);
    return verdict(dot3(n, filters::difference(p, make_point(plane.origin))), side_);
  }
  Verdict side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q) const {
    const int sign =
        meet_verdict(meet_estimate(a, b, c, q), filters::largest(normal_.x, normal_.y, normal_.z), size_);
    return sign == 0 ? kUnknown : sign;
  }

 private:
  static Verdict verdict(double det, double bound) { return det > bound ? 1 : det < -bound ? -1 : kUnknown; }

  /// A plane may be projected along any axis: the two largest differences stand for the ones kept.
  void lattice(const Vec3& d, double lift, bool rational) {
    using namespace filters;
    const double second = std::max(std::min(d.x, d.y), std::min(std::max(d.x, d.y), d.z));
    Estimate flat{0, size_, second}, round{0, size_, second, 1, lift}, space{0, d.x, d.y, d.z},
        ball{0, d.x, d.y, d.z, lift};
    const double blurred = rational ? 1 : 0;
    lattice_orient2d_ = kOrient2dError * flat.size() + blurred * blur_orient2d(flat);
    lattice_incircle_ = kIncircleError * round.size() + blurred * blur_incircle(round);
    lattice_orient3d_ = kOrient3dError * space.size() + blurred * blur_orient3d(space);
    lattice_insphere_ = kInsphereError * ball.size() + blurred * blur_insphere(ball);
    const double n = normal_.x + normal_.y + normal_.z;
    side_ = kSideOfPlaneError * kRoom * (normal_.x * d.x + normal_.y * d.y + normal_.z * d.z) +
            blurred * kBlur * kRoom * n;
  }

  static constexpr double kNothing = Extent::kAny;
  Vec3 normal_;
  double size_ = kNothing;
  double orient2d_ = kNothing, orient3d_ = kNothing, incircle_ = kNothing, insphere_ = kNothing;
  double power_ = kNothing, side_ = kNothing;
  double lattice_orient2d_ = kNothing, lattice_incircle_ = kNothing;
  double lattice_orient3d_ = kNothing, lattice_insphere_ = kNothing;
};

static_assert(Strategy<StaticFilter>);

}  // namespace crossloft::strategies
