#pragma once
/// The mode `natural`: the solid between the sections that looks likely and has no handle that they do not
/// ask for.

#include <cstdint>
#include <vector>

#include "cell_complex.h"
#include "cell_shape.h"
#include "cell_topology.h"
#include "ground.h"
#include "second_look.h"
#include "simple_growth.h"
#include "spikes.h"

namespace crossloft {

inline constexpr double kLargestSmoothWeight = 1e9;

/// In which cells something is done that takes time. `automatic`: where planes meet, so not between two
/// planes of a stack, whose sections lie face to face.
enum class InCells : std::uint8_t { off, automatic, all };

/// Confidences are -1..1, the weight 0..kLargestSmoothWeight.
struct NaturalOptions {
  double join_confidence = -0.03;  ///< two sections are joined where the best way between them has this
  double dome_confidence = -0.4;   ///< a hole in a section is closed over where the last piece has this
  double alone_confidence = -0.5;  ///< a small body that no cell joins with anything is joined from this on
  double cavity_confidence = 0;    ///< a cavity is opened where a wall is less sure than this, and nothing
                                   ///< less sure is built there; -1: cavities stay
  double smooth_weight = 1;        ///< of a small surface against a likely volume
  /// Tetrahedra that are lost for an edge outside are divided by points inside the cell, before it is pruned
  /// (interior_places.h).
  InCells divide = InCells::automatic;
  /// Joins in doubt are decided by the planes around the cell (likely_joins.h), if its shape has them; else a
  /// cell is pruned by itself.
  InCells look_around = InCells::automatic;
};

/// What happened in a cell.
struct NaturalReport {
  CellTopology before;  ///< of what the cut leaves
  CellTopology after;
  bool grown = false;       ///< whether growth had to decide
  std::vector<Join> joins;  ///< done, the most confident first or in the order of growth; then refused ones
  std::vector<std::int32_t> domes;  ///< confidences of those that growth closed
  std::uint32_t handles = 0;        ///< that the sections ask for: the genus of the result, which has less
                                    ///< where sections touch in a point (CellTopology::outsides), and
                                    ///< where a body with one was dropped
  std::uint32_t joined_alone = 0;   ///< joins by request, of bodies that were alone
  std::uint32_t opened = 0;         ///< requests to leave open that came true
  std::uint32_t dropped = 0;        ///< spikes, by request
  std::vector<Spike> spikes;        ///< kept, as they may be all that the section has
};

/// What a cell is asked for beyond its options: by the user, and by what its neighbours have found.
struct CellRequests {
  std::vector<JoinWish> wishes;
  std::vector<TetName> joined;  ///< bodies to be joined with what they most likely belong to
  std::vector<OpenRequest> opened;
  std::vector<TetName> dropped;  ///< of spikes, whose sections need none
  bool walls = true;             ///< those that the sections ask for are built
  bool handles = true;  ///< those that the sections ask for may come
  CancelFlag cancel = nullptr;  ///< once it is raised the result comes soon, and means nothing
};

struct NaturalResult {
  std::vector<std::uint8_t> kept;
  std::uint32_t r2 = 0;  ///< tetrahedra that the cut leaves
  NaturalReport report;
};

/// (1) Confidences of the tetrahedra of R1 (confidence.h). (2) The cheapest subset of R1 (energy.h). (3)
/// Where that has handles, holes, domes or joins that are not sure: growth from the sections within it by
/// moves that make no handle but where the sections ask for one (simple_growth.h), and its cracks filled;
/// also where it lacks walls that R1 has (walls.h). (4) If the shape has a field: joins in doubt are decided
/// by it, with growth again where that changes any (likely_joins.h). (5) Requested joins, filled in by
/// growth, then requested drops. The result depends on the tetrahedra and vertex numbers alone, and on the
/// field. REQUIRES: the ground is the complex's.
NaturalResult prune_naturally(const CellComplex& complex, const Ground& ground, const CellShape& shape,
                              const std::vector<std::uint8_t>& r1, const NaturalOptions& options,
                              const CellRequests& requests);

}  // namespace crossloft
