#include "targets.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "../../cli/plane_list.h"
#include "../../delaunay/triangulation.h"
#include "../../geom/weighted_point.h"
#include "../../inspect/check.h"
#include "../../inspect/info.h"
#include "../../io/read_mesh.h"
#include "../../io/read_points.h"
#include "../../io/read_sections.h"
#include "../../io/read_sites.h"
#include "../../io/write_diagram_svg.h"
#include "../../io/write_sections.h"
#include "promises.h"
#include "stream_judge.h"

namespace crossloft::test {
namespace {

constexpr const char* kName = "the file";

/// A message that a person understands: of a file, with a place that is in it.
std::string error_complaint(const Error& error, std::string_view bytes) {
  if (error.message.empty()) return "an error without a message";
  if (error.file != kName) return "an error that does not name the file: " + to_string(error);
  const auto line_ends =
      std::count_if(bytes.begin(), bytes.end(), [](char c) { return c == '\n' || c == '\r'; });
  if (error.line > line_ends + 1) return "an error on a line that is not there: " + to_string(error);
  const bool printable =
      std::all_of(error.message.begin(), error.message.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (!printable) return "a message with control characters";
  if (error.code == ErrorCode::internal || error.code == ErrorCode::cancelled)
    return "error: " + to_string(error);
  return {};
}

std::string sections_complaint(const Sections& sections) {
  if (sections.planes.empty()) return "no plane, and no error";
  for (const PlaneSection& plane : sections.planes) {
    if (!is_finite(plane.normal) || !std::isfinite(plane.offset) || plane.normal == Vec3{})
      return "a bad plane was read";
    for (const Vec3& v : plane.vertices)
      if (!is_finite(v)) return "a vertex that is not finite was read";
    for (const ContourEdge& e : plane.edges)
      if (std::max(e.a, e.b) >= plane.vertices.size()) return "an edge names a vertex that is not there";
  }
  return {};
}

bool same(const PlaneSection& a, const PlaneSection& b) {
  const auto same_edge = [](const ContourEdge& x, const ContourEdge& y) {
    return x.a == y.a && x.b == y.b && x.material_a == y.material_a && x.material_b == y.material_b;
  };
  return a.normal == b.normal && a.vertices == b.vertices && a.edges.size() == b.edges.size() &&
         std::fabs(a.offset) == std::fabs(b.offset) &&
         std::equal(a.edges.begin(), a.edges.end(), b.edges.begin(), same_edge);
}

/// What is written is read again as it was, but for the one sign of all offsets.
std::string again_complaint(const Sections& sections) {
  const auto again = parse_contour(format_contour(sections), kName);
  if (!again) return "not readable once written: " + to_string(again.error());
  const bool equal = std::equal(sections.planes.begin(), sections.planes.end(), again->planes.begin(),
                                again->planes.end(), same);
  return equal ? "" : "not the same when written and read again";
}

/// Larger ones take too long, and others of their kind are smaller.
bool is_small(const Sections& sections) {
  std::size_t vertices = 0;
  for (const PlaneSection& plane : sections.planes) vertices += plane.vertices.size() + plane.edges.size();
  return sections.planes.size() <= 8 && vertices <= 400;
}

std::string judge_sections(const Result<Sections>& sections, std::string_view bytes, const char* extension) {
  if (auto complaint = section_file_complaint(bytes, extension); !complaint.empty()) return complaint;
  if (!sections) return error_complaint(sections.error(), bytes);
  if (auto complaint = sections_complaint(*sections); !complaint.empty()) return complaint;
  if (auto complaint = again_complaint(*sections); !complaint.empty()) return complaint;
  if (!is_small(*sections)) return {};
  if (const auto info = examine(*sections); !info && info.error().code == ErrorCode::internal)
    return "info: " + to_string(info.error());
  SectionSet set;
  set.sections = *sections;
  return judge(set).broken;
}

std::string judge_contour(std::string_view bytes) {
  return judge_sections(parse_contour(bytes, kName), bytes, ".contour");
}
std::string judge_csl(std::string_view bytes) {
  return judge_sections(parse_csl(bytes, kName), bytes, ".csl");
}

template <class Simplices>
std::string mesh_complaint(const std::vector<Vec3>& points, const Simplices& simplices) {
  for (const Vec3& p : points)
    if (!is_finite(p)) return "a point that is not finite was read";
  for (const auto& simplex : simplices)
    for (const std::uint32_t v : simplex)
      if (v >= points.size()) return "a vertex is named that is not there";
  return {};
}

std::string judge_surface(const Result<Surface>& surface, std::string_view bytes) {
  if (!surface) return error_complaint(surface.error(), bytes);
  if (auto complaint = mesh_complaint(surface->points, surface->triangles); !complaint.empty())
    return complaint;
  if (surface->triangles.size() > 1000) return {};
  const CheckReport report = check_surface(*surface);
  return report.bad_indices != 0 || report.bad_coordinates != 0 ? "check finds what the reader should have"
                                                                : "";
}

std::string judge_solid(const Result<Solid>& solid, std::string_view bytes) {
  return solid ? mesh_complaint(solid->points, solid->tets) : error_complaint(solid.error(), bytes);
}

std::string judge_ply(std::string_view bytes) { return judge_surface(parse_ply(bytes, kName), bytes); }
std::string judge_obj(std::string_view bytes) { return judge_surface(parse_obj(bytes, kName), bytes); }
std::string judge_off(std::string_view bytes) { return judge_surface(parse_off(bytes, kName), bytes); }
std::string judge_stl(std::string_view bytes) { return judge_surface(parse_stl(bytes, kName), bytes); }
std::string judge_medit(std::string_view bytes) { return judge_solid(parse_medit(bytes, kName), bytes); }
std::string judge_vtu(std::string_view bytes) { return judge_solid(parse_vtu(bytes, kName), bytes); }

/// Every point has a vertex or is hidden, and simplices name vertices.
std::string triangulation_complaint(const Triangulation& t, std::size_t points) {
  if (t.kept.size() != points) return "not every point is accounted for";
  for (const std::uint32_t v : t.kept)
    if (v != kNone && v >= points) return "a point's vertex is not there";
  const bool good = std::all_of(t.chain.begin(), t.chain.end(), [&](std::uint32_t v) { return v < points; });
  return good && (points == 0) == (t.dimension == -1)
             ? ""
             : "a triangulation of another dimension or of other points";
}

std::string judge_points(std::string_view bytes) {
  const auto points = parse_points(bytes, kName);
  if (!points) return error_complaint(points.error(), bytes);
  if (points->size() > 200) return {};
  return triangulation_complaint(delaunay_triangulation(*points), points->size());
}

std::string judge_weighted(std::string_view bytes) {
  const auto points = parse_weighted_points(bytes, kName);
  if (!points) return error_complaint(points.error(), bytes);
  if (points->size() > 200) return {};
  return triangulation_complaint(regular_triangulation(*points), points->size());
}

std::string judge_sites(std::string_view bytes) {
  const auto sites = parse_sites(bytes, kName);
  if (!sites) return error_complaint(sites.error(), bytes);
  if (sites->size() > 60) return {};
  const auto diagram = moebius_diagram(*sites);
  if (!diagram) return "no diagram: " + to_string(diagram.error());
  // Beyond this, curves and vertices are lost in rounding, as documented: then the drawing need only not fail
  // hard.
  double low = 1, high = 1;
  for (const MoebiusSite& s : *sites)
    for (const double x : {s.p.x, s.p.y, s.lambda, s.mu})
      if (x != 0) low = std::min(low, std::fabs(x)), high = std::max(high, std::fabs(x));
  if (high > 1e6 || low < 1e-6) return {};
  if (const std::string broken = verify(*diagram); !broken.empty()) return broken;
  const auto drawn = format_diagram_svg(*diagram);
  return drawn || drawn.error().code != ErrorCode::internal ? "" : "drawing: " + to_string(drawn.error());
}

std::string judge_planes(std::string_view bytes) {
  const auto planes = cli::parse_planes(bytes, kName);
  if (!planes) return error_complaint(planes.error(), bytes);
  for (const CuttingPlane& plane : *planes)
    if (!is_finite(plane.normal) || !std::isfinite(plane.offset) || plane.normal == Vec3{})
      return "a bad plane was read";
  return {};
}

std::string judge_pipeline(std::string_view bytes) {
  ByteSource source({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  return judge(draw_section_set(source)).broken;
}

constexpr FuzzTarget kTargets[] = {
    {"contour", judge_contour},   {"csl", judge_csl},     {"ply", judge_ply},
    {"obj", judge_obj},           {"off", judge_off},     {"stl", judge_stl},
    {"medit", judge_medit},       {"vtu", judge_vtu},     {"points", judge_points},
    {"weighted", judge_weighted}, {"sites", judge_sites}, {"planes", judge_planes},
    {"pipeline", judge_pipeline}};

}  // namespace

std::span<const FuzzTarget> fuzz_targets() { return kTargets; }

const FuzzTarget* find_fuzz_target(std::string_view name) {
  const auto at = std::find_if(std::begin(kTargets), std::end(kTargets),
                               [&](const FuzzTarget& t) { return t.name == name; });
  return at != std::end(kTargets) ? at : nullptr;
}

}  // namespace crossloft::test
