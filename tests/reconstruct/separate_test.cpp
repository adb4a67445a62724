/// Copies of one point come apart, where nothing is in the way and no section changes.

#include "../../reconstruct/separate.h"

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <numeric>
#include <random>

#include "../../inspect/check.h"
#include "../../inspect/random.h"
#include "../../inspect/slice.h"
#include "../inspect/shapes.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

std::atomic<std::size_t> largest_allocation{0};

}  // namespace

// Not inlined: GCC warns of free() for what it takes for the library's memory.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  std::size_t largest = largest_allocation.load();
  while (largest < bytes && !largest_allocation.compare_exchange_weak(largest, bytes)) {
  }
  void* const memory = std::malloc(bytes != 0 ? bytes : 1);
  if (memory == nullptr) std::abort();
  return memory;
}
// std::stable_sort asks for its buffer so; AddressSanitizer's own would not match free().
[[gnu::noinline]] void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return operator new(bytes);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using Tet = std::array<std::uint32_t, 4>;

struct Anywhere : Confinement {
  bool may_move(const Umbrella&) const override { return true; }
  bool admit(const Umbrella&, Vec3&) const override { return true; }
};

/// A surface and where its points come from.
struct Cut {
  Surface surface;
  std::vector<SurfaceVertex> origins;
};

Cut cut_apart(const std::vector<Vec3>& points, const std::vector<Tet>& tets) {
  auto glued = glue(tets);
  REQUIRE(glued.ok());
  Cut cut;
  for (const SurfaceVertex& v : glued->vertices)
    cut.surface.points.push_back(v.is_midpoint() ? 0.5 * (points[v.a] + points[v.b]) : points[v.a]);
  cut.surface.triangles = glued->triangles;
  cut.origins = glued->vertices;
  return cut;
}

/// One origin each, but for vertices at equal coordinates: those get the same and stand together.
Cut with_origins(Surface surface) {
  Cut cut;
  std::vector<std::uint32_t> order(surface.points.size()), number(surface.points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return surface.points[a] < surface.points[b]; });
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
    const bool repeats = i > 0 && cut.surface.points.back() == surface.points[order[i]];
    cut.origins.push_back({repeats ? cut.origins.back().a : i, kNone});
    cut.surface.points.push_back(surface.points[order[i]]);
  }
  for (const auto& t : surface.triangles)
    cut.surface.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return cut;
}

struct Judged {
  CheckReport surface, welded;
};

Judged judge(const Surface& surface) { return {check_surface(surface), check_surface(welded(surface))}; }

/// What holds of every separation; returns the result for more.
Separation checked(Cut& cut, const Confinement& confinement = Anywhere{}) {
  const std::vector<Vec3> before = cut.surface.points;
  const Judged was = judge(cut.surface);
  const Separation s = separate_copies(cut.surface, cut.origins, confinement);
  const Judged is = judge(cut.surface);
  CHECK(is.surface.good_topology() == was.surface.good_topology());
  CHECK(is.surface.crossings <= was.surface.crossings);
  CHECK(is.surface.overlaps == was.surface.overlaps);
  CHECK(is.surface.flat_triangles == was.surface.flat_triangles);
  CHECK(is.surface.repeated_points <= was.surface.repeated_points);
  CHECK(is.surface.inverted == was.surface.inverted);
  CHECK(is.surface.cavities == was.surface.cavities);
  CHECK(is.welded.nonmanifold_vertices <= was.welded.nonmanifold_vertices);
  std::uint32_t moved = 0;
  double largest = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    const bool copy = (v > 0 && cut.origins[v] == cut.origins[v - 1]) ||
                      (v + 1 < before.size() && cut.origins[v] == cut.origins[v + 1]);
    if (!copy) CHECK(before[v] == cut.surface.points[v]);
    moved += before[v] != cut.surface.points[v];
    largest = std::max(largest, norm(before[v] - cut.surface.points[v]));
  }
  CHECK(moved == s.separated);
  CHECK(largest == s.largest);
  // Different origins are different places here, so what touches are the copies that welding makes one.
  CHECK(s.touching.size() == cut.surface.points.size() - welded(cut.surface).points.size());
  return s;
}

const std::vector<Vec3> kCubeCorners{{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                                     {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};

/// Points of an n x n x n grid, a little off it so that few are coplanar, its cubes cut into six tetrahedra
/// each (Kuhn).
struct Grid {
  std::vector<Vec3> points;
  std::vector<Tet> tets;

  explicit Grid(std::uint32_t n, double off = 0) {
    Random random(n);
    const auto jitter = [&] { return random.uniform(-off, off); };
    for (std::uint32_t i = 0; i < n * n * n; ++i) {
      const double x = i / (n * n) + jitter(), y = i / n % n + jitter(), z = i % n + jitter();
      points.push_back({x, y, z});
    }
    std::array<std::uint32_t, 3> step{n * n, n, 1};
    do {
      for (std::uint32_t i = 0; i < n * n * n; ++i)
        if (i / (n * n) + 1 < n && i / n % n + 1 < n && i % n + 1 < n) add(i, step);
    } while (std::next_permutation(step.begin(), step.end(), std::greater<>()));
  }
  void add(std::uint32_t i, const std::array<std::uint32_t, 3>& step) {
    Tet t{i, i + step[0], i + step[0] + step[1], i + step[0] + step[1] + step[2]};
    const Vec3 a = points[t[0]];
    if (dot(points[t[1]] - a, cross(points[t[2]] - a, points[t[3]] - a)) < 0) std::swap(t[2], t[3]);
    tets.push_back(t);
  }
};

}  // namespace

TEST_CASE("two tetrahedra with a common vertex draw back from each other") {
  Cut cut = cut_apart(kCubeCorners, {{0, 1, 2, 3}, {0, 5, 4, 6}});
  CHECK(judge(cut.surface).welded.nonmanifold_vertices == 1);
  const Separation s = checked(cut);
  CHECK(s.separated == 2);
  CHECK(s.touching.empty());
  CHECK(s.largest == doctest::Approx(0.02));
  CHECK(judge(cut.surface).welded.good_topology());
  CHECK(judge(cut.surface).surface.volume < 2.0 / 6);
}

TEST_CASE("two tetrahedra with a common edge come apart at both ends") {
  Cut cut = cut_apart(kCubeCorners, {{0, 3, 1, 2}, {0, 3, 4, 5}});
  CHECK(judge(cut.surface).welded.crowded_edges == 1);
  const Separation s = checked(cut);
  CHECK(s.separated == 4);
  CHECK(s.touching.empty());
  CHECK(judge(cut.surface).welded.good_topology());
}

TEST_CASE("an annular link: two voids that touch at a vertex inside the solid shrink away from each other") {
  const Grid grid(5);
  const std::uint32_t centre = 2 * 25 + 2 * 5 + 2;
  std::vector<Tet> around, tets;
  for (const Tet& t : grid.tets)
    if (std::find(t.begin(), t.end(), centre) != t.end()) around.push_back(t);
  const Tet first = around.front();
  const auto apart = std::find_if(around.begin(), around.end(), [&](const Tet& t) {
    return std::none_of(t.begin(), t.end(), [&](std::uint32_t v) {
      return v != centre && std::find(first.begin(), first.end(), v) != first.end();
    });
  });
  REQUIRE(apart != around.end());
  for (const Tet& t : grid.tets)
    if (t != first && t != *apart) tets.push_back(t);
  Cut cut = cut_apart(grid.points, tets);
  const double volume = judge(cut.surface).surface.volume;
  const Separation s = checked(cut);
  CHECK(s.separated == 2);
  CHECK(s.touching.empty());
  const Judged after = judge(cut.surface);
  CHECK(after.welded.good_topology());
  CHECK(after.surface.cavities == 2);
  CHECK(after.surface.volume > volume);
}

// Every other tetrahedron around the edge 0-1 is missing, but its ends are wrapped up all around
// (glue_test.cpp).
TEST_CASE("midpoints of a split edge draw back into their wedges") {
  std::vector<Vec3> points{{0, 0, 1}, {0, 0, -1}};
  const Vec3 hexagon[] = {{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
  points.insert(points.end(), hexagon, hexagon + 6);
  points.push_back({0, 0, 3});
  points.push_back({0, 0, -3});
  std::vector<Tet> tets;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % 6;
    if (i % 2 == 0) tets.push_back({1, 0, a, b});
    tets.push_back({0, 8, a, b});
    tets.push_back({9, 1, a, b});
  }
  Cut cut = cut_apart(points, tets);
  const Separation s = checked(cut);
  CHECK(s.separated == 3 + 3 * 2);
  CHECK(s.touching.empty());
}

TEST_CASE("a raised cancel flag leaves all copies where they are") {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  SeparationEffort hard;
  hard.rounds = 8;
  for (const SeparationEffort& effort : {SeparationEffort{}, hard}) {
    Cut cut = cut_apart(kCubeCorners, {{0, 1, 2, 3}, {0, 5, 4, 6}});
    const std::vector<Vec3> before = cut.surface.points;
    const Separation s = separate_copies(cut.surface, cut.origins, Anywhere{}, effort, context);
    CHECK(s.separated == 0);
    CHECK(s.touching.size() == 1);
    CHECK(cut.surface.points == before);
  }
}

TEST_CASE("what is in the way shortens the step, or undoes it") {
  for (const double gap : {0.5, 0.01, 0.004, 1e-5}) {
    CAPTURE(gap);
    Surface mesh = tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    append(mesh, tetrahedron({0, 0, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 0, -1}));
    // A small void on the way: the tip must not pass it.
    const double g = gap / 1.75, size = g / 4;
    append(mesh, inside_out(tetrahedron({g, g, g}, {g + size, g, g}, {g, g + size, g}, {g, g, g + size})));
    Cut cut = with_origins(mesh);
    const Separation s = checked(cut);
    CHECK(s.separated == (gap < 1e-3 ? 1 : 2));
    CHECK(s.touching.empty());  // one of two is enough
  }
}

// The planes of the wider cone's sides have the narrow one on both sides.
TEST_CASE("two hubs of n triangles at one place take no memory of n^2") {
  constexpr std::uint32_t kSides = 1300;
  Surface mesh;
  for (const double z : {1.0, -1.0}) {
    const auto tip = static_cast<std::uint32_t>(mesh.points.size()), rim = tip + 2;
    const double radius = z > 0 ? 0.3 : 1, turn = z > 0 ? 0 : 0.3;
    mesh.points.insert(mesh.points.end(), {{0, 0, 0}, {0, 0, 2 * z}});
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const double angle = 6.283185307179586 * (i + turn) / kSides;
      mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
      std::array<std::uint32_t, 2> side{rim + i, rim + (i + 1) % kSides};
      if (z < 0) std::swap(side[0], side[1]);
      mesh.triangles.push_back({tip, side[1], side[0]});
      mesh.triangles.push_back({tip + 1, side[0], side[1]});
    }
  }
  Cut cut = with_origins(mesh);
  largest_allocation = 0;
  const Separation s = separate_copies(cut.surface, cut.origins, Anywhere{});
  CHECK(s.separated == 2);
  CHECK(s.touching.empty());
  CHECK(largest_allocation < std::size_t{kSides} * kSides);
  CHECK(check_surface(cut.surface).crossings == 0);
}

TEST_CASE("copies with too much around them stay, and are counted") {
  const std::vector<Tet> far_and_near{
      {0, 1, 2, 3}, {0, 5, 4, 6}, {7, 8, 9, 10}, {7, 12, 11, 13}, {7, 14, 15, 16}};
  std::vector<Vec3> points = kCubeCorners;
  for (const Vec3& p : kCubeCorners) points.push_back(p + Vec3{10, 0, 0});
  for (const Vec3& p : {Vec3{1, -1, 1}, Vec3{1, -1, 2}, Vec3{2, -1, 1}}) points.push_back(p + Vec3{10, 0, 0});
  Cut cut = cut_apart(points, far_and_near);
  SeparationEffort effort;
  effort.most_around = 8;  // the first two have each other's four triangles around them, the others twelve
  const std::vector<Vec3> before = cut.surface.points;
  const Separation s = separate_copies(cut.surface, cut.origins, Anywhere{}, effort);
  CHECK(s.separated == 2);
  CHECK(s.crowded.size() == 3);
  CHECK(s.touching.size() == 2);
  for (std::size_t v = 0; v < before.size(); ++v)
    if (before[v].x >= 9) CHECK(before[v] == cut.surface.points[v]);
  effort.most_around = 12;
  CHECK(separate_copies(cut.surface, cut.origins, Anywhere{}, effort).crowded.empty());
}

TEST_CASE("a confinement is asked, and obeyed to the bit") {
  struct Half : Confinement {
    bool may_move(const Umbrella& u) const override { return u.triangles.size() == 3; }
    bool admit(const Umbrella&, Vec3& place) const override {
      place.x = 0x1p-7 * std::floor(0x1p7 * place.x);
      return place.x >= 0;
    }
  };
  Cut cut = cut_apart(kCubeCorners, {{0, 1, 2, 3}, {0, 5, 4, 6}});
  const Separation s = checked(cut, Half{});
  CHECK(s.separated == 1);
  CHECK(s.touching.empty());
  CHECK(std::count_if(cut.surface.points.begin(), cut.surface.points.end(),
                      [](const Vec3& p) { return p.x == 0x1p-7; }) == 1);
  struct Nowhere : Anywhere {
    bool may_move(const Umbrella&) const override { return false; }
  };
  cut = cut_apart(kCubeCorners, {{0, 1, 2, 3}, {0, 5, 4, 6}});
  const std::vector<Vec3> before = cut.surface.points;
  CHECK(checked(cut, Nowhere{}).touching.size() == 1);
  CHECK(cut.surface.points == before);
}

TEST_CASE("random subsets of a grid: no crossing appears, most contacts go") {
  for (const double off : {0.0, 0.1}) {
    const Grid grid(5, off);
    std::uint64_t copies = 0, touching = 0, welded_before = 0, welded_after = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
      CAPTURE(seed);
      Random random(seed);
      std::vector<Tet> tets;
      for (const Tet& t : grid.tets)
        if (random.next() % 10 < 1 + seed % 9) tets.push_back(t);
      Cut cut = cut_apart(grid.points, tets);
      copies += cut.surface.points.size() - welded(cut.surface).points.size();
      welded_before += judge(cut.surface).welded.nonmanifold_vertices;
      touching += checked(cut).touching.size();
      welded_after += judge(cut.surface).welded.nonmanifold_vertices;
    }
    MESSAGE("off grid by " << off << ": " << copies << " copies, " << touching
                           << " left; vertices not manifold when welded " << welded_before << " -> "
                           << welded_after);
    CHECK(copies > 1000);
    CHECK(touching < copies / 4);
    CHECK(welded_after < welded_before / 4);
  }
}

TEST_CASE("solids by planes: sections stay, contacts go, threads and --keep-touching leave no other trace") {
  struct Scene {
    const char* name;
    Surface mesh;
    std::uint32_t planes;
  };
  const Scene scenes[] = {{"torus", torus(1, 0.4, 40, 20), 12},
                          {"genus 3", genus3_solid(20), 14},
                          {"vessel", vessel_solid(20), 14},
                          {"shells", nested_shells(16), 12}};
  std::uint64_t copies = 0, left = 0, welded_before = 0, welded_after = 0;
  for (const Scene& scene : scenes)
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      CAPTURE(std::string(scene.name));
      CAPTURE(seed);
      const auto sections =
          slice(scene.mesh, random_planes(bounds_of(scene.mesh.points), scene.planes, seed));
      REQUIRE(sections.ok());
      Options apart;
      apart.mode = PruneMode::joint;  // most of its copies carry no contour edge and can move
      Options touching = apart;
      touching.separate = false;
      Context one, two;
      one.threads = 1, two.threads = 2;
      const auto before = reconstruct(*sections, touching, one), after = reconstruct(*sections, apart, one);
      REQUIRE(before.ok());
      REQUIRE(after.ok());
      CHECK(hash(*after) == hash(*reconstruct(shuffled(*sections, seed), apart, two)));

      CHECK(before->surface.triangles == after->surface.triangles);
      CHECK(before->solid.points == after->solid.points);
      CHECK(before->report.volume == after->report.volume);
      CHECK(before->report.touching_copies == before->report.vertex_copies);
      CHECK(before->report.separated_copies == 0);
      std::uint32_t moved = 0;
      for (std::size_t v = 0; v < after->surface.points.size(); ++v)
        moved += before->surface.points[v] != after->surface.points[v];
      CHECK(moved == after->report.separated_copies);
      CHECK(after->report.touching_copies + moved >= after->report.vertex_copies);

      const Judged was = judge(before->surface), is = judge(after->surface);
      CHECK(is.surface.good_topology());
      CHECK(is.surface.crossings == 0);
      CHECK(is.surface.overlaps <= was.surface.overlaps);
      CHECK(is.surface.inverted == was.surface.inverted);
      CHECK(is.surface.cavities == was.surface.cavities);
      CHECK(is.welded.nonmanifold_vertices <= was.welded.nonmanifold_vertices);
      const SectionCheck met = check_sections(before->surface, before->sections),
                         meets = check_sections(after->surface, after->sections);
      for (std::size_t p = 0; p < met.planes.size(); ++p) {
        CHECK(meets.planes[p].difference_area() <= met.planes[p].difference_area() + 1e-12);
        CHECK(meets.planes[p].distance <= met.planes[p].distance + 1e-12);
      }
      copies += after->report.vertex_copies;
      left += after->report.touching_copies;
      welded_before += was.welded.nonmanifold_vertices;
      welded_after += is.welded.nonmanifold_vertices;
    }
  MESSAGE(copies << " copies, " << left << " left; vertices not manifold when welded " << welded_before
                 << " -> " << welded_after);
  CHECK(copies > 50);
  CHECK(left < copies / 2);
  CHECK(welded_after < welded_before / 2);
}
