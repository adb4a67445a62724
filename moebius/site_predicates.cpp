#include "site_predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "../geom/bounded.h"
#include "site_filters.h"
#include "site_rows.h"

namespace crossloft {
namespace {

using Integer = boost::multiprecision::cpp_int;

/// mantissa * 2^exponent: sums, differences and products of doubles stay in this ring.
class Dyadic {
 public:
  explicit Dyadic(double v) {
    const double fraction = std::frexp(v, &exponent_);
    exponent_ -= 53;
    mantissa_ = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  }

  int sign() const { return mantissa_.sign(); }
  /// Within an ulp. Numbers beyond the range of doubles become infinite or 0.
  double rounded() const {
    if (sign() == 0) return 0;
    const Integer size = abs(mantissa_);
    const int excess = static_cast<int>(msb(size)) - 62;
    const auto top =
        static_cast<std::int64_t>(excess > 0 ? Integer(size >> excess) : Integer(size << -excess));
    return sign() * std::ldexp(static_cast<double>(top), exponent_ + excess);
  }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.exponent_ < b.exponent_) return b + a;
    if (a.sign() == 0) return b;
    return {(a.mantissa_ << (a.exponent_ - b.exponent_)) + b.mantissa_, b.exponent_};
  }
  friend Dyadic operator-(const Dyadic& a) { return {-a.mantissa_, a.exponent_}; }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }

 private:
  Dyadic(Integer mantissa, int exponent) : mantissa_(std::move(mantissa)), exponent_(exponent) {}

  Integer mantissa_;
  int exponent_ = 0;
};

int compare(double a, double b) { return (a > b) - (a < b); }

/// The kept pair of columns of (-l, x, y) with the height, as a row of three: axes in the order of
/// PowerPredicates3. Dropping -l must undo the shear, which moves x and y along it.
template <class T>
SiteRow<T> projected_row(const MoebiusSite& m, const MoebiusSite& base, int drop) {
  const SiteRow<T> r = site_row<T>(m, base);
  if (drop == 1) return {r.y, -r.z, r.w, T(0)};
  if (drop == 2) return {-r.z, r.x, r.w, T(0)};
  return {r.x + r.z * T(base.p.x), r.y + r.z * T(base.p.y), r.w, T(0)};
}

/// PowerLine in doubles.
struct RoundedLine {
  double ux, uy, uz, m, a, b, product, discriminant;
};

/// Roots of t^2 + 4 uz t + product, the lower first: that without cancellation by the formula, the other by
/// their product.
std::array<double, 2> roots(const RoundedLine& line) {
  const double root = std::sqrt(std::max(line.discriminant, 0.0));
  const double far = line.uz > 0 ? -2 * line.uz - root : -2 * line.uz + root;
  const double near = far != 0 ? line.product / far : 0;
  return {std::min(far, near), std::max(far, near)};
}

std::array<Vec2, 2> crossings_of(const RoundedLine& line, Vec2 origin) {
  const double n = line.ux * line.ux + line.uy * line.uy;
  if (n == 0) {
    const Vec2 p = origin + 0.5 / line.uz * Vec2{line.b, -line.a};
    return {p, p};
  }
  const auto at = [&](double t) {
    return origin + 0.5 / n * (line.m * Vec2{-line.uy, line.ux} + t * Vec2{line.ux, line.uy});
  };
  const auto [enter, leave] = roots(line);
  return {at(enter), at(leave)};
}

/// Each coefficient has 35 good bits at least, or is exact.
bool is_sharp(const Bounded& b) { return b.error <= 0x1p-35 * std::abs(b.value); }

RoundedLine rounded_line(const MoebiusSite& i, const MoebiusSite& j, const MoebiusSite& k) {
  const PowerLine<Bounded> line(site_row<Bounded>(j, i), site_row<Bounded>(k, i));
  const Bounded discriminant = line.discriminant(), product = line.product();
  if (is_sharp(discriminant) && is_sharp(product) && is_sharp(line.ux) && is_sharp(line.uy) &&
      is_sharp(line.uz) && is_sharp(line.m) && is_sharp(line.a) && is_sharp(line.b))
    return {line.ux.value, line.uy.value, line.uz.value, line.m.value,
            line.a.value,  line.b.value,  product.value, discriminant.value};
  const PowerLine<Dyadic> exact(site_row<Dyadic>(j, i), site_row<Dyadic>(k, i));
  return {exact.ux.rounded(), exact.uy.rounded(), exact.uz.rounded(),        exact.m.rounded(),
          exact.a.rounded(),  exact.b.rounded(),  exact.product().rounded(), exact.discriminant().rounded()};
}

/// circle_extent() of the row of `other`, with all that cancels in one sum.
template <class T>
T extent_of_circle(const MoebiusSite& base, const MoebiusSite& other) {
  const T dx = T(other.p.x) - T(base.p.x), dy = T(other.p.y) - T(base.p.y);
  const T l = T(other.lambda) - T(base.lambda);
  return T(base.lambda) * T(other.lambda) * (dx * dx + dy * dy) + l * (T(other.mu) - T(base.mu));
}

/// Whether the permutation that `sort` made is odd; sorts three sites by position.
bool sort_by_position(const SitePredicates& sites, std::array<std::uint32_t, 3>& s) {
  bool odd = false;
  const auto order = [&](std::size_t p, std::size_t q) {
    if (sites.compare_lex(s[p], s[q]) <= 0) return;
    std::swap(s[p], s[q]);
    odd = !odd;
  };
  order(0, 1), order(1, 2), order(0, 1);
  return odd;
}

}  // namespace

SitePredicates::SitePredicates(std::span<const MoebiusSite> sites) : sites_(sites) {
  double sum = 0;
  for (const MoebiusSite& s : sites) {
    sum += std::abs(s.lambda);
    const Vec2 half = 0.5 * s.p - 0.5 * sites[0].p;  // halves do not overflow
    extent_ = std::max(extent_, std::max(std::abs(half.x), std::abs(half.y)));
  }
  const double mean = sum / static_cast<double>(sites.size());
  if (mean > 0) usual_lambda_ = mean;  // subnormal ones may leave 0, and 0/0 is no coordinate
}

/// `polynomial(row)` with row(m, base) in the ring of the first stage that is certain.
template <class Polynomial>
int SitePredicates::sign_of(const Polynomial& polynomial) const {
  const Bounded b = polynomial([&](auto m, auto base) { return site_row<Bounded>(sites_[m], sites_[base]); });
  if (b.is_certain()) return b.sign();
  return polynomial([&](auto m, auto base) { return site_row<Dyadic>(sites_[m], sites_[base]); }).sign();
}

int SitePredicates::orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
  if (const int sign = site_orient3d_filter(sites_[a], sites_[b], sites_[c], sites_[d])) return sign;
  // det(-l, x, y) = -det(x, y, l).
  return sign_of([&](const auto& row) { return -det3(row(b, a), row(c, a), row(d, a)); });
}

int SitePredicates::power_test(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                               std::uint32_t e) const {
  if (const int sign = site_power_filter(sites_[a], sites_[b], sites_[c], sites_[d], sites_[e])) return sign;
  // -det(-l, x, y, w) = det(x, y, l, w): with all heights 1 over e, det(position, 1) is minus the
  // orientation.
  return sign_of([&](const auto& row) { return det4(row(a, e), row(b, e), row(c, e), row(d, e)); });
}

int SitePredicates::compare_lex(std::uint32_t a, std::uint32_t b) const {
  const MoebiusSite &s = sites_[a], &t = sites_[b];
  if (const int sign = compare(t.lambda, s.lambda)) return sign;
  const int direction = compare(s.lambda, 0);  // all sites of lambda 0 are in one place
  if (const int sign = compare(s.p.x, t.p.x)) return direction * sign;
  return direction * compare(s.p.y, t.p.y);
}

int SitePredicates::compare_height(std::uint32_t a, std::uint32_t b) const {
  return compare(sites_[b].mu, sites_[a].mu);  // equal positions: lambda p equal and lambda |p|^2 with it
}

int SitePredicates::orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, int drop) const {
  const auto det = [&]<class T>(T) {
    const auto r = projected_row<T>(sites_[b], sites_[a], drop),
               s = projected_row<T>(sites_[c], sites_[a], drop);
    return det2(r.x, r.y, s.x, s.y);
  };
  const Bounded filter = det(Bounded(0));
  return filter.is_certain() ? filter.sign() : det(Dyadic(0)).sign();
}

int SitePredicates::power_test2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                                 int drop) const {
  const auto det = [&]<class T>(T) {
    const auto row = [&](std::uint32_t m) { return projected_row<T>(sites_[m], sites_[d], drop); };
    return det3(row(a), row(b), row(c));
  };
  const Bounded filter = det(Bounded(0));
  return filter.is_certain() ? filter.sign() : det(Dyadic(0)).sign();
}

int SitePredicates::power_test1d(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  // Along the first axis that tells a from b, relative to c: the line is at (w_a t_b - w_b t_a) / (t_b - t_a)
  // there.
  const MoebiusSite &s = sites_[a], &t = sites_[b];
  const int direction = compare_lex(b, a);
  const auto height = [&](const auto& r, const auto& q) {
    if (s.lambda != t.lambda) return r.z * q.w - r.w * q.z;  // -l
    return s.p.x != t.p.x ? r.w * q.x - r.x * q.w : r.w * q.y - r.y * q.w;
  };
  return direction * sign_of([&](const auto& row) { return height(row(a, c), row(b, c)); });
}

bool SitePredicates::vertex_inside(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const {
  return sign_of([&](const auto& row) {
           return PowerVertex(PowerLine(row(j, i), row(k, i)), row(l, i)).inside();
         }) > 0;
}

bool SitePredicates::line_passes(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  return sign_of([&](const auto& row) { return PowerLine(row(j, i), row(k, i)).discriminant(); }) > 0;
}

bool SitePredicates::rises_away(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const {
  return sign_of([&](const auto& row) {
           const PowerLine line(row(j, i), row(k, i));
           return PowerVertex(line, row(l, i)).rise(line);
         }) > 0;
}

bool SitePredicates::line_leads_up(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  // The third coordinate is -Z.
  return sign_of([&](const auto& row) { return PowerLine(row(j, i), row(k, i)).uz; }) < 0;
}

bool SitePredicates::circle_exists(std::uint32_t i, std::uint32_t j) const {
  return sign_of([&](const auto& row) { return circle_extent(row(j, i)); }) > 0;
}

bool SitePredicates::circle_clears(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  return sign_of([&](const auto& row) { return circle_clearance(row(j, i), row(k, i)); }) > 0;
}

std::array<Vec2, 2> SitePredicates::crossings(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  std::array<std::uint32_t, 3> s{i, j, k};
  const bool odd = sort_by_position(*this, s);
  auto points = crossings_of(rounded_line(sites_[s[0]], sites_[s[1]], sites_[s[2]]), sites_[s[0]].p);
  if (odd) std::swap(points[0], points[1]);
  return points;
}

double rounded_circle_extent(const MoebiusSite& base, const MoebiusSite& other) {
  const Bounded extent = extent_of_circle<Bounded>(base, other);
  return is_sharp(extent) ? extent.value : extent_of_circle<Dyadic>(base, other).rounded();
}

}  // namespace crossloft
