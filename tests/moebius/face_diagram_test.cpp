#include "../../moebius/face_diagram.h"

#include "face_cells.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

void check_cell(const Cell& cell, double reach) {
  const Diagrams arcs = all_arcs(cell);
  for (std::uint32_t f = 0; f < cell.planes.size(); ++f) {
    CAPTURE(f);
    const std::size_t checked = check_by_scan(arcs[f], sites_of(cell, f), reach, 60, reach * 1e-7);
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
