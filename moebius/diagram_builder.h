#pragma once
/// Collects the power edges and facets of the lifted sites and turns them into the vertices and arcs of a
/// Moebius diagram.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/ids.h"
#include "diagram.h"
#include "facet_cut.h"
#include "site_predicates.h"

namespace crossloft {

/// One side of a facet: a power edge, walked as it was added or backwards, or a gap at infinity.
struct FacetSide {
  Passage passage = Passage::outside;  ///< as walked around the facet
  std::uint32_t edge = kNone;          ///< kNone for a gap
  bool backwards = false;
};

/// From the states of the two ends; `dips` counts only where both are outside.
Passage passage_between(bool starts_inside, bool ends_inside, bool dips);
/// The same walked the other way.
Passage reversed(Passage passage);

/// Every power edge first, then every facet, then finish().
class DiagramBuilder {
 public:
  explicit DiagramBuilder(const SitePredicates& sites) : sites_(sites) {}

  /// The power edge of three sites, or the piece of it that exists, walked along r x s of the sites in the
  /// order given (PowerLine). Returns its number.
  std::uint32_t add_edge(const std::array<std::uint32_t, 3>& sites, Passage passage);
  /// The side that walks an edge.
  FacetSide side(std::uint32_t edge, bool backwards) const;
  /// The facet where i and j are equally near: all its sides, counter-clockwise seen from the cell of j; none
  /// if it is a whole plane.
  void add_facet(std::uint32_t i, std::uint32_t j, std::span<const FacetSide> sides);
  /// Vertices and arcs in canonical order.
  MoebiusDiagram finish();

 private:
  /// A vertex belongs to one crossing of one edge: `sites` ascending, `leaves` if the edge leaves the inside
  /// there when walked along r x s of those.
  struct Vertex {
    std::array<std::uint32_t, 3> sites;
    bool leaves;
    friend auto operator<=>(const Vertex&, const Vertex&) = default;
  };
  struct Edge {
    std::array<std::uint32_t, 3> sites;
    Passage passage;
    std::uint32_t entry = kNone, exit = kNone;  ///< vertices
  };

  std::uint32_t vertex_at(const FacetSide& side, bool leaving) const;
  void add_whole_curve(std::uint32_t i, std::uint32_t j, std::span<const FacetSide> sides);
  void add_arc(std::uint32_t i, std::uint32_t j, std::uint32_t from, std::uint32_t to);
  bool is_over_half(const MoebiusArc& arc, std::span<const MoebiusArc> pieces,
                    std::span<const FacetSide> sides) const;
  void sort_vertices();
  void sort_arcs();

  const SitePredicates& sites_;
  std::vector<Edge> edges_;
  std::vector<Vertex> vertices_;
  std::vector<Vec2> places_;
  std::vector<MoebiusArc> arcs_;
  std::vector<Passage> passages_;  ///< of the facet at hand
  std::vector<FacetArc> cut_;
};

}  // namespace crossloft
