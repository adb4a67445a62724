#include "plane_line.h"

#include "homogeneous.h"

namespace crossloft {
namespace {

// |N_k| <= 2^40 and |x_k - o_k w| <= 2^51 w: the sum is below 2^93 w, w < 2^122.
using Value = Fixed<256>;

Value times(std::int64_t n, const Value& x, std::int64_t o, const Value& w) { return (x - w * o) * n; }

Value value_times_w(const LatticePlane& plane, const Value& x, const Value& y, const Value& z, const Value& w) {
  const auto& n = plane.normal;
  const auto& o = plane.origin;
  return times(n[0], x, o[0], w) + times(n[1], y, o[1], w) + times(n[2], z, o[2], w);
}

}  // namespace

double plane_value(const LatticePlane& plane, const LatticePoint& p) {
  if (p.exact) {
    const Value w(p.exact->w);
    const Value v = value_times_w(plane, Value(p.exact->x), Value(p.exact->y), Value(p.exact->z), w);
    return static_cast<double>(v) / static_cast<double>(w);
  }
  const LatticeVector c = to_vector(p);
  return static_cast<double>(value_times_w(plane, Value(c[0]), Value(c[1]), Value(c[2]), Value(1)));
}

int line_axis(const LatticePlane& a, const LatticePlane& b) {
  std::array<Value, 3> d;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    d[k] = abs(Value(Value(a.normal[i]) * b.normal[j] - Value(a.normal[j]) * b.normal[i]));
  }
  const std::size_t axis = d[1] > d[0] ? (d[2] > d[1] ? 2 : 1) : (d[2] > d[0] ? 2 : 0);
  return d[axis] == 0 ? -1 : static_cast<int>(axis);
}

bool line_point(LatticePointStore& store, const LatticePlane& a, const LatticePlane& b, std::int64_t t,
                LatticePoint& point) {
  const int axis = line_axis(a, b);
  return axis >= 0 && store.meet(a, b, make_axis_plane(axis, t), point);
}

}  // namespace crossloft
