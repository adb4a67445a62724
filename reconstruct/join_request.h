#pragma once
/// What the user says about the joining of sections.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/ids.h"
#include "../geom/result.h"
#include "../prune/prune.h"

namespace crossloft {

/// Two contours of the input that must, or must not, be joined within a cell of the arrangement that both
/// reach: there they bound the section on one of its faces. Numbers are positions in the file: of the plane,
/// and of the contour in it. Mode natural only; in others, and where no cell has both contours, a request
/// does nothing, with a warning. A request to join can't do what the tetrahedra don't allow. Errors (usage):
/// a request that names what is not in the file, or one contour twice, and two that contradict each other.
/// With a request that forbids, the second look joins no small bodies (reconstruct/README.md).
struct JoinRequest {
  std::uint32_t plane_a = kNone, contour_a = kNone;
  std::uint32_t plane_b = kNone, contour_b = kNone;
  bool join = true;
};

/// A request that names nothing would be passed over in silence. `section`: the plane at that position, null
/// if there is none. Error: usage.
Result<Done> check_named(const PlaneSection* section, std::uint32_t plane, std::uint32_t contour);

/// That each names two contours and none says the contrary of another, whichever contour comes first. Error:
/// usage. O(n log n).
Result<Done> check_against_each_other(std::span<const JoinRequest> requests);

/// What the user is told of requests that do nothing. `heard`: by request, not 0 if some cell has both
/// contours.
std::vector<std::string> why_unheard(std::span<const JoinRequest> requests, PruneMode mode,
                                     std::span<const std::uint8_t> heard);

}  // namespace crossloft
