#include "second_look.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "bodies.h"
#include "confidence.h"
#include "contact.h"
#include "prune.h"
#include "star.h"

namespace crossloft {
namespace {

/// What a way prefers to go through. By confidence, then by sorted vertices.
enum class Prefers : std::uint8_t { sure, unsure };

/// A tetrahedron that a way has come to; the greatest is preferred.
struct Step {
  std::int32_t confidence;
  TetName name;
  std::uint32_t tet;
};

/// From one of `starts` to a tetrahedron with goal(t), over those with usable(t), so that the worst one on
/// the way is as good as can be; from the start on, empty if there is no way. (Prim's algorithm: the first
/// goal it comes to.) Only what it comes to is measured.
template <class Usable, class Goal>
std::vector<std::uint32_t> best_way(const TetMesh& mesh, Prefers prefers, const SecondLook::Measure& measure,
                                    const std::vector<std::uint32_t>& starts, Usable usable, Goal goal) {
  const auto comes_later = [prefers](const Step& x, const Step& y) {
    const bool is_surer = x.confidence != y.confidence ? x.confidence > y.confidence : x.name < y.name;
    return x.tet != y.tet && is_surer != (prefers == Prefers::sure);
  };
  std::priority_queue<Step, std::vector<Step>, decltype(comes_later)> queue(comes_later);
  std::vector<std::uint32_t> before(mesh.size(), kNone);
  const auto see = [&](std::uint32_t t, std::uint32_t from) {
    if (before[t] != kNone || !usable(t)) return;
    before[t] = from;
    queue.push({measure(t), sorted_vertices(mesh, t), t});
  };
  for (const std::uint32_t t : starts) see(t, t);
  while (!queue.empty()) {
    std::uint32_t t = queue.top().tet;
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

bool is_join_of_two(const Contact& contact) {
  std::vector<std::uint32_t> bodies;
  for (unsigned i = 0; i < 4; ++i)
    if ((contact.facets >> i & 1U) != 0) bodies.push_back(contact.bodies[i]);
  std::sort(bodies.begin(), bodies.end());
  return contact.parts == 2 && contact.loops == 0 &&
         std::unique(bodies.begin(), bodies.end()) - bodies.begin() == 2;
}

/// By simple moves, and a join at the end.
bool can_add(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept,
             const std::vector<std::uint32_t>& way) {
  GrowingSolid solid(complex, ground);
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    if (kept[t] != 0) solid.add(t);
  for (const std::uint32_t t : way) {
    const Contact contact = solid.contact(t);
    if (t == way.back() ? !is_join_of_two(contact) : !contact.is_simple()) return false;
    solid.add(t);
  }
  return !way.empty();
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
struct SecondLook::View {
  explicit View(const SecondLook& look) : bodies(look.complex_, look.ground_, look.kept_) {}

  Bodies bodies;
  std::vector<std::pair<TetName, std::uint32_t>> names;  ///< kept ones, ascending; only for answers
};

Way SecondLook::way_from(const TetName& body) const {
  const std::uint32_t start = tet_of_name(complex_.mesh, body);
  if (start == kNone || kept_[start] == 0) return {};
  View view(*this);
  return way_from(view, start);
}

Way SecondLook::way_from(View& view, std::uint32_t start) const {
  Bodies& bodies = view.bodies;  // for clang 14 no lambda may take what is bound together with others
  const std::uint32_t own = bodies.of_tet(start);
  if (!bodies.stands_on_one_part(own)) return {};
  std::vector<std::uint32_t> starts;
  const auto is_free = [&](std::uint32_t t) { return candidates_[t] != 0 && kept_[t] == 0; };
  for (std::uint32_t t = 0; t < kept_.size(); ++t)
    if (is_free(t) && bodies.touches(t, own)) starts.push_back(t);
  Way way;
  way.tets = best_way(complex_.mesh, Prefers::sure, measure_, starts, is_free,
                      [&](std::uint32_t t) { return bodies.other_at(t, own) != kNone; });
  if (!can_add(complex_, ground_, kept_, way.tets)) return {};
  const std::uint32_t other = bodies.other_at(way.tets.back(), own);
  for (const std::uint32_t n : complex_.mesh.neighbours[way.tets.back()])
    if (n != kNone && kept_[n] != 0 && bodies.of_tet(n) == other)
      way.target = std::min(way.target, sorted_vertices(complex_.mesh, n));
  const std::uint32_t a = bodies.name_of(own), b = bodies.name_of(other);
  way.join = {std::min(a, b), std::max(a, b), measure_(way.tets[0]), true};
  for (const std::uint32_t t : way.tets) way.join.confidence = std::min(way.join.confidence, measure_(t));
  return way;
}

BodyAnswer SecondLook::answer_body(View& view, const std::vector<TetName>& names) const {
  BodyAnswer answer;
  std::uint32_t own = kNone, start = kNone;
  for (const TetName& name : names) {
    const auto place = std::lower_bound(view.names.begin(), view.names.end(), std::pair(name, 0U));
    if (place == view.names.end() || place->first != name) return answer;
    if (own != kNone && view.bodies.of_tet(place->second) != own) return answer;
    own = view.bodies.of_tet(place->second);
    if (start == kNone) start = place->second;
  }
  answer.is_alone = own != kNone && view.bodies.stands_on_one_part(own);
  if (!answer.is_alone) return answer;
  const Way way = way_from(view, start);
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
  const auto way = best_way(
      complex_.mesh, Prefers::unsure, measure_, starts, [&](std::uint32_t t) { return kept_[t] != 0; },
      [&](std::uint32_t t) { return beyond(t)[0] != kNone; });
  if (way.empty()) return answer;
  answer.can_open = true;
  answer.confidence = measure_(way[0]);
  for (const std::uint32_t t : way) answer.confidence = std::max(answer.confidence, measure_(t));
  answer.from = sorted_vertices(complex_.mesh, start);
  answer.to = beyond(way.back());
  return answer;
}

Answers SecondLook::answer(const SecondThoughts& questions) const {
  Answers answers;
  if (!questions.bodies.empty()) {
    View view(*this);
    for (std::uint32_t t = 0; t < kept_.size(); ++t)
      if (kept_[t] != 0) view.names.push_back({sorted_vertices(complex_.mesh, t), t});
    std::sort(view.names.begin(), view.names.end());
    for (const auto& names : questions.bodies) answers.bodies.push_back(answer_body(view, names));
  }
  const std::vector<OutsideAt> seen =
      questions.cavities.empty() ? std::vector<OutsideAt>{} : outside_of_facets(complex_, ground_, kept_);
  for (const auto& facets : questions.cavities) {
    std::vector<CavityAnswer>& parts = answers.cavities.emplace_back();
    std::vector<std::uint8_t> known(kept_.size(), 0);
    bool beyond_hull = false;
    for (const Triangle& facet : facets) {
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
                         const std::vector<std::uint8_t>& kept, const SecondThoughts& questions) {
  const std::vector<std::uint8_t> r1 = without_external(complex);
  ConfidenceMeter meter(complex, ground, shape);
  return SecondLook(complex, ground, r1, kept, [&](std::uint32_t t) { return meter.measure(t); })
      .answer(questions);
}

}  // namespace crossloft
