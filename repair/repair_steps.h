#pragma once
/// The steps of a repair over shared data; internal to repair/.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "planar_lattice.h"
#include "repair.h"

namespace crossloft::repair_steps {

/// Where the numbers of a plane of the file are among those of the plane that it is part of now.
struct FileNumbers {
  std::uint32_t source = kNone;  ///< position in the file
  std::uint32_t contours_begin = 0, contours_end = 0;
  std::uint32_t vertices_begin = 0, vertices_end = 0;
};

/// A plane on its way. Vertices are appended and never taken away before the end, so that numbers of vertices
/// are those of the file as long as there are that many.
struct WorkPlane {
  PlaneSection section;
  std::uint32_t source = kNone;  ///< position in the file
  Vec3 normal;                   ///< unit length, first component that is not 0 positive
  double offset = 0;             ///< half way between the extreme vertices, as framing does it
  bool edited = false;
  bool torn = false;        ///< vertices stay beside it, beyond the limit: its offset is where the others are
  std::uint32_t given = 0;  ///< vertices in the file; those after them are new
  std::vector<FileNumbers> numbers = {};  ///< its own, and those of planes united with it
};

struct Work {
  const RepairOptions& options;
  const Context& context;
  std::vector<WorkPlane> planes;  ///< in the order of the file
  Vec3 middle;                    ///< of the box around the contours that count
  double diagonal = 0;
  Repair result;

  PlaneChart chart(const WorkPlane& plane) const { return {plane.normal, plane.offset, middle, diagonal}; }
  /// Nothing moves further than the limit, whatever a tolerance allows.
  double capped(double length) const { return std::min(length, options.limit * diagonal); }
  void note(RepairChange change) { result.changes.push_back(std::move(change)); }
};

/// Normal and offset of the plane from its section as it is now.
void settle_plane(WorkPlane& plane);

/// Of planes in the order of the file.
void drop_flat_contours(Work& work, const std::vector<std::vector<std::uint32_t>>& flat);

// In this order. Cancelled, a step ends soon and leaves something that is of no use.
void repair_planes(Work& work);
void unite_planes(Work& work);
void repair_chains(Work& work);
void repair_crossings(Work& work);
void repair_loops(Work& work);
void repair_agreement(Work& work);
/// Of sections that were changed. True iff there were some.
bool remove_new_spikes(Work& work);
/// Late, since points on the grid bend runs.
void straighten_runs(Work& work);
/// Crossings without partner, as the reconstruction will find them, of sections that were changed and of
/// planes that nothing is told of so far.
void tell_unmatched(Work& work);

/// True iff the vertex of a plane is a crossing with another plane.
bool on_another_plane(const Work& work, const WorkPlane& plane, Vec3 v);

/// "3 vertices", "1 vertex".
std::string count_of(std::size_t n, const char* one, const char* several);

}  // namespace crossloft::repair_steps
