#pragma once
/// Who answers the predicates of lattice.h in the copy of the library that strategies run in.

#include "../../geom/lattice.h"

namespace crossloft::bench {

/// Answers are -1, 0 or +1.
class Answers {
 public:
  virtual ~Answers() = default;
  virtual int orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                       const LatticePoint& d) const = 0;
  virtual int insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                       const LatticePoint& d, const LatticePoint& e) const = 0;
  virtual int orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                       const LatticePoint& c) const = 0;
  virtual int incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                       const LatticePoint& c, const LatticePoint& d) const = 0;
  virtual int side_of_plane(const LatticePlane& plane, const LatticePoint& p) const = 0;
};

/// From now on, for all threads; to be called before the first question, and not while others ask.
void let_answer(const Answers& answers);

}  // namespace crossloft::bench
