#include "alone.h"

#include <algorithm>
#include <queue>

#include "contact.h"
#include "disjoint_sets.h"
#include "outside.h"

namespace crossloft {
namespace {

constexpr std::uint32_t kSeveral = kNone - 1;

/// Tetrahedra from one of `starts` to one with goal(t), through those with a rank, so that the largest rank on
/// the way is as small as can be; from the start on, empty if there is none.
template <class Goal>
std::vector<std::uint32_t> best_way(const TetMesh& mesh, const std::vector<std::uint32_t>& rank,
                                    const std::vector<std::uint32_t>& order,
                                    const std::vector<std::uint32_t>& starts, Goal goal) {
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> queue;
  std::vector<std::uint32_t> before(mesh.size(), kNone);
  const auto see = [&](std::uint32_t t, std::uint32_t from) {
    if (rank[t] == kNone || before[t] != kNone) return;
    before[t] = from;
    queue.push(rank[t]);
  };
  for (const std::uint32_t t : starts) see(t, t);
  while (!queue.empty()) {
    std::uint32_t t = order[queue.top()];
    queue.pop();
    if (goal(t)) {
      std::vector<std::uint32_t> way{t};
      for (; before[t] != t; t = before[t]) way.push_back(before[t]);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const std::uint32_t n : mesh.neighbours[t])
      if (n != kNone) see(n, t);
  }
  return {};
}

std::vector<std::uint32_t> ranks_of(std::size_t size, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> rank(size, kNone);
  for (std::uint32_t r = 0; r < order.size(); ++r) rank[order[r]] = r;
  return rank;
}

/// Bodies as sets of ground triangles, then tetrahedra.
class AloneBodies {
 public:
  AloneBodies(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& candidates,
              const std::vector<std::uint8_t>& kept, std::span<const std::int32_t> confidence)
      : complex_(complex),
        ground_(ground),
        candidates_(candidates),
        kept_(kept),
        confidence_(confidence),
        sets_(std::size_t{ground.size()} + complex.mesh.size()),
        part_(ground.size(), kNone),
        face_(ground.size(), kNone),
        name_(ground.size(), Triangle{kNone, kNone, kNone}) {
    join_sets();
    describe();
  }

  std::vector<AlonePart> run() {
    std::vector<AlonePart> alone;
    const bool has_others = std::count_if(part_.begin(), part_.end(), [](auto p) { return p != kNone; }) > 1;
    for (std::uint32_t b = 0; b < ground_.size(); ++b) {
      if (!is_alone(b)) continue;
      const std::vector<std::uint32_t> way = has_others ? way_from(b) : std::vector<std::uint32_t>{};
      alone.push_back({name_[b], face_[b], can_add(way), weakest(way)});
    }
    std::sort(alone.begin(), alone.end(), [](const auto& x, const auto& y) { return x.name < y.name; });
    return alone;
  }

  /// The way that joins the body of that name, if it can be added.
  std::vector<std::uint32_t> way_of(const Triangle& name) {
    for (std::uint32_t b = 0; b < ground_.size(); ++b) {
      if (!is_alone(b) || name_[b] != name) continue;
      std::vector<std::uint32_t> way = way_from(b);
      return can_add(way) ? way : std::vector<std::uint32_t>{};
    }
    return {};
  }

  /// Names of the bodies at the end of a way.
  Join join_by(const std::vector<std::uint32_t>& way) {
    const std::vector<std::uint32_t> names = part_names(complex_, ground_);
    std::array<std::uint32_t, 2> ends{kNone, kNone};
    const std::uint32_t from = start_of(way.front());
    for (std::uint32_t g = 0; g < ground_.size(); ++g) {
      const std::uint32_t body = sets_.find(g), name = names[ground_.part(g)];
      if (body == from) ends[0] = std::min(ends[0], name);
      if (body == goal_of(way.back(), from)) ends[1] = std::min(ends[1], name);
    }
    return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), weakest(way), true};
  }

 private:
  void join_sets() {
    for (std::uint32_t g = 0; g < ground_.size(); ++g) {
      sets_.join(ground_.part(g), g);
      if (const std::uint32_t t = ground_.facet(g).tet; kept_[t] != 0) sets_.join(g, ground_.size() + t);
    }
    for (std::uint32_t t = 0; t < kept_.size(); ++t)
      for (const std::uint32_t n : complex_.mesh.neighbours[t])
        if (kept_[t] != 0 && n != kNone && n < t && kept_[n] != 0)
          sets_.join(ground_.size() + n, ground_.size() + t);
  }

  /// The one part and face of each body, or that it has several.
  void describe() {
    for (std::uint32_t g = 0; g < ground_.size(); ++g) {
      const std::uint32_t b = sets_.find(g);
      const Triangle triangle = facet_vertices(complex_.mesh, ground_.facet(g).tet, ground_.facet(g).facet);
      const auto put = [](std::uint32_t& place, std::uint32_t x) { place = place == kNone || place == x ? x : kSeveral; };
      put(part_[b], ground_.part(g));
      put(face_[b], complex_.common_face(triangle[0], triangle[1], triangle[2]));
      name_[b] = std::min(name_[b], triangle);
    }
  }

  bool is_alone(std::uint32_t b) const { return part_[b] < kSeveral && face_[b] < kSeveral; }

  /// The body at a facet of t, kNone if there is none.
  std::uint32_t body_at(std::uint32_t t, unsigned i) {
    if (ground_.is_ground(t, i)) return sets_.find(ground_.at(t, i));
    const std::uint32_t n = complex_.mesh.neighbours[t][i];
    return n != kNone && kept_[n] != 0 ? sets_.find(ground_.size() + n) : kNone;
  }

  bool touches(std::uint32_t t, std::uint32_t body) {
    for (unsigned i = 0; i < 4; ++i)
      if (body_at(t, i) == body) return true;
    return false;
  }

  /// A body at t other than `own`.
  std::uint32_t goal_of(std::uint32_t t, std::uint32_t own) {
    for (unsigned i = 0; i < 4; ++i)
      if (const std::uint32_t b = body_at(t, i); b != kNone && b != own) return b;
    return kNone;
  }

  /// The alone body that a way starts at.
  std::uint32_t start_of(std::uint32_t t) {
    for (unsigned i = 0; i < 4; ++i)
      if (const std::uint32_t b = body_at(t, i); b != kNone && b < ground_.size() && is_alone(b)) return b;
    return kNone;
  }

  std::vector<std::uint32_t> way_from(std::uint32_t body) {
    std::vector<std::uint8_t> free(kept_.size());
    for (std::size_t t = 0; t < free.size(); ++t) free[t] = candidates_[t] != 0 && kept_[t] == 0;
    const std::vector<std::uint32_t> order = by_confidence(complex_, free, confidence_);
    std::vector<std::uint32_t> starts;
    for (const std::uint32_t t : order)
      if (touches(t, body)) starts.push_back(t);
    return best_way(complex_.mesh, ranks_of(free.size(), order), order, starts,
                    [&](std::uint32_t t) { return goal_of(t, body) != kNone; });
  }

  /// By simple moves and one join at the end.
  bool can_add(const std::vector<std::uint32_t>& way) {
    if (way.empty()) return false;
    GrowingSolid solid(complex_, ground_);
    for (std::uint32_t t = 0; t < kept_.size(); ++t)
      if (kept_[t] != 0) solid.add(t);
    for (const std::uint32_t t : way) {
      const Contact contact = solid.contact(t);
      const bool is_join = contact.parts == 2 && contact.loops == 0 && bodies_at(contact) == 2;
      if (t == way.back() ? !is_join : !contact.is_simple()) return false;
      solid.add(t);
    }
    return true;
  }

  static int bodies_at(const Contact& contact) {
    std::vector<std::uint32_t> bodies;
    for (unsigned i = 0; i < 4; ++i)
      if ((contact.facets >> i & 1U) != 0) bodies.push_back(contact.bodies[i]);
    std::sort(bodies.begin(), bodies.end());
    return static_cast<int>(std::unique(bodies.begin(), bodies.end()) - bodies.begin());
  }

  std::int32_t weakest(const std::vector<std::uint32_t>& way) const {
    std::int32_t weakest = way.empty() ? 0 : confidence_[way[0]];
    for (const std::uint32_t t : way) weakest = std::min(weakest, confidence_[t]);
    return weakest;
  }

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& candidates_;
  const std::vector<std::uint8_t>& kept_;
  std::span<const std::int32_t> confidence_;
  DisjointSets sets_;
  std::vector<std::uint32_t> part_, face_;  ///< by body
  std::vector<Triangle> name_;
};

/// How sure the closing of a dome is: the strongest tetrahedron on the weakest way out.
AlonePart bubble_of(const CellComplex& complex, const Ground& ground, const ClosedHole& hole,
                    const std::vector<std::uint8_t>& kept, std::span<const std::int32_t> confidence) {
  std::vector<std::uint8_t> within(kept.size(), 0);
  for (const std::uint32_t t : hole.tets) within[t] = 1;
  std::vector<std::uint32_t> order = by_confidence(complex, kept, confidence);
  std::reverse(order.begin(), order.end());
  std::vector<std::uint32_t> starts;
  for (const std::uint32_t t : hole.tets)
    for (const std::uint32_t n : complex.mesh.neighbours[t])
      if (n != kNone && kept[n] != 0) starts.push_back(n);
  const auto leads_out = [&](std::uint32_t t) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = complex.mesh.neighbours[t][i];
      if (n == kNone ? !ground.is_ground(t, i) : kept[n] == 0 && within[n] == 0) return true;
    }
    return false;
  };
  const auto way = best_way(complex.mesh, ranks_of(kept.size(), order), order, starts, leads_out);
  AlonePart bubble{hole.name, hole.face, !way.empty(), 0};
  for (std::size_t i = 0; i < way.size(); ++i)
    bubble.confidence = i == 0 ? confidence[way[i]] : std::max(bubble.confidence, confidence[way[i]]);
  return bubble;
}

}  // namespace

AloneParts find_alone(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& candidates,
                      const std::vector<std::uint8_t>& kept, std::span<const std::int32_t> confidence) {
  AloneParts alone;
  alone.bodies = AloneBodies(complex, ground, candidates, kept, confidence).run();
  for (const ClosedHole& hole : closed_holes(complex, kept))
    alone.bubbles.push_back(bubble_of(complex, ground, hole, kept, confidence));
  std::sort(alone.bubbles.begin(), alone.bubbles.end(),
            [](const auto& x, const auto& y) { return x.name < y.name; });
  return alone;
}

bool join_alone(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& candidates,
                std::span<const std::int32_t> confidence, const Triangle& name, std::vector<std::uint8_t>& kept,
                std::vector<Join>& joins) {
  AloneBodies bodies(complex, ground, candidates, kept, confidence);
  const std::vector<std::uint32_t> way = bodies.way_of(name);
  if (way.empty()) return false;
  joins.push_back(bodies.join_by(way));
  for (const std::uint32_t t : way) kept[t] = 1;
  return true;
}

}  // namespace crossloft
