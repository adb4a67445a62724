#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "../delaunay/in_parallel.h"
#include "../delaunay/triangulation.h"
#include "../io/atomic_file.h"
#include "../io/read_points.h"
#include "../io/write_triangulation.h"
#include "arguments.h"
#include "commands.h"
#include "delaunay_report.h"
#include "peak_memory.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string points, output, report;
  bool weights = false;
  unsigned threads = 1;
};

struct Built {
  Triangulation triangulation;
  std::vector<Vec3> positions;  ///< only if they are to be written
  unsigned threads = 1;
  double seconds = 0;
};

template <class Build>
double seconds_of(Build build) {
  const auto start = std::chrono::steady_clock::now();
  build();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Result<Built> delaunay(const Arguments& arguments) {
  auto points = read_points(arguments.points);
  if (!points) return points.error();
  Built built;
  built.threads = detail::useful_threads(
      arguments.threads != 0 ? arguments.threads : std::max(1u, std::thread::hardware_concurrency()),
      points->size());
  if (!arguments.output.empty()) built.positions = *points;  // the triangulation takes the others over
  built.seconds =
      seconds_of([&] { built.triangulation = delaunay_triangulation(std::move(*points), built.threads); });
  return built;
}

/// By one thread.
Result<Built> regular(const Arguments& arguments) {
  const auto points = read_weighted_points(arguments.points);
  if (!points) return points.error();
  Built built;
  built.seconds = seconds_of([&] { built.triangulation = regular_triangulation(*points); });
  if (!arguments.output.empty()) {
    built.positions.reserve(points->size());
    for (const WeightedPoint& p : *points) built.positions.push_back(p.position);
  }
  return built;
}

Result<Done> write(const Arguments& arguments, Built& built, DelaunayReport& report,
                   const Context& context) {
  if (!arguments.output.empty()) {
    sort_simplices(built.triangulation);  // threads leave no trace in the file
    const auto written = write_triangulation(arguments.output, built.positions, built.triangulation, context);
    if (!written) return written;
  }
  report.peak_rss_kib = peak_memory_kib();
  if (arguments.report.empty()) return Done{};
  return write_file(arguments.report, delaunay_json(report, arguments.points));
}

ExitCode run(const Arguments& arguments) {
  release_interrupts();
  Terminal terminal;
  if (auto outputs = check_outputs({arguments.points}, {arguments.output, arguments.report}); !outputs)
    return terminal.fail(outputs.error());
  auto built = arguments.weights ? regular(arguments) : delaunay(arguments);
  if (!built) return terminal.fail(built.error());
  DelaunayReport report = describe(built->triangulation, arguments.weights);
  report.threads = built->threads;
  report.seconds = built->seconds;
  catch_interrupts();  // writing looks at the flag, and takes its temporary file away
  const auto written = write(arguments, *built, report, terminal.context());
  if (!written) return terminal.fail(written.error());
  print_summary(terminal, report);
  return kGood;
}

}  // namespace

void add_delaunay(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "delaunay", "The exact Delaunay or regular triangulation of points in space.",
      "crossloft delaunay points.txt -o tets.vtu --report report.json",
      [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command
      ->add_option("POINTS", a.points,
                   "x y z a line, vertices of a surface, or raw little-endian doubles (docs/formats.md)")
      ->required()
      ->check(extension_in({".txt", ".xyz", ".pts", ".f64", ".off", ".ply"}));
  command->add_option("-o,--output", a.output, "the tetrahedra, or what there is of a lower dimension")
      ->check(is_solid_file());
  command->add_option("--report", a.report, "also a report (docs/report.md)")->check(extension_in({".json"}));
  command->add_flag("--weights", a.weights,
                    "each point has a fourth number, its weight: the regular triangulation, by one thread");
  command->add_option("--threads", a.threads, "worker threads, 0: one per core; the result is the same")
      ->capture_default_str()
      ->transform(whole_number_in(0, 1024));
}

}  // namespace crossloft::cli
