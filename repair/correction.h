#pragma once
/// How far a contour has to be moved next to a misfit of its line.

#include <array>

#include "line_target.h"

namespace crossloft {

/// How much further than it must a contour is moved at most, so that it does not end up at the line.
inline constexpr double kPush = 1.25;
/// A correction falls off over this many times its size: the contour turns by an angle of 1 : kReach.
inline constexpr double kReach = 3;

/// The difference between blend and distance along a misfit, at most kPush times its depth, led into the
/// plane: it falls off to 0 within kReach times its largest value. Towards the side of its span.
class Correction {
 public:
  /// `least`: it is not capped below this. O(log n) for a section of n edges.
  Correction(const SectionBoundary& section, const CommonLine& line, const LineTarget& target,
             const Misfit& misfit, bool inside, double least);

  bool inside() const { return inside_; }  ///< the section is to be extended, not taken back
  double reach() const { return reach_; }
  bool holds(double t) const { return misfit_.begin <= t && t <= misfit_.end; }
  /// In the misfit or no further than `least` from it: the old crossing at its end is to be left behind.
  bool is_near(double t) const { return misfit_.begin - least_ <= t && t <= misfit_.end + least_; }
  /// At t along the line and s beside it.
  double operator()(double t, double s) const;
  /// Positions along the line, within its reach, at which it is well seen.
  void add_samples(std::vector<double>& samples) const;

 private:
  static constexpr int kAcross = 8, kBeyond = 8;
  double size_at(double t) const;

  Misfit misfit_;
  bool inside_;
  double least_;
  std::array<double, kAcross + 1> sizes_{};
  double reach_ = 0;
};

}  // namespace crossloft
