#pragma once
/// What `.contour` and `.csl` have in common: the header of a plane, the sign of D, and materials.

#include <set>

#include "../geom/context.h"
#include "section_grammar.h"

namespace crossloft {

/// Reads "A B C D" into the plane. Errors: those of TokenReader::real, zero_normal.
void read_plane_equation(TokenReader& in, PlaneSection& plane);

/// Reads `count` vertices into the plane.
void read_vertices(TokenReader& in, std::uint32_t count, PlaneSection& plane);

/// What is told of all planes of a file together.
///
/// The convention of D is n.x + D = 0, but files with n.x = D exist. One sign is chosen for the whole file,
/// the one with the smaller sum of distances of the vertices from their planes.
class SectionConventions {
 public:
  /// Takes the planes one after the other.
  void observe(const ParsedPlane& plane);
  /// Tells the context, once all planes have been seen: that the sign of D was changed, that walls bound more
  /// than one material (inside is any), that labels name the outside.
  void tell(const Context& context) const;
  /// Negates the offset if the file has n.x = D.
  void apply(PlaneSection& plane) const;

 private:
  bool is_negated() const { return residual_negated_ < residual_; }

  double residual_ = 0, residual_negated_ = 0;
  bool has_outside_label_ = false;
  std::set<std::int32_t> materials_;
};

}  // namespace crossloft
