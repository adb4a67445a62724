// In the place of the functions that geom/lattice_predicates.cpp leaves out when CROSSLOFT_BENCH_STRATEGIES
// is defined.

#include "routed_predicates.h"

namespace crossloft {

static const bench::Answers* answers = nullptr;

void bench::let_answer(const Answers& to) { answers = &to; }

int orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  return answers->orient3d(a, b, c, d);
}
int insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
             const LatticePoint& e) {
  return answers->insphere(a, b, c, d, e);
}
int orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  return answers->orient2d(plane, a, b, c);
}
int incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
             const LatticePoint& d) {
  return answers->incircle(plane, a, b, c, d);
}
int side_of_plane(const LatticePlane& plane, const LatticePoint& p) {
  return answers->side_of_plane(plane, p);
}

}  // namespace crossloft
