#include "../../moebius/cutting.h"

#include <numbers>

#include "face_cells.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Counter-clockwise polygons have the section inside, clockwise ones are holes.
std::vector<DirectedWall> walls_of(const std::vector<std::vector<Vec2>>& polygons) {
  std::vector<DirectedWall> walls;
  for (const auto& polygon : polygons)
    for (std::size_t k = 0; k < polygon.size(); ++k)
      walls.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  return walls;
}

std::vector<Vec2> circle(double radius, std::size_t n, bool clockwise) {
  std::vector<Vec2> polygon;
  for (std::size_t k = 0; k < n; ++k) {
    const double t = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    polygon.push_back({radius * std::cos(t), (clockwise ? -1 : 1) * radius * std::sin(t)});
  }
  return polygon;
}

std::vector<NumberedSite> numbered(const std::vector<FaceSite>& sites) {
  std::vector<NumberedSite> list;
  for (std::uint32_t v = 0; v < sites.size(); ++v)
    if (sites[v].height > 0) list.push_back({v, sites[v]});
  return list;
}

bool in_section(const std::vector<DirectedWall>& walls, Vec2 p) {
  int winding = 0;
  for (const DirectedWall& w : walls) {
    const double turn = cross(w.to - w.from, p - w.from);
    if (w.from.y <= p.y && w.to.y > p.y && turn > 0) ++winding;
    if (w.from.y > p.y && w.to.y <= p.y && turn < 0) --winding;
  }
  return winding > 0;
}

/// By flooding a grid of n x n points: pieces of at least `least` points per vertex.
std::vector<std::uint32_t> flooded(const std::vector<FaceSite>& sites, const std::vector<DirectedWall>& walls,
                                   double reach, std::size_t n, std::size_t least) {
  std::vector<std::uint32_t> label(n * n, kNone), pieces(sites.size());
  const auto at = [&](std::size_t k) {
    return reach * ((2 * static_cast<double>(k) + 1) / static_cast<double>(n) - 1);
  };
  for (std::size_t y = 0; y < n; ++y)
    for (std::size_t x = 0; x < n; ++x)
      if (const Vec2 p{at(x), at(y)}; in_section(walls, p)) label[y * n + x] = test::nearest(sites, p);
  for (std::size_t start = 0; start < n * n; ++start) {
    const std::uint32_t site = label[start];
    if (site == kNone) continue;
    std::vector<std::size_t> stack{start};
    std::size_t size = 0;
    label[start] = kNone;
    while (!stack.empty()) {
      const std::size_t k = stack.back();
      stack.pop_back();
      ++size;
      for (const std::size_t next : {k - 1, k + 1, k - n, k + n})
        if (next < n * n && label[next] == site) label[next] = kNone, stack.push_back(next);
    }
    pieces[site] += size >= least;
  }
  return pieces;
}

/// The counts agree but for a few sites whose pieces hang together by less than the grid shows.
void check_pieces(const Cell& cell, std::uint32_t face, const std::vector<DirectedWall>& walls,
                  double reach) {
  const std::vector<FaceSite> sites = sites_of(cell, face);
  const auto list = numbered(sites);
  const auto pieces = pieces_in_section(list, all_arcs(cell)[face], walls);
  const auto coarse = flooded(sites, walls, reach, 200, 1), fine = flooded(sites, walls, reach, 401, 1);
  std::size_t compared = 0, different = 0, split = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const std::uint32_t v = list[k].vertex;
    if (coarse[v] != fine[v]) continue;
    ++compared;
    split += fine[v] > 1;
    different += pieces[k] != fine[v];
  }
  CAPTURE(compared);
  CAPTURE(split);
  CHECK(compared > list.size() / 2);
  CHECK(different <= compared / 25);
}

/// Two parallel planes; over the lower one a cell between four others.
Cell five_over_three() {
  Cell cell = cell_of({make_axis_plane(2, -100), make_axis_plane(2, 100)});
  for (const LatticeVector& v :
       {LatticeVector{0, 0, 100}, {400, 10, 100}, {-390, 20, 100}, {10, 410, 100}, {0, -395, 100}})
    cell.add(make_point(v));
  for (const LatticeVector& v : {LatticeVector{900, 900, -100}, {-900, 800, -100}, {0, -900, -100}})
    cell.add(make_point(v));
  cell.finish();
  return cell;
}

}  // namespace

TEST_CASE("pieces of cells in a ring, a cross and two squares") {
  const std::vector<std::vector<std::vector<Vec2>>> sections{
      {circle(7e5, 41, false), circle(4e5, 23, true)},
      {{{9e5, -1e5},
        {9e5, 1e5},
        {1e5, 1e5},
        {1e5, 9e5},
        {-1e5, 9e5},
        {-1e5, 1e5},
        {-9e5, 1e5},
        {-9e5, -1e5},
        {-1e5, -1e5},
        {-1e5, -9e5},
        {1e5, -9e5},
        {1e5, -1e5}}},
      {{{-8e5, -5e5}, {-1e5, -5e5}, {-1e5, 5e5}, {-8e5, 5e5}},
       {{1e5, -5e5}, {8e5, -5e5}, {8e5, 5e5}, {1e5, 5e5}}}};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    Cell cell = seed == 1 ? box_cell(1000000) : random_cell(5, 1000000, seed);
    scatter(cell, 30, 40000, seed);
    if (seed == 1) scatter(cell, 30, 1000000, seed);
    cell.finish();
    for (const auto& section : sections) check_pieces(cell, 0, walls_of(section), 1e6);
  }
}

TEST_CASE("a section within one cell, and one that has a cell in it") {
  const Cell cell = five_over_three();
  const auto sites = numbered(sites_of(cell, 0));
  const auto arcs = all_arcs(cell)[0];
  const auto pieces = [&](const std::vector<std::vector<Vec2>>& section) {
    return pieces_in_section(sites, arcs, walls_of(section));
  };
  using Counts = std::vector<std::uint32_t>;
  CHECK(pieces({circle(50, 12, false)}) == Counts{1, 0, 0, 0, 0});
  CHECK(pieces({circle(50, 12, false), circle(20, 12, true)}) == Counts{1, 0, 0, 0, 0});
  CHECK(pieces({circle(600, 40, false)}) == Counts{1, 1, 1, 1, 1});
  CHECK(pieces({circle(600, 40, false), circle(500, 40, true)}) == Counts{0, 1, 1, 1, 1});
  CHECK(pieces({circle(600, 40, false), circle(230, 40, true)}) == Counts{4, 1, 1, 1, 1});
  CHECK(pieces({}) == Counts{0, 0, 0, 0, 0});
  CHECK(pieces_in_section({}, {}, walls_of({circle(50, 12, false)})).empty());
}

TEST_CASE("cutting arcs: between a connected cell and its neighbour that is not") {
  const Cell cell = five_over_three();
  const auto sites = numbered(sites_of(cell, 0));
  const auto arcs = all_arcs(cell)[0];
  // The cell of vertex 0 is cut in four by the hole, those of 1 to 4 are connected.
  const auto walls = walls_of({circle(600, 40, false), circle(230, 40, true)});
  const std::vector<std::array<std::uint32_t, 2>> neighbours{{0, 1}, {0, 3}, {1, 3}};
  const auto cutting = cutting_arcs(sites, arcs, walls, neighbours);
  REQUIRE(cutting.size() == 2);
  CHECK(arcs[cutting[0]].sites == neighbours[0]);
  CHECK(arcs[cutting[1]].sites == neighbours[1]);
  CHECK(cutting_arcs(sites, arcs, walls_of({circle(600, 40, false)}), neighbours).empty());
}
