#include "../../geom/bounded.h"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <limits>
#include <random>
#include <vector>

using namespace crossloft;

namespace {

/// A bounded number beside the true one.
struct Pair {
  Bounded bounded;
  mpq_class exact;
};

bool holds(const Pair& p) {
  if (!std::isfinite(p.bounded.value) || !std::isfinite(p.bounded.error)) return true;
  return abs(p.exact - mpq_class(p.bounded.value)) <= mpq_class(p.bounded.error);
}

bool claims_truth(const Pair& p) { return !p.bounded.is_certain() || p.bounded.sign() == sgn(p.exact); }

/// Random sums and products of what is there, from doubles of all sizes.
class Expressions {
 public:
  Expressions(unsigned seed, int exponents) : random_(seed) {
    for (int k = 0; k < 12; ++k) {
      const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random_);
      const double v =
          std::ldexp(mantissa, std::uniform_int_distribution<int>(-exponents, exponents)(random_));
      numbers_.push_back({Bounded(v), mpq_class(v)});
    }
    numbers_.push_back({Bounded(0), 0});
    numbers_.push_back({Bounded(1), 1});
  }

  Pair next() {
    const Pair a = any(), b = any();
    Pair r;
    switch (std::uniform_int_distribution<int>(0, 3)(random_)) {
      case 0:
        r = {a.bounded + b.bounded, a.exact + b.exact};
        break;
      case 1:
        r = {a.bounded - b.bounded, a.exact - b.exact};
        break;
      case 2:
        r = {a.bounded * b.bounded, a.exact * b.exact};
        break;
      default:
        r = {-a.bounded, -a.exact};
    }
    numbers_.push_back(r);
    return r;
  }

 private:
  Pair any() { return numbers_[std::uniform_int_distribution<std::size_t>(0, numbers_.size() - 1)(random_)]; }

  std::mt19937 random_;
  std::vector<Pair> numbers_;
};

}  // namespace

TEST_CASE("the truth is within the error") {
  int certain = 0;
  for (const int exponents : {1, 40, 300, 1000})
    for (unsigned seed = 0; seed < 200; ++seed) {
      INFO("exponents " << exponents << ", seed " << seed);
      Expressions expressions(seed, exponents);
      for (int k = 0; k < 24; ++k) {
        const Pair p = expressions.next();
        CHECK(holds(p));
        CHECK(claims_truth(p));
        certain += p.bounded.is_certain();
      }
    }
  CHECK(certain > 4000);
}

TEST_CASE("products that underflow are not taken for zero") {
  const Bounded tiny(0x1p-600);
  CHECK(!(tiny * tiny).is_certain());
  CHECK(!((tiny * tiny) * Bounded(0x1p+1000)).is_certain());
  CHECK((tiny * Bounded(0)).is_zero());
  const Bounded smallest(std::numeric_limits<double>::denorm_min());
  CHECK((smallest - smallest).is_zero());
  CHECK((smallest + smallest).value == 2 * smallest.value);
}

TEST_CASE("what overflows is not certain") {
  const Bounded huge(0x1p+900);
  CHECK(!(huge * huge).is_certain());
  CHECK(!(huge * huge - huge * huge).is_certain());
}

TEST_CASE("a vanishing factor decides") {
  const Bounded a(0.1), b(0.2);
  CHECK(((a - a) * (a * b + b)).is_certain());
  CHECK(!((a + b) - Bounded(0.3)).is_zero());
}
