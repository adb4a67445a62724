/// Second step: every wall is cut at every plane that it crosses, so that it lies in one face or on one edge.

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "../geom/plane_line.h"
#include "section_steps.h"

namespace crossloft::section_steps {
namespace {

/// A plane that separates the ends of a wall, and where: 0 at a, 1 at b.
struct Cut {
  std::uint32_t plane = kNone;
  double at = 0;
};

class Cutter {
 public:
  Cutter(SectionGraph& graph, LatticePointStore& store, double snap)
      : graph_(graph), store_(store), snap_(snap) {}

  /// The wall from its lexicographically lower end.
  Wall forward(Wall wall) const {
    if (compare_lex(graph_.points[wall.a], graph_.points[wall.b]) >= 0) std::swap(wall.a, wall.b);
    return wall;
  }
  bool cut(std::uint32_t plane, const Wall& wall, std::vector<Wall>& pieces);

 private:
  std::vector<Cut> cuts(std::uint32_t a, std::uint32_t b) const;
  std::uint32_t crossing(std::uint32_t i, std::uint32_t a, std::uint32_t b, const std::vector<Cut>& cuts);
  std::optional<std::uint32_t> corner_near(std::uint32_t i, std::uint32_t a, std::uint32_t b,
                                           const std::vector<Cut>& cuts);
  std::optional<std::uint32_t> corner(std::uint32_t i, std::uint32_t j, std::uint32_t q, Vec3 target,
                                      double reach);
  std::optional<std::uint32_t> on_line(std::uint32_t i, std::uint32_t j, std::uint32_t a, std::uint32_t b,
                                       Vec3 target, std::uint32_t& offender);
  std::uint32_t offender(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t j) const;
  Vec3 between(std::uint32_t a, std::uint32_t b, double at) const;

  SectionGraph& graph_;
  LatticePointStore& store_;
  double snap_;
};

Vec3 Cutter::between(std::uint32_t a, std::uint32_t b, double at) const {
  const LatticePoint &p = graph_.points[a], &q = graph_.points[b];
  return {p.x + at * (q.x - p.x), p.y + at * (q.y - p.y), p.z + at * (q.z - p.z)};
}

/// All planes with a strictly on one side and b strictly on the other, nearest to a first.
std::vector<Cut> Cutter::cuts(std::uint32_t a, std::uint32_t b) const {
  std::vector<Cut> found;
  const auto pa = graph_.positive_of(a), pb = graph_.positive_of(b), za = graph_.zero_of(a),
             zb = graph_.zero_of(b);
  for (std::uint32_t w = 0; w < graph_.rows.words(); ++w)
    for (std::uint64_t bits = (pa[w] ^ pb[w]) & ~za[w] & ~zb[w]; bits != 0; bits &= bits - 1) {
      const std::uint32_t p = w * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
      const double va = std::abs(plane_value(graph_.planes[p], graph_.points[a]));
      const double vb = std::abs(plane_value(graph_.planes[p], graph_.points[b]));
      found.push_back({p, va / (va + vb)});
    }
  std::stable_sort(found.begin(), found.end(), [](const Cut& x, const Cut& y) { return x.at < y.at; });
  return found;
}

/// A plane other than j against which the new vertex c has not the sign that the open segment ab has near it:
/// that of both ends where they agree, of the other where one is 0, of a where they differ (c is the cut
/// nearest to a).
std::uint32_t Cutter::offender(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t j) const {
  const auto pa = graph_.positive_of(a), pb = graph_.positive_of(b), pc = graph_.positive_of(c);
  const auto za = graph_.zero_of(a), zb = graph_.zero_of(b), zc = graph_.zero_of(c);
  for (std::uint32_t w = 0; w < graph_.rows.words(); ++w) {
    const std::uint64_t want_positive = (za[w] & pb[w]) | (~za[w] & pa[w]);
    std::uint64_t wrong = ((pc[w] ^ want_positive) | zc[w]) & ~(za[w] & zb[w]);
    if (j / 64 == w) wrong &= ~(std::uint64_t{1} << (j % 64));
    for (; wrong != 0; wrong &= wrong - 1) {
      const std::uint32_t q = w * 64 + static_cast<std::uint32_t>(std::countr_zero(wrong));
      // A plane of the same pencil contains the whole line: it changes sign where j does.
      if (q < graph_.planes.size() && !(graph_.sign(c, q) == 0 && graph_.sign(a, q) * graph_.sign(b, q) < 0))
        return q;
    }
  }
  return kNone;
}

std::optional<std::uint32_t> Cutter::corner(std::uint32_t i, std::uint32_t j, std::uint32_t q, Vec3 target,
                                            double reach) {
  LatticePoint point;
  if (!store_.meet(graph_.planes[i], graph_.planes[j], graph_.planes[q], point)) return std::nullopt;
  if (norm(Vec3{point.x, point.y, point.z} - target) > reach) return std::nullopt;
  return graph_.add(point);
}

/// Two lines cut the wall within the on tolerance: the contour passes through their arrangement vertex.
std::optional<std::uint32_t> Cutter::corner_near(std::uint32_t i, std::uint32_t a, std::uint32_t b,
                                                 const std::vector<Cut>& cuts) {
  const Vec3 target = between(a, b, cuts[0].at);
  const double length = norm(between(a, b, 1) - between(a, b, 0));
  const double room = std::min(cuts[0].at, 1 - cuts[0].at) * length / 4;
  for (std::size_t m = 1; m < cuts.size() && (cuts[m].at - cuts[0].at) * length <= snap_; ++m)
    if (const auto c = corner(i, cuts[0].plane, cuts[m].plane, target, std::min(snap_, room))) {
      if (offender(a, b, *c, cuts[0].plane) == kNone) return c;
      graph_.take_back();  // it was only a trial
    }
  return std::nullopt;
}

/// The crossing rounded along the line of i and j; if every rounding changes a sign, none and the plane in
/// the way.
std::optional<std::uint32_t> Cutter::on_line(std::uint32_t i, std::uint32_t j, std::uint32_t a,
                                             std::uint32_t b, Vec3 target, std::uint32_t& in_the_way) {
  const int axis = line_axis(graph_.planes[i], graph_.planes[j]);
  const double along = axis == 0 ? target.x : axis == 1 ? target.y : target.z;
  const std::int64_t nearest = std::llround(along);
  const std::int64_t second = static_cast<double>(nearest) > along ? nearest - 1 : nearest + 1;
  for (const std::int64_t t : {nearest, second}) {
    LatticePoint point;
    if (!line_point(store_, graph_.planes[i], graph_.planes[j], t, point)) continue;
    const std::uint32_t c = graph_.add(point);
    const std::uint32_t q = offender(a, b, c, j);
    if (q == kNone) return c;
    if (in_the_way == kNone) in_the_way = q;
    graph_.take_back();
  }
  return std::nullopt;
}

std::uint32_t Cutter::crossing(std::uint32_t i, std::uint32_t a, std::uint32_t b,
                               const std::vector<Cut>& cuts) {
  const std::uint32_t j = cuts[0].plane;
  for (std::uint32_t q = 0; q < graph_.planes.size();
       ++q)  // a wall along the line of i and q crosses at a corner
    if (q != i && graph_.sign(a, q) == 0 && graph_.sign(b, q) == 0)
      if (const auto c = corner(i, j, q, {}, INFINITY)) return *c;
  if (const auto c = corner_near(i, a, b, cuts)) return *c;
  const Vec3 target = between(a, b, cuts[0].at);
  std::uint32_t in_the_way = kNone;
  if (const auto c = on_line(i, j, a, b, target, in_the_way)) return *c;
  if (in_the_way == kNone) return kNone;
  const auto c = corner(i, j, in_the_way, target, INFINITY);
  return c ? *c : kNone;
}

bool Cutter::cut(std::uint32_t plane, const Wall& wall, std::vector<Wall>& pieces) {
  // From the lexicographically lower end, so that the result does not depend on the direction of the contour.
  // A new vertex may have been rounded past a further plane: its piece counts as done only once nothing
  // crosses it.
  std::vector<Wall> open{forward(wall)};  // the next piece last
  const std::size_t limit = 16 + 8 * graph_.planes.size();
  for (std::size_t round = 0; !open.empty(); ++round) {
    if (round == limit) return false;
    const Wall piece = open.back();
    const std::vector<Cut> at = cuts(piece.a, piece.b);
    if (at.empty()) {
      pieces.push_back(piece);
      open.pop_back();
      continue;
    }
    const std::uint32_t c = crossing(plane, piece.a, piece.b, at);
    if (c == kNone) return false;
    Wall first = piece;
    first.b = c;
    open.back().a = c;
    open.push_back(first);
  }
  return true;
}

}  // namespace

bool cut_at_planes(SectionGraph& graph, LatticePointStore& store, double snap, const Context& context) {
  Cutter cutter(graph, store, snap);
  for (std::uint32_t p = 0; p < graph.planes.size() && !context.cancelled(); ++p) {
    const std::vector<Wall>& walls = graph.walls[p];
    const auto crosses = [&](const Wall& wall) { return crosses_a_plane(graph, wall); };
    if (std::none_of(walls.begin(), walls.end(), crosses)) continue;
    std::vector<Wall> pieces;
    pieces.reserve(walls.size() + walls.size() / 4);
    for (const Wall& wall : walls) {
      if (!crosses(wall))
        pieces.push_back(cutter.forward(wall));
      else if (!cutter.cut(p, wall, pieces))
        return false;
    }
    graph.walls[p] = std::move(pieces);
  }
  return true;
}

}  // namespace crossloft::section_steps
