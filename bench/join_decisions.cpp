// How well do the measures of a tetrahedron tell which sections of a cell are one body? Cuts solids of known
// topology and lets Kruskal's algorithm join the sections of each cell, the best tetrahedron of R1 first.
// Each time that it brings two bodies together the mesh that was cut tells whether they are one in truth.
//
//   bench_joins [--seeds FIRST LAST] [--case TEXT] [--mesh FILE PLANES]      default: 11 to 20, all cases but
//   the nested shells; with a mesh random planes through it instead
//
// Per measure, and by how many planes meet the one of the two bodies that fewer meet: joins of what is one
// body and of what is not, the area under the ROC curve, and how many would be decided wrongly by the best
// limit, and by 0; and in how many runs there is one of these.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "../prune/confidence.h"
#include "../prune/likely_joins.h"
#include "../prune/prune.h"
#include "../prune/section_field.h"
#include "../prune/section_parts.h"
#include "../prune/star.h"
#include "../reconstruct/observer.h"
#include "../reconstruct/pruning_input.h"
#include "../reconstruct/reconstruct.h"
#include "cell_truth.h"
#include "topology_cases.h"

namespace {

using namespace crossloft;
using bench::CellTruth;

/// A measure brings two bodies together.
struct Decision {
  double measure = 0;
  bool is_one = false;     ///< in truth
  std::size_t planes = 0;  ///< that meet the body that fewer meet
  std::uint32_t run = 0;
};

using Decisions = std::map<std::string, std::vector<Decision>>;  ///< by measure

/// What of a cell is needed to decide.
struct CellUnderStudy {
  const CellComplex& complex;
  const CellShape& shape;
  const Ground ground;
  std::vector<std::uint8_t> r1;
  std::vector<std::uint32_t> body;  ///< in truth, by ground triangle
};

/// Kruskal's algorithm: sets of ground triangles, then tetrahedra.
class Joining {
 public:
  explicit Joining(const CellUnderStudy& cell)
      : cell_(cell),
        sets_(cell.ground.size() + cell.r1.size()),
        bodies_(sets_size()),
        parts_(section_parts(cell.complex, cell.ground)),
        seen_(parts_),
        part_(sets_size(), kNone) {
    for (std::uint32_t g = 0; g < cell.ground.size(); ++g) {
      sets_.join(g, cell.ground.part(g));
      if (cell.ground.part(g) == g) bodies_[g].insert(cell.body[g]);
    }
    for (std::uint32_t i = 0; i < parts_.size(); ++i) part_[sets_.find(parts_[i].number)] = i;
  }

  void run(const std::vector<double>& measure, std::uint32_t run, std::vector<Decision>& decisions) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t t = 0; t < cell_.r1.size(); ++t)
      if (cell_.r1[t] != 0) order.push_back(t);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return measure[a] > measure[b]; });
    std::vector<std::uint8_t> in(cell_.r1.size(), 0);
    for (const std::uint32_t t : order) {
      in[t] = 1;
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t n = cell_.complex.mesh.neighbours[t][i];
        const auto join_with = [&](std::uint32_t other) {
          if (const auto made = join(tet(t), other))
            decisions.push_back({measure[t], made->is_one, made->planes, run});
        };
        if (n != kNone && in[n] != 0) join_with(tet(n));
        if (cell_.ground.is_ground(t, i)) join_with(cell_.ground.at(t, i));
      }
    }
  }

 private:
  std::size_t sets_size() const { return cell_.ground.size() + cell_.r1.size(); }
  std::uint32_t tet(std::uint32_t t) const { return cell_.ground.size() + t; }

  /// Of two pieces, if both have a section.
  struct Made {
    bool is_one = false;  ///< in truth
    std::size_t planes = 0;
  };

  std::optional<Made> join(std::uint32_t a, std::uint32_t b) {
    a = sets_.find(a), b = sets_.find(b);
    if (a == b) return std::nullopt;
    std::optional<Made> made;
    std::set<std::uint32_t> all = bodies_[a];
    if (part_[a] != kNone && part_[b] != kNone) {
      const std::uint32_t x = seen_.body_of(part_[a]), y = seen_.body_of(part_[b]);
      made = Made{std::any_of(all.begin(), all.end(),
                              [&](std::uint32_t body) { return bodies_[b].count(body) != 0; }),
                  seen_.planes_at_both(x, y)};
      seen_.join(x, y);
    }
    all.insert(bodies_[b].begin(), bodies_[b].end());
    const std::uint32_t part = std::min(part_[a], part_[b]);
    sets_.join(a, b);
    bodies_[sets_.find(a)] = std::move(all);
    part_[sets_.find(a)] = part;
    return made;
  }

  const CellUnderStudy& cell_;
  DisjointSets sets_;
  std::vector<std::set<std::uint32_t>> bodies_;  ///< by root
  std::vector<SectionPart> parts_;
  SeenBodies seen_;
  std::vector<std::uint32_t> part_;  ///< by root: one of its parts, kNone if it has none
};

std::vector<double> by_confidence(const CellUnderStudy& cell) {
  const std::vector<std::int32_t> confidence = confidences(cell.complex, cell.shape, cell.r1);
  std::vector<double> measure;
  for (const std::int32_t c : confidence) measure.push_back(static_cast<double>(c) / kCertain);
  return measure;
}

std::vector<double> by_function(const CellUnderStudy& cell, const SmoothFunction& f) {
  std::vector<double> measure(cell.r1.size(), -1);
  for (std::uint32_t t = 0; t < cell.r1.size(); ++t)
    if (cell.r1[t] != 0)
      measure[t] = largest_value(cell.complex, cell.shape, f, std::numeric_limits<double>::infinity(), t);
  return measure;
}

/// Looks at every cell of one run.
class JoinStudy : public Observer {
 public:
  JoinStudy(const CellTruth& truth, std::uint32_t run, Decisions& decisions)
      : truth_(truth), run_(run), decisions_(decisions) {}

  void on_sections(const FramedSections& framed, const Arrangement& arrangement,
                   const SectionGraph& graph) override {
    grid_.emplace(framed.grid);
    arrangement_.emplace(arrangement);
    field_.emplace(section_field(graph));
  }
  void on_cell(CellId id, const BuiltCell& built, const PruneResult&) override {
    if (built.complex.mesh.size() == 0) return;
    std::vector<FaceId> faces;
    for (const FaceId f : arrangement_->faces_of(id))
      if (!arrangement_->on_box(f)) faces.push_back(f);
    const CellShape shape = cell_shape(*arrangement_, id, faces, built);
    CellUnderStudy cell{built.complex, shape, Ground(built.complex), without_external(built.complex), {}};
    cell.body = bodies(built, cell.ground);
    if (cell.ground.part_count() > 1) study(cell);
  }

 private:
  /// By ground triangle. A cell is convex: the mean of its vertices is within.
  std::vector<std::uint32_t> bodies(const BuiltCell& built, const Ground& ground) const {
    const auto place = [&](std::uint32_t v) { return grid_->from_lattice(built.points[v]); };
    Vec3 middle;
    for (std::uint32_t v = 0; v < built.vertices.size(); ++v)
      middle = middle + (1 / static_cast<double>(built.vertices.size())) * place(v);
    const CellTruth::Sides sides = truth_.sides_of(middle);
    DisjointSets sets(ground.size());
    std::map<std::uint32_t, std::uint32_t> first;  // ground triangle by piece
    for (std::uint32_t g = 0; g < ground.size(); ++g) {
      sets.join(g, ground.part(g));
      for (const std::uint8_t slot : kFacetSlots[ground.facet(g).facet]) {
        const std::uint32_t v = built.complex.mesh.vertices[ground.facet(g).tet][slot];
        const std::uint32_t piece = truth_.piece_at(sides, place(v));
        if (piece != kNone) sets.join(g, first.try_emplace(piece, g).first->second);
      }
    }
    std::vector<std::uint32_t> bodies;
    for (std::uint32_t g = 0; g < ground.size(); ++g) bodies.push_back(sets.find(g));
    return bodies;
  }

  void study(const CellUnderStudy& cell) {
    const auto f = function_around(cell.complex, cell.shape, *field_);
    if (!f) return;
    Joining(cell).run(by_confidence(cell), run_, decisions_["confidence"]);
    Joining(cell).run(by_function(cell, *f), run_, decisions_["function"]);
  }

  const CellTruth& truth_;
  std::uint32_t run_;
  Decisions& decisions_;
  std::optional<WorldGrid> grid_;  // copies: what an observer sees is valid during its call
  std::optional<Arrangement> arrangement_;
  std::optional<SectionField> field_;
};

/// Decided wrongly by a limit, and the runs in which that happens.
struct Wrong {
  std::size_t joins = 0;
  std::set<std::uint32_t> runs;
};

Wrong wrong_by(double limit, const std::vector<Decision>& decisions) {
  Wrong wrong;
  for (const Decision& d : decisions)
    if ((d.measure >= limit) != d.is_one) ++wrong.joins, wrong.runs.insert(d.run);
  return wrong;
}

/// `decisions`: the largest measure first.
double best_limit(const std::vector<Decision>& decisions) {
  double limit = 0;
  std::size_t least = decisions.size() + 1;
  std::size_t wrong = static_cast<std::size_t>(
      std::count_if(decisions.begin(), decisions.end(), [](const Decision& d) { return d.is_one; }));
  for (const Decision& d : decisions) {
    d.is_one ? --wrong : ++wrong;
    if (wrong < least) least = wrong, limit = d.measure;
  }
  return limit;
}

void print(const std::string& name, const std::vector<Decision>& decisions) {
  double ones = 0, pairs = 0;  // of one that is and one that is not, in the right order
  for (const Decision& d : decisions) d.is_one ? ones += 1 : pairs += ones;
  const double others = static_cast<double>(decisions.size()) - ones, limit = best_limit(decisions);
  const Wrong best = wrong_by(limit, decisions), zero = wrong_by(0, decisions);
  std::printf("  %-12s %4.0f one %4.0f apart  ", name.c_str(), ones, others);
  if (ones > 0 && others > 0) std::printf("area %.4f  ", pairs / (ones * others));
  std::printf("wrong %zu in %zu runs at %.4f, %zu in %zu at 0\n", best.joins, best.runs.size(), limit,
              zero.joins, zero.runs.size());
}

/// Numbers of planes from here on are one line.
constexpr std::size_t kManyPlanes = 5;

void print_with_planes(const std::string& name, std::vector<Decision> decisions) {
  std::stable_sort(decisions.begin(), decisions.end(),
                   [](const Decision& a, const Decision& b) { return a.measure > b.measure; });
  print(name, decisions);
  for (std::size_t planes = 1; planes <= kManyPlanes; ++planes) {
    std::vector<Decision> some;
    std::copy_if(decisions.begin(), decisions.end(), std::back_inserter(some),
                 [&](const Decision& d) { return std::min(d.planes, kManyPlanes) == planes; });
    if (!some.empty()) print("  planes " + std::to_string(planes) + (planes == kManyPlanes ? "+" : ""), some);
  }
}

struct Arguments {
  std::uint64_t first = 11, last = 20;
  std::string only;
  std::vector<bench::TopologyCase> cases;
};

bool read_arguments(int count, char** words, Arguments& arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--case" && i + 1 < count) {
      arguments.only = words[++i];
    } else if (word == "--mesh" && i + 2 < count) {
      const auto planes = static_cast<std::uint32_t>(std::strtoul(words[i + 2], nullptr, 10));
      auto mesh = bench::mesh_case(words[i + 1], planes);
      if (!mesh) return false;
      arguments.cases.push_back(std::move(mesh).value());
      i += 2;
    } else if (word == "--seeds" && i + 2 < count) {
      arguments.first = std::strtoull(words[++i], nullptr, 10);
      arguments.last = std::strtoull(words[++i], nullptr, 10);
    } else {
      return false;
    }
  }
  return arguments.first <= arguments.last;
}

bool study_case(const bench::TopologyCase& c, const Arguments& arguments, std::uint32_t& run,
                Decisions& all) {
  const Surface mesh = c.solid();
  Decisions here;
  for (std::uint64_t seed = arguments.first; seed <= arguments.last; ++seed, ++run) {
    const std::vector<CuttingPlane> planes = c.planes(bounds_of(mesh.points), seed);
    const auto sections = slice(mesh, planes);
    if (!sections) return false;
    const CellTruth truth(mesh, planes);
    JoinStudy study(truth, run, here);
    if (!reconstruct(*sections, {}, {}, &study)) return false;
  }
  std::printf("%s\n", c.name.c_str());
  for (const auto& [name, decisions] : here) {
    print_with_planes(name, decisions);
    all[name].insert(all[name].end(), decisions.begin(), decisions.end());
  }
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int count, char** words) {
  Arguments arguments;
  if (!read_arguments(count, words, arguments))
    return std::fprintf(stderr,
                        "usage: bench_joins [--seeds FIRST LAST] [--case TEXT] [--mesh FILE PLANES]\n"),
           2;
  Decisions all;
  std::uint32_t run = 0;
  if (arguments.cases.empty()) arguments.cases = bench::topology_cases();
  for (const bench::TopologyCase& c : arguments.cases) {
    if (c.name.find(arguments.only) == std::string::npos || c.name.find("nested") == 0) continue;
    if (!study_case(c, arguments, run, all)) return std::fprintf(stderr, "error: %s\n", c.name.c_str()), 1;
  }
  std::printf("all, %u runs\n", run);
  for (const auto& [name, decisions] : all) print_with_planes(name, decisions);
  return 0;
}
