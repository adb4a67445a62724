#include "../../moebius/face_diagram.h"

#include "face_cells.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

void check_cell(const Cell& cell, double reach) {
  const Diagrams arcs = all_arcs(cell);
  for (std::uint32_t f = 0; f < cell.planes.size(); ++f) {
    CAPTURE(f);
    const std::size_t checked =
        check_by_scan(arcs[f], sites_of(cell, f), square(4 * reach), 60, reach * 1e-7);
    CHECK(checked > 200);
  }
}

}  // namespace

TEST_CASE("boxes: nearest sites along scan lines") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    Cell cell = box_cell(1000000);
    scatter(cell, 60, 1000000, seed);
    cell.finish();
    check_cell(cell, 2e6);
  }
}

TEST_CASE("random cells: nearest sites along scan lines") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    Cell cell = random_cell(4 + seed, 1000000, seed);
    scatter(cell, 60, 40000, seed);
    cell.finish();
    check_cell(cell, 2e6);
  }
}

TEST_CASE("a region may lose only what is outside it") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    Cell cell = random_cell(6, 1000000, seed);
    scatter(cell, 100, 40000, seed);
    cell.finish();
    const Box2 region{{-3e5, -1e5}, {5e5, 4e5}};
    std::vector<Box2> regions(cell.planes.size(), region);
    regions[0] = {{1, 1}, {0, 0}};
    const Diagrams arcs = all_arcs(cell, regions), all = all_arcs(cell);
    CHECK(arcs[0].empty());
    for (std::uint32_t f = 1; f < cell.planes.size(); ++f) {
      CHECK(check_by_scan(arcs[f], sites_of(cell, f), region, 60, 0.1) > 100);
      CHECK(arcs[f].size() < all[f].size());
    }
  }
}
