#include "simple_growth.h"

#include <algorithm>
#include <array>
#include <queue>

#include "contact.h"
#include "open_loops.h"
#include "outside.h"
#include "star.h"

namespace crossloft {
namespace {

class SimpleGrowth {
 public:
  SimpleGrowth(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& allowed,
               std::span<const std::int32_t> confidence, const GrowthLimits& limits, GrowingSolid& solid)
      : complex_(complex),
        ground_(ground),
        confidence_(confidence),
        limits_(limits),
        solid_(solid),
        rank_(complex.mesh.size(), kNone),
        listed_(complex.mesh.size(), 0),
        changed_at_(complex.vertex_count, 0),
        refusal_(complex.mesh.size()),
        vertex_of_body_(part_names(complex, ground)) {
    set_ranks(allowed);
    for (std::uint32_t g = 0; g < ground.size(); ++g) {
      std::uint32_t& name = vertex_of_body_[solid.body_of_ground(g)];
      name = std::min(name, vertex_of_body_[ground.part(g)]);
    }
    find_wished();
    for (const OpenRequest& request : limits.open)
      open_.push_back({tet_of_name(complex.mesh, request.from), tet_of_name(complex.mesh, request.to), {}});
    std::erase_if(open_, [](const StaysOpen& open) { return open.from == kNone || open.to == kNone; });
  }

  GrowthResult run() {
    for (std::uint32_t g = 0; g < ground_.size(); ++g) list(ground_.facet(g).tet);
    for (std::uint32_t t = 0; t < rank_.size(); ++t)
      if (solid_.has(t)) list_around(t);
    grow();
    for (bool domes = false;;) {
      if (retry(domes)) {
        domes = false;
      } else if (!domes && result_.handles == 0) {  // what looks like a dome may fill a handle
        domes = true;
      } else if (add_handle()) {
        domes = false;
      } else {
        break;
      }
    }
    add_refused();
    result_.kept = solid_.kept();
    return std::move(result_);
  }

 private:
  /// The most confident first within each layer.
  void set_ranks(const std::vector<std::uint8_t>& allowed) {
    std::array<std::vector<std::uint32_t>, 3> layers;
    for (const std::uint32_t t : by_confidence(complex_, allowed, confidence_)) layers[layer(t)].push_back(t);
    for (const auto& list : layers) order_.insert(order_.end(), list.begin(), list.end());
    for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
  }

  /// Those on the ground come first, then those at its inner edges: cells on both sides must close the fans
  /// there, or the solid falls apart along the edge.
  std::size_t layer(std::uint32_t t) const {
    return stands_on_section(complex_, t) ? 0U : has_inner_edge(complex_, t) ? 1U : 2U;
  }

  /// Ground triangles at the vertices of the wishes: where these are, whatever the solid becomes.
  void find_wished() {
    wished_.resize(limits_.wishes.size());
    for (std::uint32_t g = 0; !wished_.empty() && g < ground_.size(); ++g)
      for (const std::uint8_t slot : kFacetSlots[ground_.facet(g).facet]) {
        const std::uint32_t v = complex_.mesh.vertices[ground_.facet(g).tet][slot];
        for (std::size_t w = 0; w < wished_.size(); ++w) {
          const JoinWish& wish = limits_.wishes[w];
          if (std::binary_search(wish.a.begin(), wish.a.end(), v)) wished_[w][0].push_back(g);
          if (std::binary_search(wish.b.begin(), wish.b.end(), v)) wished_[w][1].push_back(g);
        }
      }
  }

  /// Puts an allowed tetrahedron that is not in the solid yet into the queue.
  void list(std::uint32_t t) {
    if (rank_[t] == kNone || listed_[t] != 0 || solid_.has(t)) return;
    listed_[t] = 1;
    queue_.push(rank_[t]);
  }

  void add(std::uint32_t t) {
    solid_.add(t);
    ++additions_;
    for (const std::uint32_t v : complex_.mesh.vertices[t]) changed_at_[v] = additions_;
    list_around(t);
  }

  void list_around(std::uint32_t t) {
    for (const std::uint32_t n : complex_.mesh.neighbours[t])
      if (n != kNone) list(n);
  }

  /// Adds by simple moves and joins until the queue is empty; puts off what it can't add.
  void grow() {
    while (!queue_.empty() && !is_raised(limits_.cancel)) {
      const std::uint32_t t = order_[queue_.top()];
      queue_.pop();
      listed_[t] = 0;
      if (!try_add(t, false)) put_off_.push_back(rank_[t]);
    }
  }

  bool try_add(std::uint32_t t, bool domes) {
    if (is_as_refused(t, domes)) return false;
    const Contact contact = solid_.contact(t);
    const bool is_easy = contact.is_simple() || contact.is_plug();
    if (!is_easy && contact.is_dome() && (!domes || !may_close(t, contact))) return refuse(t, Refused::dome);
    if (!is_easy && !contact.is_dome() && !contact.is_join()) return refuse(t, Refused::always);
    if (!open_.empty() && parts_what_stays_open(t)) return false;
    if (!is_easy && contact.is_dome()) result_.domes.push_back(confidence_[t]);
    if (!is_easy && !contact.is_dome() && !join(t, contact))
      return wished_.empty() ? refuse(t, Refused::always) : false;
    add(t);
    return true;
  }

  /// Why a tetrahedron was refused, if its contact alone says so. What the contact is made of is at its
  /// vertices, but for the bodies: as these only come together, a loop stays one, and so does a join that is
  /// not sure, or it becomes a loop.
  enum class Refused : std::uint8_t { no, dome, always };
  struct Refusal {
    std::uint32_t additions = 0;  ///< before it
    Refused why = Refused::no;
  };

  bool refuse(std::uint32_t t, Refused why) {
    refusal_[t] = {additions_, why};
    return false;
  }

  /// Whether nothing has been added at its vertices since.
  bool is_as_refused(std::uint32_t t, bool domes) const {
    const Refusal& refusal = refusal_[t];
    if (refusal.why == Refused::no || (refusal.why == Refused::dome && domes)) return false;
    for (const std::uint32_t v : complex_.mesh.vertices[t])
      if (changed_at_[v] > refusal.additions) return false;
    return true;
  }

  /// Tries those put off again, the most confident first. False if none could be added.
  bool retry(bool domes) {
    std::vector<std::uint32_t> again;
    std::swap(again, put_off_);
    std::sort(again.begin(), again.end());
    again.erase(std::unique(again.begin(), again.end()), again.end());
    bool changed = false;
    for (const std::uint32_t rank : again) {
      const std::uint32_t t = order_[rank];
      if (solid_.has(t) || is_raised(limits_.cancel)) continue;
      if (try_add(t, domes)) {
        changed = true;
        grow();
      } else {
        put_off_.push_back(rank);
      }
    }
    return changed;
  }

  /// Tetrahedra sure enough to close a handle, the most confident first.
  std::vector<std::uint32_t> handles_in_question() {
    std::vector<std::uint32_t> list;
    std::sort(put_off_.begin(), put_off_.end());
    for (const std::uint32_t rank : put_off_) {
      const std::uint32_t t = order_[rank];
      if (confidence_[t] >= limits_.handle && !solid_.has(t) && solid_.contact(t).is_handle())
        list.push_back(t);
    }
    std::stable_sort(list.begin(), list.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return confidence_[a] > confidence_[b]; });
    return list;
  }

  /// Closes the surest loop that nothing fills and goes on from there; false if there is none.
  bool add_handle() {
    if (!limits_.may_fill) return false;
    const std::vector<std::uint32_t> list = handles_in_question();
    if (list.empty()) return false;
    std::vector<std::uint8_t> wider = solid_.kept();
    for (std::uint32_t t = 0; t < wider.size(); ++t)
      if (wider[t] == 0 && limits_.may_fill(t)) wider[t] = 1;
    const OpenLoops loops(complex_, ground_, solid_, wider);
    for (const std::uint32_t t : list) {
      if (!loops.is_closed_by(t, solid_.contact(t)) || (!open_.empty() && parts_what_stays_open(t))) continue;
      add(t);
      grow();
      ++result_.handles;
      return true;
    }
    return false;
  }

  /// The different bodies in a contact by their names, one for each of its parts. REQUIRES: it is a
  /// join. (By numbers they would come in an order that depends on the tetrahedra's.)
  std::vector<std::uint32_t> bodies_to_join(const Contact& contact) const {
    std::vector<std::uint32_t> bodies;
    for (unsigned i = 0; i < 4; ++i)
      if ((contact.facets >> i & 1U) != 0) bodies.push_back(contact.bodies[i]);
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    std::stable_sort(bodies.begin(), bodies.end(), [&](std::uint32_t a, std::uint32_t b) {
      return vertex_of_body_[a] < vertex_of_body_[b];
    });
    return bodies;
  }

  /// True if the tetrahedron may join the bodies of its contact, a join; they are then one.
  bool join(std::uint32_t t, const Contact& contact) {
    const std::vector<std::uint32_t> bodies = bodies_to_join(contact);
    bool wanted = false;
    for (std::size_t w = 0; w < wished_.size(); ++w) {
      if (!concerns(w, bodies)) continue;
      if (!limits_.wishes[w].join) return false;
      wanted = true;
    }
    if (!wanted && confidence_[t] < limits_.join) return false;
    const std::uint32_t name = vertex_of_body_[bodies[0]];
    for (std::size_t i = 1; i < bodies.size(); ++i)
      result_.joins.push_back({name, vertex_of_body_[bodies[i]], confidence_[t], true});
    vertex_of_body_[*std::min_element(bodies.begin(), bodies.end())] = name;
    return true;
  }

  /// Whether joining the bodies brings together the two sides of wish w from different bodies.
  bool concerns(std::size_t w, const std::vector<std::uint32_t>& bodies) {
    std::array<std::vector<std::uint32_t>, 2> sides;
    for (std::size_t side = 0; side < 2; ++side)
      for (const std::uint32_t body : bodies) {
        const auto& ground = wished_[w][side];
        if (std::any_of(ground.begin(), ground.end(),
                        [&](std::uint32_t g) { return solid_.body_of_ground(g) == body; }))
          sides[side].push_back(body);
      }
    return !sides[0].empty() && !sides[1].empty() && (sides[0] != sides[1] || sides[0].size() > 1);
  }

  /// A dome must not leave a hole within the cell, and over a hole in one section it must be confident
  /// enough. Walls between wider parts of the outside always are: the sections around them say so.
  bool may_close(std::uint32_t t, const Contact& contact) {
    const bool sure = confidence_[t] >= limits_.dome || stands_on_section(complex_, t);
    for (const std::uint32_t start : solid_.outside_around(t, contact)) {
      const Opening opening = opening_from(start, t);
      if (opening == Opening::none || (opening == Opening::hole && !sure)) return false;
    }
    return true;
  }

  /// Two tetrahedra that are to stay connected outside, and a way between them that still is there.
  struct StaysOpen {
    std::uint32_t from, to;
    std::vector<std::uint8_t> on_way;
  };

  /// The way again, but not through t, across facets and edges; false if there is none.
  bool find_way(StaysOpen& open, std::uint32_t t) const {
    std::vector<std::uint32_t> before(rank_.size(), kNone), list{open.from};
    before[open.from] = open.from;
    for (std::size_t head = 0; head < list.size() && before[open.to] == kNone; ++head)
      for (unsigned corner = 4; corner < kCorners; ++corner)
        visit_around_edge(complex_.mesh, list[head], corner, [&](std::uint32_t n, unsigned) {
          if (n == t || before[n] != kNone || solid_.has(n)) return;
          before[n] = list[head];
          list.push_back(n);
        });
    if (before[open.to] == kNone) return false;
    open.on_way.assign(rank_.size(), 0);
    for (std::uint32_t at = open.to; open.on_way[at] == 0; at = before[at]) open.on_way[at] = 1;
    return true;
  }

  /// Whether without t some pair is not connected any more. Simple moves can part them too: what is left is
  /// of no width then, at the end of a section.
  bool parts_what_stays_open(std::uint32_t t) {
    return std::any_of(open_.begin(), open_.end(), [&](StaysOpen& open) {
      return (open.on_way.empty() || open.on_way[t] != 0) && !find_way(open, t);
    });
  }

  /// Breadth first through the outside, not through the dome; across edges too, where gluing leaves it
  /// connected. A part of allowed tetrahedra alone can still be filled: it counts as wide.
  Opening opening_from(std::uint32_t start, std::uint32_t dome) {
    std::vector<std::uint32_t> seen{start};
    visited_.resize(complex_.mesh.size());
    visited_[start] = visited_[dome] = 1;
    OpeningOf opening(complex_);
    bool fillable = true;
    const auto see = [&](std::uint32_t t, unsigned = 0) {
      if (visited_[t] != 0 || solid_.has(t)) return;
      visited_[t] = 1;
      seen.push_back(t);
    };
    for (std::size_t head = 0; head < seen.size() && opening.kind() != Opening::wide; ++head) {
      const std::uint32_t t = seen[head];
      opening.add(t);
      fillable &= rank_[t] != kNone;
      for (unsigned corner = 4; corner < kCorners; ++corner) visit_around_edge(complex_.mesh, t, corner, see);
    }
    for (const std::uint32_t t : seen) visited_[t] = 0;
    visited_[dome] = 0;
    return fillable ? Opening::wide : opening.kind();
  }

  /// The best join of each pair of bodies that was not confident enough.
  void add_refused() {
    std::vector<Join> refused;
    for (const std::uint32_t rank : put_off_) {
      const std::uint32_t t = order_[rank];
      const Contact contact = solid_.contact(t);
      if (!contact.is_join()) continue;
      const std::vector<std::uint32_t> bodies = bodies_to_join(contact);
      for (std::size_t i = 1; i < bodies.size(); ++i)
        refused.push_back({vertex_of_body_[bodies[0]], vertex_of_body_[bodies[i]], -confidence_[t], false});
    }
    std::sort(refused.begin(), refused.end());
    const auto same_pair = [](const Join& x, const Join& y) { return x.a == y.a && x.b == y.b; };
    refused.erase(std::unique(refused.begin(), refused.end(), same_pair), refused.end());
    for (Join& j : refused) j.confidence = -j.confidence;
    result_.joins.insert(result_.joins.end(), refused.begin(), refused.end());
  }

  const CellComplex& complex_;
  const Ground& ground_;
  std::span<const std::int32_t> confidence_;
  const GrowthLimits& limits_;
  GrowingSolid& solid_;
  std::vector<std::uint32_t> order_;  ///< allowed tetrahedra, the most confident first
  std::vector<std::uint32_t> rank_;   ///< place in order_, kNone if not allowed
  std::vector<std::uint8_t> listed_, visited_;
  std::uint32_t additions_ = 0;
  std::vector<std::uint32_t> changed_at_;                          ///< by vertex: the last addition there
  std::vector<Refusal> refusal_;                                   ///< by tetrahedron: the last one
  std::vector<std::uint32_t> vertex_of_body_;                      ///< by body: its smallest section vertex
  std::vector<std::array<std::vector<std::uint32_t>, 2>> wished_;  ///< by wish and side: ground triangles
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> queue_;
  std::vector<std::uint32_t> put_off_;              ///< ranks
  std::vector<StaysOpen> open_;
  GrowthResult result_;
};

}  // namespace

GrowthResult grow_simply(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& allowed, std::span<const std::int32_t> confidence,
                         const GrowthLimits& limits, GrowingSolid& solid) {
  return SimpleGrowth(complex, ground, allowed, confidence, limits, solid).run();
}

GrowthResult grow_simply(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& allowed, std::span<const std::int32_t> confidence,
                         const GrowthLimits& limits) {
  GrowingSolid solid(complex, ground);
  return grow_simply(complex, ground, allowed, confidence, limits, solid);
}

}  // namespace crossloft
