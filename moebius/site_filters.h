#pragma once
/// The first stage of the two predicates that a triangulation of lifted sites mostly asks: +-1 when certain,
/// 0 when it cannot tell.
///
/// Rows as in site_rows.h, bounds in the notation of difference_filters.h. Relative to its base a row has the
/// entries x = L dx and y = L dy, off by 2 of their size; l, off by 1; and w = (x dx + y dy) - dm, measured
/// by W, the largest computed |x dx| + |y dy| + |dm|: the products are off by 2 + 1 + 1 of their size, their
/// sum by 5, dm by 1, the difference by 1 of W more: 6.

#include "../geom/double_filters.h"
#include "diagram.h"

namespace crossloft {

namespace filters {

/// Minors 2 : 2 (2 + 2 + 1) + 2 = 12; times l 2 : 12 + 2 + 2 = 16; two terms 4 : 36; three 6 : 36 + 16 + 6.
inline constexpr double kSiteOrient3dError = 58 * kU * kRoom;
/// det3 6 : 58, times w 6 : 58 + 6*6 + 6 = 100; pairs 12 : 212; all 24 : 424 + 24.
inline constexpr double kSitePowerError = 448 * kU * kRoom;

/// (x, y, -l) turns as the position (-l, x, y) does.
struct SiteLift {
  Vec3 d;
  double w, size;
};

inline SiteLift site_lift(const MoebiusSite& m, const MoebiusSite& base) {
  const double dx = m.p.x - base.p.x, dy = m.p.y - base.p.y, dm = m.mu - base.mu;
  const double x = m.lambda * dx, y = m.lambda * dy, xx = x * dx, yy = y * dy;
  return {{x, y, base.lambda - m.lambda}, (xx + yy) - dm, (std::fabs(xx) + std::fabs(yy)) + std::fabs(dm)};
}

}  // namespace filters

inline int site_orient3d_filter(const MoebiusSite& a, const MoebiusSite& b, const MoebiusSite& c,
                                const MoebiusSite& d) {
  const filters::Estimate e =
      filters::orient3d(filters::site_lift(b, a).d, filters::site_lift(c, a).d, filters::site_lift(d, a).d);
  if (!filters::in_range(e.x, e.y, e.z)) return 0;
  return filters::decide(e.det, filters::kSiteOrient3dError * e.size());
}

inline int site_power_filter(const MoebiusSite& a, const MoebiusSite& b, const MoebiusSite& c,
                             const MoebiusSite& d, const MoebiusSite& e) {
  using filters::site_lift;
  const filters::SiteLift p = site_lift(a, e), q = site_lift(b, e), r = site_lift(c, e), s = site_lift(d, e);
  const double largest = std::max(std::max(p.size, q.size), std::max(r.size, s.size));
  const filters::Estimate estimate = filters::insphere(p.d, q.d, r.d, s.d, p.w, q.w, r.w, s.w, largest);
  // Unlike a square the heights have a least size of their own: where all are tiny or 0, underflow would
  // count.
  if (!filters::in_range(estimate.x, estimate.y, estimate.z) || !filters::in_range(largest, largest))
    return 0;
  return filters::decide(estimate.det, filters::kSitePowerError * estimate.size());
}

}  // namespace crossloft
