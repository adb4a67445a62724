#include "../../arrangement/complex.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "flats.h"
#include "plane_sets.h"

using namespace crossloft;
using flats::Counts;

namespace {

Arrangement build(const std::vector<LatticePlane>& planes, const LatticeBox& box, LatticePointStore& store) {
  auto result = build_arrangement(planes, box, store);
  REQUIRE(result.ok());
  REQUIRE(result->verify() == "");
  return std::move(result).value();
}

void check_volumes(const Arrangement& a) {
  const auto x = flats::all_coordinates(a);
  mpq_class sum, box = 6;
  for (std::uint32_t c = 0; c < a.cell_count(); ++c) {
    const mpq_class volume = flats::six_volumes(a, CellId(c), x);
    CHECK(volume > 0);
    sum += volume;
  }
  for (std::size_t k = 0; k < 3; ++k) box *= flats::big(a.box().upper[k] - a.box().lower[k]);
  CHECK(sum == box);
}

/// Counts against the referee, volumes against the box.
Arrangement build_and_judge(const std::vector<LatticePlane>& planes, const LatticeBox& box,
                            LatticePointStore& store) {
  Arrangement a = build(planes, box, store);
  CHECK(flats::counts(a) == flats::Flats(planes, box).expected());
  check_volumes(a);
  return a;
}

}  // namespace

TEST_CASE("the box alone is one cell") {
  LatticePointStore store;
  const Arrangement a = build({}, {{-3, -2, -1}, {5, 7, 11}}, store);
  CHECK(a.vertex_count() == 8);
  CHECK(a.edge_count() == 12);
  CHECK(a.face_count() == 6);
  CHECK(a.cell_count() == 1);
  check_volumes(a);
  CHECK(a.locate(make_point({0, 0, 0})) == Location{3, 0});
  CHECK_FALSE(a.locate(make_point({5, 0, 0})).found());
  CHECK_FALSE(a.locate(make_point({9, 0, 0})).found());
}

TEST_CASE("grids of axis planes") {
  LatticePointStore store;
  std::vector<LatticePlane> planes;
  const std::array<int, 3> counts{4, 3, 5};
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < counts[static_cast<std::size_t>(axis)]; ++i)
      planes.push_back(make_axis_plane(axis, 10 * i - 20));
  const Arrangement a = build_and_judge(planes, centred_box(100), store);
  CHECK(a.cell_count() == 5 * 4 * 6);
  CHECK(flats::counts(a).vertices == 4 * 3 * 5);
  CHECK(store.size() == 0);  // all vertices are integral
}

TEST_CASE("random planes of few coordinates: all degeneracies at once") {
  const std::uint64_t seed = 20070131;
  MESSAGE("seed ", seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 60; ++round) {
    LatticePointStore store;
    const auto planes =
        plane_sets::distinct(plane_sets::random_planes(random, 4 + random() % 12, 3, 1 + round % 3));
    build_and_judge(planes, {{-5, -4, -3}, {4, 5, 6}}, store);
  }
}

TEST_CASE("random planes in general position") {
  std::mt19937_64 random(7);
  for (const std::size_t count : {1u, 2u, 3u, 8u, 15u}) {
    LatticePointStore store;
    const std::int64_t bound = std::int64_t{1} << 49;
    build_and_judge(plane_sets::random_planes(random, count, bound / 2, 1 << 19), centred_box(bound), store);
  }
}
