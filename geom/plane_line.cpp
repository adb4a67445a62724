#include "plane_line.h"

#include "determinants.h"
#include "fixed_division.h"
#include "homogeneous.h"

namespace crossloft {
namespace {

using Entry = FixedInt<40>;
static_assert(kNormalLimit == std::int64_t{1} << 40 && kLatticeLimit == std::int64_t{1} << 50);

Entry entry(const LatticePlane& p, std::size_t k) { return Entry(p.normal[k]); }

/// N . (X - o W), W times the value of the plane.
template <unsigned Bits, unsigned WeightBits>
auto value_times_w(const LatticePlane& plane, const FixedInt<Bits>& x, const FixedInt<Bits>& y,
                   const FixedInt<Bits>& z, const FixedInt<WeightBits>& w) {
  const auto term = [&](std::size_t k, const FixedInt<Bits>& c) {
    return entry(plane, k) * (c - w * FixedInt<50>(plane.origin[k]));
  };
  return term(0, x) + term(1, y) + term(2, z);
}

}  // namespace

double plane_value(const LatticePlane& plane, const LatticePoint& p) {
  if (const Homogeneous* h = p.exact)
    return to_double(value_times_w(plane, h->x, h->y, h->z, h->w)) / to_double(h->w);
  const LatticeVector c = to_vector(p);
  return to_double(
      value_times_w(plane, FixedInt<50>(c[0]), FixedInt<50>(c[1]), FixedInt<50>(c[2]), FixedInt<0>(1)));
}

int line_axis(const LatticePlane& a, const LatticePlane& b) {
  const auto component = [&](std::size_t i, std::size_t j) {
    return magnitude(det2(entry(a, i), entry(a, j), entry(b, i), entry(b, j)));
  };
  const std::array d{component(1, 2), component(2, 0), component(0, 1)};
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (less(d[axis], d[k])) axis = k;
  return d[axis].is_zero() ? -1 : static_cast<int>(axis);
}

bool line_point(LatticePointStore& store, const LatticePlane& a, const LatticePlane& b, std::int64_t t,
                LatticePoint& point) {
  const int axis = line_axis(a, b);
  return axis >= 0 && store.meet(a, b, make_axis_plane(axis, t), point);
}

}  // namespace crossloft
