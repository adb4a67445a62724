#include "../../reconstruct/grounded_table.h"

#include <doctest/doctest.h>

#include <map>
#include <random>

using namespace crossloft;

TEST_CASE("grounded triangles are found by their vertices in any order, at hubs as elsewhere") {
  using Key = GroundedTable::Key;
  constexpr std::uint32_t kVertices = 300;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto any = [&] { return static_cast<std::uint32_t>(random() % kVertices); };
    std::map<Key, std::uint32_t> numbers;
    std::vector<Key> triangles;
    const auto shuffled = [&](Key key) {
      std::shuffle(key.begin(), key.end(), random);
      return key;
    };
    for (int i = 0; i < 2000; ++i) {
      // Half of them at the first vertex, a quarter at the last one.
      Key key{i % 2 == 0 ? 0 : any(), i % 4 == 1 ? kVertices - 1 : any(), any()};
      std::sort(key.begin(), key.end());
      if (key[0] == key[1] || key[1] == key[2]) continue;
      if (numbers.try_emplace(key, static_cast<std::uint32_t>(triangles.size())).second)
        triangles.push_back(shuffled(key));
    }
    const GroundedTable table(kVertices, triangles);
    for (const auto& [key, number] : numbers) CHECK(table.find(shuffled(key)) == number);
    for (int i = 0; i < 2000; ++i) {
      Key key{i % 2 == 0 ? 0 : any(), any(), any()};
      std::sort(key.begin(), key.end());
      const auto known = numbers.find(key);
      CHECK(table.find(shuffled(key)) == (known == numbers.end() ? kNone : known->second));
    }
  }
  CHECK(GroundedTable(3, {}).find({2, 0, 1}) == kNone);
}
