#pragma once
/// Small determinants by cofactors, for any ring: doubles in the filters, FixedInt behind them. Additions are
/// balanced so that a FixedInt grows by the least number of bits.

#include <utility>

namespace crossloft {

template <class A, class B, class C, class D>
auto det2(const A& a, const B& b, const C& c, const D& d) {
  return a * d - b * c;
}

/// Rows r, s, t of the columns x, y, z.
template <class R, class S, class T>
auto det3(const R& r, const S& s, const T& t) {
  return det2(s.x, s.y, t.x, t.y) * r.z - det2(r.x, r.y, t.x, t.y) * s.z + det2(r.x, r.y, s.x, s.y) * t.z;
}

/// Rows of the columns x, y, z, w; Laplace expansion by the column pairs xy and zw.
template <class R, class S, class T, class U>
auto det4(const R& r, const S& s, const T& t, const U& u) {
  const auto xy = [](const auto& p, const auto& q) { return det2(p.x, p.y, q.x, q.y); };
  const auto zw = [](const auto& p, const auto& q) { return det2(p.z, p.w, q.z, q.w); };
  return (xy(r, s) * zw(t, u) - xy(r, t) * zw(s, u) + xy(r, u) * zw(s, t)) +
         (xy(s, t) * zw(r, u) - xy(s, u) * zw(r, t) + xy(t, u) * zw(r, s));
}

}  // namespace crossloft
