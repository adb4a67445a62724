/// Points inside cells whose solid they let be what it is likely to be.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "../prune/confidence.h"
#include "../prune/interior_places.h"
#include "pipeline.h"

namespace crossloft {
namespace {

/// Ways between sections that are less sure are not divided: of those below hardly any ends as a join, and
/// they took a seventh of a run.
constexpr double kLeastOfWay = -0.3;

/// A way that is divided may still lead along external edges; what is left of it is divided again.
constexpr std::uint32_t kRounds = 3;

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

bool is_known(std::span<const InsidePoint> known, const LatticePoint& p) {
  return std::any_of(known.begin(), known.end(),
                     [&](const InsidePoint& q) { return compare_lex(q.point, p) == 0; });
}

/// Inside the cell, not known, each once, in lexicographic order.
std::vector<LatticePoint> points_at(std::span<const Vec3> places, const Arrangement& arrangement, CellId cell,
                                    std::span<const InsidePoint> known) {
  std::vector<LatticePoint> points;
  for (const Vec3& place : places) {
    const LatticePoint p = rounded_point(place);
    if (is_inside(arrangement, cell, p) && !is_known(known, p)) points.push_back(p);
  }
  std::sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return compare_lex(p, q) < 0; });
  points.erase(std::unique(points.begin(), points.end(),
                           [](const auto& p, const auto& q) { return compare_lex(p, q) == 0; }),
               points.end());
  return points;
}

/// Where a point inside is: the cell and its position there.
struct InsideName {
  std::uint32_t cell = 0, position = 0;
};

}  // namespace

/// Planes meet in a cell if one of its edges is not on the box.
bool Pipeline::is_in(InCells which, CellId id) const {
  if (which != InCells::automatic) return which == InCells::all;
  const std::span<const ArrEdgeId> edges = arrangement_->edges_of(id);
  return std::any_of(edges.begin(), edges.end(), [&](ArrEdgeId e) { return !arrangement_->on_box(e); });
}

/// Round by round, each with the cell built anew. Until it is known whether samples come the points get
/// numbers that no other point of the cell has; the order of its numbers is final.
Result<Done> Pipeline::divide(CellInHand& hand, CellState& state) const {
  if (!points_may_come_ || !is_in(options_.natural.divide, hand.id)) return Done{};
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    Stopwatch watch;
    const double least = std::max(kLeastOfWay, options_.natural.alone_confidence);
    if (hand.places.empty())
      hand.places = interior_places(hand.built.complex, hand.shape, *hand.ground, as_integer(least));
    state.pruning_seconds += watch.lap();
    state.undivided = !hand.places.empty() && samples_may_come_ && is_near_branching(hand.ids);
    if (hand.places.empty() || state.undivided) return Done{};
    const std::vector<LatticePoint> points =
        points_at(std::exchange(hand.places, {}), *arrangement_, hand.id, state.inside);
    if (points.empty()) return Done{};
    for (const LatticePoint& p : points) {
      state.interior.push_back(static_cast<std::uint32_t>(numbering_.points.size() + state.inside.size()));
      state.inside.push_back({p, round});
    }
    if (auto done = build(hand, state); !done) return done;
  }
  return Done{};
}

/// After all others, in the order of rounds and in lexicographic order: no two cells have a point in common.
void Pipeline::number_inside_points() {
  std::vector<InsideName> names;
  for (std::uint32_t c = 0; c < cells_.size(); ++c)
    for (std::uint32_t k = 0; k < cells_[c].inside.size(); ++k) names.push_back({c, k});
  const auto point = [&](const InsideName& n) -> const InsidePoint& {
    return cells_[n.cell].inside[n.position];
  };
  if (names.empty()) return;
  std::sort(names.begin(), names.end(), [&](const InsideName& x, const InsideName& y) {
    const InsidePoint &p = point(x), &q = point(y);
    return p.round != q.round ? p.round < q.round : compare_lex(p.point, q.point) < 0;
  });
  const std::size_t first = numbering_.points.size();
  for (const InsideName& n : names) {
    cells_[n.cell].interior[n.position] = static_cast<std::uint32_t>(numbering_.points.size());
    numbering_.points.push_back(point(n).point);
    numbering_.graph_vertex.push_back(kNone);
  }
  result_.report.interior_points = static_cast<std::uint32_t>(names.size());
  std::vector<std::uint32_t> number(first);
  std::iota(number.begin(), number.end(), 0u);
  for (CellState& cell : cells_) {
    number.resize(first);
    number.insert(number.end(), cell.interior.begin(), cell.interior.end());
    if (!cell.inside.empty()) cell.renumber(number);
  }
}

}  // namespace crossloft
