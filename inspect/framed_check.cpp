#include <algorithm>

#include "../arrangement/framed_sections.h"
#include "../arrangement/normalise.h"
#include "check.h"

namespace crossloft {
namespace {

/// By position in the file; null if framing leaves the plane out.
std::vector<const FramedPlane*> frames_by_source(const FramedSections& framed, std::size_t planes) {
  std::vector<const FramedPlane*> frames(planes, nullptr);
  for (const FramedPlane& plane : framed.planes)
    for (const std::uint32_t source : plane.sources) frames[source] = &plane;
  return frames;
}

PlaneSection section_of(const FramedPlane& frame, const WorldGrid& grid) {
  PlaneSection section = plane_in_input(frame.plane, grid);
  for (const LatticePoint& v : frame.vertices) section.vertices.push_back(grid.from_lattice(v));
  for (const WallEdge& w : frame.walls) section.edges.push_back({w.a, w.b, 1, 0, w.contour, w.line});
  return section;
}

/// Of a plane that is left out because nothing of its contours is.
PlaneSection without_contours(const PlaneSection& section) {
  return {section.normal, section.offset, {}, {}, section.line};
}

void tell(const FramedSections& framed, const Context& context) {
  for (const std::string& note : framed.notes) context.note(note);
  for (const std::string& warning : framed.warnings) context.warn(warning);
}

void add_displacements(const FramedPlane& frame, PlaneCheck& plane, SectionCheck& check) {
  plane.section_off_plane = frame.off_plane;
  plane.section_displacement = frame.displacement;
  check.section_off_plane = std::max(check.section_off_plane, frame.off_plane);
  check.section_displacement = std::max(check.section_displacement, frame.displacement);
}

}  // namespace

Result<SectionCheck> check_framed_sections(const Surface& surface, const Sections& in,
                                           const SectionCheckOptions& options, const Context& context) {
  if (auto good = check_size(in); !good) return good.error();
  const auto framed = frame_sections(in, options.plane_tolerance, context);
  if (!framed) return framed.error();
  tell(*framed, context);
  const auto frames = frames_by_source(*framed, in.planes.size());
  Sections united;
  std::vector<std::uint32_t> positions;
  for (std::uint32_t p = 0; p < frames.size(); ++p) {
    if (frames[p] && frames[p]->sources[0] != p) continue;
    united.planes.push_back(frames[p] ? section_of(*frames[p], framed->grid)
                                      : without_contours(in.planes[p]));
    positions.push_back(p);
  }
  SectionCheck check = check_sections(surface, united, options);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    check.planes[i].plane = positions[i];
    if (frames[positions[i]]) add_displacements(*frames[positions[i]], check.planes[i], check);
  }
  return check;
}

}  // namespace crossloft
