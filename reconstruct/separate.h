#pragma once
/// Separation: copies of one point (glue.h) come apart in space, not by index only.
///
/// Around a copy its triangles form a cone that the other copies only touch: the tip of a solid wedge, or of
/// a void that the solid encloses. Pulling the copy into its cone opens the contact. Where that is allowed is
/// for the caller to say (Confinement); that nothing is hit on the way is decided here, exactly on the
/// coordinates.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/bounds.h"
#include "../geom/context.h"
#include "glue.h"
#include "surface.h"

namespace crossloft {

/// The triangles of a surface around one of its vertices, ascending by number.
struct Umbrella {
  std::uint32_t vertex = kNone;
  std::span<const std::uint32_t> triangles;
};

/// What must not be lost by a move.
class Confinement {
 public:
  virtual ~Confinement() = default;
  virtual bool may_move(const Umbrella& umbrella) const = 0;
  /// Brings `place` to the nearest one allowed for the umbrella's vertex; false if there is none nearby.
  /// Asked about umbrellas that may move only.
  virtual bool admit(const Umbrella& umbrella, Vec3& place) const = 0;
};

/// How hard it is tried.
struct SeparationEffort {
  double longest = Bounds::kFar;  ///< no copy moves further from its place
  int halvings = 4;               ///< of the step where the way is not free
  /// Copies with more triangles around them stay where they are: in a tangle of n there are n^2 pairs.
  /// (Copies in measured data have 1052 at most.)
  std::uint32_t most_around = 4096;
  /// Above 0: only copies that still touch another one move, and where the best direction is not free 343
  /// others are tried, until no copy moves any more but in so many rounds at most.
  int rounds = 0;
};

struct Separation {
  std::uint32_t separated = 0;  ///< copies that moved
  /// Copies left beyond one a place, ascending; before the moves GluedSurface::copies of them.
  std::vector<std::uint32_t> touching;
  std::vector<std::uint32_t> crowded;  ///< those that touch others and might have moved, but for most_around
  double largest = 0;                  ///< longest move
};

/// Moves copies, in the order of their numbers, into the cones of their umbrellas: by a fiftieth of the
/// shortest edge there, by half of it and so on down to 1/16 if the way is not free, else not at all.
///
/// The way is free iff no other vertex lies in what the umbrella sweeps, the new place is on no other
/// triangle, and no triangle of the moved umbrella is degenerate or crosses or overlaps another one, as
/// inspect/check.h counts it. All exact on the double coordinates, each move against those before it: a
/// surface without crossings stays one. Not asked: that all triangles have the new place on one side; of a
/// cone that is not star-shaped none is, and a short move along it is as good.
///
/// With `effort` nothing changes but how many ways are tried, and which copies.
///
/// `origins` are those of the surface's points, copies of one point side by side. Expected O(n log m) for n
/// triangles and m copies that may move, at worst O(n m). Stops early if cancelled. Source: the choice and
/// the tests are our own.
Separation separate_copies(Surface& surface, std::span<const SurfaceVertex> origins,
                           const Confinement& confinement, const SeparationEffort& effort = {},
                           const Context& context = {});

}  // namespace crossloft
