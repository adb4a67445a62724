#include "tetrahedron_meeting.h"

#include <cstddef>

namespace crossloft {
namespace {

using Corner = const LatticePoint*;

/// The sides of the plane p q r that a tetrahedron reaches: the least and the greatest sign.
struct Reach {
  int low = 0, high = 0;
};

Reach reach(Corner p, Corner q, Corner r, const LatticeTet& t) {
  Reach found;
  for (const LatticePoint& s : t) {
    if (&s == p || &s == q || &s == r) continue;
    const int side = orient3d(*p, *q, *r, s);
    found.low = side < found.low ? side : found.low;
    found.high = side > found.high ? side : found.high;
    if (found.low * found.high < 0) break;
  }
  return found;
}

/// Collinear corners have no plane: then the tetrahedra, not flat, show no side and nothing is separated.
bool separates(Corner p, Corner q, Corner r, const LatticeTet& a, const LatticeTet& b) {
  const Reach at_a = reach(p, q, r, a);
  if (at_a.low * at_a.high < 0 || (at_a.low == 0 && at_a.high == 0)) return false;
  const Reach at_b = reach(p, q, r, b);
  return at_a.high > 0 ? at_b.high <= 0 : at_b.low >= 0;
}

/// Planes of facets first: they separate most that is apart.
bool facet_separates(const LatticeTet& a, const LatticeTet& b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (separates(&a[(i + 1) % 4], &a[(i + 2) % 4], &a[(i + 3) % 4], a, b)) return true;
  return false;
}

/// Planes through an edge of a and a corner of b.
bool edge_separates(const LatticeTet& a, const LatticeTet& b) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const LatticePoint& c : b)
        if (separates(&a[i], &a[j], &c, a, b)) return true;
  return false;
}

}  // namespace

bool overlap(const LatticeTet& a, const LatticeTet& b) {
  return !facet_separates(a, b) && !facet_separates(b, a) && !edge_separates(a, b) && !edge_separates(b, a);
}

}  // namespace crossloft
