#pragma once
/// The contours of one plane while vertices are taken out of them; internal to arrangement/.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "section_graph.h"

namespace crossloft::section_steps {

/// The vertices of one plane's contours by numbers from 0 on. One table over all vertices of the graph serves
/// all planes in turn: with a stack of k slices, one for each would be k times as much work as there are
/// vertices.
class ContourPlaces {
 public:
  explicit ContourPlaces(std::uint32_t vertices) : of_(vertices, kNone) {}
  /// Turns to the ends of these walls; what was asked for before is forgotten.
  void renew(const std::vector<Wall>& walls);

  std::uint32_t operator[](std::uint32_t v) const { return of_[v]; }
  /// By place.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }

 private:
  std::vector<std::uint32_t> of_, vertices_;
};

/// Each vertex knows its walls, each wall the vertices that it has replaced: a deviation is measured from the
/// contour as it was, so that the errors of many steps don't add up.
class ContourChains {
 public:
  /// Changes `walls` in place; they and `places`, which are renewed for them, must outlive the chains.
  ContourChains(std::vector<Wall>& walls, ContourPlaces& places);

  std::size_t degree(std::uint32_t v) const { return degree_[places_[v]]; }
  /// REQUIRES: degree 2.
  std::array<std::uint32_t, 2> neighbours(std::uint32_t v) const {
    const auto list = around(v);
    return {other_end(list[0], v), other_end(list[1], v)};
  }
  /// REQUIRES: degree 2.
  std::array<std::uint32_t, 2> walls_at(std::uint32_t v) const { return {around(v)[0], around(v)[1]}; }
  /// True iff there is a wall between them.
  bool joined(std::uint32_t u, std::uint32_t w) const;
  /// How many vertices a wall in place of the two at v would have replaced. REQUIRES: degree 2.
  std::size_t replaced_without(std::uint32_t v) const {
    return replaced_.empty() ? 1 : replaced_[around(v)[0]].size() + replaced_[around(v)[1]].size() + 1;
  }
  /// True iff keep() holds for those vertices; asks until one fails. REQUIRES: degree 2.
  template <class Keep>
  bool all_replaced_without(std::uint32_t v, Keep&& keep) const {
    if (replaced_.empty()) return keep(v);
    const auto& [first, second] = std::tie(replaced_[around(v)[0]], replaced_[around(v)[1]]);
    return keep(v) && std::all_of(first.begin(), first.end(), keep) &&
           std::all_of(second.begin(), second.end(), keep);
  }
  /// The first of the two walls at v takes the place of both. REQUIRES: degree 2, two different neighbours
  /// that are not joined.
  void remove(std::uint32_t v);
  /// Calls visit(wall, vertex) for each vertex that was removed and the wall that is in its place now.
  template <class Visit>
  void for_each_replaced(Visit&& visit) const {
    for (std::size_t w = 0; w < replaced_.size(); ++w)
      for (const std::uint32_t v : replaced_[w]) visit(walls_[w], v);
  }
  /// Takes the walls that are gone out of the list; the chains are of no more use then.
  void finish();

 private:
  std::uint32_t other_end(std::uint32_t wall, std::uint32_t v) const {
    return walls_[wall].a == v ? walls_[wall].b : walls_[wall].a;
  }
  std::span<const std::uint32_t> around(std::uint32_t v) const {
    return {around_.data() + begin_[places_[v]], degree_[places_[v]]};
  }

  std::vector<Wall>& walls_;
  const ContourPlaces& places_;
  std::vector<std::uint32_t> begin_, degree_;  ///< by place: its walls are around_[begin .. begin + degree)
  std::vector<std::uint32_t> around_;          ///< walls; a list can change or end, but not grow
  std::vector<std::vector<std::uint32_t>> replaced_;  ///< vertices by wall, once one is removed
  std::vector<bool> dead_;                            ///< by wall, likewise
};

}  // namespace crossloft::section_steps
