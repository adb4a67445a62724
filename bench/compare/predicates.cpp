// Our predicates beside those of CGAL's kernels on the same points, taking turns in one run: EPICK (filters,
// then exact) and EPECK (lazy exact numbers), with the naive formula as the unit. Answers are compared too.
//
//   bench_compare_predicates [--json FILE] [REPETITIONS]

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "../../geom/strategies/naive_double.h"
#include "../../geom/strategies/production.h"
#include "../measurement.h"
#include "../predicate_cases.h"
#include "../predicate_questions.h"

namespace {

using namespace crossloft;
using namespace crossloft::bench;

constexpr std::size_t kCount = 512;
constexpr double kTurnSeconds = 2e-4;

volatile int sink;

/// A kernel's predicates on its own points, made before the clock runs.
template <class K>
struct Kernel {
  using Point2 = typename K::Point_2;
  using Point3 = typename K::Point_3;
  using Weighted = typename K::Weighted_point_3;

  static std::array<Point2, 4> convert(const PlanarCase& c) {
    return {convert(c[0]), convert(c[1]), convert(c[2]), convert(c[3])};
  }
  static std::array<Weighted, 5> convert(const SpaceCase& c) {
    return {convert(c[0]), convert(c[1]), convert(c[2]), convert(c[3]), convert(c[4])};
  }
  static Point2 convert(const Vec2& p) { return Point2(p.x, p.y); }
  static Weighted convert(const WeightedPoint& p) {
    return Weighted(Point3(p.position.x, p.position.y, p.position.z), p.weight);
  }
  static int ask(Orient2d, const std::array<Point2, 4>& p) { return CGAL::orientation(p[0], p[1], p[2]); }
  static int ask(Incircle, const std::array<Point2, 4>& p) {
    return CGAL::side_of_oriented_circle(p[0], p[1], p[2], p[3]);
  }
  static int ask(Orient3d, const std::array<Weighted, 5>& p) {
    return CGAL::orientation(p[0].point(), p[1].point(), p[2].point(), p[3].point());
  }
  static int ask(Insphere, const std::array<Weighted, 5>& p) {
    return CGAL::side_of_oriented_sphere(p[0].point(), p[1].point(), p[2].point(), p[3].point(),
                                         p[4].point());
  }
  static int ask(PowerTest, const std::array<Weighted, 5>& p) {
    return K().power_side_of_oriented_power_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]);
  }
};

template <class Cases, class Ask>
Contestant contestant(const Cases& cases, const Ask& ask) {
  return {[cases, ask, at = std::size_t{0}](std::size_t calls) mutable {
    int sum = 0;
    for (; calls > 0; --calls) {
      sum += ask(cases[at]);
      if (++at == cases.size()) at = 0;
    }
    sink = sum;
  }};
}

/// The contestants of one predicate and distribution.
template <class Q, class Case>
class Duel {
 public:
  explicit Duel(const CaseSet<Case>& set) : set_(set) {}

  template <class S>
  void add_strategy() {
    add(S::kName, set_.cases, [](const Case& c) { return Q::ask(S(), c); });
  }
  template <class K>
  void add_kernel(std::string_view name) {
    using Converted = decltype(Kernel<K>::convert(set_.cases[0]));
    std::vector<Converted> converted;
    for (const Case& c : set_.cases) converted.push_back(Kernel<K>::convert(c));
    add(name, converted, [](const Converted& c) { return Kernel<K>::ask(Q{}, c); });
  }
  void run(int repetitions, std::vector<Measurement>& all) {
    const std::vector<double> times = take_turns(std::move(contestants_), repetitions, kTurnSeconds);
    for (std::size_t i = 0; i < times.size(); ++i) {
      measurements_[i].nanoseconds = times[i];
      measurements_[i].multiple = times[i] / times[0];
    }
    all.insert(all.end(), measurements_.begin(), measurements_.end());
  }

 private:
  template <class Cases, class Ask>
  void add(std::string_view name, const Cases& cases, const Ask& ask) {
    Measurement m{std::string(Q::kName), set_.name, std::string(name)};
    for (std::size_t i = 0; i < cases.size(); ++i)
      m.wrong += ask(cases[i]) != Q::ask(strategies::Crossloft(), set_.cases[i]);
    m.wrong /= static_cast<double>(cases.size());
    m.stages = {m.strategy}, m.decided = {1, 0};
    measurements_.push_back(m);
    contestants_.push_back(contestant(cases, ask));
  }

  const CaseSet<Case>& set_;
  std::vector<Contestant> contestants_;
  std::vector<Measurement> measurements_;
};

template <class Questions, class Case>
void compare(const std::vector<CaseSet<Case>>& sets, int repetitions, std::vector<Measurement>& all) {
  for_each_question<Questions>([&]<class Q>() {
    for (const CaseSet<Case>& set : sets) {
      Duel<Q, Case> duel(set);
      duel.template add_strategy<strategies::NaiveDouble>();
      duel.template add_strategy<strategies::Crossloft>();
      duel.template add_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>("CGAL EPICK");
      duel.template add_kernel<CGAL::Exact_predicates_exact_constructions_kernel>("CGAL EPECK");
      duel.run(repetitions, all);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  std::string json;
  int repetitions = 9;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--json" && i + 1 < argc)
      json = argv[++i];
    else
      repetitions = std::max(1, std::atoi(argv[i]));
  }
  std::vector<Measurement> all;
  compare<PlanarQuestions>(planar_cases(kCount, 1), repetitions, all);
  compare<SpaceQuestions>(space_cases(kCount, 1, {}), repetitions, all);
  print_tables(all);
  std::size_t different = 0;
  for (const Measurement& m : all) different += m.strategy.rfind("CGAL", 0) == 0 && m.wrong > 0;
  std::printf("\n%zu predicates and distributions with another answer than CGAL's\n", different);
  if (std::FILE* file = json.empty() ? nullptr : std::fopen(json.c_str(), "wb")) {
    std::fputs(to_json(all).c_str(), file);
    std::fclose(file);
  }
  return different == 0 ? 0 : 1;
}
