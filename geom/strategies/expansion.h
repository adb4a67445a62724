#pragma once
/// Strategy: expansions, sums of doubles that don't overlap, as long as a value needs; zeros are dropped, so
/// the length adapts to the data. Exact: within the ranges of number_range.h nothing over- or underflows, and
/// doubles outside of them are left to FixedIntegers; homogeneous coordinates are scaled into the range.
///
/// Invariant: components are nonzero, of increasing size, and strongly nonoverlapping, which sums (merged by
/// size) and products with a double keep in round-to-even arithmetic (Theorems 13 and 19 of the source; a
/// product of expansions is a sum of products with a double). The largest one has the sign of the whole.
/// Source: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates,
/// 1997, sections 2.4 to 2.6.

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "../two_sum.h"
#include "lattice_pieces.h"
#include "number_range.h"
#include "number_strategy.h"

namespace crossloft::strategies {

class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double v) { push(v); }
  Expansion(const Expansion& other) : Expansion(Room{other.size_}) { copy(other); }
  Expansion(Expansion&& other) noexcept : heap_(std::move(other.heap_)), size_(other.size_) {
    if (!heap_) copy(other);
  }
  Expansion& operator=(const Expansion& other) { return *this = Expansion(other); }
  Expansion& operator=(Expansion&& other) noexcept {
    heap_ = std::move(other.heap_), size_ = other.size_;
    if (!heap_) copy(other);
    return *this;
  }

  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return data()[i]; }
  int sign() const { return size_ == 0 ? 0 : data()[size_ - 1] > 0 ? 1 : -1; }

  friend Expansion operator+(const Expansion& a, const Expansion& b) { return sum(a, b, 1); }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return sum(a, b, -1); }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    if (a.size_ < b.size_) return b * a;
    Expansion product;
    for (std::size_t i = 0; i < b.size_; ++i)
      product = i == 0 ? scaled(a, b[0]) : sum(product, scaled(a, b[i]), 1);
    return product;
  }

 private:
  static constexpr std::size_t kInline = 24;
  struct Room {
    std::size_t size;
  };
  explicit Expansion(Room room) {
    if (room.size > kInline) heap_ = std::make_unique_for_overwrite<double[]>(room.size);
  }

  double* data() { return heap_ ? heap_.get() : inline_.data(); }
  const double* data() const { return heap_ ? heap_.get() : inline_.data(); }
  void push(double v) {
    data()[size_] = v;
    size_ += v != 0;
  }
  /// REQUIRES: room for it.
  void copy(const Expansion& other) {
    size_ = other.size_;
    for (std::size_t i = 0; i < size_; ++i) data()[i] = other.data()[i];
  }

  /// a + sign b.
  static Expansion sum(const Expansion& a, const Expansion& b, double sign) {
    Expansion r(Room{a.size_ + b.size_ + 1});
    double q = 0;
    for (std::size_t i = 0, j = 0; i < a.size_ || j < b.size_;) {
      const bool from_a = j == b.size_ || (i < a.size_ && std::fabs(a[i]) < std::fabs(b[j]));
      const Exact2 s = two_sum(q, from_a ? a[i++] : sign * b[j++]);
      q = s.high;
      r.push(s.low);
    }
    r.push(q);
    return r;
  }

  static Expansion scaled(const Expansion& a, double b) {
    Expansion r(Room{2 * a.size_ + 1});
    const Exact2 halves = split(b);
    double q = 0;
    for (std::size_t i = 0; i < a.size_; ++i) {
      const Exact2 p = two_product(a[i], b, halves), s = two_sum(q, p.low);
      r.push(s.low);
      const Exact2 t = fast_two_sum(p.high, s.high);
      r.push(t.low);
      q = t.high;
    }
    r.push(q);
    return r;
  }

  // Not initialised: most numbers have few components.
  std::array<double, kInline> inline_;
  std::unique_ptr<double[]> heap_;
  std::size_t size_ = 0;
};

struct ExpansionArithmetic {
  using Number = Expansion;
  static constexpr std::string_view kName = "expansions";
  static constexpr Guarantee kGuarantee = Guarantee::exact;
  static constexpr bool kIntegers = false, kHomogeneous = true;

  static bool accepts(double v) { return range::holds(v, range::kSmallest, range::kLargest); }
  static bool accepts_weight(double v) {
    return range::holds(v, range::kSmallestWeight, range::kLargestWeight);
  }
  static Expansion from_integer(double v) { return Expansion(v); }
  static Expansion from_double(double v) { return Expansion(v); }
  template <unsigned Bits>
  static Expansion from_fixed(const FixedInt<Bits>& v) {
    return sum_of_pieces<Expansion>(v);
  }
  static Verdict sign(const Expansion& v) { return v.sign(); }
};

using Expansions = NumberStrategy<ExpansionArithmetic>;
static_assert(Strategy<Expansions>);

}  // namespace crossloft::strategies
