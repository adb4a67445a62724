/// Pairs at hubs: all that meet, against all pairs; few of those that do not.

#include "../../reconstruct/close_pairs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "../../geom/box_tree.h"
#include "../../geom/triangle_meeting.h"
#include "../../reconstruct/contacts.h"

using namespace crossloft;

namespace {

using Pair = std::array<std::uint32_t, 2>;

Corners corners(const Surface& surface, std::uint32_t t) {
  const auto& c = surface.triangles[t];
  return {surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]};
}

std::vector<Pair> found_pairs(const Surface& surface, const std::vector<std::uint8_t>& asked,
                              SameCorner same) {
  std::vector<Pair> pairs;
  for_close_pairs(surface, asked, same, nullptr, [&](std::uint32_t s, std::uint32_t t) {
    pairs.push_back({std::min(s, t), std::max(s, t)});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// As find_contacts() asks.
bool touches(const Surface& surface, const Pair& pair) {
  auto a = surface.triangles[pair[0]], b = surface.triangles[pair[1]];
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
    if (at == b.end()) continue;
    std::swap(*at, b[shared]);
    std::swap(a[i], a[shared]);
    ++shared;
  }
  const auto placed = [&](const auto& t) {
    return Corners{surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
  };
  return shared == 3 || touch(placed(a), placed(b), static_cast<int>(shared));
}

/// Three hubs, two of them at one place, amid triangles without; on a coarse grid, so that much coincides.
Surface hubs_at_random(std::uint32_t seed, std::uint32_t range) {
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  const auto coordinate = [&] { return static_cast<double>(below(range)) - range / 2; };
  Surface surface;
  const std::uint32_t count = 60;
  for (std::uint32_t v = 0; v < count; ++v)
    surface.points.push_back({coordinate(), coordinate(), coordinate()});
  surface.points[1] = surface.points[0];
  for (std::uint32_t i = 0; i < 260; ++i) {
    const std::uint32_t hub = i % 4 == 3 ? below(count) : i % 4;
    std::array<std::uint32_t, 3> t{hub, below(count), below(count)};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    std::rotate(t.begin(), t.begin() + i % 3, t.end());
    surface.triangles.push_back(t);
  }
  return surface;
}

/// A cone over n points around a tip, closed by a fan below.
Surface cone(std::uint32_t n) {
  Surface surface{{{0.1, 0.2, 1}, {0.3, 0.1, 0}}, {}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    surface.points.push_back({std::cos(angle), 0.7 * std::sin(angle), 0});
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
    surface.triangles.push_back({0, a, b});
    surface.triangles.push_back({b, a, 1});
  }
  return surface;
}

}  // namespace

TEST_CASE("hubs: all pairs that meet are visited, once, and none whose boxes are apart") {
  std::size_t crossing = 0, touching = 0, left_out = 0;
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    CAPTURE(seed);
    Surface surface = hubs_at_random(seed, seed % 3 == 0 ? 5 : seed % 3 == 1 ? 9 : 4000);
    for (Vec3& p : surface.points) p = (seed < 16 ? 1 : seed < 20 ? 0x1p290 : 0x1p-290) * p;
    std::vector<std::uint8_t> asked(surface.triangles.size(), 1);
    if (seed % 2 == 1)
      for (std::size_t t = 0; t < asked.size(); ++t) asked[t] = t % 3 == 0 ? 1 : 0;
    const std::vector<Pair> by_place = found_pairs(surface, asked, SameCorner::place),
                            by_index = found_pairs(surface, asked, SameCorner::index);
    CHECK(std::adjacent_find(by_place.begin(), by_place.end()) == by_place.end());
    CHECK(std::adjacent_find(by_index.begin(), by_index.end()) == by_index.end());
    for (std::uint32_t t = 0; t < asked.size(); ++t)
      for (std::uint32_t s = 0; s < t; ++s) {
        const Corners a = corners(surface, s), b = corners(surface, t);
        const bool in_place = std::binary_search(by_place.begin(), by_place.end(), Pair{s, t});
        const bool in_index = std::binary_search(by_index.begin(), by_index.end(), Pair{s, t});
        if (!overlap(bounds_of(a), bounds_of(b)) || (asked[s] | asked[t]) == 0) {
          CHECK_FALSE((in_place || in_index));
          continue;
        }
        const bool crosses = meeting(a, b) != Meeting::none, contact = touches(surface, {s, t});
        if (crosses) CHECK(in_place);
        if (contact) CHECK(in_index);
        crossing += crosses ? 1U : 0U;
        touching += contact ? 1U : 0U;
        left_out += in_place ? 0U : 1U;
      }
  }
  MESSAGE(crossing << " cross, " << touching << " touch, " << left_out << " left out");
  CHECK(crossing > 10000);
  CHECK(touching > crossing);
  CHECK(left_out > 10000);
}

TEST_CASE("hubs: what only has its tip in common is left out, wherever it is and however small") {
  const Surface near = cone(1000);
  const std::vector<std::uint8_t> all(near.triangles.size(), 1);
  for (const double size : {1.0, 0x1p300, 0x1p-280})
    for (const double away : {0.0, 0x1p22}) {
      CAPTURE(size);
      CAPTURE(away);
      Surface surface = near;
      for (Vec3& p : surface.points) p = size * (p + Vec3{away, away, -away});
      for (const SameCorner same : {SameCorner::place, SameCorner::index})
        CHECK(found_pairs(surface, all, same).size() < 20 * all.size());
    }
  CHECK(find_contacts(near).empty());
}

TEST_CASE("close pairs: a raised flag ends the visits") {
  const Surface surface = cone(300);
  std::atomic<bool> flag{false};
  std::size_t visits = 0;
  for_close_pairs(surface, std::vector<std::uint8_t>(surface.triangles.size(), 1), SameCorner::place, &flag,
                  [&](std::uint32_t, std::uint32_t) {
                    ++visits;
                    flag = true;
                  });
  CHECK(visits == 1);
}
