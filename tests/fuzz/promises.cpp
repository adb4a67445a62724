#include "promises.h"

#include <algorithm>
#include <cmath>

#include "../../inspect/check.h"
#include "../reconstruct/result_hash.h"
#include "../reconstruct/shuffled.h"
#include "section_judge.h"
#include "stream_judge.h"

namespace crossloft::test {
namespace {

constexpr double kAreaTolerance = 1e-10;   // of the squared diagonal
constexpr double kVolumeTolerance = 1e-9;  // of the cubed diagonal
constexpr double kNeedle = 2;              // units of the grid: what is no wider may have no room for a plate

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

/// Refusals that an input can deserve.
bool may_refuse(ErrorCode code) {
  switch (code) {
    case ErrorCode::off_plane:
    case ErrorCode::open_chain:
    case ErrorCode::self_crossing:
    case ErrorCode::contradicting_planes:
    case ErrorCode::too_thin:
    case ErrorCode::no_plane:
    case ErrorCode::too_large:
    case ErrorCode::zero_normal:
    case ErrorCode::not_finite:
      return true;
    default:
      return false;
  }
}

std::string refused(const SectionSet& set, const Error& error) {
  if (error.message.empty()) return "an error without a message";
  if (!may_refuse(error.code))
    return "error " + std::to_string(static_cast<int>(error.code)) + ": " + to_string(error);
  if (set.consistent && error.code != ErrorCode::too_large)
    return "slices of a solid refused: " + to_string(error);
  return {};
}

/// How far a point may be from its exact place when its coordinates are rounded, and be taken to be when it is
/// projected.
double last_places(const Reconstruction& r) {
  double largest = 0;
  const auto add = [&](const std::vector<Vec3>& points) {
    for (const Vec3& p : points)
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  };
  add(r.surface.points);
  for (const PlaneSection& plane : r.sections.planes) add(plane.vertices);
  return 0x1p-50 * largest;
}

/// A written point: rounded, then mended.
double rounding(const Reconstruction& r) { return last_places(r) + r.report.mending; }

double contour_length(const PlaneSection& plane) {
  double sum = 0;
  for (const ContourEdge& e : plane.edges) sum += norm(plane.vertices[e.a] - plane.vertices[e.b]);
  return sum;
}

std::string surface_complaint(const Reconstruction& r, const CheckReport& check) {
  if (check.bad_coordinates != 0) return "a coordinate of the surface is no finite number";
  if (!check.closed()) return "the surface is not closed";
  if (!check.oriented()) return "the surface is not oriented";
  if (!check.manifold()) return "the surface is not a manifold";
  if (check.crossings + check.overlaps != 0)
    return std::to_string(check.crossings + check.overlaps) + " pairs of triangles cross";
  const double most = kVolumeTolerance * std::pow(r.report.diagonal, 3) + check.area * rounding(r);
  // Copies that were moved apart leave the tetrahedra where they were.
  if (r.report.separated_copies == 0 && !(std::fabs(check.volume - r.report.volume) <= most))
    return "the surface has the volume " + number(check.volume) + ", the tetrahedra " +
           number(r.report.volume);
  return {};
}

/// The exact judge, and for what it sees the numbers of the report and the sections that are handed out. On
/// written coordinates the same can't be told where the solid is thinner than their rounding.
std::string section_complaint(const Reconstruction& r, const SectionJudge& judge) {
  if (!judge.complaint().empty()) return judge.complaint();
  const SectionCheck check = check_sections({}, r.sections);
  const double area = kAreaTolerance * r.report.diagonal * r.report.diagonal;
  const double rounded = rounding(r);
  for (std::size_t p = 0; p < check.planes.size(); ++p) {
    const double most = area + rounded * contour_length(r.sections.planes[p]);
    const double reported = r.report.planes[p].flat_area;
    if (!(std::fabs(judge.flat_area[p] - reported) <= most))
      return "plane " + std::to_string(p) + ": an area of " + number(judge.flat_area[p]) + " is flat, " +
             number(reported) + " are reported";
    if (!(std::fabs(judge.section_area[p] - check.planes[p].section_area) <= most))
      return "plane " + std::to_string(p) + ": section triangles of area " + number(judge.section_area[p]) +
             " for a section of area " + number(check.planes[p].section_area);
  }
  return {};
}

std::string report_complaint(const Reconstruction& r) {
  const Report& report = r.report;
  if (report.surface_triangles != r.surface.triangles.size() ||
      report.surface_vertices != r.surface.points.size() || report.solid_tets != r.solid.tets.size())
    return "the report's counts are not those of the result";
  if (report.planes.size() != r.sections.planes.size())
    return "the report's planes are not those of the sections";
  for (const double x : {report.diagonal, report.volume, report.section_area, report.flat_area,
                         report.displacement, report.off_plane, report.largest_match_gap, report.separation})
    if (!(std::isfinite(x) && x >= 0)) return "the report has a length, area or volume of " + number(x);
  if (report.flat_area > report.section_area * (1 + 1e-9)) return "more flat area than sections have";
  if (report.matched_crossings > report.crossings) return "more crossings are matched than there are";
  if (report.mode == "natural" && report.topology.handles > report.topology.handles_asked)
    return std::to_string(report.topology.handles) + " handles within cells, " +
           std::to_string(report.topology.handles_asked) + " asked for";
  if (r.surface.triangles.empty() && report.warnings.empty()) return "an empty surface and not a word why";
  return {};
}

std::string twice_complaint(const SectionSet& set, const Reconstruction& r) {
  if (!set.options.joins.empty()) return {};  // they name planes and contours by number
  Context context;
  context.threads = 3 - set.threads;
  const auto again = reconstruct(shuffled(set.sections, r.surface.points.size() + 1), set.options, context);
  if (!again) return "refused when told in another order: " + to_string(again.error());
  return hash(*again) == hash(r) ? "" : "another result when told in another order";
}

/// How far the report's volume may be from that of the tetrahedra, which is what plates change. It is that of
/// the surface before anything is mended, whose vertices are within e = last_places(r) of theirs. To move one
/// vertex of a closed surface changes the volume by a third of the move times the area around it at most
/// (that of its star seen along the move, whose rim stays), so all of them, one after the other, by e A, A
/// the largest area on the way. On the way all vertices are within m = rounding(r) of where they are written,
/// and a triangle's area is within m/2 of its perimeter P, and m of that growing by m and 2 m: its own + m P
/// / 2 + 3 m m / 2. Summing up adds less than kVolumeTolerance, since it is done relative to a corner.
double volume_rounding(const Reconstruction& r) {
  const double m = rounding(r);
  double area = 0;
  for (const auto& [i, j, k] : r.surface.triangles) {
    const Vec3 a = r.surface.points[j] - r.surface.points[i], b = r.surface.points[k] - r.surface.points[i];
    area += (norm(cross(a, b)) + m * (norm(a) + norm(b) + norm(b - a)) + 3 * m * m) / 2;
  }
  return last_places(r) * area;
}

/// What plates do beside the sections: nothing is bare any more but needles, and they are no higher than
/// asked.
std::string plate_complaint(const SectionSet& set, const Reconstruction& with, const Reconstruction& without,
                            const SectionJudge& judge) {
  const Report &report = with.report, &bare = without.report;
  const double room = kVolumeTolerance * std::pow(report.diagonal, 3) + volume_rounding(with) +
                      volume_rounding(without);
  if (judge.widest_flat > kNeedle)
    return "an area of " + number(report.flat_area) + ", " + number(judge.widest_flat) +
           " units of the grid wide, is flat in spite of plates";
  if ((report.thickened_regions + report.flat_regions != 0) != (bare.flat_regions != 0))
    return "plates, but not where it was flat";
  if (!(report.thickness <= set.options.thicken * report.diagonal)) return "plates are higher than asked";
  const double most = bare.volume + 1.001 * bare.flat_area * report.thickness;
  if (!(report.volume >= bare.volume - room && report.volume <= most + room))
    return "the volume is " + number(report.volume) + " with plates, " + number(bare.volume) + " without";
  return {};
}

/// Of moves that were asked for.
std::string separation_complaint(const SectionSet& set, const Reconstruction& r) {
  const Report& report = r.report;
  if (set.options.separation == 0) return {};
  double largest = 0;
  for (const Vec3& p : r.surface.points)
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  // Places are rounded to the grid, and to doubles.
  const double most = set.options.separation * report.diagonal * (1 + 1e-9) + 0x1p-50 * largest;
  if (!(report.separation <= most)) return "copies moved further than asked";
  return {};
}

/// One run, judged; nothing if it was refused.
std::optional<Reconstruction> judge_run(const SectionSet& set, SectionJudge& sections, Verdict& verdict) {
  Context context;
  context.threads = set.threads;
  auto r = reconstruct(set.sections, set.options, context, &sections);
  if (!r) {
    verdict.error = r.error().code;
    verdict.broken = refused(set, r.error());
    return {};
  }
  verdict.empty = r->surface.triangles.empty();
  const CheckReport check = check_surface(r->surface);
  verdict.merged = r->report.merged_vertices != 0;
  verdict.broken = surface_complaint(*r, check);
  if (verdict.broken.empty()) verdict.broken = section_complaint(*r, sections);
  if (verdict.broken.empty()) verdict.broken = report_complaint(*r);
  if (verdict.broken.empty()) verdict.broken = separation_complaint(set, *r);
  if (verdict.broken.empty() && set.told_twice) verdict.broken = twice_complaint(set, *r);
  return std::move(r).value();
}

/// First without plates, to know what they have brought.
Verdict judge_with_plates(const SectionSet& set) {
  Verdict verdict;
  SectionSet without = set;
  without.options.thicken = without.options.separation = 0;
  without.told_twice = false;
  SectionJudge bare;
  const auto before = judge_run(without, bare, verdict);
  if (!verdict.broken.empty()) {
    verdict.broken = "without plates: " + verdict.broken;
    return verdict;
  }
  const bool refused_before = verdict.error.has_value();
  verdict = {};
  SectionJudge sections(bare);
  const auto r = judge_run(set, sections, verdict);
  if (!verdict.broken.empty()) return verdict;
  if (verdict.error.has_value() != refused_before)
    verdict.broken = "refused only with plates, or only without";
  else if (r)
    verdict.broken = plate_complaint(set, *r, *before, sections);
  verdict.outside = sections.plate_edges_outside;
  verdict.bare = r && r->report.flat_regions != 0;
  return verdict;
}

}  // namespace

Verdict judge(const SectionSet& set) {
  if (set.options.thicken > 0) return judge_with_plates(set);
  Verdict verdict;
  SectionJudge sections;
  const auto r = judge_run(set, sections, verdict);
  if (!r || !verdict.broken.empty()) return verdict;
  const StreamVerdict stream = judge_stream(set, *r);
  verdict.broken = stream.broken;
  verdict.stack = stream.stack;
  verdict.unlike = stream.other;
  return verdict;
}

}  // namespace crossloft::test
