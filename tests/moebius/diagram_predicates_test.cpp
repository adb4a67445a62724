#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../../moebius/site_filters.h"
#include "../../moebius/site_predicates.h"

using namespace crossloft;

namespace {

using Sites = std::vector<MoebiusSite>;

/// A lifted site by definition: position (-L, L x, L y), height L |p|^2 - M; all exact.
struct Lifted {
  mpq_class at[3], height;

  explicit Lifted(const MoebiusSite& s) {
    const mpq_class l(s.lambda), x(s.p.x), y(s.p.y);
    at[0] = -l, at[1] = l * x, at[2] = l * y;
    height = l * (x * x + y * y) - mpq_class(s.mu);
  }
};

using Matrix = std::vector<std::vector<mpq_class>>;

mpq_class determinant(Matrix m) {
  mpq_class result = 1;
  for (std::size_t c = 0; c < m.size(); ++c) {
    std::size_t pivot = c;
    while (pivot < m.size() && m[pivot][c] == 0) ++pivot;
    if (pivot == m.size()) return 0;
    if (pivot != c) std::swap(m[pivot], m[c]), result = -result;
    result *= m[c][c];
    for (std::size_t r = c + 1; r < m.size(); ++r) {
      const mpq_class f = m[r][c] / m[c][c];
      for (std::size_t k = c; k < m.size(); ++k) m[r][k] -= f * m[c][k];
    }
  }
  return result;
}

/// Rows of the axes asked for, the height if asked for, and 1: lifted points without a common origin.
int sign_of(const std::vector<Lifted>& sites, std::vector<int> axes, bool with_height) {
  Matrix m;
  for (const Lifted& s : sites) {
    std::vector<mpq_class> row;
    for (const int a : axes) row.push_back(s.at[a]);
    if (with_height) row.push_back(s.height);
    row.push_back(1);
    m.push_back(row);
  }
  return sgn(determinant(m));
}

/// X, Y, Z where all d are equal, by Cramer's rule on d_k - d_0 = l Z - 2 x X - 2 y Y + height = 0.
struct Place {
  mpq_class x, y, z;
  bool is_inside() const { return z > x * x + y * y; }
};

Place power_vertex(const std::vector<Lifted>& s) {
  Matrix m;
  std::vector<mpq_class> right;
  for (std::size_t k = 1; k < 4; ++k) {
    m.push_back({-2 * (s[k].at[1] - s[0].at[1]), -2 * (s[k].at[2] - s[0].at[2]), -(s[k].at[0] - s[0].at[0])});
    right.push_back(s[0].height - s[k].height);
  }
  const mpq_class d = determinant(m);
  mpq_class v[3];
  for (std::size_t c = 0; c < 3; ++c) {
    Matrix n = m;
    for (std::size_t r = 0; r < 3; ++r) n[r][c] = right[r];
    v[c] = determinant(n) / d;
  }
  return {v[0], v[1], v[2]};
}

class Source {
 public:
  explicit Source(unsigned seed) : random_(seed) {}
  /// Small integers, thirds (whose products round), or reals of all sizes.
  MoebiusSite site(int kind) { return {{number(kind), number(kind)}, number(kind), number(kind)}; }

 private:
  double number(int kind) {
    const double n = std::uniform_int_distribution<int>(-3, 3)(random_);
    if (kind == 0) return n;
    if (kind == 1) return n / 3;
    const double real = std::uniform_real_distribution<double>(-1, 1)(random_);
    return kind == 2 ? real : std::ldexp(real, std::uniform_int_distribution<int>(-400, 400)(random_));
  }
  std::mt19937 random_;
};

}  // namespace

TEST_CASE("predicates of the triangulation") {
  for (int round = 0; round < 4000; ++round) {
    Source source(round);
    INFO("seed " << round);
    Sites sites;
    std::vector<Lifted> lifted;
    for (int k = 0; k < 5; ++k) {
      sites.push_back(source.site(round % 4));
      lifted.emplace_back(sites.back());
    }
    const SitePredicates p(sites);
    const std::vector<Lifted> four(lifted.begin(), lifted.begin() + 4);
    // Rows with a 1 at the end turn the other way than rows of differences from the first.
    CHECK(p.orient3d(0, 1, 2, 3) == -sign_of(four, {0, 1, 2}, false));
    CHECK(p.power_test(0, 1, 2, 3, 4) == -sign_of(lifted, {0, 1, 2}, true));
    for (int axis = 0; axis < 3; ++axis) {
      if (const int sign = cmp(lifted[0].at[axis], lifted[1].at[axis])) {
        CHECK(p.compare_lex(0, 1) == (sign > 0) - (sign < 0));
        break;
      }
      if (axis == 2) CHECK(p.compare_lex(0, 1) == 0);
    }
  }
}

TEST_CASE("predicates where all positions are on one plane or line") {
  for (int round = 0; round < 2000; ++round) {
    Source source(round);
    INFO("seed " << round);
    // lambda = 1 + x + 2 y puts (-L, L x, L y) on a plane only for three sites; equal lambdas for any number.
    Sites sites, along;
    std::vector<Lifted> lifted, lifted_along;
    const MoebiusSite first = source.site(round % 3);
    for (int k = 0; k < 4; ++k) {
      sites.push_back(source.site(round % 3));
      sites.back().lambda = first.lambda;
      along.push_back(source.site(round % 3));
      along.back().p = first.p;  // one place: the line through the origin
      lifted.emplace_back(sites.back());
      lifted_along.emplace_back(along.back());
    }
    const SitePredicates p(sites), q(along);
    const std::vector<Lifted> three(lifted.begin(), lifted.begin() + 3);
    CHECK(p.orient2d(0, 1, 2, 0) == sign_of(three, {1, 2}, false));
    CHECK(p.power_test2d(0, 1, 2, 3, 0) == -(-sign_of(lifted, {1, 2}, true)));
    if (q.compare_lex(0, 1) == 0) continue;
    const mpq_class t =
        (lifted_along[2].at[0] - lifted_along[0].at[0]) / (lifted_along[1].at[0] - lifted_along[0].at[0]);
    const mpq_class line = lifted_along[0].height + t * (lifted_along[1].height - lifted_along[0].height);
    CHECK(q.power_test1d(0, 1, 2) == sgn(mpq_class(line - lifted_along[2].height)));
  }
}

TEST_CASE("coordinates order the sites, whatever their sizes") {
  constexpr double tiny = std::numeric_limits<double>::denorm_min(),
                   huge = std::numeric_limits<double>::max();
  const Sites subnormal{{{0, 0}, 0, 0}, {{0, 2}, tiny, 1}};  // the mean lambda vanishes
  const Sites large{{{-huge, 0}, huge, 0}, {{huge, 2}, huge, 1}, {{0, 0}, 0, 0}};
  for (const Sites& sites : {subnormal, large, Sites{{{1, 2}, 0, 0}}}) {
    const SitePredicates p(sites);
    for (std::uint32_t i = 0; i < p.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) CHECK(std::isfinite(p.coordinate(i, axis)));
  }
}

TEST_CASE("projections of any three sites") {
  for (int round = 0; round < 2000; ++round) {
    Source source(round);
    INFO("seed " << round);
    const Sites sites{source.site(round % 4), source.site(round % 4), source.site(round % 4)};
    const std::vector<Lifted> lifted(sites.begin(), sites.end());
    const SitePredicates p(sites);
    for (int drop = 0; drop < 3; ++drop)
      CHECK(p.orient2d(0, 1, 2, drop) == sign_of(lifted, {(drop + 1) % 3, (drop + 2) % 3}, false));
  }
}

TEST_CASE("power vertices against the paraboloid") {
  int inside = 0, on = 0;
  for (int round = 0; round < 6000; ++round) {
    Source source(round);
    INFO("seed " << round);
    Sites sites;
    for (int k = 0; k < 4; ++k) sites.push_back(source.site(round % 4));
    if (round % 8 == 0)  // all equally far from (1, -2)
      for (MoebiusSite& s : sites) s.mu = s.lambda * dot(s.p - Vec2{1, -2}, s.p - Vec2{1, -2}) - 5;
    const SitePredicates p(sites);
    if (p.orient3d(0, 1, 2, 3) == 0) continue;
    const std::vector<Lifted> lifted(sites.begin(), sites.end());
    const Place place = power_vertex(lifted);
    CHECK(p.vertex_inside(0, 1, 2, 3) == place.is_inside());
    CHECK(p.vertex_inside(3, 1, 0, 2) == place.is_inside());
    inside += place.is_inside();
    on += place.z == place.x * place.x + place.y * place.y;
    // A tiny step away from the last site: where d_3 - d_0 is larger, the others being equal.
    const mpq_class step(1, mpz_class(1) << 2000);
    std::vector<Lifted> nudged = lifted;
    nudged[3].height -= step;  // the line crosses the plane of d_3 = d_0 + step
    const Place next = power_vertex(nudged);
    const mpq_class rise =
        (next.z - next.x * next.x - next.y * next.y) - (place.z - place.x * place.x - place.y * place.y);
    if (round % 4 < 3) CHECK(p.rises_away(0, 1, 2, 3) == (rise > 0));
  }
  CHECK(inside > 100);
  CHECK(on > 100);
}

namespace {

/// A computed value: its size and its distance from the true one, as multiples of the maxima that a bound is
/// made of.
struct Tracked {
  mpq_class size, error;
};

const mpq_class kUnit(filters::kU);

Tracked rounded(const mpq_class& size, const mpq_class& error) {
  return {size * (1 + kUnit), error + size * kUnit};
}
Tracked operator+(const Tracked& a, const Tracked& b) { return rounded(a.size + b.size, a.error + b.error); }
Tracked operator*(const Tracked& a, const Tracked& b) {
  return rounded(a.size * b.size, a.size * b.error + b.size * a.error + a.error * b.error);
}

/// An entry of computed size 1, rounded `times` times.
Tracked entry(int times) {
  mpq_class growth = 1;
  for (int k = 0; k < times; ++k) growth /= 1 - kUnit;
  return {1, growth - 1};
}

void check_constant(double constant, const Tracked& determinant) {
  mpq_class least(constant);
  for (int k = 0; k < 6; ++k) least *= 1 - kUnit;
  CHECK(least >= determinant.error);
  CHECK(least <= determinant.error * mpq_class(101, 100));
}

}  // namespace

TEST_CASE("error constants of the filters, recomputed") {
  const Tracked minor = entry(2) * entry(2) + entry(2) * entry(2), term = minor * entry(1);
  const Tracked det = (term + term) + term;
  check_constant(filters::kSiteOrient3dError, det);
  const Tracked height{entry(3).error + 1,
                       entry(6).error + 9 * kUnit * kUnit};  // W is rounded three times itself
  const Tracked pair = height * det + height * det;
  check_constant(filters::kSitePowerError, pair + pair);
}
