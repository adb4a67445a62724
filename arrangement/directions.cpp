#include "directions.h"

#include <algorithm>
#include <cstdlib>

#include "../geom/disjoint_sets.h"

namespace crossloft {
namespace {

LatticeVector negative(const LatticeVector& v) { return {-v[0], -v[1], -v[2]}; }

std::int64_t largest_difference(const LatticeVector& a, const LatticeVector& b) {
  std::int64_t largest = 0;
  for (std::size_t k = 0; k < 3; ++k) largest = std::max<std::int64_t>(largest, std::llabs(a[k] - b[k]));
  return largest;
}

/// Joins the place of one of the sorted directions with those of its neighbours.
void join_neighbours(const std::vector<LatticeVector>& sorted, std::uint32_t place, DisjointSets& sets) {
  for (int step = 0; step < 27; ++step) {
    const LatticeVector& d = sorted[place];
    const LatticeVector near{d[0] + step % 3 - 1, d[1] + step / 3 % 3 - 1, d[2] + step / 9 - 1};
    for (const LatticeVector& wanted : {near, negative(near)}) {
      const auto found = std::lower_bound(sorted.begin(), sorted.end(), wanted);
      if (found != sorted.end() && *found == wanted)
        sets.join(place, static_cast<std::uint32_t>(found - sorted.begin()));
    }
  }
}

}  // namespace

void unify_directions(std::vector<LatticeVector>& directions) {
  std::vector<LatticeVector> sorted = directions;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  DisjointSets sets(sorted.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) join_neighbours(sorted, i, sets);
  for (LatticeVector& d : directions) {
    const auto place = std::lower_bound(sorted.begin(), sorted.end(), d) - sorted.begin();
    d = sorted[sets.find(static_cast<std::uint32_t>(place))];
  }
}

std::int64_t difference(const LatticeVector& a, const LatticeVector& b) {
  return std::min(largest_difference(a, b), largest_difference(a, negative(b)));
}

}  // namespace crossloft
