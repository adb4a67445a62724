#pragma once
/// The contours of one plane while vertices are taken out of them; internal to arrangement/.

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "section_graph.h"

namespace crossloft::section_steps {

/// Each vertex knows its walls, each wall the vertices that it has replaced: a deviation is measured from the
/// contour as it was, so that the errors of many steps don't add up.
class ContourChains {
 public:
  /// Changes `walls` in place; they must outlive the chains. `vertices`: all numbers in them are below.
  ContourChains(std::vector<Wall>& walls, std::uint32_t vertices);

  std::size_t degree(std::uint32_t v) const { return around_[v].size(); }
  /// REQUIRES: degree 2.
  std::array<std::uint32_t, 2> neighbours(std::uint32_t v) const {
    return {other_end(around_[v][0], v), other_end(around_[v][1], v)};
  }
  /// True iff there is a wall between them.
  bool joined(std::uint32_t u, std::uint32_t w) const;
  /// How many vertices a wall in place of the two at v would have replaced. REQUIRES: degree 2.
  std::size_t replaced_without(std::uint32_t v) const {
    return replaced_[around_[v][0]].size() + replaced_[around_[v][1]].size() + 1;
  }
  /// True iff keep() holds for those vertices; asks until one fails. REQUIRES: degree 2.
  template <class Keep>
  bool all_replaced_without(std::uint32_t v, Keep&& keep) const {
    const auto& [first, second] = std::tie(replaced_[around_[v][0]], replaced_[around_[v][1]]);
    return keep(v) && std::all_of(first.begin(), first.end(), keep) &&
           std::all_of(second.begin(), second.end(), keep);
  }
  /// One wall takes the place of the two at v. REQUIRES: degree 2, two different neighbours that are not
  /// joined.
  void remove(std::uint32_t v);
  /// Calls visit(wall, vertex) for each vertex that was removed and the wall that is in its place now.
  template <class Visit>
  void for_each_replaced(Visit&& visit) const {
    for (std::size_t w = 0; w < walls_.size(); ++w)
      for (const std::uint32_t v : replaced_[w]) visit(walls_[w], v);
  }
  /// Takes the walls that are gone out of the list; the chains are of no more use then.
  void finish();

 private:
  std::uint32_t other_end(std::uint32_t wall, std::uint32_t v) const {
    return walls_[wall].a == v ? walls_[wall].b : walls_[wall].a;
  }

  std::vector<Wall>& walls_;
  std::vector<std::vector<std::uint32_t>> around_;    ///< walls by vertex
  std::vector<std::vector<std::uint32_t>> replaced_;  ///< vertices by wall
  std::vector<bool> dead_;                            ///< by wall
};

}  // namespace crossloft::section_steps
