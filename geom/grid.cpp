#include "grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "two_sum.h"

namespace crossloft {
namespace {

constexpr int kDataBits = 48;
constexpr int kSmallestExponent = 1074;                // of the smallest double, 2^-1074
constexpr double kExactIntegers = 9007199254740992.0;  // 2^53

/// v 2^exponent, rounded once where it leaves the range of doubles.
Vec3 scale(Vec3 v, int exponent) {
  constexpr int kLargest = 1022;  // such powers are doubles themselves
  if (exponent >= -kLargest && exponent <= kLargest)
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52) * v;
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}
double largest(Vec3 v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
/// Not floor(v + 0.5), whose sum may round up.
double round_up_half(double v) {
  const double below = std::floor(v);
  return v - below >= 0.5 ? below + 1 : below;
}
Vec3 round_up_half(Vec3 v) { return {round_up_half(v.x), round_up_half(v.y), round_up_half(v.z)}; }

}  // namespace

WorldGrid::WorldGrid(Vec3 low, Vec3 high) {
  // Halved before the subtraction, which could overflow; halves of the smallest doubles may vanish.
  double half = largest(scale(high, -1) - scale(low, -1));
  if (half == 0 && low != high) half = std::numeric_limits<double>::denorm_min();
  int bits = 0;  // half < 2^bits
  std::frexp(half == 0 ? 1.0 : half, &bits);
  exponent_ = kDataBits - bits;
  shift_ = round_up_half(scale(low, exponent_ - 1) + scale(high, exponent_ - 1));
}

Vec3 WorldGrid::scaled(Vec3 input) const { return scale(input, exponent_) - shift_; }

LatticeVector WorldGrid::to_lattice(Vec3 input) const {
  const Vec3 r = round_up_half(scaled(input));
  return {static_cast<std::int64_t>(r.x), static_cast<std::int64_t>(r.y), static_cast<std::int64_t>(r.z)};
}

Vec3 WorldGrid::from_lattice(const LatticePoint& p) const {
  return scale(Vec3{p.x, p.y, p.z} + shift_, -exponent_);
}

double WorldGrid::unit() const { return std::ldexp(1.0, -exponent_); }

bool WorldGrid::exact() const {
  const double farthest = largest(shift_) + static_cast<double>(kLatticeLimit);
  return exponent_ <= kSmallestExponent && farthest <= kExactIntegers &&
         std::isfinite(std::ldexp(farthest, -exponent_));
}

bool WorldGrid::exact_at(const LatticePoint& p) const {
  return exponent_ <= kSmallestExponent && two_sum(p.x, shift_.x).low == 0 &&
         two_sum(p.y, shift_.y).low == 0 && two_sum(p.z, shift_.z).low == 0;
}

}  // namespace crossloft
