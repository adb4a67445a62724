#include "../../arrangement/directions.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "../../geom/frame.h"
#include "polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

constexpr std::int64_t kOne = std::int64_t{1} << 46;

std::vector<LatticeVector> unified(std::vector<LatticeVector> directions) {
  unify_directions(directions);
  return directions;
}

}  // namespace

TEST_CASE("a normal and its multiples are one direction") {
  std::mt19937_64 random(5);
  int different = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 n = random_vector(random);
    std::vector<LatticeVector> directions;
    for (const double factor : {1.0, 3.0, -3.0, 0.7, -1e-9})
      directions.push_back(quantise_direction(factor * n));
    different += directions[0] != directions[1] ? 1 : 0;
    const std::vector<LatticeVector> one = unified(directions);
    CHECK(std::count(one.begin(), one.end(), one[0]) == 5);
    CHECK(one[0] == *std::min_element(directions.begin(), directions.end()));
    std::reverse(directions.begin(), directions.end());
    CHECK(unified(directions) == one);
  }
  CHECK(different > 0);
}

TEST_CASE("what is a unit away is one, also where the sign changes; what is two away is not") {
  const LatticeVector a{0, 5, kOne}, b{1, -4, -kOne}, c{2, -3, -kOne}, far{0, 7, kOne};
  CHECK(difference(a, b) == 1);
  CHECK(difference(a, far) == 2);
  CHECK(unified({b, a}) == std::vector<LatticeVector>{a, a});
  CHECK(unified({a, far}) == std::vector<LatticeVector>{a, far});
  CHECK(unified({c, a, b}) == std::vector<LatticeVector>{a, a, a});  // by steps
  CHECK(unified({}).empty());
}
