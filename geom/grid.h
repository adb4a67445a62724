#pragma once
/// The world grid: the map between input coordinates and the integers of the exact model.

#include "lattice.h"
#include "vec3.h"

namespace crossloft {

/// lattice = input 2^exponent - shift, `shift` a vector of integers: multiplications by powers of two are
/// exact, so lattice points go back to input coordinates without rounding while |lattice + shift| <= 2^53.
/// That is so for data whose distance from the origin is at most some 28 times their extent (`exact()`);
/// beyond, and for coordinates below 1e-308, the doubles of the input are themselves coarser than the grid
/// and a point goes back to the nearest double.
class WorldGrid {
 public:
  /// The identity on integers.
  WorldGrid() = default;
  /// The finest grid that brings the box [low, high] to |x| <= 2^48, which leaves a factor of two for the box
  /// of the arrangement and another for kLatticeLimit. REQUIRES: finite, low <= high in every coordinate.
  WorldGrid(Vec3 low, Vec3 high);

  /// Lattice coordinates, not rounded to integers.
  Vec3 scaled(Vec3 input) const;
  /// The nearest lattice point, half way upwards. REQUIRES: the result within kLatticeLimit.
  LatticeVector to_lattice(Vec3 input) const;
  /// Input coordinates of a point; of the rounded point if it is not explicit.
  Vec3 from_lattice(const LatticePoint& p) const;
  /// Input length of one lattice unit.
  double unit() const;
  /// True iff every lattice point goes back to input coordinates without rounding.
  bool exact() const;
  /// True iff this one does. REQUIRES: explicit.
  bool exact_at(const LatticePoint& p) const;

 private:
  int exponent_ = 0;
  Vec3 shift_;
};

}  // namespace crossloft
