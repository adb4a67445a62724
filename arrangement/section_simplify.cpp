/// Fewer vertices: those that a straight wall replaces within the tolerance go, without a change of the
/// topology.
///
/// Vertex v goes if it is in the interior of a face, has two walls, to u and w, and
///   (a) v and all vertices that its two walls have replaced are within the tolerance of the segment uw;
///   (b) u and w are not joined by a wall and not on one line of planes;
///   (c) the closed triangle u v w holds no other vertex of the plane's contours, and uw passes by none at
///   less
///       than a thousandth of its distance from u and w: the face is triangulated with uw as an edge, which
///       takes the more splits the closer it is to others.
/// Smallest deviation first, then the one that replaces fewer, then by coordinates.
///
/// *The tolerance bounds the distance between the contours, both ways.* Distance from a segment is a convex
/// function, so if it holds at the vertices of the replaced chain, it holds on its edges; and the chain leads
/// from u to w, so each point of uw is the foot of a point of it, which is no nearer to any other point of
/// the segment.
///
/// *Nothing crosses.* Let s be a wall other than uv and vw. Before the step walls share ends only, and v is
/// no end of s, so s has no point of uv and vw but u and w; an end of s in the triangle is u or w too, by
/// (c). What s and the triangle share is a segment or nothing, and each end of the segment is an end of s or
/// on the border: both are on uw. A single point between u and w is impossible: s does not end there, and
/// would pass on into the triangle. So is a segment along uw: where it ends, s ends or leaves the triangle at
/// u or w, so it is all of uw, and s is uw, against (b), or has u or w in its interior. What is left is u or
/// w alone: uw can take the place of uv and vw. If u, v, w are collinear, v is between the others, since uv
/// and vw share only v; uw covers the same points, and (c) needs no test.
///
/// *Sections stay what they are elsewhere.* Inside and outside differ before and after only in the triangle.
/// It lies in the closed face, which is convex; an arrangement vertex or a point of an arrangement edge is in
/// it only if a corner is or, on the edge, both u and w are, against (b). So the traces of the section on the
/// lines of planes stay, to the point, and the open wall uw is in the open face. A loop ends as a triangle at
/// least, by (b), and its edges share ends only: its area is positive. What it holds, it holds still, by (c).

#include <algorithm>
#include <queue>
#include <tuple>

#include "../geom/lattice_rounding.h"
#include "contour_chains.h"
#include "point_tree.h"
#include "section_steps.h"

namespace crossloft::section_steps {
namespace {

/// From p to the segment ab. Exactly 0 for explicit points on the segment: the products that cancel are the
/// same real numbers, rounded alike.
double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 d = b - a, e = p - a;
  const double along = dot(e, d), length2 = dot(d, d);
  if (along <= 0) return norm(e);
  if (along >= length2) return norm(p - b);
  return norm(cross(e, d)) / std::sqrt(length2);
}

constexpr double kClose = 0x1p-10;

/// Whether segment ab goes past p at a thousandth of its distance from the ends, or less.
bool grazes(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 d = b - a, e = p - a, f = p - b;
  if (dot(e, d) <= 0 || dot(f, d) >= 0) return false;
  const double to_ends = std::min(dot(e, e), dot(f, f));
  const Vec3 off = cross(e, d);
  return dot(off, off) <= kClose * kClose * to_ends * dot(d, d);
}

/// A vertex that may go. Replacing few first keeps long straight runs from growing at one end, which were
/// quadratic.
struct Candidate {
  double deviation = 0;
  std::size_t replaced = 0;
  std::uint32_t vertex = 0;   ///< their numbers are in lexicographic order
  std::uint32_t version = 0;  ///< out of date if the vertex has a later one

  friend bool operator>(const Candidate& x, const Candidate& y) {
    return std::tie(x.deviation, x.replaced, x.vertex) > std::tie(y.deviation, y.replaced, y.vertex);
  }
};

/// One plane. The order of removals is that of the candidates not hindered by (c) at the time: one that is
/// hindered waits at some vertex in its triangle. Whichever that is, it comes free when the last of them
/// goes.
class Simplifier {
 public:
  Simplifier(SectionGraph& graph, std::uint32_t plane, ContourPlaces& places, double tolerance);
  void run();

 private:
  void assess(std::uint32_t v);
  std::uint32_t hindrance(std::uint32_t v) const;
  void remove(std::uint32_t v);

  SectionGraph& graph_;
  LatticePlane plane_;
  double tolerance_;
  ContourChains chains_;
  const ContourPlaces& place_;                   ///< by vertex
  const std::vector<std::uint32_t>& vertices_;   ///< of this plane, by place
  PointTree tree_;                               ///< of vertices_, seen along the dominant axis
  std::vector<std::uint32_t> version_;           ///< by place
  std::vector<std::vector<Candidate>> waiting_;  ///< by place of the vertex that is in the way
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

/// Rounded coordinates but the dominant one. Rounding is monotone: a point in a triangle is in the box of its
/// corners when all are rounded.
Vec2 flat(const LatticePlane& plane, const LatticePoint& p) {
  const int k = dominant_axis(plane.normal);
  return {p[(k + 1) % 3], p[(k + 2) % 3]};
}

std::vector<Vec2> flat(const LatticePlane& plane, const SectionGraph& graph,
                       std::span<const std::uint32_t> vertices) {
  std::vector<Vec2> points;
  for (const std::uint32_t v : vertices) points.push_back(flat(plane, graph.points[v]));
  return points;
}

Simplifier::Simplifier(SectionGraph& graph, std::uint32_t plane, ContourPlaces& places, double tolerance)
    : graph_(graph),
      plane_(graph.planes[plane]),
      tolerance_(tolerance),
      chains_(graph.walls[plane], places),
      place_(places),
      vertices_(places.vertices()),
      tree_(flat(plane_, graph, vertices_)),
      version_(vertices_.size(), 0),
      waiting_(vertices_.size()) {}

/// Puts v into the queue if (a) holds and it is not pinned; outdates what was said of it before.
void Simplifier::assess(std::uint32_t v) {
  const std::uint32_t version = ++version_[place_[v]];
  if (chains_.degree(v) != 2 || graph_.on_line(v)) return;
  auto [u, w] = chains_.neighbours(v);
  if (graph_.share_line(u, w)) return;
  if (u > w) std::swap(u, w);  // rounded alike whichever way the contour runs
  const Vec3 a = real(graph_.points[u]), b = real(graph_.points[w]);
  double deviation = 0;
  const bool near = chains_.all_replaced_without(v, [&](std::uint32_t p) {
    deviation = std::max(deviation, distance_to_segment(a, b, real(graph_.points[p])));
    return deviation <= tolerance_;
  });
  if (near) queue_.push({deviation, chains_.replaced_without(v), v, version});
}

/// A vertex in the triangle of v and its neighbours, or too close to what would take the place of v; kNone if
/// there is none: condition (c).
std::uint32_t Simplifier::hindrance(std::uint32_t v) const {
  auto [u, w] = chains_.neighbours(v);
  if (u > w) std::swap(u, w);
  const LatticePoint &a = graph_.points[u], &b = graph_.points[v], &c = graph_.points[w];
  const int turn = orient2d(plane_, a, b, c);
  const Vec3 from = real(a), to = real(c);
  const Vec2 p = flat(plane_, a), q = flat(plane_, b), r = flat(plane_, c);
  const double margin = kClose * norm(to - from);
  const auto in_triangle = [&](const LatticePoint& d) {
    return turn != 0 && turn * orient2d(plane_, a, b, d) >= 0 && turn * orient2d(plane_, b, c, d) >= 0 &&
           turn * orient2d(plane_, c, a, d) >= 0;
  };
  return tree_.find({std::min({p.x, q.x, r.x}) - margin, std::min({p.y, q.y, r.y}) - margin},
                    {std::max({p.x, q.x, r.x}) + margin, std::max({p.y, q.y, r.y}) + margin},
                    [&, u = u, w = w](std::uint32_t k) {
                      const std::uint32_t x = vertices_[k];
                      if (x == u || x == v || x == w) return false;
                      const LatticePoint& d = graph_.points[x];
                      return in_triangle(d) || grazes(from, to, real(d));
                    });
}

void Simplifier::remove(std::uint32_t v) {
  const std::uint32_t k = place_[v];
  const auto [u, w] = chains_.neighbours(v);
  chains_.remove(v);
  tree_.remove(k);
  ++version_[k];
  ++graph_.statistics.simplified;
  for (const Candidate& free : waiting_[k]) queue_.push(free);
  waiting_[k] = {};
  assess(u);
  assess(w);
}

void Simplifier::run() {
  for (const std::uint32_t v : vertices_) assess(v);
  while (!queue_.empty()) {
    const Candidate next = queue_.top();
    queue_.pop();
    if (next.version != version_[place_[next.vertex]]) continue;
    const auto [u, w] = chains_.neighbours(next.vertex);
    if (chains_.joined(u, w)) continue;  // for good: that wall stays as long as u and w do
    const std::uint32_t k = hindrance(next.vertex);
    if (k == kNone)
      remove(next.vertex);
    else
      waiting_[k].push_back(next);
  }
  // Of the walls that stay: a piece on the way there may have been further off than the one that took its
  // place.
  chains_.for_each_replaced([&](const Wall& wall, std::uint32_t v) {
    const auto [a, b] = std::minmax(wall.a, wall.b);
    const double d =
        distance_to_segment(real(graph_.points[a]), real(graph_.points[b]), real(graph_.points[v]));
    graph_.statistics.deviation = std::max(graph_.statistics.deviation, d);
  });
  chains_.finish();
}

}  // namespace

void simplify_contours(SectionGraph& graph, double tolerance, const Context& context) {
  ContourPlaces places(graph.size());
  for (std::uint32_t p = 0; p < graph.planes.size() && !context.cancelled(); ++p)
    Simplifier(graph, p, places, tolerance).run();
  drop_bare_vertices(graph, context);
}

}  // namespace crossloft::section_steps
