#include "../../moebius/diagram.h"

#include "diagram_checks.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

using Sites = std::vector<MoebiusSite>;

/// Integers -reach..reach.
class SmallIntegers {
 public:
  explicit SmallIntegers(unsigned seed) : random_(seed) {}
  double operator()(int reach) { return std::uniform_int_distribution<int>(-reach, reach)(random_); }

 private:
  std::mt19937 random_;
};

}  // namespace

TEST_CASE("random small integers: every tie there is") {
  const unsigned seed = 4711;
  INFO("seed " << seed);
  SmallIntegers random(seed);
  for (int round = 0; round < 1500; ++round) {
    Sites sites;
    const int n = 1 + round % 7, reach = 1 + round % 3;
    for (int k = 0; k < n; ++k)
      sites.push_back({{random(reach), random(reach)},
                       random(round % 5 == 0 ? 0 : 2) + (round % 5 == 0),
                       random(round % 4)});
    checked(sites, 4, 12);
  }
}

TEST_CASE("random reals") {
  const unsigned seed = 815;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 300; ++round) {
    Sites sites;
    for (int k = 0; k < 2 + round % 30; ++k)
      sites.push_back({{unit(random), unit(random)},
                       round % 3 ? unit(random) + round % 4 : 1.0,
                       round % 2 ? unit(random) : 0.0});
    checked(sites, 1.5, 24);
  }
}
