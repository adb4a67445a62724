/// Points inside cells whose solid they let be what it is likely to be.

#include <algorithm>
#include <cmath>

#include "pipeline.h"

namespace crossloft {
namespace {

/// A way that is divided may still lead along external edges; what is left of it is divided again.
constexpr int kRounds = 3;

/// A point and the cell that wants it.
struct InteriorPoint {
  LatticePoint point;
  std::uint32_t cell = 0;
};

LatticePoint rounded_point(const Vec3& p) {
  const auto rounded = [](double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); };
  return make_point(LatticeVector{rounded(p.x), rounded(p.y), rounded(p.z)});
}

/// Strictly: a point on a face would be a vertex of its other cell too.
bool is_inside(const Arrangement& arrangement, CellId cell, const LatticePoint& p) {
  const std::span<const FaceId> faces = arrangement.faces_of(cell);
  return std::all_of(faces.begin(), faces.end(), [&](FaceId f) {
    const int side = arrangement.cells_of(f)[0] == cell ? -1 : 1;
    return side_of_plane(arrangement.plane(arrangement.plane_of(f)), p) == side;
  });
}

/// Of all cells, in lexicographic order, each once and new: no two cells have a point in common.
std::vector<InteriorPoint> interior_points(const Arrangement& arrangement, std::span<const CellState> cells,
                                           std::span<const LatticePoint> known) {
  const auto is_new = [&](std::uint32_t c, const LatticePoint& p) {
    return std::none_of(cells[c].interior.begin(), cells[c].interior.end(),
                        [&](std::uint32_t v) { return compare_lex(known[v], p) == 0; });
  };
  std::vector<InteriorPoint> points;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (const Vec3& place : cells[c].places) {
      const LatticePoint p = rounded_point(place);
      if (is_inside(arrangement, CellId{c}, p) && is_new(c, p)) points.push_back({p, c});
    }
  std::sort(points.begin(), points.end(),
            [](const auto& x, const auto& y) { return compare_lex(x.point, y.point) < 0; });
  const auto same = [](const auto& x, const auto& y) { return compare_lex(x.point, y.point) == 0; };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  return points;
}

}  // namespace

/// Numbers after all others. Cells with places are pruned again even if none of them is a point: joins in
/// doubt have waited.
Result<Done> Pipeline::divide_cells() {
  for (int round = 1; points_may_come_; ++round) {
    points_may_come_ = false;
    for (CellState& cell : cells_) {
      cell.due = !cell.places.empty();
      points_may_come_ |= cell.due && round < kRounds;
    }
    for (const InteriorPoint& p : interior_points(*arrangement_, cells_, numbering_.points)) {
      cells_[p.cell].interior.push_back(static_cast<std::uint32_t>(numbering_.points.size()));
      numbering_.points.push_back(p.point);
      numbering_.graph_vertex.push_back(kNone);
      ++result_.report.interior_points;
    }
    if (auto done = prune_due_cells(); !done) return done;
  }
  return Done{};
}

}  // namespace crossloft
