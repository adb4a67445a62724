#include "stream_judge.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "../../inspect/check.h"
#include "../../io/atomic_file.h"
#include "../../io/read_sections.h"
#include "../../io/section_file.h"
#include "../reconstruct/words.h"

namespace crossloft::test {
namespace {

class Source : public SectionSource {
 public:
  explicit Source(const Sections& sections) : sections_(sections) {}
  std::string name() const override { return sections_.source; }
  std::uint32_t plane_count() const override { return static_cast<std::uint32_t>(sections_.planes.size()); }
  Result<PlaneSection> read(std::uint32_t position) override { return sections_.planes[position]; }

 private:
  const Sections& sections_;
};

class Sink : public SurfaceSink {
 public:
  Result<Done> take(std::span<const Vec3> points,
                    std::span<const std::array<std::uint32_t, 3>> triangles) override {
    surface.points.insert(surface.points.end(), points.begin(), points.end());
    surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
    return Done{};
  }
  Surface surface;
};

/// Triangles by coordinates, each with its smallest corner first, in order.
std::vector<std::array<Vec3, 3>> triangles_of(const Surface& surface) {
  std::vector<std::array<Vec3, 3>> list;
  for (const auto& t : surface.triangles) {
    std::array<Vec3, 3> c{surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    list.push_back(c);
  }
  std::sort(list.begin(), list.end());
  return list;
}

std::string surface_complaint(const StackReport& report, const Surface& surface) {
  const CheckReport check = check_surface(surface);
  if (!check.good_topology()) return "no closed oriented manifold";
  if (check.crossings + check.overlaps != 0) return "triangles cross";
  if (report.surface_triangles != surface.triangles.size() ||
      report.surface_vertices != surface.points.size())
    return "the report's counts are not those of the surface";
  if (report.bodies + report.cavities != check.components.size() ||
      report.genus != static_cast<std::uint64_t>(check.genus))
    return "the report has other shells or handles than the surface";
  const double far_off = 1e-9 * std::pow(report.diagonal, 3) + 1e-9 * std::fabs(check.volume);
  return std::fabs(report.volume - check.volume) <= far_off ? "" : "the report has another volume";
}

/// Reads each plane, the last one first.
std::string planes_complaint(SectionFile& file, const Sections& sections) {
  const auto same_edge = [](const ContourEdge& a, const ContourEdge& b) {
    return a.a == b.a && a.b == b.b && a.material_a == b.material_a && a.material_b == b.material_b &&
           a.contour == b.contour && a.line == b.line;
  };
  if (file.plane_count() != sections.planes.size()) return "not as many planes as at once";
  for (std::uint32_t p = file.plane_count(); p-- > 0;) {
    const auto plane = file.read(p);
    if (!plane) return "a plane can't be read: " + to_string(plane.error());
    const PlaneSection& same = sections.planes[p];
    if (!(plane->normal == same.normal && plane->offset == same.offset && plane->line == same.line &&
          plane->vertices == same.vertices &&
          std::equal(plane->edges.begin(), plane->edges.end(), same.edges.begin(), same.edges.end(),
                     same_edge)))
      return "plane " + std::to_string(p) + " is another one than at once";
  }
  return {};
}

std::string file_complaint(const std::string& path) {
  const auto at_once = read_sections(path);
  auto file = SectionFile::open(path);
  if (file.ok() != at_once.ok()) return file.ok() ? "refused at once only" : "refused plane by plane only";
  if (file) return planes_complaint(*file, *at_once);
  return to_string(file.error()) == to_string(at_once.error()) && file.error().code == at_once.error().code
             ? ""
             : "another error than at once: " + to_string(file.error());
}

}  // namespace

StreamVerdict judge_stream(const SectionSet& set, const Reconstruction& at_once) {
  Source source(set.sections);
  Sink sink;
  Context context;
  context.threads = set.threads;
  const auto report = reconstruct_stack(source, sink, {set.options, 1}, context);
  if (!report) {
    const bool not_parallel = report.error().code == ErrorCode::usage;
    return {not_parallel ? "" : "refused as a stream: " + to_string(report.error()), false, false};
  }
  StreamVerdict verdict;
  verdict.stack = true;
  verdict.broken = surface_complaint(*report, sink.surface);
  if (!verdict.broken.empty()) verdict.broken = "as a stream: " + verdict.broken;
  verdict.other = triangles_of(sink.surface) != triangles_of(at_once.surface);
  if (verdict.broken.empty() && !verdict.other &&
      words_of(report->notes, report->warnings) != words_of(at_once.report.notes, at_once.report.warnings))
    verdict.broken = "as a stream: other notes or warnings";
  return verdict;
}

std::string section_file_complaint(std::string_view bytes, const char* extension) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("crossloft-fuzz-" + std::to_string(getpid()))).string() +
      extension;
  if (const auto written = write_file(path, bytes); !written)
    return "a file could not be written: " + to_string(written.error());
  std::string complaint = file_complaint(path);
  std::filesystem::remove(path);
  return complaint.empty() ? "" : "plane by plane: " + complaint;
}

}  // namespace crossloft::test
