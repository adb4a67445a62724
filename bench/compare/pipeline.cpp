// A whole reconstruction against no more than CGAL's Delaunay triangulations (EPICK, range insertion) of the
// same cells' points, in turns in one process: what a program built on CGAL could not do without.
//
//   bench_compare_pipeline [--rounds N] [--mode MODE] [--threads N] [--plain] FILE...      sections, as
//   crossloft reconstruct reads them; --plain: no points inside cells, joins in doubt not looked into
//
// Medians of N rounds (3), in seconds: of processor time with one thread, which CGAL has always; of the clock
// with more.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "../../io/read_sections.h"
#include "../../reconstruct/observer.h"
#include "../../reconstruct/reconstruct.h"

namespace {

using namespace crossloft;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The points of each cell that was triangulated, as rounded lattice coordinates.
class CellPoints : public Observer {
 public:
  void on_cell(CellId, const BuiltCell& cell, const PruneResult&) override {
    std::vector<Kernel::Point_3>& points = cells.emplace_back();
    for (const LatticePoint& p : cell.points) points.emplace_back(p.x, p.y, p.z);
  }
  std::vector<std::vector<Kernel::Point_3>> cells;
};

double seconds(bool of_processor) {
  if (of_processor) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Run>
double timed(bool of_processor, const Run& run) {
  const double start = seconds(of_processor);
  run();
  return seconds(of_processor) - start;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool compare_on(const char* path, const Options& options, unsigned threads, int rounds) {
  const auto sections = read_sections(path);
  if (!sections) return std::fprintf(stderr, "%s\n", sections.error().message.c_str()), false;
  Context context;
  context.threads = threads;
  CellPoints points;
  if (!reconstruct(*sections, options, context, &points)) return false;
  std::vector<double> ours, theirs, ratios;
  std::size_t vertices = 0, tets = 0;
  for (const auto& cell : points.cells) vertices += cell.size();
  for (int round = 0; round < rounds; ++round) {
    ours.push_back(timed(threads == 1, [&] { (void)reconstruct(*sections, options, context); }));
    tets = 0;
    theirs.push_back(timed(threads == 1, [&] {
      for (const auto& cell : points.cells)
        tets += CGAL::Delaunay_triangulation_3<Kernel>(cell.begin(), cell.end()).number_of_finite_cells();
    }));
    ratios.push_back(ours.back() / theirs.back());
  }
  std::printf(
      "%-40s %8zu vertices in cells %9zu tetrahedra  ours %.3f s  CGAL's Delaunay %.3f s  ratio %.2f\n", path,
      vertices, tets, median(ours), median(theirs), median(ratios));
  std::fflush(stdout);
  return true;
}

bool set_mode(const std::string& word, Options& options) {
  for (const PruneMode mode : {PruneMode::joint, PruneMode::paper, PruneMode::natural})
    if (word == name_of(mode)) return options.mode = mode, true;
  return false;
}

}  // namespace

int main(int count, char** words) {
  Options options;
  int rounds = 3, threads = 1;
  std::vector<const char*> files;
  bool good = true;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--rounds" && i + 1 < count)
      rounds = std::atoi(words[++i]);
    else if (word == "--threads" && i + 1 < count)
      threads = std::atoi(words[++i]);
    else if (word == "--mode" && i + 1 < count)
      good = set_mode(words[++i], options) && good;
    else if (word == "--plain")
      options.natural.divide = options.natural.look_around = InCells::off;
    else
      files.push_back(words[i]);
  }
  if (!good || rounds < 1 || threads < 1 || files.empty()) {
    std::fprintf(
        stderr, "usage: bench_compare_pipeline [--rounds N] [--mode MODE] [--threads N] [--plain] FILE...\n");
    return 2;
  }
  for (const char* file : files)
    good = compare_on(file, options, static_cast<unsigned>(threads), rounds) && good;
  return good ? 0 : 1;
}
