#include "power_facets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace crossloft {
namespace {

double least_lambda(const SitePredicates& sites) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < sites.size(); ++i) least = std::min(least, sites.site(i).lambda);
  return least;
}

/// A side of the facet between two directions at infinity. Straight up can lie strictly between them only if
/// both sites have the least lambda, and then does unless it is one of the two.
FacetSide gap(bool starts_inside, bool ends_inside, bool lambdas_least) {
  return {passage_between(starts_inside, ends_inside, lambdas_least), kNone, false};
}

bool begins_inside(const FacetSide& s) {
  return s.passage == Passage::inside || s.passage == Passage::leaves;
}
bool ends_inside(const FacetSide& s) { return s.passage == Passage::inside || s.passage == Passage::enters; }

using Triangle = std::array<std::uint32_t, 3>;

template <std::size_t N>
std::size_t slot_of(const std::array<std::uint32_t, N>& simplex, std::uint32_t v) {
  return static_cast<std::size_t>(std::find(simplex.begin(), simplex.end(), v) - simplex.begin());
}

/// For each edge of kEdgeSlots the other two slots, so that all four are an even permutation: turning
/// positively about the edge one comes in across the facet opposite the second and goes out across that
/// opposite the first.
constexpr std::array<std::array<std::uint8_t, 2>, 6> kOtherSlots{
    {{2, 3}, {3, 1}, {1, 2}, {0, 3}, {2, 0}, {0, 1}}};

/// The facets of dimension 3: one for each edge of the triangulation, its sides the triangles around that
/// edge.
class SpatialFacets {
 public:
  SpatialFacets(const SitePredicates& sites, const TetMesh& mesh, DiagramBuilder& builder)
      : sites_(sites),
        mesh_(mesh),
        builder_(builder),
        least_lambda_(least_lambda(sites)),
        edges_(mesh.size()) {
    inside_.reserve(mesh.size());
    for (const auto& v : mesh.vertices) inside_.push_back(sites.vertex_inside(v[0], v[1], v[2], v[3]));
  }

  void add_edges() {
    for (std::uint32_t t = 0; t < mesh_.size(); ++t)
      for (std::size_t slot = 0; slot < 4; ++slot)
        if (t < mesh_.neighbours[t][slot]) add_edge(t, slot);
  }

  void add_facets() {
    for (std::uint32_t t = 0; t < mesh_.size(); ++t)
      for (std::size_t e = 0; e < kEdgeSlots.size(); ++e) add_facet(t, e);
  }

 private:
  enum class Turn : std::uint8_t { closed, at_infinity, met_earlier };

  bool is_least(std::uint32_t i) const { return sites_.site(i).lambda == least_lambda_; }

  /// The end at infinity of the power edge of a hull triangle.
  bool infinity_inside(const Triangle& s) const { return is_least(s[0]) && is_least(s[1]) && is_least(s[2]); }

  /// Towards infinity a power edge falls below the paraboloid unless it is vertical, and then it does not
  /// rise away from both ends, or ends inside. `beyond` is the apex on the other side, kNone at infinity.
  bool dips(const Triangle& s, std::uint32_t apex, std::uint32_t beyond) const {
    return sites_.rises_away(s[0], s[1], s[2], apex) &&
           (beyond == kNone || sites_.rises_away(s[0], s[1], s[2], beyond)) &&
           sites_.line_passes(s[0], s[1], s[2]);
  }

  /// The triangle opposite a slot of t. Facets of kFacetSlots turn counter-clockwise seen from outside; r x s
  /// leads away from t in the other order.
  void add_edge(std::uint32_t t, std::size_t slot) {
    const auto& v = mesh_.vertices[t];
    const auto& f = kFacetSlots[slot];
    const Triangle s{v[f[0]], v[f[2]], v[f[1]]};
    const std::uint32_t next = mesh_.neighbours[t][slot];
    const std::size_t back = next == kNone ? 0 : slot_of(mesh_.neighbours[next], t);
    const bool starts = inside_[t], ends = next == kNone ? infinity_inside(s) : inside_[next];
    const bool between =
        !starts && !ends && dips(s, v[slot], next == kNone ? kNone : mesh_.vertices[next][back]);
    const std::uint32_t id = builder_.add_edge(s, passage_between(starts, ends, between));
    edges_[t][slot] = id;
    if (next != kNone) edges_[next][back] = id;
  }

  /// The facet of an edge, found from the first of its tetrahedra.
  void add_facet(std::uint32_t t, std::size_t e) {
    const auto [out, keep] = kOtherSlots[e];
    const std::uint32_t a = mesh_.vertices[t][kEdgeSlots[e][0]], b = mesh_.vertices[t][kEdgeSlots[e][1]];
    sides_.clear();
    const Turn turn = turn_about(a, b, t, out, keep, false);
    if (turn == Turn::met_earlier) return;
    if (turn == Turn::at_infinity) {
      const std::size_t forward = sides_.size();
      if (turn_about(a, b, t, keep, out, true) == Turn::met_earlier) return;
      std::reverse(sides_.begin() + static_cast<std::ptrdiff_t>(forward), sides_.end());
      const bool starts = ends_inside(sides_[forward - 1]), ends = begins_inside(sides_[forward]);
      sides_.insert(sides_.begin() + static_cast<std::ptrdiff_t>(forward),
                    gap(starts, ends, is_least(a) && is_least(b)));
    }
    builder_.add_facet(a, b, sides_);
  }

  /// Appends the sides met on the way around the edge a b from tetrahedron t, out across the facet opposite
  /// slot `out`, as walked that way or, with `inward`, towards t.
  Turn turn_about(std::uint32_t a, std::uint32_t b, std::uint32_t t, std::size_t out, std::size_t keep,
                  bool inward) {
    for (std::uint32_t at = t;;) {
      const std::uint32_t next = mesh_.neighbours[at][out];
      if (next < t) return Turn::met_earlier;
      sides_.push_back(builder_.side(edges_[at][out], (next < at) != inward));
      if (next == t) return Turn::closed;
      if (next == kNone) return Turn::at_infinity;
      const auto& v = mesh_.vertices[next];
      out = slot_of(v, mesh_.vertices[at][keep]);
      keep = 6 - out - slot_of(v, a) - slot_of(v, b);
      at = next;
    }
  }

  const SitePredicates& sites_;
  const TetMesh& mesh_;
  DiagramBuilder& builder_;
  double least_lambda_;
  std::vector<bool> inside_;                         ///< the power vertex of each tetrahedron
  std::vector<std::array<std::uint32_t, 4>> edges_;  ///< the builder's numbers of its triangles
  std::vector<FacetSide> sides_;                     ///< of the facet at hand
};

/// Two lines with the gaps between their ends, or one line with the half turn at infinity between its ends.
/// `lines` are numbers of the triangles left and right of the edge from i to j, kNone beyond the hull.
void add_strip(std::uint32_t i, std::uint32_t j, std::array<std::uint32_t, 2> lines, bool lambdas_least,
               DiagramBuilder& builder) {
  std::array<FacetSide, 4> sides;
  std::size_t count = 0;
  for (const bool right : {false, true})  // the edge of the triangle on the left turns from j to i
    if (lines[right] != kNone) sides[2 * count++] = builder.side(lines[right], !right);
  for (std::size_t k = 0; k < count; ++k) {
    const FacetSide &before = sides[2 * k], &after = sides[2 * ((k + 1) % count)];
    sides[2 * k + 1] = gap(ends_inside(before), begins_inside(after), lambdas_least && count == 1);
  }
  builder.add_facet(i, j, std::span(sides).first(2 * count));
}

}  // namespace

void add_facets(const SitePredicates& sites, const TetMesh& mesh, DiagramBuilder& builder) {
  SpatialFacets facets(sites, mesh, builder);
  facets.add_edges();
  facets.add_facets();
}

void add_facets(const SitePredicates& sites, const TriMesh& mesh, DiagramBuilder& builder) {
  const double least = least_lambda(sites);
  // All lines are parallel and walked in one direction. A vertical one meets the paraboloid once; the others
  // fall away on both sides.
  const auto passage = [&](const Triangle& s) {
    if (sites.lambdas_equal(s[0], s[1], s[2]))
      return sites.line_leads_up(s[0], s[1], s[2]) ? Passage::enters : Passage::leaves;
    return sites.line_passes(s[0], s[1], s[2]) ? Passage::dips : Passage::outside;
  };
  std::vector<std::uint32_t> lines;
  for (const Triangle& s : mesh.vertices) lines.push_back(builder.add_edge(s, passage(s)));
  for (std::uint32_t t = 0; t < mesh.size(); ++t)
    for (std::size_t slot = 0; slot < 3; ++slot) {
      const std::uint32_t next = mesh.neighbours[t][slot];
      if (next < t) continue;  // kNone is not
      const std::uint32_t i = mesh.vertices[t][(slot + 1) % 3], j = mesh.vertices[t][(slot + 2) % 3];
      const bool level = sites.site(i).lambda == least && sites.site(j).lambda == least;
      add_strip(i, j, {lines[t], next == kNone ? kNone : lines[next]}, level, builder);
    }
}

}  // namespace crossloft
