#pragma once
/// The arcs of a Moebius diagram between two sites, found on the facet where their power cells meet.
///
/// The facet is a convex polygon, bounded or not; the surface over it (the paraboloid of the lifting, or the
/// centres of tangent spheres) is the border of a convex region. So facet and region meet in a convex set,
/// whose border runs in turns along the facet's own border and along the surface: the latter pieces are the
/// arcs.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/ids.h"

namespace crossloft {

/// How one side of a facet, walked counter-clockwise around it, meets the open region within the surface.
enum class Passage : std::uint8_t {
  outside,  ///< no common point
  inside,   ///< all of it
  enters,   ///< begins outside, ends inside
  leaves,   ///< begins inside, ends outside
  dips      ///< begins and ends outside, inside in between
};

/// A point where the border of the facet crosses the surface.
struct FacetCrossing {
  std::uint32_t side = kNone;  ///< number of the side
  std::uint8_t root = 0;       ///< 1 for the second crossing of a side that dips
  friend bool operator==(const FacetCrossing&, const FacetCrossing&) = default;
};

/// A piece of the surface across the facet: from where its border leaves the region to where it next enters
/// it.
struct FacetArc {
  FacetCrossing from, to;
};

/// Appends the arcs of one facet. `sides` are its sides in counter-clockwise order; a gap at infinity between
/// two sides is a side too. Each begins as the one before it ends. No arc if the border never crosses: then
/// the surface misses the facet, or lies within it as one whole curve, which the caller decides. Linear time.
void cut_facet(std::span<const Passage> sides, std::vector<FacetArc>& arcs);

}  // namespace crossloft
