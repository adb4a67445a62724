#include "lattice_reduction.h"

#include <algorithm>
#include <utility>

namespace crossloft {
namespace {

constexpr int kDirectionBits = 46;

struct EuclideanForm {
  Wide operator()(const WideVector& x, const WideVector& y) const { return dot(x, y); }
};

/// After it |a| <= |b| and 2 |a.b| <= |a|^2 under the form.
template <class Form>
void lagrange(WideVector& a, WideVector& b, const Form& form) {
  Wide aa = form(a, a), bb = form(b, b);
  for (;;) {
    if (bb < aa) std::swap(a, b), std::swap(aa, bb);
    const Wide q = round_quotient(form(a, b), aa);
    if (q == 0) return;
    b = b - q * a;
    bb = form(b, b);
    if (bb >= aa) return;
  }
}

/// c minus the vector of the lattice of (a, b) nearest to it. REQUIRES: (a, b) reduced, so that the nearest
/// is at most one step from the rounded coefficients.
WideVector remainder(const WideVector& a, const WideVector& b, const WideVector& c,
                     const DirectionForm& form) {
  const Wide aa = form(a, a), bb = form(b, b), ab = form(a, b), ac = form(a, c), bc = form(b, c);
  const Wide det = aa * bb - ab * ab;
  const WideVector base =
      c - round_quotient(ac * bb - bc * ab, det) * a - round_quotient(bc * aa - ac * ab, det) * b;
  WideVector best = base;
  Wide best_length = form(base, base);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      const WideVector d = base + Wide(i) * a + Wide(j) * b;
      if (Wide length = form(d, d); length < best_length) best = d, best_length = std::move(length);
    }
  return best;
}

/// g = gcd(a, b) = x a + y b, g >= 0.
struct Bezout {
  Wide g, x, y;
};
Bezout bezout(Wide a, Wide b) {
  Wide x0 = 1, y0 = 0, x1 = 0, y1 = 1;
  while (b != 0) {
    const Wide q = a / b;
    a = std::exchange(b, Wide(a - q * b));
    x0 = std::exchange(x1, Wide(x0 - q * x1));
    y0 = std::exchange(y1, Wide(y0 - q * y1));
  }
  if (a < 0) return {-a, -x0, -y0};
  return {a, x0, y0};
}

bool first_is_negative(const WideVector& v) {
  for (const Wide& c : v)
    if (c != 0) return c < 0;
  return false;
}

}  // namespace

WideVector widen(const LatticeVector& v) { return {Wide(v[0]), Wide(v[1]), Wide(v[2])}; }
LatticeVector narrow(const WideVector& v) {
  return {static_cast<std::int64_t>(v[0]), static_cast<std::int64_t>(v[1]), static_cast<std::int64_t>(v[2])};
}
WideVector operator+(const WideVector& a, const WideVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
WideVector operator-(const WideVector& a, const WideVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
WideVector operator*(const Wide& s, const WideVector& a) { return {s * a[0], s * a[1], s * a[2]}; }
Wide dot(const WideVector& a, const WideVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
WideVector cross(const WideVector& a, const WideVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Wide round_quotient(const Wide& n, const Wide& d) {
  const Wide numerator = 2 * n + d, denominator = 2 * d;
  Wide q = numerator / denominator;  // truncates towards zero
  if (numerator < 0 && q * denominator != numerator) --q;
  return q;
}

DirectionForm::DirectionForm(const LatticeVector& direction, int weight)
    : direction_(widen(direction)),
      direction_norm_(dot(direction_, direction_)),
      length_shift_(2 * std::max(0, kDirectionBits - weight)),
      angle_shift_(2 * std::max(0, weight - kDirectionBits)) {}

Wide DirectionForm::operator()(const WideVector& x, const WideVector& y) const {
  const Wide xy = dot(x, y);
  const Wide angle = xy * direction_norm_ - dot(x, direction_) * dot(y, direction_);  // (x x d).(y x d)
  return xy * (Wide(1) << length_shift_) + angle * (Wide(1) << angle_shift_);
}

void reduce_basis(std::span<WideVector> basis, const DirectionForm& form) {
  if (basis.size() == 2) return lagrange(basis[0], basis[1], form);
  for (;;) {
    std::stable_sort(basis.begin(), basis.end(),
                     [&](const WideVector& x, const WideVector& y) { return form(x, x) < form(y, y); });
    lagrange(basis[0], basis[1], form);
    basis[2] = remainder(basis[0], basis[1], basis[2], form);
    if (form(basis[2], basis[2]) >= form(basis[1], basis[1])) return;
  }
}

void reduce_basis(WideVector& a, WideVector& b) { lagrange(a, b, EuclideanForm{}); }

Kernel kernel_of(const LatticeVector& n) {
  const WideVector w = widen(n);
  const Wide zero = 0, one = 1;
  Kernel k{{one, zero, zero}, {zero, one, zero}, {zero, zero, w[2]}};
  if (n[0] != 0 || n[1] != 0) {
    // Solutions of n0 x + n1 y = 0, and one for each multiple of g = gcd(n0, n1) that z needs.
    const Bezout xy = bezout(w[0], w[1]), gz = bezout(xy.g, w[2]);
    k.a = {-w[1] / xy.g, w[0] / xy.g, zero};
    k.b = {-xy.x * w[2], -xy.y * w[2], xy.g};
    k.t = {gz.x * xy.x, gz.x * xy.y, gz.y};
  }
  reduce_basis(k.a, k.b);
  if (first_is_negative(k.a)) k.a = Wide(-1) * k.a;
  if (dot(cross(k.a, k.b), w) < 0) k.b = Wide(-1) * k.b;
  return k;
}

}  // namespace crossloft
