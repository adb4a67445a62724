// Strategy x predicate x distribution: nanoseconds a call, multiples of the naive strategy, and which stage
// of a cascade decides. docs/strategies.md shows a run.
//
//   bench_predicates [--json FILE] [--picture FILE.svg] [--contours FILE] [--only PREDICATE]
//                    [--repetitions N] [--seed N]
//
// Strategies take turns; a time is the median of the repetitions. Without --contours the contour data are
// those of examples/demo.contour.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include "../geom/strategies/list.h"
#include "../io/read_sections.h"
#include "measurement.h"
#include "output.h"
#include "predicate_cases.h"
#include "predicate_questions.h"

namespace {

using namespace crossloft;
using namespace crossloft::bench;
using namespace crossloft::strategies;

constexpr std::size_t kCount = 512;
constexpr double kTurnSeconds = 2e-4;

struct Options {
  std::string json, picture, contours = CROSSLOFT_SOURCE_DIR "/examples/demo.contour", only;
  int repetitions = 9;
  std::uint64_t seed = 1;
};

/// Keeps a result from being optimised away.
volatile int sink;

template <class Q, class S, class Case>
Contestant contestant(const std::vector<Case>& cases, const Extent& extent) {
  return {[&cases, strategy = S(extent), at = std::size_t{0}](std::size_t calls) mutable {
    int sum = 0;
    for (; calls > 0; --calls) {
      sum += Q::ask(strategy, cases[at]);
      if (++at == cases.size()) at = 0;
    }
    sink = sum;
  }};
}

template <class Q, class S, class Case>
Measurement histogram(const CaseSet<Case>& set, const Extent& extent) {
  Measurement m{std::string(Q::kName), set.name, std::string(S::kName)};
  const Counted<S> counted(extent);
  std::size_t wrong = 0;
  for (const Case& c : set.cases) {
    const Verdict verdict = Q::ask(counted, c);
    wrong += verdict != kUnknown && verdict != Q::ask(Crossloft(), c);
  }
  const auto share = [&](std::uint64_t n) {
    return static_cast<double>(n) / static_cast<double>(set.cases.size());
  };
  m.wrong = share(wrong);
  for (const std::string_view name : StagesOf<S>::kNames) m.stages.emplace_back(name);
  for (const std::uint64_t n : counted.counts()) m.decided.push_back(share(n));
  return m;
}

template <class Q, class Case>
void measure(const CaseSet<Case>& set, const Options& options, std::vector<Measurement>& all) {
  const Extent extent = extent_of(set.cases);
  std::vector<Contestant> contestants;
  std::vector<Measurement> measurements;
  for_each_strategy([&]<class S>() {
    contestants.push_back(contestant<Q, S>(set.cases, extent));
    measurements.push_back(histogram<Q, S>(set, extent));
  });
  const std::vector<double> times = take_turns(std::move(contestants), options.repetitions, kTurnSeconds);
  for (std::size_t i = 0; i < times.size(); ++i) {
    measurements[i].nanoseconds = times[i];
    measurements[i].multiple = times[i] / times[0];  // the naive strategy is the first of the list
  }
  all.insert(all.end(), measurements.begin(), measurements.end());
  std::fprintf(stderr, "%s, %s\n", std::string(Q::kName).c_str(), set.name.c_str());
}

template <class Questions, class Case>
void measure_all(const std::vector<CaseSet<Case>>& sets, const Options& options,
                 std::vector<Measurement>& all) {
  for_each_question<Questions>([&]<class Q>() {
    if (!options.only.empty() && options.only != Q::kName) return;
    for (const CaseSet<Case>& set : sets) measure<Q>(set, options, all);
  });
}

std::vector<Vec3> contour_points(const std::string& path) {
  std::vector<Vec3> points;
  const auto sections = read_sections(path);
  if (!sections) {
    std::fprintf(stderr, "%s: %s\n", path.c_str(), sections.error().message.c_str());
    std::exit(3);
  }
  for (const PlaneSection& plane : sections->planes)
    points.insert(points.end(), plane.vertices.begin(), plane.vertices.end());
  return points;
}

bool parse(int argc, char** argv, Options& options) {
  const std::map<std::string, std::string*> texts{{"--json", &options.json},
                                                  {"--picture", &options.picture},
                                                  {"--contours", &options.contours},
                                                  {"--only", &options.only}};
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    if (const auto found = texts.find(name); found != texts.end()) {
      *found->second = argv[i + 1];
    } else if (name == "--repetitions") {
      options.repetitions = std::max(1, std::atoi(argv[i + 1]));
    } else if (name == "--seed") {
      options.seed = std::strtoull(argv[i + 1], nullptr, 10);
    } else {
      return false;
    }
  }
  return argc % 2 == 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    std::fprintf(stderr,
                 "usage: bench_predicates [--json FILE] [--picture FILE.svg] [--contours FILE]\n"
                 "                        [--only PREDICATE] [--repetitions N] [--seed N]\n");
    return 2;
  }
  std::printf("seed %llu, %zu cases a distribution, median of %d\n",
              static_cast<unsigned long long>(options.seed), kCount, options.repetitions);
  std::vector<Measurement> all;
  LatticePointStore store;
  measure_all<PlanarQuestions>(planar_cases(kCount, options.seed), options, all);
  measure_all<SpaceQuestions>(space_cases(kCount, options.seed, contour_points(options.contours)), options,
                              all);
  measure_all<LatticeQuestions>(lattice_cases(kCount, options.seed, store), options, all);
  print_tables(all);
  return write_file(options.json, to_json(all)) && write_file(options.picture, to_svg(all)) ? 0 : 3;
}
