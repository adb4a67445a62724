#include "lattice.h"

#include <vector>

#include "determinants.h"
#include "fixed_division.h"
#include "homogeneous.h"

namespace crossloft {

LatticeVector cross(const LatticeVector& a, const LatticeVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

LatticePlane make_lattice_plane(LatticeVector origin, LatticeVector e1, LatticeVector e2) {
  return {origin, e1, e2, cross(e1, e2)};
}

LatticePlane make_axis_plane(int axis, std::int64_t value) {
  LatticeVector origin{}, e1{}, e2{};
  origin[static_cast<std::size_t>(axis)] = value;
  e1[static_cast<std::size_t>((axis + 1) % 3)] = 1;
  e2[static_cast<std::size_t>((axis + 2) % 3)] = 1;
  return make_lattice_plane(origin, e1, e2);
}

int dominant_axis(const LatticeVector& n) {
  const auto size = [&](std::size_t k) { return n[k] < 0 ? -n[k] : n[k]; };
  int axis = 0;
  if (size(1) > size(0)) axis = 1;
  if (size(2) > size(static_cast<std::size_t>(axis))) axis = 2;
  return axis;
}

LatticePoint make_point(const LatticeVector& c) {
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2]), nullptr};
}

LatticeVector to_vector(const LatticePoint& p) {
  return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)};
}

namespace {

bool same(const Homogeneous& a, const Homogeneous& b) {
  return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z;
}

std::uint64_t hash_of(const Homogeneous& h) {
  // Multiply and fold per limb; the order of the table shows nowhere.
  std::uint64_t hash = 0x9E3779B97F4A7C15u;
  const auto fold = [&](const auto& v) {
    for (const limbs::Limb l : v.limb) {
      hash = (hash ^ l) * 0xFF51AFD7ED558CCDu;
      hash ^= hash >> 32;
    }
  };
  fold(h.x), fold(h.y), fold(h.z), fold(h.w);
  return hash;
}

}  // namespace

struct LatticePointStore::Impl {
  std::deque<Homogeneous> points;
  std::vector<const Homogeneous*> slots;  ///< open addressing over the points, at most half full

  /// The stored point equal to `h`, stored now if it is the first.
  const Homogeneous* keep(const Homogeneous& h) {
    if (slots.size() <= 2 * points.size()) grow();
    const Homogeneous*& slot = slot_of(h);
    if (slot == nullptr) slot = &points.emplace_back(h);
    return slot;
  }

 private:
  const Homogeneous*& slot_of(const Homogeneous& h) {
    std::size_t i = static_cast<std::size_t>(hash_of(h)) & (slots.size() - 1);
    while (slots[i] != nullptr && !same(*slots[i], h)) i = (i + 1) & (slots.size() - 1);
    return slots[i];
  }
  void grow() {
    slots.assign(std::max<std::size_t>(64, 2 * slots.size()), nullptr);
    for (const Homogeneous& h : points) slot_of(h) = &h;
  }
};

LatticePointStore::LatticePointStore() : impl_(std::make_unique<Impl>()) {}
LatticePointStore::~LatticePointStore() = default;
LatticePointStore::LatticePointStore(LatticePointStore&&) noexcept = default;
LatticePointStore& LatticePointStore::operator=(LatticePointStore&&) noexcept = default;
std::size_t LatticePointStore::size() const { return impl_->points.size(); }

namespace {

/// Holds every value of a solution and its numerator: asserted in solve().
using Value = FixedInt<kNumeratorBits + 4>;

struct SystemRow {
  FixedInt<40> x, y, z;
  FixedInt<92> offset;
};

SystemRow system_row(const LatticePlane& p) {
  const FixedInt<40> x(p.normal[0]), y(p.normal[1]), z(p.normal[2]);
  const auto o = [&](std::size_t k) { return FixedInt<50>(p.origin[k]); };
  return {x, y, z, x * o(0) + y * o(1) + z * o(2)};
}

/// Cramer's rule, W > 0; W = 0 if the planes have no or more than one common point. In lowest terms or not.
struct Solution {
  std::array<Value, 3> x;
  Value w;
};

Solution solve(const SystemRow& a, const SystemRow& b, const SystemRow& c) {
  // N.p = offset: p = (offset_a Nb x Nc + offset_b Nc x Na + offset_c Na x Nb) / det(Na, Nb, Nc)
  const auto component = [&](auto i, auto j) {
    const auto value = (a.offset * det2(b.*i, b.*j, c.*i, c.*j) - b.offset * det2(a.*i, a.*j, c.*i, c.*j)) +
                       c.offset * det2(a.*i, a.*j, b.*i, b.*j);
    static_assert(decltype(value)::kBits <= Value::kBits);
    return Value(value);
  };
  Solution s{{component(&SystemRow::y, &SystemRow::z), component(&SystemRow::z, &SystemRow::x),
              component(&SystemRow::x, &SystemRow::y)},
             Value(det3(a, b, c))};
  if (s.w.negative()) {
    s.w = -s.w;
    for (Value& v : s.x) v = -v;
  }
  return s;
}

bool within_lattice(const Solution& s) {
  const auto limit = s.w * FixedInt<50>(kLatticeLimit);
  return std::all_of(s.x.begin(), s.x.end(),
                     [&](const Value& v) { return !(limit - magnitude(v)).negative(); });
}

void reduce(Solution& s) {
  Value divisor = s.w;
  const Value one(1);
  for (const Value& v : s.x)
    if (divisor != one) divisor = gcd(divisor, magnitude(v));
  if (divisor == one) return;
  s.w = divide(s.w, divisor).quotient;
  for (Value& v : s.x) {
    const Value q = divide(magnitude(v), divisor).quotient;
    v = v.negative() ? -q : q;
  }
}

}  // namespace

bool LatticePointStore::meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                             LatticePoint& point) {
  Solution s = solve(system_row(a), system_row(b), system_row(c));
  if (s.w.is_zero() || !within_lattice(s)) return false;
  reduce(s);
  const auto& [x, w] = s;
  if (w == Value(1)) {
    point = make_point({x[0].to_int64(), x[1].to_int64(), x[2].to_int64()});
    return true;
  }
  using Numerator = FixedInt<kNumeratorBits>;
  const Homogeneous h{Numerator(x[0]), Numerator(x[1]), Numerator(x[2]), FixedInt<kWeightBits>(w)};
  point = {round_quotient(x[0], w), round_quotient(x[1], w), round_quotient(x[2], w), impl_->keep(h)};
  return true;
}

}  // namespace crossloft
