#pragma once
/// Exact representation behind LatticePoint; included by geom's sources only, since it pulls in Boost.

// GCC 12 takes the copy loop between fixed widths for a copy past the end of the narrower one.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Warray-bounds"
#endif
#include <boost/multiprecision/cpp_int.hpp>

namespace crossloft {

/// Signed fixed width integer of `Bits` bits on the stack: no allocation, no overflow check; widths are
/// proven where they are used.
template <unsigned Bits>
using Fixed = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<Bits, Bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// (x, y, z) / w, w >= 2, gcd(x, y, z, w) = 1. Widths: w <= 122 bits and |x| <= 2^50 w.
struct Homogeneous {
  Fixed<192> x, y, z;
  Fixed<128> w;
};

}  // namespace crossloft
