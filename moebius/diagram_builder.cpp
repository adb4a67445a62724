#include "diagram_builder.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace crossloft {
namespace {

/// Sorts three sites; whether the permutation was odd.
bool sort_sites(std::array<std::uint32_t, 3>& s) {
  const bool odd = (s[0] > s[1]) != ((s[1] > s[2]) != (s[0] > s[2]));
  std::sort(s.begin(), s.end());
  return odd;
}

/// Square of an angle within rounding.
constexpr double kNoTurn = 1e-12;

double moebius_distance(const MoebiusSite& s, Vec2 x) { return s.lambda * dot(x - s.p, x - s.p) - s.mu; }

bool is_entry(Passage p) { return p == Passage::enters || p == Passage::dips; }
bool is_exit(Passage p) { return p == Passage::leaves || p == Passage::dips; }

std::uint32_t third_site(const std::array<std::uint32_t, 3>& sites, std::uint32_t i, std::uint32_t j) {
  for (const std::uint32_t k : sites)
    if (k != i && k != j) return k;
  return kNone;
}

}  // namespace

Passage passage_between(bool starts_inside, bool ends_inside, bool dips) {
  if (starts_inside) return ends_inside ? Passage::inside : Passage::leaves;
  if (ends_inside) return Passage::enters;
  return dips ? Passage::dips : Passage::outside;
}

Passage reversed(Passage passage) {
  if (passage == Passage::enters) return Passage::leaves;
  return passage == Passage::leaves ? Passage::enters : passage;
}

std::uint32_t DiagramBuilder::add_edge(const std::array<std::uint32_t, 3>& sites, Passage passage) {
  Edge edge{sites, passage};
  if (is_entry(passage) || is_exit(passage)) {
    const auto places = sites_.crossings(sites[0], sites[1], sites[2]);
    auto sorted = sites;
    const bool odd = sort_sites(sorted);
    const auto add = [&](bool leaves) {
      vertices_.push_back({sorted, leaves != odd});
      places_.push_back(places[leaves]);
      return static_cast<std::uint32_t>(places_.size() - 1);
    };
    if (is_entry(passage)) edge.entry = add(false);
    if (is_exit(passage)) edge.exit = add(true);
  }
  edges_.push_back(edge);
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

FacetSide DiagramBuilder::side(std::uint32_t edge, bool backwards) const {
  const Passage passage = edges_[edge].passage;
  return {backwards ? reversed(passage) : passage, edge, backwards};
}

std::uint32_t DiagramBuilder::vertex_at(const FacetSide& side, bool leaving) const {
  if (side.edge == kNone) return kNone;
  const Edge& edge = edges_[side.edge];
  return leaving != side.backwards ? edge.exit : edge.entry;
}

void DiagramBuilder::add_facet(std::uint32_t i, std::uint32_t j, std::span<const FacetSide> sides) {
  passages_.clear();
  for (const FacetSide& side : sides) passages_.push_back(side.passage);
  cut_.clear();
  cut_facet(passages_, cut_);
  const std::size_t first = arcs_.size();
  for (const FacetArc& piece : cut_)
    add_arc(i, j, vertex_at(sides[piece.from.side], true), vertex_at(sides[piece.to.side], false));
  const auto pieces = std::span(arcs_).subspan(first);
  if (cut_.empty())
    add_whole_curve(i, j, sides);
  else if (!pieces.front().curve.is_line)
    for (MoebiusArc& arc : pieces) arc.over_half = is_over_half(arc, pieces, sides);
}

/// The border of the facet never crosses the paraboloid. If it is outside, the curve of a plane that is not
/// vertical bounds a disk which lies in the facet or misses it: its centre tells. A vertical plane holds a
/// parabola, which reaches infinity, so the facet has no border.
void DiagramBuilder::add_whole_curve(std::uint32_t i, std::uint32_t j, std::span<const FacetSide> sides) {
  if (sites_.site(i).lambda == sites_.site(j).lambda) {
    if (sides.empty()) add_arc(i, j, kNone, kNone);
    return;
  }
  if (!sides.empty() && sides.front().passage == Passage::inside) return;
  if (!sites_.circle_exists(i, j)) return;
  for (const FacetSide& side : sides)
    if (side.edge != kNone && !sites_.circle_clears(i, j, third_site(edges_[side.edge].sites, i, j))) return;
  add_arc(i, j, kNone, kNone);
}

/// The cell of i is on the left: where the plane of the facet rises, as seen from above, the side of the
/// larger lambda is within the circle and the border of the facet turns counter-clockwise. Here i becomes the
/// smaller index.
void DiagramBuilder::add_arc(std::uint32_t i, std::uint32_t j, std::uint32_t from, std::uint32_t to) {
  if (i > j) std::swap(i, j), std::swap(from, to);
  arcs_.push_back({{i, j}, from, to, moebius_curve(sites_.site(i), sites_.site(j))});
}

/// From the turn between the ends, seen from the centre. Ends too close to tell a tiny arc from nearly a
/// whole circle: it is the latter if no arc of the facet is elsewhere and the place across the circle is in
/// the facet.
bool DiagramBuilder::is_over_half(const MoebiusArc& arc, std::span<const MoebiusArc> pieces,
                                  std::span<const FacetSide> sides) const {
  const auto [i, j] = arc.sites;
  const Vec2 centre = arc.curve.centre, from = places_[arc.from] - centre, to = places_[arc.to] - centre;
  const bool turns_back = (cross(from, to) < 0) == (sites_.site(i).lambda > sites_.site(j).lambda);
  const auto is_near = [&](Vec2 a, Vec2 b) { return dot(b - a, b - a) <= kNoTurn * dot(from, from); };
  if (!is_near(from, to)) return turns_back;
  for (const MoebiusArc& other : pieces)
    if (!is_near(places_[other.from] - centre, from) || !is_near(places_[other.to] - centre, from))
      return false;
  const Vec2 across = centre - from;
  const double nearest = moebius_distance(sites_.site(i), across);
  for (const FacetSide& side : sides)
    if (side.edge != kNone &&
        moebius_distance(sites_.site(third_site(edges_[side.edge].sites, i, j)), across) < nearest)
      return false;
  return turns_back || pieces.size() == 1;
}

void DiagramBuilder::sort_vertices() {
  std::vector<std::uint32_t> order(vertices_.size()), place(vertices_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return vertices_[a] < vertices_[b]; });
  std::vector<Vec2> places(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    place[order[k]] = k;
    places[k] = places_[order[k]];
  }
  places_ = std::move(places);
  for (MoebiusArc& arc : arcs_)
    for (std::uint32_t* end : {&arc.from, &arc.to})
      if (*end != kNone) *end = place[*end];
}

void DiagramBuilder::sort_arcs() {
  std::sort(arcs_.begin(), arcs_.end(), [](const MoebiusArc& a, const MoebiusArc& b) {
    return a.sites != b.sites ? a.sites < b.sites : a.from < b.from;
  });
}

MoebiusDiagram DiagramBuilder::finish() {
  sort_vertices();
  sort_arcs();
  return {{}, std::move(places_), std::move(arcs_)};
}

}  // namespace crossloft
