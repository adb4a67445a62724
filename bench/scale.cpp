// Time and memory of a reconstruction as the input grows: a stack of slices with more and more contour
// vertices, a stack of more and more slices that is streamed, and a knot by more and more random planes. Each
// reconstruction runs in a process of its own, whose peak of memory is the operating system's figure.
//
//   bench_scale [--most-vertices N] [--most-streamed N] [--most-planes N] [--markdown FILE] [--svg FILE]
//
// default: 1000000 vertices, 10000000, 100 planes

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>
#include <string>

#include "../inspect/slice.h"
#include "../inspect/solids.h"
#include "../reconstruct/reconstruct.h"
#include "../reconstruct/stack.h"
#include "output.h"
#include "scale.h"

namespace {

using namespace crossloft;
using namespace crossloft::bench;

/// A closed curve around the z axis with `count` vertices, wound the way that `outer` asks for.
void add_curve(PlaneSection& plane, double z, double radius, double depth, std::uint32_t count, bool outer) {
  const auto first = static_cast<std::uint32_t>(plane.vertices.size());
  const std::uint32_t contour = plane.edges.empty() ? 0 : plane.edges.back().contour + 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * (outer ? i : count - i) / count;
    const double r = radius * (1 + depth * std::sin(5 * t + 2 * z) + 0.05 * std::sin(23 * t - 5 * z));
    plane.vertices.push_back({r * std::cos(t), r * std::sin(t), z});
    plane.edges.push_back({first + i, first + (i + 1) % count, 1, 0, contour, 0});
  }
}

/// A slice of a twisted tube with five lobes: a wall and a channel.
PlaneSection tube_slice(double z, std::uint32_t vertices) {
  PlaneSection plane;
  plane.normal = {0, 0, 1};
  plane.offset = -z;
  add_curve(plane, z, 1, 0.2, vertices * 2 / 3, true);
  add_curve(plane, z, 0.4, 0.1, vertices - vertices * 2 / 3, false);
  return plane;
}

/// 3 high, `vertices` in all slices.
Sections twisted_tube(std::uint32_t slices, std::uint32_t vertices) {
  Sections sections;
  for (std::uint32_t k = 0; k < slices; ++k)
    sections.planes.push_back(tube_slice(3.0 * k / slices, vertices / slices));
  return sections;
}

/// As many slices of 2000 vertices each as are asked for, made when they are read.
class EndlessTube : public SectionSource {
 public:
  static constexpr std::uint32_t kVertices = 2000;

  explicit EndlessTube(std::uint32_t slices) : slices_(slices) {}
  std::string name() const override { return {}; }
  std::uint32_t plane_count() const override { return slices_; }
  Result<PlaneSection> read(std::uint32_t k) override { return tube_slice(3.0 * k / 500, kVertices); }

 private:
  std::uint32_t slices_;
};

struct Nowhere : SurfaceSink {
  Result<Done> take(std::span<const Vec3>, std::span<const std::array<std::uint32_t, 3>>) override {
    return Done{};
  }
};

Sections knot(std::uint32_t planes) {
  const Surface mesh = trefoil_solid(128);
  auto sections = slice(mesh, random_planes(bounds_of(mesh.points), planes, 1));
  return sections ? std::move(sections).value() : Sections{};
}

/// Of this process, since the call of forget_peak.
double peak_megabytes() {
  double kilobytes = 0;
  char line[128];
  std::FILE* status = std::fopen("/proc/self/status", "r");
  while (status != nullptr && std::fgets(line, sizeof line, status) != nullptr)
    if (std::sscanf(line, "VmHWM: %lf", &kilobytes) == 1) break;
  if (status != nullptr) std::fclose(status);
  return kilobytes / 1024;
}

/// What making the input took does not count.
void forget_peak() {
  if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {
    std::fputs("5", file);
    std::fclose(file);
  }
}

ScalePoint measure(const Sections& sections, unsigned threads) {
  ScalePoint point;
  point.threads = threads;
  point.planes = static_cast<std::uint32_t>(sections.planes.size());
  for (const PlaneSection& p : sections.planes) point.vertices += p.vertices.size();
  Context context;
  context.threads = threads;
  forget_peak();
  const std::clock_t start = std::clock();
  const auto result = reconstruct(sections, {}, context);
  point.processor = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!result) return point;
  point.megabytes = peak_megabytes();
  point.seconds = result->report.seconds.total;
  point.cells = result->report.arrangement_cells;
  for (const CellReport& cell : result->report.cells) point.tetrahedra += cell.tets_r0;
  return point;
}

ScalePoint measure_stream(std::uint32_t slices, unsigned threads) {
  EndlessTube tube(slices);
  Nowhere nowhere;
  ScalePoint point;
  point.threads = threads;
  point.planes = slices;
  point.vertices = std::uint64_t{slices} * EndlessTube::kVertices;
  Context context;
  context.threads = threads;
  forget_peak();
  const std::clock_t start = std::clock();
  const auto report = reconstruct_stack(tube, nowhere, {}, context);
  point.processor = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (!report) return point;
  point.megabytes = peak_megabytes();
  point.seconds = report->seconds;
  point.cells = report->cells.size();
  for (const CellReport& cell : report->cells) point.tetrahedra += cell.tets_r0;
  return point;
}

/// By threads.
using Run = std::function<ScalePoint(unsigned)>;

/// In a child; no seconds if that failed.
ScalePoint in_child(const Run& run, unsigned threads) {
  int ends[2];
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    const ScalePoint point = run(threads);
    const bool sent = write(ends[1], &point, sizeof point) == sizeof point;
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  ScalePoint point;
  const bool got = child > 0 && read(ends[0], &point, sizeof point) == sizeof point;
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  std::fprintf(stderr, "%u planes, %llu vertices, %u threads: %.3g s, %.0f MB\n", point.planes,
               static_cast<unsigned long long>(point.vertices), threads, point.seconds, point.megabytes);
  return got ? point : ScalePoint{};
}

ScaleSeries run_all(const std::string& name, const std::string& grows, const std::vector<Run>& runs) {
  ScaleSeries series{name, grows, {}};
  for (const Run& run : runs)
    for (const unsigned threads : {1U, 2U})
      if (const ScalePoint point = in_child(run, threads); point.seconds > 0) series.points.push_back(point);
  return series;
}

/// Makes the input in the process that reconstructs it.
template <class Make>
Run at_once(Make make) {
  return [make](unsigned threads) { return measure(make(), threads); };
}

struct Settings {
  std::uint32_t most_vertices = 1'000'000, most_streamed = 10'000'000, most_planes = 100;
  std::string markdown, svg;
};

/// False if it does not know a word, or one has no value.
bool read_settings(int count, char** words, Settings& settings) {
  for (int i = 1; i < count; i += 2) {
    const std::string word = words[i];
    if (i + 1 == count) return false;
    const auto number = [&] { return static_cast<std::uint32_t>(std::strtoul(words[i + 1], nullptr, 10)); };
    if (word == "--most-vertices")
      settings.most_vertices = number();
    else if (word == "--most-streamed")
      settings.most_streamed = number();
    else if (word == "--most-planes")
      settings.most_planes = number();
    else if (word == "--markdown")
      settings.markdown = words[i + 1];
    else if (word == "--svg")
      settings.svg = words[i + 1];
    else
      return false;
  }
  return true;
}

}  // namespace

int main(int count, char** words) {
  Settings settings;
  if (!read_settings(count, words, settings)) {
    std::fputs(
        "usage: bench_scale [--most-vertices N] [--most-streamed N] [--most-planes N] [--markdown FILE]"
        " [--svg FILE]\n",
        stderr);
    return 2;
  }
  std::vector<Run> stacks, streams, knots;
  for (std::uint32_t v = 1000; v <= settings.most_vertices; v *= 10)
    stacks.push_back(at_once([v] { return twisted_tube(std::clamp<std::uint32_t>(v / 2000, 20, 500), v); }));
  for (std::uint32_t v = 100'000; v <= settings.most_streamed; v *= 10)
    streams.push_back([v](unsigned threads) { return measure_stream(v / EndlessTube::kVertices, threads); });
  for (const std::uint32_t k : {5U, 10U, 20U, 50U, 100U})
    if (k <= settings.most_planes) knots.push_back(at_once([k] { return knot(k); }));
  std::vector<ScaleSeries> all{run_all("a stack of slices", "vertices", stacks),
                               run_all("a stack that is streamed", "vertices", streams),
                               run_all("a knot by random planes", "planes", knots)};
  std::erase_if(all, [](const ScaleSeries& s) { return s.points.empty(); });
  if (all.empty()) return 1;
  const std::string table = to_markdown(all);
  std::fputs(table.c_str(), stdout);
  return write_file(settings.markdown, table) && write_file(settings.svg, to_svg(all)) ? 0 : 1;
}
