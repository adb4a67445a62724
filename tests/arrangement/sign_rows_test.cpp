#include "../../arrangement/sign_rows.h"

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <vector>

using namespace crossloft;

namespace {

__extension__ using Int128 = __int128;

/// In integers that hold it.
int side(const LatticePlane& plane, const LatticeVector& x) {
  Int128 sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += Int128{plane.normal[k]} * (x[k] - plane.origin[k]);
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

/// Planes with small normals through points of a small grid, so that points often lie on them.
struct Scene {
  Scene(std::uint32_t seed, std::size_t count, std::int64_t step) : random(seed), scale(step) {
    for (std::size_t p = 0; p < count; ++p) {
      LatticePlane plane{};
      while (plane.normal == LatticeVector{}) plane.normal = {below(7) - 3, below(7) - 3, below(7) - 3};
      plane.origin = point();
      planes.push_back(plane);
    }
  }

  std::int64_t below(std::uint32_t n) { return random() % n; }
  LatticeVector point() { return {scale * (below(5) - 2), scale * (below(5) - 2), scale * (below(5) - 2)}; }
  std::vector<int> signs(const LatticeVector& x) const {
    std::vector<int> list;
    for (const LatticePlane& plane : planes) list.push_back(side(plane, x));
    return list;
  }

  std::mt19937 random;
  std::int64_t scale;
  std::vector<LatticePlane> planes;
};

void check_row(const SignRows& rows, std::uint32_t row, const std::vector<int>& signs) {
  REQUIRE(row < rows.size());
  REQUIRE(rows[row].pos.size() == sign_words(signs.size()));
  std::uint32_t through = 0;
  for (std::uint32_t p = 0; p < signs.size(); ++p) {
    CHECK(sign_at(rows[row], PlaneId(p)) == signs[p]);
    CHECK(!(has_bit(rows[row].pos, PlaneId(p)) && has_bit(rows[row].zero, PlaneId(p))));
    through += signs[p] == 0 ? 1U : 0U;
  }
  CHECK(rows.planes_through(row) == through);
  for (std::size_t p = signs.size(); p < 64 * rows.words(); ++p)
    CHECK(((rows[row].pos[p / 64] | rows[row].zero[p / 64]) >> (p % 64) & 1) == 0);
}

}  // namespace

TEST_CASE("a point's row has its signs, and points of equal signs have one row") {
  for (const std::size_t count : {0U, 1U, 9U, 64U, 65U, 130U})
    for (const std::int64_t scale : {std::int64_t{1}, std::int64_t{1} << 40}) {
      CAPTURE(count);
      Scene scene(static_cast<std::uint32_t>(count) + 1, count, scale);
      SignRows rows(scene.planes);
      std::map<std::vector<int>, std::uint32_t> known;  // as they come, which makes the table grow
      for (int i = 0; i < 400; ++i) {
        const LatticeVector x = scene.point();
        const std::vector<int> signs = scene.signs(x);
        const std::uint32_t row = rows.of(make_point(x));
        check_row(rows, row, signs);
        CHECK(known.try_emplace(signs, row).first->second == row);
      }
      CHECK(rows.size() == known.size());
      for (const auto& [signs, row] : known) check_row(rows, row, signs);
    }
}

TEST_CASE("a row like another one but for some planes") {
  Scene scene(5, 70, 3);
  SignRows rows(scene.planes);
  for (int i = 0; i < 300; ++i) {
    const LatticeVector x = scene.point(), y = scene.point();
    const std::vector<int> from = scene.signs(x), to = scene.signs(y);
    std::vector<std::uint32_t> across;
    for (std::uint32_t p = 0; p < 70; ++p)
      if (from[p] != to[p] || p % 5 == 0) across.push_back(p);
    const std::uint32_t like = rows.of(make_point(x)), row = rows.of(make_point(y), like, across);
    check_row(rows, row, to);
    CHECK(rows.of(make_point(y)) == row);
    CHECK(rows.of(make_point(x), row, across) == like);
  }
}
