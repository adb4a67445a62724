#include "../geom/failing.h"
#include "info.h"

#include <algorithm>
#include <map>
#include <set>

#include "../arrangement/data_box.h"
#include "../arrangement/normalise.h"
#include "../arrangement/section_graph.h"
#include "../geom/unit_plane.h"

namespace crossloft {
namespace {

/// Twice the signed area of each contour, its walls directed with the section on their left: positive for an outer
/// contour, negative for a hole. By (plane of the file, contour).
std::map<std::pair<std::uint32_t, std::uint32_t>, double> contour_areas(const FramedPlane& plane,
                                                                       const SectionLocator& locator) {
  const int k = dominant_axis(plane.plane.normal);
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const double sign = plane.plane.normal[static_cast<std::size_t>(k)] > 0 ? 1 : -1;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
  const LatticePoint& o = plane.vertices[0];
  for (std::uint32_t w = 0; w < plane.walls.size(); ++w) {
    const WallEdge& wall = plane.walls[w];
    const LatticePoint &a = plane.vertices[wall.a], &b = plane.vertices[wall.b];
    const double area = (a[i] - o[i]) * (b[j] - o[j]) - (a[j] - o[j]) * (b[i] - o[i]);
    areas[{wall.plane, wall.contour}] += (locator.inside_left(w) ? sign : -sign) * area;
  }
  return areas;
}

PlaneInfo examine_plane(const FramedPlane& plane, const Sections& sections) {
  PlaneInfo info;
  info.plane = plane.sources[0];
  const PlaneSection& given = *plane_at(sections, info.plane);
  const UnitPlane unit = unit_plane(given.normal, given.offset);
  info.normal = unit.normal;
  info.offset = unit.offset;
  info.vertices = static_cast<std::uint32_t>(plane.vertices.size());
  info.edges = static_cast<std::uint32_t>(plane.walls.size());
  info.off_plane = plane.off_plane;
  if (plane.walls.empty()) return info;
  std::vector<WallEnds> ends;
  for (const WallEdge& w : plane.walls) ends.push_back({w.a, w.b});
  const SectionLocator locator(plane.plane, plane.vertices, ends);
  info.crossing_edges = static_cast<std::uint32_t>(locator.conflicts().size());
  for (const auto& [contour, area] : contour_areas(plane, locator)) ++(area >= 0 ? info.contours : info.holes);
  return info;
}

/// Pairs the crossings on every common line at any distance: the widest pair is the mismatch.
Result<Done> compare_lines(const FramedSections& framed, const Context& context, SectionsInfo& info) {
  std::vector<LatticePlane> planes;
  for (const FramedPlane& plane : framed.planes) planes.push_back(plane.plane);
  LatticePointStore store;
  const auto arrangement = build_arrangement(planes, data_box(framed), store, context);
  if (!arrangement) return arrangement.error();
  const double diagonal = framed.diagonal / framed.grid.unit();
  const auto graph = build_section_graph(framed, *arrangement, store, {1e-9 * diagonal, 2 * diagonal}, context);
  if (!graph) return graph.error().code == ErrorCode::self_crossing ? Result<Done>(Done{}) : graph.error();
  info.lines_compared = true;
  info.crossings = graph->statistics.crossings;
  info.unpaired = graph->statistics.unpaired;
  info.mismatch = graph->statistics.widest_pair * framed.grid.unit();
  return Done{};
}

void extend_bounds(SectionsInfo& info, const FramedPlane& plane, bool& first) {
  for (const Vec3& p : plane.input) {
    if (first) info.low = info.high = p;
    first = false;
    info.low = {std::min(info.low.x, p.x), std::min(info.low.y, p.y), std::min(info.low.z, p.z)};
    info.high = {std::max(info.high.x, p.x), std::max(info.high.y, p.y), std::max(info.high.z, p.z)};
  }
}

}  // namespace

Result<SectionsInfo> examine(const Sections& sections, double plane_tolerance, const Context& context) {
  return or_out_of_memory([&]() -> Result<SectionsInfo> {
    if (auto good = check_size(sections); !good) return good.error();
    const auto framed = frame_sections(sections, plane_tolerance, context);
    if (!framed) return framed.error();
    SectionsInfo info;
    info.diagonal = framed->diagonal;
    info.pencils = framed->pencils;
    info.common_points = framed->common_points;
    info.notes = framed->notes;
    info.warnings = framed->warnings;
    for (const std::string& text : info.notes) context.note(text);
    for (const std::string& text : info.warnings) context.warn(text);
    std::set<LatticeVector> normals;
    bool first = true;
    for (const FramedPlane& plane : framed->planes) {
      normals.insert(plane.plane.normal);
      extend_bounds(info, plane, first);
      info.planes.push_back(examine_plane(plane, sections));
      const PlaneInfo& p = info.planes.back();
      info.sections += p.edges != 0;
      info.contours += p.contours, info.holes += p.holes;
      info.vertices += p.vertices, info.edges += p.edges, info.crossing_edges += p.crossing_edges;
      info.off_plane = std::max(info.off_plane, p.off_plane);
    }
    std::sort(info.planes.begin(), info.planes.end(),
              [](const PlaneInfo& x, const PlaneInfo& y) { return x.plane < y.plane; });
    info.directions = static_cast<std::uint32_t>(normals.size());
    if (!framed->planes.empty())
      if (auto done = compare_lines(*framed, context, info); !done) return done.error();
    return info;
  });
}

}  // namespace crossloft
