#pragma once
/// The smoothest function through given values.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "section_field.h"

namespace crossloft {

/// A sum of cubed distances to the samples and a linear function, with the samples' values at the samples:
/// among all such functions the one that bends least (a polyharmonic spline; Duchon 1977, Carr et al. 2001).
class SmoothFunction {
 public:
  /// Nothing where the samples do not determine it: all in one plane. O(n^3).
  static std::optional<SmoothFunction> through(std::span<const FieldSample> samples, Vec3 centre,
                                               double unit);
  /// At two points together, as that is faster. O(n)
  std::array<double, 2> at(Vec3 p, Vec3 q) const;

 private:
  SmoothFunction(Vec3 centre, double unit) : centre_(centre), per_unit_(1 / unit) {}
  Vec3 scaled(Vec3 p) const { return per_unit_ * (p - centre_); }

  Vec3 centre_;
  double per_unit_;
  std::vector<Vec3> points_;     ///< scaled
  std::vector<double> weights_;  ///< of the points; then of 1, x, y, z
};

}  // namespace crossloft
