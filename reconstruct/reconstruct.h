#pragma once
/// The main job: sections in, solid and surface out (Boissonnat & Memari 2007).

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "../geom/result.h"
#include "../prune/prune.h"
#include "branching_options.h"
#include "join_request.h"
#include "report.h"
#include "surface.h"

namespace crossloft {

/// Tolerances are fractions of the diagonal of all contours' bounding box.
struct Options {
  PruneMode mode = PruneMode::natural;
  NaturalOptions natural;          ///< for the mode natural, as are
  std::vector<JoinRequest> joins;  ///< what the user says of single contours
  BranchingOptions branching;
  double match_tolerance = 2e-3;  ///< crossings of two sections on their common line that are taken as one
  double plane_tolerance = 1e-3;  ///< a vertex further from its plane is an error
  double on_tolerance = 1e-9;  ///< a contour vertex this near another plane is a crossing already, this near
                               ///< another edge of its plane it is on it
  double simplify =
      0;  ///< contours get fewer vertices and move no further than this; 0: they stay as they are
  double thicken = 0;  ///< flat section regions get a plate of solid no thicker than this; 0: they stay out
  double separation =
      0;  ///< above 0: what still touches then moves by up to this, though sections change with it
  bool separate = true;  ///< move copies of pinched vertices apart where no section changes
};

struct Reconstruction {
  Solid solid;
  Surface surface;  ///< closed, oriented, a 2-manifold by index; empty if there is nothing to join
  Sections
      sections;  ///< snapped, merged and split: what the solid meets exactly; its planes in canonical order
  Report report;
};

class Observer;

/// Reconstructs. The result does not depend on the order of planes, contours, vertices or on context.threads.
/// Errors: those of the input (ErrorCode up to contradicting_planes), too_thin, out_of_memory, cancelled,
/// internal; too_large for a coordinate beyond 1e100, where volumes would overflow, for contours that are all
/// together smaller than some 1e-309, and for an arrangement with more elements than an index can name.
/// Throws only what a callback throws (geom/README.md, "Memory"). No plane is an error; planes without
/// contours or one plane alone give an empty surface and a warning in the report. `observer` (observer.h) is
/// shown every intermediate product.
Result<Reconstruction> reconstruct(const Sections& sections, const Options& options = {},
                                   const Context& context = {}, Observer* observer = nullptr);

}  // namespace crossloft
