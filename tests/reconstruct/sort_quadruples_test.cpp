#include "../../reconstruct/sort_quadruples.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace crossloft;

TEST_CASE("quadruples get into lexicographic order, by any number of threads") {
  std::mt19937 random(1);
  for (const std::size_t count : {0u, 1u, 1000u, 300'000u})
    for (const std::uint32_t firsts : {1u, 1023u, 1024u, 100'000u}) {
      std::vector<std::array<std::uint32_t, 4>> items(count);
      for (auto& item : items) {
        for (std::uint32_t& number : item) number = static_cast<std::uint32_t>(random() % 5);
        item[0] = static_cast<std::uint32_t>(random() % firsts);
      }
      auto expected = items;
      std::sort(expected.begin(), expected.end());
      for (const unsigned threads : {1u, 3u}) {
        Context context;
        context.threads = threads;
        auto sorted = items;
        sort_quadruples(sorted, firsts, context);
        CHECK(sorted == expected);
      }
    }
}
