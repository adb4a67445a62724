#include "repair.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "../arrangement/normalise.h"
#include "../geom/bounds.h"
#include "../geom/failing.h"
#include "repair_steps.h"
#include "section_edit.h"
#include "section_trace.h"

namespace crossloft {
namespace {

using repair_steps::FileNumbers;
using repair_steps::Work;
using repair_steps::WorkPlane;

/// Nearer to another plane a vertex is a crossing, as the reconstruction takes it.
constexpr double kOnPlane = 1e-9;

constexpr std::array<const char*, 16> kNames{
    "offset-sign",    "plane-fitted",     "onto-plane",        "planes-united",
    "contour-closed", "contour-left-out", "repeated-vertices", "spikes",
    "crossings",      "no-area",          "tiny-loop",         "nearly-straight",
    "agreed",         "pieces-left-out",  "borders-left-out",  "left-as-it-is"};

Result<Done> check_options(const RepairOptions& o) {
  for (const double tolerance : {o.limit, o.plane_tolerance, o.same_plane, o.close_gap, o.repeated, o.spike,
                                 o.tiny_loop, o.collinear, o.agree})
    if (!(tolerance >= 0 && tolerance <= 1))
      return make_error(ErrorCode::usage, "a tolerance is a fraction of the diagonal, between 0 and 1");
  return Done{};
}

Result<Done> check_input(const Sections& in, const RepairOptions& options) {
  if (auto good = check_options(options); !good) return good;
  if (in.planes.empty()) return Error{ErrorCode::no_plane, "there is no cutting plane", in.source};
  if (auto good = check_numbers(in); !good) return good;
  return check_size(in);
}

/// What the numbers of its contours are below.
std::uint32_t contours_in(const PlaneSection& p) {
  std::uint32_t count = 0;
  for (const ContourEdge& e : p.edges)
    if (e.contour != kNone) count = std::max(count, e.contour + 1);
  return count;
}

/// An open chain beside which all else is tiny is not where it should be, and says nothing of the size.
Bounds box_of(const WallExtent& extent, const RepairOptions& options) {
  const double closed = extent.closed.diagonal();
  return closed > 0 && closed <= options.tiny_loop * extent.wide.diagonal() ? extent.closed : extent.wide;
}

/// The largest distance of a vertex of one contour from the other, both ways.
double displacement(const Work& work, const WorkPlane& plane, const PlaneSection& before) {
  const UnitPlane unit{plane.normal, plane.offset};
  const SectionBoundary old(before, unit, work.chart(plane)), now(plane.section, unit, work.chart(plane));
  return largest_distance(old, now);
}

bool moves_points(RepairKind kind) {
  return kind == RepairKind::onto_plane || kind == RepairKind::repeated_vertices ||
         kind == RepairKind::nearly_straight || kind == RepairKind::crossings;
}

/// Steps before the agreement. Each is followed by what it may have made necessary.
void repair_planes_and_contours(Work& work) {
  const RepairOptions& o = work.options;
  if (o.planes) repair_steps::repair_planes(work);
  for (WorkPlane& p : work.planes) join_equal_vertices(p.section);
  if (o.chains) repair_steps::repair_chains(work);
  if (o.planes) repair_steps::unite_planes(work);
  if (o.crossings) repair_steps::repair_crossings(work);
  if (o.loops) repair_steps::repair_loops(work);
}

/// What the pass before had to leave: the next one looks at all again.
void forget_left(Work& work, std::size_t first) {
  auto& changes = work.result.changes;
  changes.erase(std::remove_if(changes.begin() + static_cast<std::ptrdiff_t>(first), changes.end(),
                               [](const RepairChange& c) { return c.kind == RepairKind::left_as_it_is; }),
                changes.end());
}

void agree(Work& work) {
  std::vector<PlaneSection> before;
  for (const WorkPlane& p : work.planes) before.push_back(p.section);
  const std::size_t told = work.result.changes.size();
  do {
    forget_left(work, told);
    repair_steps::repair_agreement(work);
  } while (work.options.chains && repair_steps::remove_new_spikes(work));
  if (work.context.cancelled()) return;
  for (std::size_t p = 0; p < before.size(); ++p)
    if (work.planes[p].edited)
      work.result.largest_displacement =
          std::max(work.result.largest_displacement, displacement(work, work.planes[p], before[p]));
}

/// Numbers of contours and vertices become those of the file; new ones have none there.
void number_as_in_file(RepairChange& c, const WorkPlane& plane) {
  const auto has_contour = [&](const FileNumbers& n) {
    return n.contours_begin <= c.contour && c.contour < n.contours_end;
  };
  const auto has_vertex = [&](const FileNumbers& n) {
    return n.vertices_begin <= c.vertex && c.vertex < n.vertices_end;
  };
  const auto owner = std::find_if(plane.numbers.begin(), plane.numbers.end(), [&](const FileNumbers& n) {
    return c.contour != kNone ? has_contour(n) : has_vertex(n);
  });
  if (owner == plane.numbers.end()) {
    c.contour = c.vertex = kNone;
    return;
  }
  c.plane = owner->source;
  c.vertex = has_vertex(*owner) ? c.vertex - owner->vertices_begin : kNone;
  if (c.contour != kNone) c.contour -= owner->contours_begin;
}

void number_as_in_file(Work& work, std::size_t planes) {
  std::vector<const WorkPlane*> by_source(planes, nullptr);
  for (const WorkPlane& p : work.planes) by_source[p.source] = &p;
  for (RepairChange& c : work.result.changes)
    if (c.plane != kNone && by_source[c.plane]) number_as_in_file(c, *by_source[c.plane]);
}

void finish(Work& work, const Sections& in) {
  Repair& r = work.result;
  number_as_in_file(work, in.planes.size());
  r.sections.source = in.source;
  r.diagonal = work.diagonal;
  for (WorkPlane& p : work.planes) {
    if (p.edited)
      tidy_section(p.section);
    else
      p.section.edges = in.planes[p.source].edges;  // also where they name equal vertices
    r.sources.push_back(p.source);
    r.sections.planes.push_back(std::move(p.section));
  }
  for (const RepairChange& c : r.changes) {
    if (moves_points(c.kind)) r.largest_displacement = std::max(r.largest_displacement, c.distance);
    r.left += is_left(c.kind);
  }
}

}  // namespace

namespace repair_steps {

std::string count_of(std::size_t n, const char* one, const char* several) {
  return std::to_string(n) + " " + (n == 1 ? one : several);
}

bool on_another_plane(const Work& work, const WorkPlane& plane, Vec3 v) {
  return std::any_of(work.planes.begin(), work.planes.end(), [&](const WorkPlane& other) {
    return &other != &plane && std::fabs(dot(other.normal, v) + other.offset) <= kOnPlane * work.diagonal;
  });
}

}  // namespace repair_steps

const char* name_of(RepairKind kind) { return kNames[static_cast<std::size_t>(kind)]; }

namespace {

Result<Repair> repair_all(const Sections& in, const RepairOptions& options, const Context& context) {
  if (auto good = check_input(in, options); !good) return good.error();
  const WallExtent extent = wall_extent(in);
  const Bounds box = box_of(extent, options);
  Work work{options, context, {}, {}, box.diagonal(), {}};
  if (!(work.diagonal > 0)) {
    finish(work, in);
    work.result.sections = in;
    for (std::uint32_t p = 0; p < in.planes.size(); ++p) work.result.sources.push_back(p);
    return std::move(work.result);
  }
  work.middle = box.center();
  for (std::uint32_t p = 0; p < in.planes.size(); ++p) {
    const auto vertices = static_cast<std::uint32_t>(in.planes[p].vertices.size());
    work.planes.push_back({in.planes[p], p, {}, 0, false, false, vertices, {}});
    work.planes.back().numbers.push_back({p, 0, contours_in(in.planes[p]), 0, vertices});
  }
  if (options.loops) repair_steps::drop_flat_contours(work, extent.flat);
  for (WorkPlane& p : work.planes) repair_steps::settle_plane(p);
  repair_planes_and_contours(work);
  for (WorkPlane& p : work.planes) repair_steps::settle_plane(p);
  if (options.agreement) agree(work);
  if (options.loops) repair_steps::straighten_runs(work);
  if (options.agreement) repair_steps::tell_unmatched(work);
  if (context.cancelled()) return Error{ErrorCode::cancelled, "cancelled", in.source};
  finish(work, in);
  return std::move(work.result);
}

}  // namespace

Result<Repair> repair_sections(const Sections& in, const RepairOptions& options, const Context& context) {
  return or_out_of_memory([&] { return repair_all(in, options, context); });
}

}  // namespace crossloft
