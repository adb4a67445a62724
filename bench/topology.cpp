// Does a mode of pruning find the topology of a known solid? Cuts the solids of inspect/solids.h with seeded
// sets of planes, all contour vertices kept, reconstructs in every mode and compares with the mesh that was
// cut.
//
//   bench_topology [--first N] [--seeds N] [--case TEXT] [--rays N] [--divide WHERE] [--look-around WHERE]
//                 [--branching all|auto|off] [--mesh FILE PLANES] [--stacks] [--verbose] [MODE...]
//                 default: seeds 1 to 10, all cases, 128 rays, modes joint and natural; with a mesh, which
//                 may come several times, random planes through it instead of the cases;
//                 with --stacks parallel slices through the same solids, a direction for each seed
//
// A run is right if its genus (summed) and its number of surface components are those of the mesh. Per case
// and mode: right runs, means of intersection over union and of the volume's error, the worst loss of IoU
// against the first mode in any run, and the time of pruning as a part of the Delaunay triangulations of the
// same cells.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "../inspect/check.h"
#include "../inspect/compare.h"
#include "../inspect/slice.h"
#include "../inspect/surface_topology.h"
#include "../reconstruct/reconstruct.h"
#include "topology_cases.h"

namespace {

using namespace crossloft;
/// One component of a surface.
struct Body {
  std::int64_t genus = 0;
  double volume = 0;
};

struct Shape {
  std::int64_t genus = 0;
  std::size_t components = 0;
  double volume = 0;
  std::vector<Body> bodies;  ///< the largest first

  bool same(const Shape& o) const { return genus == o.genus && components == o.components; }
};

/// By index only: crossings are not asked for here.
Shape shape_of(const Surface& surface) {
  CheckReport report;
  const SurfaceTopology topology = check_topology(surface, report);
  for (std::size_t i = 0; i < topology.triangles.size(); ++i) {
    const auto [a, b, c] = corners(surface, topology.triangles[i]);
    report.components[topology.component[i]].volume += dot(a, cross(b, c)) / 6;
  }
  Shape shape{0, report.components.size(), 0, {}};
  for (const ComponentReport& c : report.components) {
    shape.genus += 1 - c.euler / 2;
    shape.volume += c.volume;
    shape.bodies.push_back({1 - c.euler / 2, c.volume});
  }
  std::sort(shape.bodies.begin(), shape.bodies.end(),
            [](const Body& a, const Body& b) { return std::fabs(a.volume) > std::fabs(b.volume); });
  return shape;
}

struct Run {
  Shape shape;
  double iou = 0, volume_error = 0, pruning = 0, delaunay = 0;
  Report report;
};

struct Arguments {
  std::uint64_t first = 1, seeds = 10;
  std::uint32_t rays = 128;
  std::string only;
  std::vector<bench::TopologyCase> cases;
  bool verbose = false;
  std::vector<PruneMode> modes;
  Options options;
};

bool reconstruct_one(const Surface& mesh, const Shape& truth, const Sections& sections,
                     const Options& options, std::uint32_t rays, Run& run) {
  const auto result = reconstruct(sections, options);
  if (!result) {
    std::fprintf(stderr, "error: %s\n", result.error().message.c_str());
    return false;
  }
  run.shape = shape_of(result->surface);
  CompareOptions compared;
  compared.rays = rays;
  compared.samples = 0;
  run.iou = compare(mesh, result->surface, compared).iou;
  run.volume_error = std::fabs(run.shape.volume / truth.volume - 1);
  run.pruning = result->report.seconds.pruning;
  run.delaunay = result->report.seconds.delaunay;
  run.report = result->report;
  return true;
}

void print_summary(const std::string& name, PruneMode mode, const Shape& truth, const std::vector<Run>& runs,
                   const std::vector<Run>& first) {
  double iou = 0, error = 0, pruning = 0, delaunay = 0, worst = 0;
  int right = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    right += runs[i].shape.same(truth);
    iou += runs[i].iou;
    error += runs[i].volume_error;
    pruning += runs[i].pruning;
    delaunay += runs[i].delaunay;
    worst = std::min(worst, runs[i].iou - first[i].iou);
  }
  const double n = static_cast<double>(runs.size());
  std::printf("%-24s %-8s %2d of %2zu  iou %.4f worst %+.4f  volume error %.4f  pruning/delaunay %.2f\n",
              name.c_str(), name_of(mode), right, runs.size(), iou / n, worst, error / n, pruning / delaunay);
  std::fflush(stdout);
}

/// What a wrong run consists of, and the joins it did without.
void print_bodies(const Run& run) {
  std::printf("       ");
  for (const Body& b : run.shape.bodies)
    std::printf(" [genus %lld volume %.2g]", static_cast<long long>(b.genus), b.volume);
  const TopologyReport& t = run.report.topology;
  std::printf(" joins refused %u walls %u pinched vertices %u edges %u\n", t.refused_joins, t.walls,
              run.report.pinched_vertices, run.report.pinched_edges);
}

bool run_case(const bench::TopologyCase& c, const Arguments& arguments) {
  const Surface mesh = c.solid();
  const Shape truth = shape_of(mesh);
  std::vector<std::vector<Run>> runs(arguments.modes.size());
  for (std::uint64_t seed = arguments.first; seed <= arguments.seeds; ++seed) {
    const auto sections = slice(mesh, c.planes(bounds_of(mesh.points), seed));
    if (!sections) return false;
    for (std::size_t m = 0; m < arguments.modes.size(); ++m) {
      Options options = arguments.options;
      options.mode = arguments.modes[m];
      Run run;
      if (!reconstruct_one(mesh, truth, *sections, options, arguments.rays, run)) return false;
      const bool right = run.shape.same(truth);
      if (arguments.verbose || !right)
        std::printf("  seed %2llu %-8s genus %lld of %lld, components %zu of %zu, iou %.4f, flat %.2g\n",
                    static_cast<unsigned long long>(seed), name_of(options.mode),
                    static_cast<long long>(run.shape.genus), static_cast<long long>(truth.genus),
                    run.shape.components, truth.components, run.iou,
                    run.report.flat_area / run.report.section_area);
      if (arguments.verbose && !right) print_bodies(run);
      runs[m].push_back(std::move(run));
    }
  }
  for (std::size_t m = 0; m < runs.size(); ++m)
    print_summary(c.name, arguments.modes[m], truth, runs[m], runs[0]);
  return true;
}

bool read_mode(const std::string& word, Arguments& arguments) {
  for (const PruneMode mode :
       {PruneMode::joint, PruneMode::paper, PruneMode::paper_literal, PruneMode::natural})
    if (word == name_of(mode)) {
      arguments.modes.push_back(mode);
      return true;
    }
  return false;
}

/// Of Branching and InCells.
template <class Where>
bool read_where(const std::string& word, Where& where) {
  if (word != "all" && word != "auto" && word != "off") return false;
  where = word == "all" ? Where::all : word == "off" ? Where::off : Where::automatic;
  return true;
}

/// The two words after --mesh.
bool read_mesh_case(char** words, Arguments& arguments) {
  auto mesh = bench::mesh_case(words[1], static_cast<std::uint32_t>(std::strtoul(words[2], nullptr, 10)));
  if (mesh)
    arguments.cases.push_back(std::move(mesh).value());
  else
    std::fprintf(stderr, "%s\n", mesh.error().message.c_str());
  return mesh.ok();
}

bool read_arguments(int count, char** words, Arguments& arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const bool last = i + 1 == count;
    if (word == "--look-around" && !last) {
      if (!read_where(words[++i], arguments.options.natural.look_around)) return false;
    } else if (word == "--divide" && !last) {
      if (!read_where(words[++i], arguments.options.natural.divide)) return false;
    } else if (word == "--branching" && !last) {
      if (!read_where(words[++i], arguments.options.branching.mode)) return false;
    } else if (word == "--mesh" && i + 2 < count) {
      if (!read_mesh_case(words + i, arguments)) return false;
      i += 2;
    } else if (word == "--stacks") {
      arguments.cases = bench::stack_cases();
    } else if (word == "--verbose") {
      arguments.verbose = true;
    } else if (word == "--seeds" && !last) {
      arguments.seeds = std::strtoull(words[++i], nullptr, 10);
    } else if (word == "--first" && !last) {
      arguments.first = std::strtoull(words[++i], nullptr, 10);
    } else if (word == "--rays" && !last) {
      arguments.rays = static_cast<std::uint32_t>(std::strtoul(words[++i], nullptr, 10));
    } else if (word == "--case" && !last) {
      arguments.only = words[++i];
    } else if (!read_mode(word, arguments)) {
      return false;
    }
  }
  if (arguments.seeds == 0 || arguments.rays == 0) return false;
  if (arguments.modes.empty()) arguments.modes = {PruneMode::joint, PruneMode::natural};
  return true;
}

}  // namespace

int main(int count, char** words) {
  Arguments arguments;
  if (!read_arguments(count, words, arguments)) {
    std::fprintf(stderr,
                 "usage: bench_topology [--first N] [--seeds N] [--case TEXT] [--rays N] [--divide WHERE] "
                 "[--look-around WHERE] "
                 "[--branching all|auto|off] [--mesh FILE PLANES] [--stacks] [--verbose] [MODE...]\n");
    return 2;
  }
  if (arguments.cases.empty()) arguments.cases = bench::topology_cases();
  for (const bench::TopologyCase& c : arguments.cases)
    if (c.name.find(arguments.only) != std::string::npos && !run_case(c, arguments)) return 1;
  return 0;
}
