#pragma once
/// Exact signs on Moebius sites: the predicates of their lifted regular triangulation, and where its dual,
/// the power diagram, lies against the paraboloid.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "../delaunay/point_predicates.h"
#include "diagram.h"

namespace crossloft {

/// Sites at the positions (-lambda, lambda p) with heights lambda |p|^2 - mu: the lower hull is dual to the
/// power diagram of the lifted distances (site_rows.h). The sign of the first coordinate makes a positive
/// tetrahedron one whose power vertices turn as it does.
///
/// Every sign is exact for all finite doubles: running error bounds (geom/bounded.h) first, then integers of
/// any length. The span must stay as it is. "Inside" is Z > |x|^2; a point exactly on the paraboloid is
/// outside, as if all mu were lowered by lambda times a tiny number, which is larger than the perturbation of
/// the triangulation. So decisions agree with each other whatever the ties.
class SitePredicates {
 public:
  explicit SitePredicates(std::span<const MoebiusSite> sites);

  const MoebiusSite& site(std::uint32_t i) const { return sites_[i]; }

  bool lambdas_equal(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return sites_[i].lambda == sites_[j].lambda && sites_[j].lambda == sites_[k].lambda;
  }

  // PowerPredicates3.
  std::uint32_t size() const { return static_cast<std::uint32_t>(sites_.size()); }
  /// In place of the position (it only orders) the place, and a bounded measure of lambda: positions of large
  /// lambda lie so far out that a curve through all of them would not find neighbours among the others.
  double coordinate(std::uint32_t i, int axis) const {
    const MoebiusSite& s = sites_[i];
    if (axis == 0) return extent_ * (s.lambda / (usual_lambda_ + std::abs(s.lambda)));
    return s.lambda == 0 ? 0 : axis == 1 ? s.p.x : s.p.y;
  }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;
  int power_test(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const;
  int compare_lex(std::uint32_t a, std::uint32_t b) const;
  int compare_height(std::uint32_t a, std::uint32_t b) const;
  int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, int drop) const;
  int power_test2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, int drop) const;
  int power_test1d(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  /// The power vertex of four sites is inside. REQUIRES: they are affinely independent.
  bool vertex_inside(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const;
  /// The line where d_i = d_j = d_k passes through the inside. REQUIRES: not collinear, and the line not
  /// vertical.
  bool line_passes(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  /// On that line, away from l, it goes inwards at the power vertex of the four: Z - |x|^2 rises.
  bool rises_away(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const;
  /// The direction r x s of that line, r = j - i and s = k - i (PowerLine), leads straight up. REQUIRES:
  /// lambdas equal, not collinear.
  bool line_leads_up(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  /// i and j are equally near along a circle that is more than a point. REQUIRES: lambdas differ.
  bool circle_exists(std::uint32_t i, std::uint32_t j) const;
  /// d_k > d_i = d_j at the centre of that circle, in (X, Z) space.
  bool circle_clears(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

  /// Where the line enters and leaves the inside, walked along r x s, in doubles: the same bits for every
  /// order of the sites. Both are the same point on a vertical line. REQUIRES: it does.
  std::array<Vec2, 2> crossings(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

 private:
  template <class Polynomial>
  int sign_of(const Polynomial& polynomial) const;

  std::span<const MoebiusSite> sites_;
  double usual_lambda_ = 1;  ///< mean absolute one
  double extent_ = 0;        ///< of the places, halved
};

/// circle_extent() of site_rows.h in doubles, 35 good bits at least. REQUIRES: lambdas differ.
double rounded_circle_extent(const MoebiusSite& base, const MoebiusSite& other);

static_assert(PowerPredicates3<SitePredicates>);

}  // namespace crossloft
