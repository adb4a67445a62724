#include "../../arrangement/complex.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

#include "judge.h"
#include "plane_sets.h"

using namespace crossloft;

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

TEST_CASE("a box that is empty or too large is an error") {
  const auto code_of = [](const LatticeBox& box) {
    LatticePointStore store;
    const auto built = build_arrangement(std::vector{make_axis_plane(0, 0)}, box, store);
    return built.ok() ? ErrorCode::internal : built.error().code;
  };
  constexpr std::int64_t kMost = std::int64_t{1} << 49;
  CHECK(code_of(centred_box(kMost)) == ErrorCode::internal);
  CHECK(code_of(centred_box(kMost + 1)) == ErrorCode::too_large);
  CHECK(code_of(centred_box(std::int64_t{1} << 62)) == ErrorCode::too_large);
  CHECK(code_of({{0, 0, 0}, {1, 1, kMost + 1}}) == ErrorCode::too_large);
  CHECK(code_of({{0, 0, 0}, {1, 0, 1}}) == ErrorCode::usage);
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

TEST_CASE("a stack of parallel planes, some of them outside") {
  LatticePointStore store;
  std::vector<LatticePlane> planes;
  for (const int d : {-300, -40, -1, 0, 17, 18, 299, 500})
    planes.push_back(plane_sets::plane_of({1, 2, -3}, d));
  const Arrangement a = build_and_judge(planes, centred_box(40), store);
  CHECK(a.cell_count() == 6);
  CHECK(flats::counts(a).edges == 0);
  for (std::uint32_t c = 0; c < a.cell_count(); ++c) CHECK(sign_at(a.signs(CellId(c)), PlaneId(7)) == -1);
}

TEST_CASE("a pencil: all planes through one line") {
  LatticePointStore store;
  std::vector<LatticePlane> planes;
  for (std::int64_t i = -5; i <= 5; ++i)
    planes.push_back(make_lattice_plane({1, 2, 3}, {1, 1, 1}, {i, 1, 7}));
  const Arrangement a = build_and_judge(planes, centred_box(50), store);
  CHECK(a.cell_count() == 22);
  REQUIRE(flats::counts(a) == flats::Counts{0, 1, 22, 22});
  for (std::uint32_t i = 0; i < a.edge_count(); ++i) {
    const ArrEdgeId e(i);
    if (a.on_box(e)) continue;
    CHECK(a.signs(e).zero[0] == (1u << 11) - 1);
    CHECK(a.planes_of(e) == std::array{PlaneId(0), PlaneId(1)});
    CHECK(a.faces_around(e).size() == 22);
    CHECK(a.cells_around(e).size() == 22);
  }
}

TEST_CASE("a grid cut by all diagonal planes: many planes through each vertex") {
  LatticePointStore store;
  std::vector<LatticePlane> planes;
  for (int d = -2; d <= 2; ++d) {
    for (int axis = 0; axis < 3; ++axis) planes.push_back(make_axis_plane(axis, d));
    for (const LatticeVector& n :
         {LatticeVector{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}})
      planes.push_back(plane_sets::plane_of(n, d));
  }
  const Arrangement a = build_and_judge(planes, {{-3, -3, -3}, {3, 3, 3}}, store);
  const Location centre = a.locate(make_point({0, 0, 0}));
  REQUIRE(centre.dimension == 0);
  CHECK(flats::planes_through(a, ArrVertexId(centre.index)).size() == 9);
  CHECK(a.cells_around(ArrVertexId(centre.index)).size() == 48);  // the chambers of the Coxeter group B3
}

TEST_CASE("planes that touch the box in a corner, an edge or a face") {
  LatticePointStore store;
  const std::vector<LatticePlane> planes{
      plane_sets::plane_of({1, 1, 1}, 30),  // the upper corner alone
      plane_sets::plane_of({1, 1, 0}, 20),  // an edge alone
      make_axis_plane(2, -10),              // a face
      make_axis_plane(0, 10),               // a face
      plane_sets::plane_of({1, -1, 0}, 0),  // through two edges
      plane_sets::plane_of({1, 1, 1}, 10),  // through three corners
  };
  const Arrangement a = build_and_judge(planes, centred_box(10), store);
  CHECK(a.cell_count() == 4);
  CHECK(flats::planes_through(a, ArrVertexId(a.vertex_count() - 1)).size() == 7);
  for (std::uint32_t i = 0; i < a.edge_count(); ++i) {
    const auto [p, q] = a.planes_of(ArrEdgeId(i));
    CHECK(cross(a.plane(p).normal, a.plane(q).normal) != LatticeVector{});
  }
}

TEST_CASE("100 planes tangent to a cylinder: a cell with over 64 faces") {
  LatticePointStore store;
  const auto planes = plane_sets::cylinder_tangents(100, std::int64_t{1} << 40);
  const Arrangement a = build(planes, centred_box(std::int64_t{1} << 41), store);
  const Location inner = a.locate(make_point({0, 0, 0}));
  REQUIRE(inner.dimension == 3);
  const auto faces = a.faces_of(CellId(inner.index));
  CHECK(faces.size() == 102);
  CHECK(std::count_if(faces.begin(), faces.end(), [&](FaceId f) { return a.on_box(f); }) == 2);
  CHECK(a.words() == 2);
  const auto& signs = a.signs(CellId(inner.index));
  CHECK((signs.pos[0] | signs.pos[1] | signs.zero[0] | signs.zero[1]) == 0);
}

TEST_CASE("random planes of few coordinates: all degeneracies at once") {
  const std::uint64_t seed = 20070131;
  MESSAGE("seed ", seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 60; ++round) {
    LatticePointStore store;
    const auto planes =
        plane_sets::distinct(plane_sets::random_planes(random, 4 + random() % 12, 3, 1 + round % 3));
    build_and_judge(planes, {{-5, -4, -3}, {4, 3, 6}}, store);
  }
}

TEST_CASE("random planes in general position") {
  std::mt19937_64 random(7);
  const std::int64_t bound = std::int64_t{1} << 49;
  for (const std::size_t count : {1u, 2u, 3u, 8u, 15u}) {
    LatticePointStore store;
    build_and_judge(plane_sets::random_planes(random, count, bound / 2, 1 << 19), centred_box(bound), store);
  }
}

TEST_CASE("general position with all crossings inside the box: the closed formula") {
  LatticePointStore store;
  std::vector<LatticePlane> planes;
  for (std::int64_t i = 0; i < 14; ++i)  // osculating planes of the moment curve: every three meet
    planes.push_back(make_lattice_plane({i, i * i, i * i * i}, {1, 2 * i, 3 * i * i}, {0, 1, 3 * i}));
  const Arrangement a = build(planes, centred_box(std::int64_t{1} << 49), store);
  const std::size_t k = planes.size();
  const std::size_t pairs = k * (k - 1) / 2, triples = k * (k - 1) * (k - 2) / 6;
  CHECK(flats::counts(a) ==
        flats::Counts{triples, pairs + 3 * triples, k + 2 * pairs + 3 * triples, 1 + k + pairs + triples});
  check_volumes(a);
}

TEST_CASE("lattice points are located in the element that has their signs") {
  std::mt19937_64 random(5);
  LatticePointStore store;
  const auto planes = plane_sets::distinct(plane_sets::random_planes(random, 12, 6, 2));
  const Arrangement a = build(planes, centred_box(10), store);
  std::array<int, 4> hits{};
  for (int i = 0; i < 4000; ++i) {
    const LatticePoint p = make_point(plane_sets::random_vector(random, 9));
    const Location found = a.locate(p);
    REQUIRE(found.found());
    ++hits[found.dimension];
    const SignView signs = found.dimension == 0   ? a.signs(ArrVertexId(found.index))
                           : found.dimension == 1 ? a.signs(ArrEdgeId(found.index))
                           : found.dimension == 2 ? a.signs(FaceId(found.index))
                                                  : a.signs(CellId(found.index));
    for (std::uint32_t q = 0; q < a.plane_count(); ++q)
      REQUIRE(sign_at(signs, PlaneId(q)) == side_of_plane(a.plane(PlaneId(q)), p));
  }
  for (const int h : hits) CHECK(h > 0);
  const std::vector<SignWord> none(a.words()), all(a.words(), (1u << planes.size()) - 1);
  CHECK_FALSE(a.locate(SignView{none, all}).found());  // no point is on all planes
}

TEST_CASE("incidence by signs is incidence by lists") {
  std::mt19937_64 random(9);
  LatticePointStore store;
  const Arrangement a =
      build(plane_sets::distinct(plane_sets::random_planes(random, 9, 3, 2)), centred_box(7), store);
  for (std::uint32_t v = 0; v < a.vertex_count(); ++v) {
    std::vector<CellId> cells;
    for (std::uint32_t c = 0; c < a.cell_count(); ++c)
      if (in_closure(a.signs(ArrVertexId(v)), a.signs(CellId(c)))) cells.emplace_back(c);
    const auto listed = a.cells_around(ArrVertexId(v));
    CHECK(std::equal(cells.begin(), cells.end(), listed.begin(), listed.end()));
  }
}

TEST_CASE("a raised flag cancels") {
  LatticePointStore store;
  const std::atomic<bool> stop{true};
  Context context;
  context.cancel = &stop;
  const auto result = build_arrangement(std::vector{make_axis_plane(0, 1)}, centred_box(5), store, context);
  REQUIRE_FALSE(result.ok());
  CHECK(result.error().code == ErrorCode::cancelled);
}
