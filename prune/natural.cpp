#include "natural.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "best_way.h"
#include "confidence.h"
#include "cracks.h"
#include "energy.h"
#include "likely_joins.h"
#include "outside.h"
#include "star.h"
#include "walls.h"
#include "widest_ways.h"

namespace crossloft {
namespace {

/// The sections ask for a handle in a cell where its ring is at least so sure and the hole through it is
/// nowhere surer: near the sections all the way around, and near their outsides all the way through.
constexpr double kRingConfidence = 0.05, kTunnelConfidence = -0.2;

/// One cell on its way.
class NaturalPruning {
 public:
  NaturalPruning(const CellComplex& complex, const Ground& ground, const CellShape& shape,
                 const NaturalOptions& options, const CellRequests& requests)
      : complex_(complex),
        shape_(shape),
        options_(options),
        requests_(requests),
        limits_{as_integer(options.join_confidence), as_integer(options.dome_confidence), requests.wishes,
                requests.opened},
        ground_(ground),
        meter_(complex, ground, shape),
        confidence_(complex.mesh.size(), -kCertain),
        is_measured_(complex.mesh.size(), 0) {}

  NaturalResult run(const std::vector<std::uint8_t>& r1) {
    EnergyWeights weights;
    weights.smooth = options_.smooth_weight;
    NaturalResult result;
    result.kept = cheapest_solid(complex_, shape_, r1,
                                 {[&](std::uint32_t t) { return meter_.bounds(t); },
                                  [&](std::uint32_t t) { return confidence_of(t); }},
                                 weights, requests_.cancel);
    if (is_raised(requests_.cancel)) return result;
    result.r2 = static_cast<std::uint32_t>(std::count(result.kept.begin(), result.kept.end(), 1));
    NaturalReport& report = result.report;
    const CellBodies bodies = find_bodies(complex_, ground_, result.kept);
    report.before = report.after = count_topology(complex_, ground_, result.kept, bodies);
    if (bodies_with_ground(bodies) < report.before.sections)
      report.joins = find_widest_ways(complex_, ground_, result.kept, bodies.of_ground,
                                      [&](std::uint32_t t) { return confidence_of(t); });
    std::vector<std::uint8_t> allowed = result.kept;
    // Of the voids those that are islands in the outside are none of its parts.
    const std::uint32_t voids = std::min(report.before.outsides, report.before.voids);
    const bool lacks_walls = add_walls(r1, report.before.outsides - voids, allowed);
    const bool good = is_good(report, result.kept);
    std::vector<std::uint32_t> body_in_r1;
    if (may_doubt()) body_in_r1 = bodies_of(r1, bodies);
    const bool doubts = !body_in_r1.empty() && !is_surely_joined(bodies, body_in_r1, report.joins);
    if (!good || lacks_walls) measure_all(r1);
    for (const JoinWish& wish : limits_.wishes)
      if (wish.join) add_way(wish, r1, allowed);
    if (!good)
      result.kept = allowed, grow(result, limits_);
    else if (lacks_walls)
      build_walls(allowed, result);
    if (doubts) decide_joins(r1, body_in_r1, allowed, result);
    if (!requests_.joined.empty()) join_alone(r1, std::move(allowed), result);
    if (!requests_.dropped.empty()) {
      report.dropped = drop_bodies(complex_, ground_, requests_.dropped, result.kept);
      report.after = count_topology(complex_, ground_, result.kept);
    } else if (report.after.bodies > 1) {
      report.spikes = spikes(result.kept);
    }
    return result;
  }

 private:
  /// Where a cavity is opened, nothing at it that is not sure is built: else no more than a slit is left
  /// open. What stands on a section goes too; there are the other side and bridges.
  void drop_unsure(const OpenRequest& request, std::vector<std::uint8_t>& allowed) const {
    const std::int32_t least = as_integer(options_.cavity_confidence);
    const std::uint32_t from = tet_of_name(complex_.mesh, request.from);
    const std::uint32_t to = tet_of_name(complex_.mesh, request.to);
    if (from == kNone || to == kNone) return;
    allowed[from] = allowed[to] = 0;
    std::vector<std::uint32_t> list = outside_part(complex_, allowed, from).tets;
    for (std::size_t head = 0; head < list.size(); ++head)
      for (const std::uint32_t n : complex_.mesh.neighbours[list[head]]) {
        if (n == kNone || allowed[n] == 0 || confidence_[n] >= least) continue;
        allowed[n] = 0;
        list.push_back(n);
      }
  }

  bool is_open(const OpenRequest& request, const std::vector<std::uint8_t>& kept) const {
    const std::uint32_t from = tet_of_name(complex_.mesh, request.from);
    const std::uint32_t to = tet_of_name(complex_.mesh, request.to);
    if (from == kNone || to == kNone || kept[from] != 0) return false;
    const std::vector<std::uint32_t> part = outside_part(complex_, kept, from).tets;
    return std::find(part.begin(), part.end(), to) != part.end();
  }

  std::uint32_t count_open(const std::vector<std::uint8_t>& kept) const {
    return static_cast<std::uint32_t>(std::count_if(requests_.opened.begin(), requests_.opened.end(),
                                                    [&](const auto& r) { return is_open(r, kept); }));
  }

  /// Lets growth build walls that the cut left out though R1 has them; not where it was asked to leave
  /// something open, nor where the outside has as many parts as the hull, none of them a void. False if there
  /// are none.
  bool add_walls(const std::vector<std::uint8_t>& r1, std::uint32_t outsides,
                 std::vector<std::uint8_t>& allowed) {
    const std::uint32_t parts = shape_.memory != nullptr ? shape_.memory->hull_parts : kNone;
    if (!requests_.walls || !requests_.opened.empty() || outsides >= parts) return false;
    const Walls walls = find_walls(complex_, allowed, as_integer(kWallConfidence), [&](std::uint32_t t) {
      return r1[t] != 0 ? confidence_of(t) : -kCertain;
    });
    for (const std::uint32_t t : walls.lacking) allowed[t] = 1;
    return !walls.lacking.empty();
  }

  /// Lets growth join two sections that what the cut has kept does not connect: by the best way through R1.
  void add_way(const JoinWish& wish, const std::vector<std::uint8_t>& r1,
               std::vector<std::uint8_t>& allowed) {
    const std::vector<std::uint8_t> at_a = ground_at(wish.a), at_b = ground_at(wish.b);
    const std::vector<std::uint32_t> body = find_bodies(complex_, ground_, allowed).of_ground;
    std::vector<std::uint8_t> is_of_a(body.size(), 0), above_b(r1.size(), 0);
    for (std::uint32_t g = 0; g < body.size(); ++g)
      if (at_a[g] != 0) is_of_a[body[g]] = 1;
    std::vector<std::uint32_t> starts;
    for (std::uint32_t g = 0; g < body.size(); ++g) {
      if (at_b[g] != 0 && is_of_a[body[g]] != 0) return;
      if (at_a[g] != 0) starts.push_back(ground_.facet(g).tet);
      if (at_b[g] != 0) above_b[ground_.facet(g).tet] = 1;
    }
    Ways ways(r1.size());
    const auto measure = [&](std::uint32_t t) { return allowed[t] != 0 ? kCertain : confidence_of(t); };
    for (const std::uint32_t t : best_way(
             complex_.mesh, Prefers::sure, measure, starts, [&](std::uint32_t t) { return r1[t] != 0; },
             [&](std::uint32_t t) { return above_b[t] != 0; }, ways))
      allowed[t] = 1;
  }

  /// The ground triangles of all parts with one of the vertices, which ascend.
  std::vector<std::uint8_t> ground_at(std::span<const std::uint32_t> vertices) const {
    std::vector<std::uint8_t> is_at(ground_.size(), 0);  // by part, then by triangle
    for (std::uint32_t g = 0; g < ground_.size(); ++g)
      for (const std::uint8_t slot : kFacetSlots[ground_.facet(g).facet])
        if (std::binary_search(vertices.begin(), vertices.end(),
                               complex_.mesh.vertices[ground_.facet(g).tet][slot]))
          is_at[ground_.part(g)] = 1;
    for (std::uint32_t g = 0; g < ground_.size(); ++g) is_at[g] = is_at[ground_.part(g)];
    return is_at;
  }

  /// What the cut has left stays unless growth closes something off.
  void build_walls(const std::vector<std::uint8_t>& allowed, NaturalResult& result) {
    NaturalResult grown = result;
    grown.kept = allowed;
    grow(grown, limits_);
    if (grown.report.after.outsides > result.report.after.outsides) result = std::move(grown);
  }

  /// What is left of the sections as bodies: islands, which stand on none, are others.
  static std::uint32_t bodies_with_ground(const CellBodies& bodies) {
    std::uint32_t count = 0;
    for (std::uint32_t g = 0; g < bodies.of_ground.size(); ++g) count += bodies.of_ground[g] == g ? 1U : 0U;
    return count;
  }

  /// Not where the user has decided: of single sections, or by a limit that leaves no doubt.
  bool may_doubt() const {
    return options_.look_around != InCells::off && shape_.field != nullptr && requests_.wishes.empty() &&
           is_in_doubt(limits_.join) && ground_.part_count() > 1;
  }

  /// Whether the bodies of a subset of R1 are all that R1 has, and surely joined: the best ways through R1
  /// are no worse than those through the subset.
  bool is_surely_joined(const CellBodies& bodies, const std::vector<std::uint32_t>& body_in_r1,
                        std::span<const Join> joins) const {
    return body_in_r1 == bodies.of_ground && are_sure(complex_, ground_, joins);
  }

  /// Bodies of R1 by ground triangle. Those of a subset that are one are so in R1.
  std::vector<std::uint32_t> bodies_of(const std::vector<std::uint8_t>& r1, const CellBodies& subset) const {
    const bool is_one = std::all_of(subset.of_ground.begin(), subset.of_ground.end(),
                                    [](std::uint32_t body) { return body == 0; });
    return is_one ? subset.of_ground : find_bodies(complex_, ground_, r1).of_ground;
  }

  /// Joins in doubt by the sections around; growth starts again if that changes any.
  void decide_joins(const std::vector<std::uint8_t>& r1, std::span<const std::uint32_t> body_in_r1,
                    const std::vector<std::uint8_t>& cheapest, NaturalResult& result) {
    const auto plan = plan_joins(complex_, shape_, ground_, r1, body_in_r1, result.kept,
                                 [&](std::uint32_t t) { return confidence_of(t); });
    if (!plan) return;
    measure_all(r1);
    for (std::size_t t = 0; t < r1.size(); ++t) result.kept[t] = cheapest[t] | plan->likely[t];
    GrowthLimits limits = limits_;
    limits.wishes = plan->wishes;
    grow(result, limits);
  }

  void grow(NaturalResult& result, GrowthLimits limits) {
    for (const OpenRequest& request : requests_.opened) drop_unsure(request, result.kept);
    limits.handle = as_integer(kRingConfidence);
    limits.cancel = requests_.cancel;
    if (requests_.handles)
      limits.may_fill = [&](std::uint32_t t) { return confidence_of(t) >= as_integer(kTunnelConfidence); };
    GrowingSolid solid(complex_, ground_);
    GrowthResult grown = grow_simply(complex_, ground_, result.kept, confidence_, limits, solid);
    result.report.after = refill_cracks(complex_, ground_, result.kept, solid);
    result.kept = solid.kept();
    if (!requests_.opened.empty() && count_open(result.kept) < count_open(grown.kept)) {
      result.kept = std::move(grown.kept);
      result.report.after = count_topology(complex_, ground_, result.kept);
    }
    result.report.grown = true;
    result.report.joins = std::move(grown.joins);
    result.report.domes = std::move(grown.domes);
    result.report.handles = grown.handles;
    result.report.opened = count_open(result.kept);
  }

  /// Before the refused ones, where it is no more among them.
  static void list_join(const Join& join, std::vector<Join>& joins) {
    std::erase_if(joins, [&](const Join& j) { return !j.done && j.a == join.a && j.b == join.b; });
    joins.insert(std::find_if(joins.begin(), joins.end(), [](const Join& j) { return !j.done; }), join);
  }

  /// Only what is still alone, and sure enough: an earlier request may have changed it.
  void join_alone(const std::vector<std::uint8_t>& r1, std::vector<std::uint8_t> allowed,
                  NaturalResult& result) {
    const SecondLook::Measure measure = [&](std::uint32_t t) { return confidence_of(t); };
    SecondLook look(complex_, ground_, r1, result.kept, measure);
    for (const TetName& body : requests_.joined) {
      if (is_raised(requests_.cancel)) return;
      const Way way = look.way_from(body);
      if (way.tets.empty() || way.join.confidence < as_integer(options_.alone_confidence)) continue;
      for (const std::uint32_t t : way.tets) result.kept[t] = 1;
      look.see(way);
      list_join(way.join, result.report.joins);
      ++result.report.joined_alone;
    }
    // Where growth made a handle or left something open, what fills it might be filled in.
    if (result.report.joined_alone > 0 && requests_.opened.empty() && result.report.handles == 0) {
      grow_on(r1, allowed, result);
    } else {
      result.report.after = count_topology(complex_, ground_, result.kept);
      result.report.opened = count_open(result.kept);
    }
  }

  /// The ways are a tetrahedron wide: what the cut has kept around them can come by now. It joins nothing
  /// more: other joins were decided before.
  void grow_on(const std::vector<std::uint8_t>& r1, std::vector<std::uint8_t>& allowed,
               NaturalResult& result) {
    measure_all(r1);
    GrowingSolid solid(complex_, ground_);
    for (std::uint32_t t = 0; t < allowed.size(); ++t)
      if (result.kept[t] != 0) allowed[t] = 1, solid.add(t);
    const GrowthLimits limits{kCertain + 1, limits_.dome, {}, {}, 0, {}, requests_.cancel};
    const GrowthResult grown = grow_simply(complex_, ground_, allowed, confidence_, limits, solid);
    result.report.domes.insert(result.report.domes.end(), grown.domes.begin(), grown.domes.end());
    result.report.after = refill_cracks(complex_, ground_, allowed, solid);
    result.kept = solid.kept();
  }

  std::vector<Spike> spikes(const std::vector<std::uint8_t>& kept) {
    return find_spikes(complex_, ground_, kept, as_integer(kSpikeConfidence),
                       [&](std::uint32_t t) { return confidence_of(t); });
  }

  std::int32_t confidence_of(std::uint32_t t) {
    if (is_measured_[t] == 0) confidence_[t] = meter_.measure(t), is_measured_[t] = 1;
    return confidence_[t];
  }

  void measure_all(const std::vector<std::uint8_t>& r1) {
    for (std::uint32_t t = 0; t < r1.size() && !is_raised(requests_.cancel); ++t)
      if (r1[t] != 0) confidence_of(t);
  }

  /// Nothing that growth could decide otherwise.
  bool is_good(const NaturalReport& report, const std::vector<std::uint8_t>& kept) const {
    const CellTopology& t = report.before;
    if (t.genus != 0 || t.voids != 0 || !limits_.wishes.empty() || !limits_.open.empty()) return false;
    if (!report.joins.empty() && report.joins.back().confidence < limits_.join) return false;
    return t.outsides <= 1 || !has_dome(complex_, kept);
  }

  const CellComplex& complex_;
  const CellShape& shape_;
  const NaturalOptions& options_;
  const CellRequests& requests_;
  const GrowthLimits limits_;
  const Ground& ground_;
  ConfidenceMeter meter_;
  std::vector<std::int32_t> confidence_;
  std::vector<std::uint8_t> is_measured_;
};

}  // namespace

NaturalResult prune_naturally(const CellComplex& complex, const Ground& ground, const CellShape& shape,
                              const std::vector<std::uint8_t>& r1, const NaturalOptions& options,
                              const CellRequests& requests) {
  return NaturalPruning(complex, ground, shape, options, requests).run(r1);
}

}  // namespace crossloft
