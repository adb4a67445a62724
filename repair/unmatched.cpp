/// A last look with the eyes of the reconstruction: where a section was changed, a crossing without partner of
/// two planes of which nothing is told so far is told, whatever the steps before have thought of.

#include <algorithm>

#include "../arrangement/data_box.h"
#include "../arrangement/section_graph.h"
#include "repair_steps.h"

namespace crossloft::repair_steps {
namespace {

// As the reconstruction has them if not told otherwise.
constexpr double kOffPlane = 1e-3, kOn = 1e-9, kMatch = 2e-3;

/// A crossing of one plane's contour with another plane that has none there, by positions in work.planes.
struct LonelyCrossing {
  std::uint32_t plane = kNone, other = kNone;
  Vec3 at;
};

Result<std::vector<LonelyCrossing>> lonely_crossings(const Work& work) {
  Sections sections;
  for (const WorkPlane& p : work.planes) sections.planes.push_back(p.section);
  Context quiet;
  quiet.cancel = work.context.cancel;
  const auto framed = frame_sections(sections, kOffPlane, quiet);
  if (!framed) return framed.error();
  std::vector<LonelyCrossing> found;
  if (framed->planes.empty()) return found;
  std::vector<LatticePlane> planes;
  for (const FramedPlane& p : framed->planes) planes.push_back(p.plane);
  LatticePointStore store;
  const auto arrangement = build_arrangement(planes, data_box(*framed), store, quiet);
  if (!arrangement) return arrangement.error();
  const double unit = framed->diagonal / framed->grid.unit();
  const auto graph = build_section_graph(*framed, *arrangement, store, {kOn * unit, kMatch * unit, 0}, quiet);
  if (!graph) return graph.error();
  for (const Mismatch& m : graph->statistics.unmatched)
    found.push_back({framed->planes[m.plane].sources[0], framed->planes[m.other].sources[0],
                     framed->grid.from_lattice(m.point)});
  return found;
}

/// One of the planes is named as left already.
bool is_told(const Work& work, std::uint32_t plane, std::uint32_t other) {
  return std::any_of(work.result.changes.begin(), work.result.changes.end(), [&](const RepairChange& c) {
    return c.kind == RepairKind::left_as_it_is && (c.plane == plane || c.plane == other);
  });
}

}  // namespace

void tell_unmatched(Work& work) {
  if (std::none_of(work.planes.begin(), work.planes.end(), [](const WorkPlane& p) { return p.edited; }))
    return;
  const auto found = lonely_crossings(work);
  if (!found) return;  // the reconstruction will refuse the sections and say why
  for (const LonelyCrossing& c : *found) {
    const WorkPlane &plane = work.planes[c.plane], &other = work.planes[c.other];
    if ((!plane.edited && !other.edited) || is_told(work, plane.source, other.source)) continue;
    work.note({RepairKind::left_as_it_is, plane.source, kNone, kNone, 1, 0, c.at,
               "the section crosses plane " + std::to_string(other.source) +
                   " where that has no crossing: no way was found"});
  }
}

}  // namespace crossloft::repair_steps
