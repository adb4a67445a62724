#pragma once
/// Which loops around a growing solid nothing fills.

#include <cstdint>
#include <span>
#include <vector>

#include "cell_complex.h"
#include "contact.h"
#include "ground.h"

namespace crossloft {

/// A solid K within a wider set Y of tetrahedra. One of Y that touches a body of K twice closes a loop. It is
/// *open* if nothing in Y fills it and no loop of K goes the same way: if its class in H1(Y, K) modulo 2 is
/// not 0. That is told by the cocycles of Y that are 0 on K: values of facets, with the sum 0 on each closed
/// way from tetrahedron to tetrahedron within the star of a vertex, as what hangs together there is no ring
/// (cell_topology.h cuts S apart by umbrellas).
class OpenLoops {
 public:
  /// `solid` is K, a copy. What touches each of its bodies once is added to it first, as that leaves the
  /// classes of loops as they are; what is left, mostly little, makes a row of equations for each facet that
  /// closes a way in a star, and they are eliminated: O(n) where measured, no bound is known. REQUIRES:
  /// `wider` contains K.
  OpenLoops(const CellComplex& complex, const Ground& ground, GrowingSolid solid,
            const std::vector<std::uint8_t>& wider);
  /// Whether t closes an open loop. REQUIRES: t is in `wider` and not in K; the contact is its own.
  bool is_closed_by(std::uint32_t t, const Contact& contact) const;

 private:
  using Row = std::vector<std::uint32_t>;  ///< a sum modulo 2: ascending

  /// Between two places in the star of a vertex: its tetrahedra beside K, then parts of K.
  struct Step {
    std::uint32_t from = 0, to = 0, unknown = kNone;
  };

  bool is_beside(std::uint32_t t) const { return wider_[t] != 0 && !solid_.has(t); }
  void fill();
  bool leads_to_solid(std::uint32_t t, unsigned i) const;
  static void add(Row& row, const Row& other);
  void number_facets();
  std::vector<Step> steps_at(std::uint32_t v, std::span<const std::uint32_t> star);
  void add_ways(const std::vector<Step>& steps);
  void reduce(Row row);
  void solve();

  const CellComplex& complex_;
  const Ground& ground_;
  GrowingSolid solid_;  ///< K and what was added
  const std::vector<std::uint8_t>& wider_;
  std::vector<std::uint32_t> unknown_;  ///< by 4 t + facet; kNone where the value is 0
  std::vector<Row> equations_;          ///< by their largest unknown, reduced
  std::vector<Row> values_;             ///< by unknown: the free ones that it is the sum of
};

}  // namespace crossloft
