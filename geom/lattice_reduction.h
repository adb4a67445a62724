#pragma once
/// Integer vectors close to a wanted direction; included by geom's sources only, since it pulls in Boost.

#include <array>
#include <cstdint>
#include <span>

#include "homogeneous.h"
#include "lattice.h"

namespace crossloft {

/// Wide enough for products of two values of a DirectionForm, see there.
using Wide = Fixed<512>;
using WideVector = std::array<Wide, 3>;

WideVector widen(const LatticeVector& v);
/// REQUIRES: fits.
LatticeVector narrow(const WideVector& v);
WideVector operator+(const WideVector& a, const WideVector& b);
WideVector operator-(const WideVector& a, const WideVector& b);
WideVector operator*(const Wide& s, const WideVector& a);
Wide dot(const WideVector& a, const WideVector& b);
WideVector cross(const WideVector& a, const WideVector& b);
/// n / d to the nearest integer, half way upwards. REQUIRES: d > 0.
Wide round_quotient(const Wide& n, const Wide& d);

/// The quadratic form |x|^2 + 4^weight |x x d|^2 / |2^46|^2, scaled to integers: short vectors are both short
/// and close to the direction d; the larger the weight, the closer and the longer. d has |d_k| <= 2^46.
/// For a basis that starts from unit vectors and only ever gets shorter, values stay below 2^122; for one
/// that starts in the kernel of an axis of at most 2^30, below 2^190, in that of a normal of at most 2^40,
/// below 2^210.
class DirectionForm {
 public:
  DirectionForm(const LatticeVector& direction, int weight);
  Wide operator()(const WideVector& x, const WideVector& y) const;

 private:
  WideVector direction_;
  Wide direction_norm_;
  int length_shift_ = 0, angle_shift_ = 0;
};

/// Makes the basis as short as it gets under the form, shortest first: Lagrange's reduction for two vectors,
/// Semaev's (A 3-dimensional lattice reduction algorithm, 2001) for three. The span stays the same.
/// REQUIRES: two or three independent vectors.
void reduce_basis(std::span<WideVector> basis, const DirectionForm& form);
/// Lagrange's reduction in the Euclidean sense.
void reduce_basis(WideVector& a, WideVector& b);

/// { x : n.x = 0 } = Z a + Z b with (a, b) reduced, a x b = n, and a point with n.t = 1. A function of n
/// alone.
struct Kernel {
  WideVector a, b, t;
};
/// REQUIRES: gcd of the components 1.
Kernel kernel_of(const LatticeVector& n);

}  // namespace crossloft
