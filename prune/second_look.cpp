#include "second_look.h"

#include <algorithm>
#include <utility>

#include "best_way.h"
#include "bodies.h"
#include "confidence.h"
#include "contact.h"
#include "prune.h"
#include "star.h"

namespace crossloft {
namespace {

bool is_join_of_two(const Contact& contact) {
  std::vector<std::uint32_t> bodies;
  for (unsigned i = 0; i < 4; ++i)
    if ((contact.facets >> i & 1U) != 0) bodies.push_back(contact.bodies[i]);
  std::sort(bodies.begin(), bodies.end());
  return contact.parts == 2 && contact.loops == 0 &&
         std::unique(bodies.begin(), bodies.end()) - bodies.begin() == 2;
}

/// By simple moves, and a join at the end. The solid stays as it is.
bool can_add(GrowingSolid& solid, const std::vector<std::uint32_t>& way) {
  solid.begin_trial();
  const bool can = !way.empty() && std::all_of(way.begin(), way.end(), [&](std::uint32_t t) {
    const Contact contact = solid.contact(t);
    const bool fits = t == way.back() ? is_join_of_two(contact) : contact.is_simple();
    solid.add(t);
    return fits;
  });
  solid.end_trial(false);
  return can;
}

/// Where the outside is at a facet of the solid: a tetrahedron, or kNone beyond the hull.
struct OutsideAt {
  Triangle facet{};
  std::uint32_t tet = kNone;
  friend auto operator<=>(const OutsideAt&, const OutsideAt&) = default;
};

/// Of all facets of the solid and of the ground, ascending.
std::vector<OutsideAt> outside_of_facets(const CellComplex& complex, const Ground& ground,
                                         const std::vector<std::uint8_t>& kept) {
  std::vector<OutsideAt> list;
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = complex.mesh.neighbours[t][i];
      const bool solid_beyond = n == kNone ? ground.is_ground(t, i) : kept[n] != 0;
      if (kept[t] == 0 && solid_beyond) list.push_back({facet_vertices(complex.mesh, t, i), t});
      if (kept[t] != 0 && n == kNone && !ground.is_ground(t, i))
        list.push_back({facet_vertices(complex.mesh, t, i), kNone});
    }
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

/// What all bodies are asked with; as there may be many of them it is made once.
struct SecondLook::Bodily {
  explicit Bodily(const SecondLook& look)
      : bodies(look.complex_, look.ground_, look.kept_),
        solid(look.complex_, look.ground_),
        ways(look.kept_.size()) {
    for (std::uint32_t t = 0; t < look.kept_.size(); ++t) {
      if (look.kept_[t] == 0) continue;
      solid.add(t);
      names.push_back({sorted_vertices(look.complex_.mesh, t), t});
    }
    std::sort(names.begin(), names.end());
    find_starts(look);
  }

  void find_starts(const SecondLook& look) {
    starts.clear();
    for (std::uint32_t t = 0; t < look.kept_.size(); ++t)
      for (unsigned i = 0; i < 4 && look.is_free(t); ++i)
        if (const std::uint32_t body = bodies.at(t, i); body != kNone) starts.push_back({body, t});
    std::sort(starts.begin(), starts.end());
    starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  }

  std::vector<std::uint32_t> starts_of(std::uint32_t body) const {
    std::vector<std::uint32_t> list;
    for (auto at = std::lower_bound(starts.begin(), starts.end(), std::pair(body, 0U));
         at != starts.end() && at->first == body; ++at)
      list.push_back(at->second);
    return list;
  }

  /// kNone if it is not kept.
  std::uint32_t tet_of(const TetName& name) const {
    const auto at = std::lower_bound(names.begin(), names.end(), std::pair(name, 0U));
    return at != names.end() && at->first == name ? at->second : kNone;
  }

  Bodies bodies;
  GrowingSolid solid;
  Ways ways;
  std::vector<std::pair<TetName, std::uint32_t>> names;         ///< kept ones at first, ascending
  std::vector<std::pair<std::uint32_t, std::uint32_t>> starts;  ///< bodies, and what is free at them
};

SecondLook::SecondLook(const CellComplex& complex, const Ground& ground,
                       const std::vector<std::uint8_t>& candidates, const std::vector<std::uint8_t>& kept,
                       Measure measure)
    : complex_(complex),
      ground_(ground),
      candidates_(candidates),
      kept_(kept),
      measure_(std::move(measure)) {}
SecondLook::~SecondLook() = default;

SecondLook::Bodily& SecondLook::bodily() {
  if (!bodily_) bodily_ = std::make_unique<Bodily>(*this);
  return *bodily_;
}

Way SecondLook::way_from(const TetName& body) {
  const std::uint32_t start = bodily().tet_of(body);
  return start == kNone ? Way{} : way_from(start);
}

/// Bodies that are still on one part and not on the way keep what is free at them; one that has come together
/// with an island has more.
void SecondLook::see(const Way& way) {
  Bodily& b = bodily();
  for (const std::uint32_t t : way.tets) b.bodies.see(t), b.solid.add(t);
  if (b.bodies.stands_on_one_part(b.bodies.of_tet(way.tets[0]))) b.find_starts(*this);
}

Way SecondLook::way_from(std::uint32_t start) {
  Bodily& b = bodily();
  Bodies& bodies = b.bodies;
  const std::uint32_t own = bodies.of_tet(start);
  if (!bodies.stands_on_one_part(own)) return {};
  Way way;
  way.tets = best_way(
      complex_.mesh, Prefers::sure, measure_, b.starts_of(own), [&](std::uint32_t t) { return is_free(t); },
      [&](std::uint32_t t) { return bodies.other_at(t, own) != kNone; }, b.ways);
  if (!can_add(b.solid, way.tets)) return {};
  const std::uint32_t other = bodies.other_at(way.tets.back(), own);
  for (const std::uint32_t n : complex_.mesh.neighbours[way.tets.back()])
    if (n != kNone && kept_[n] != 0 && bodies.of_tet(n) == other)
      way.target = std::min(way.target, sorted_vertices(complex_.mesh, n));
  const std::uint32_t name = bodies.name_of(own), other_name = bodies.name_of(other);
  way.join = {std::min(name, other_name), std::max(name, other_name), measure_(way.tets[0]), true};
  for (const std::uint32_t t : way.tets) way.join.confidence = std::min(way.join.confidence, measure_(t));
  return way;
}

BodyAnswer SecondLook::answer_body(const std::vector<TetName>& names) {
  Bodily& b = bodily();
  BodyAnswer answer;
  std::uint32_t own = kNone, start = kNone;
  for (const TetName& name : names) {
    const std::uint32_t t = b.tet_of(name);
    if (t == kNone || (own != kNone && b.bodies.of_tet(t) != own)) return answer;
    own = b.bodies.of_tet(t);
    if (start == kNone) start = t;
  }
  answer.is_alone = own != kNone && b.bodies.stands_on_one_part(own);
  if (!answer.is_alone) return answer;
  const Way way = way_from(start);
  answer.can_join = !way.tets.empty();
  answer.confidence = way.join.confidence;
  answer.target = way.target;
  return answer;
}

/// The way out leads through the solid, where it is weakest.
CavityAnswer SecondLook::answer_part(const OutsidePart& part, std::uint32_t start) const {
  CavityAnswer answer;
  answer.opening = part.opening.kind();
  answer.face = part.opening.face();
  std::vector<std::uint8_t> within(kept_.size(), 0);
  for (const std::uint32_t t : part.tets) within[t] = 1;
  std::vector<std::uint32_t> starts;
  for (const std::uint32_t t : part.tets)
    for (const std::uint32_t n : complex_.mesh.neighbours[t])
      if (n != kNone && kept_[n] != 0) starts.push_back(n);
  const auto beyond = [&](std::uint32_t t) {
    TetName name{kNone, kNone, kNone, kNone};
    for (const std::uint32_t n : complex_.mesh.neighbours[t])
      if (n != kNone && kept_[n] == 0 && within[n] == 0)
        name = std::min(name, sorted_vertices(complex_.mesh, n));
    return name;
  };
  Ways ways(kept_.size());
  const auto way = best_way(
      complex_.mesh, Prefers::unsure, measure_, starts, [&](std::uint32_t t) { return kept_[t] != 0; },
      [&](std::uint32_t t) { return beyond(t)[0] != kNone; }, ways);
  if (way.empty()) return answer;
  answer.can_open = true;
  answer.confidence = measure_(way[0]);
  for (const std::uint32_t t : way) answer.confidence = std::max(answer.confidence, measure_(t));
  answer.from = sorted_vertices(complex_.mesh, start);
  answer.to = beyond(way.back());
  return answer;
}

Answers SecondLook::answer(const SecondThoughts& questions, CancelFlag cancel) {
  Answers answers;
  for (const auto& names : questions.bodies)
    answers.bodies.push_back(is_raised(cancel) ? BodyAnswer{} : answer_body(names));
  const std::vector<OutsideAt> seen =
      questions.cavities.empty() ? std::vector<OutsideAt>{} : outside_of_facets(complex_, ground_, kept_);
  for (const auto& facets : questions.cavities) {
    std::vector<CavityAnswer>& parts = answers.cavities.emplace_back();
    std::vector<std::uint8_t> known(kept_.size(), 0);
    bool beyond_hull = false;
    for (const Triangle& facet : facets) {
      if (is_raised(cancel)) break;
      const auto at = std::lower_bound(seen.begin(), seen.end(), OutsideAt{facet, 0});
      if (at == seen.end() || at->facet != facet) continue;
      beyond_hull |= at->tet == kNone;
      if (at->tet == kNone || known[at->tet] != 0) continue;
      const OutsidePart part = outside_part(complex_, kept_, at->tet);
      for (const std::uint32_t t : part.tets) known[t] = 1;
      parts.push_back(answer_part(part, at->tet));
    }
    if (beyond_hull) parts.push_back({Opening::wide, kNone, false, 0, {}, {}});
  }
  return answers;
}

Answers answer_questions(const CellComplex& complex, const Ground& ground, const CellShape& shape,
                         const std::vector<std::uint8_t>& kept, const SecondThoughts& questions,
                         CancelFlag cancel) {
  const std::vector<std::uint8_t> r1 = without_external(complex);
  ConfidenceMeter meter(complex, ground, shape);
  return SecondLook(complex, ground, r1, kept, [&](std::uint32_t t) { return meter.measure(t); })
      .answer(questions, cancel);
}

}  // namespace crossloft
