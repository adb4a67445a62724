#include "between_planes.h"

#include <cmath>

#include "../geom/inline_filters.h"
#include "../geom/lifted_row.h"
#include "../geom/static_bounds.h"
#include "perturbation.h"

namespace crossloft {
namespace {

/// So many from spoke to spoke for each tetrahedron are enough for all but contrived points; 3 are for a
/// stack of slices.
constexpr std::size_t kTurns = 64;

constexpr std::uint32_t next_in_triangle(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr std::uint32_t last_in_triangle(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// Half edges: 3 t + i leads from corner i of triangle t to the next one and has the triangle on its left;
/// those after 3 T have none there. Edges at a vertex are turned around it by half edges that lead away from
/// it, its *spokes*.
class HalfEdges {
 public:
  explicit HalfEdges(const PlaneSide& side);

  std::uint32_t triangle_count() const { return triangle_count_; }
  bool has_triangle(std::uint32_t h) const { return h < 3 * triangle_count_; }
  std::uint32_t target(std::uint32_t h) const { return halves_[h].target; }
  std::uint32_t twin(std::uint32_t h) const { return halves_[h].twin; }
  std::uint32_t source(std::uint32_t h) const { return target(twin(h)); }
  std::uint32_t edge(std::uint32_t h) const { return halves_[h].edge; }
  std::size_t size() const { return halves_.size(); }
  /// The next spoke to the left, or to the right; kNone at the border.
  std::uint32_t turned_left(std::uint32_t h) const {
    return has_triangle(h) ? twin(last_in_triangle(h)) : kNone;
  }
  std::uint32_t turned_right(std::uint32_t h) const {
    return has_triangle(twin(h)) ? next_in_triangle(twin(h)) : kNone;
  }

 private:
  struct Half {
    std::uint32_t target, twin, edge;
  };
  std::vector<Half> halves_;
  std::uint32_t triangle_count_;
};

HalfEdges::HalfEdges(const PlaneSide& side)
    : triangle_count_(static_cast<std::uint32_t>(side.triangles.size())) {
  const std::uint32_t inner = 3 * triangle_count_;
  halves_.reserve(2 * side.edge_count);
  halves_.resize(inner);
  std::vector<std::uint32_t> first(side.edge_count, kNone);
  for (std::uint32_t t = 0; t < triangle_count_; ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto corner = [&](std::uint32_t k) { return side.clockwise ? (3 - k) % 3 : k % 3; };
      const std::uint32_t e = side.sides[t][corner((i + 2) % 3)], h = 3 * t + i;
      halves_[h] = {side.numbers[side.triangles[t][corner((i + 1) % 3)]], first[e], e};
      if (first[e] != kNone) halves_[first[e]].twin = h;
      first[e] = h;
    }
  for (std::uint32_t h = 0; h < inner; ++h) {
    if (halves_[h].twin != kNone) continue;
    halves_[h].twin = static_cast<std::uint32_t>(halves_.size());
    halves_.push_back({halves_[last_in_triangle(h)].target, h, halves_[h].edge});
  }
}

class Predicates {
 public:
  explicit Predicates(std::span<const LatticePoint> points)
      : points_(points), bounds_(static_bounds(points)) {}

  const LatticePoint& point(std::uint32_t i) const { return points_[i]; }
  const StaticBounds& bounds() const { return bounds_; }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return crossloft::orient3d(bounds_, points_[a], points_[b], points_[c], points_[d]);
  }
  int insphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    return crossloft::insphere(bounds_, points_[a], points_[b], points_[c], points_[d], points_[e]);
  }
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    return crossloft::compare_lex(points_[a], points_[b]);
  }

 private:
  std::span<const LatticePoint> points_;
  StaticBounds bounds_;
};

/// A facet with two vertices in the first plane, asked about points beyond it: its rows are made once. Both
/// determinants are those of geom/, expanded in another way, for which the static bounds hold as well
/// (lifted_row.h; a term of orient3d is a minor times an entry whatever row it is expanded along).
class Facet {
 public:
  Facet(const Predicates& predicates, std::uint32_t a1, std::uint32_t a2, std::uint32_t b)
      : predicates_(predicates), corners_{a1, a2, b, kNone} {
    const Vec3 p = from_b(a1), q = from_b(a2);
    p_ = {p, dot(p, p)}, q_ = {q, dot(q, q)};
    normal_ = cross(p, q);
    pq_ = minors(p_, q_);
  }
  bool is_beyond(std::uint32_t v) const {
    const double det = kInlineFilters ? dot(normal_, from_b(v)) : 0;
    if (std::fabs(det) > predicates_.bounds().orient3d) [[likely]]
      return det > 0;
    return predicates_.orient3d(corners_[0], corners_[1], corners_[2], v) > 0;
  }
  /// The sphere from now on goes through v, which is beyond.
  void take(std::uint32_t v) {
    corners_[3] = v;
    const Vec3 d = from_b(v);
    r_ = {d, dot(d, d)};
    pr_ = minors(p_, r_), qr_ = minors(q_, r_);
  }
  bool is_in_sphere(std::uint32_t v) const {
    const Vec3 d = from_b(v);
    const LiftedRow s(d, dot(d, d));
    const filters::Lanes sum =
        (both(pq_, minors(r_, s)) - both(pr_, minors(q_, s))) + both(minors(p_, s), qr_);
    const double det = kInlineFilters ? sum[0] + sum[1] : 0;
    if (std::fabs(det) > predicates_.bounds().insphere) [[likely]]
      return det > 0;
    return detail::in_ball(predicates_, corners_, v) > 0;
  }

 private:
  Vec3 from_b(std::uint32_t v) const {
    return filters::difference(predicates_.point(v), predicates_.point(corners_[2]));
  }
  static filters::Lanes minors(const LiftedRow& a, const LiftedRow& b) {
    return a.x_lift * b.y_z - a.y_z * b.x_lift;
  }
  static filters::Lanes both(filters::Lanes a, filters::Lanes b) { return a * filters::exchanged(b); }

  const Predicates& predicates_;
  detail::Simplex<3> corners_;
  LiftedRow p_, q_, r_;
  Vec3 normal_;
  filters::Lanes pq_, pr_{}, qr_{};
};

/// A tetrahedron with an edge in each plane, as a step along the fan of its edge in the second plane: from
/// the triangle on the left of the edge's half with the smaller number.
struct Step {
  std::uint32_t from, to;            ///< vertices of the first plane
  std::uint32_t from_slot, to_slot;  ///< of these vertices
  std::uint32_t next;                ///< another one of the edge
};

class Builder {
 public:
  Builder(std::span<const LatticePoint> points, const std::array<PlaneSide, 2>& planes,
          BetweenPlanes& result);
  bool run();

 private:
  void start_triangles(const HalfEdges& plane, std::uint32_t base);
  std::uint32_t first_apex() const;
  std::uint32_t spoke_beyond(const Facet& facet, std::uint32_t b);
  std::uint32_t best_spoke(Facet& facet, std::uint32_t b);
  bool spread_over_first();
  bool walk(std::uint32_t h);
  std::uint32_t add_step(std::uint32_t h, std::uint32_t spoke);
  bool join_steps();
  bool join_steps_of(std::uint32_t h);
  bool end_fan(std::uint32_t h, std::uint32_t a, std::uint32_t tet, std::uint32_t slot);
  bool spread_over_second();
  void link(std::uint32_t t, std::uint32_t slot, std::uint32_t u, std::uint32_t back) {
    mesh_.neighbours[t][slot] = u;
    mesh_.neighbours[u][back] = t;
  }
  /// Of the tetrahedron at the triangle on the left: the slot across the half edge.
  static std::uint32_t slot_across(std::uint32_t h) { return (h + 2) % 3; }

  Predicates predicates_;
  HalfEdges first_, second_;
  BetweenPlanes& result_;
  TetMesh& mesh_;
  std::span<const std::uint32_t> candidates_;  ///< vertices of the second plane
  std::size_t turns_ = 0;                      ///< from spoke to spoke
  std::vector<std::uint32_t> spoke_;           ///< by vertex of the second plane: where the last search ended
  std::vector<std::uint32_t> steps_at_;        ///< by edge of the second plane: first of its list
  std::vector<Step> steps_;                    ///< by tetrahedron with an edge in each plane
  std::vector<std::uint32_t> leaves_,
      comes_;                           ///< by vertex of the first plane: the step, if it is of the edge
  std::vector<std::uint32_t> pending_;  ///< triangles whose apex is known
};

Builder::Builder(std::span<const LatticePoint> points, const std::array<PlaneSide, 2>& planes,
                 BetweenPlanes& result)
    : predicates_(points),
      first_(planes[0]),
      second_(planes[1]),
      result_(result),
      mesh_(result.mesh),
      candidates_(planes[1].numbers),
      spoke_(points.size(), kNone),
      steps_at_(planes[1].edge_count, kNone),
      leaves_(points.size(), kNone),
      comes_(points.size(), kNone) {
  for (std::uint32_t h = 0; h < second_.size(); ++h) spoke_[second_.source(h)] = h;
}

/// Their apexes are still to come.
void Builder::start_triangles(const HalfEdges& plane, std::uint32_t base) {
  for (std::uint32_t t = 0; t < plane.triangle_count(); ++t)
    mesh_.vertices[base + t] = {plane.target(3 * t + 2), plane.target(3 * t), plane.target(3 * t + 1), kNone};
}

std::uint32_t Builder::first_apex() const {
  detail::Simplex<3> tet = mesh_.vertices[0];
  tet[3] = candidates_[0];
  for (const std::uint32_t b : candidates_.subspan(1))
    if (detail::in_ball(predicates_, tet, b) > 0) tet[3] = b;
  return tet[3];
}

/// Some neighbour of b that is beyond the facet; kNone if there is none. Both ways at once, as it is not far
/// from the last one as a rule, and b may have thousands.
std::uint32_t Builder::spoke_beyond(const Facet& facet, std::uint32_t b) {
  const std::uint32_t start = spoke_[b];
  const auto is_beyond = [&](std::uint32_t h) { return h != kNone && facet.is_beyond(second_.target(h)); };
  if (is_beyond(start)) return start;
  std::uint32_t left = start, right = start;
  do {
    if (left != kNone) left = second_.turned_left(left), ++turns_;
    if (is_beyond(left)) return left;
    if (right != kNone) right = second_.turned_right(right), ++turns_;
    if (is_beyond(right)) return right;
  } while (left != right);  // at the border both are none, else they come back to the start
  return kNone;
}

/// The neighbour of b that a growing sphere through the facet meets first.
std::uint32_t Builder::best_spoke(Facet& facet, std::uint32_t b) {
  std::uint32_t best = spoke_beyond(facet, b);
  if (best == kNone) return kNone;
  facet.take(second_.target(best));
  const auto is_better = [&](std::uint32_t h) {
    ++turns_;
    return h != kNone && facet.is_beyond(second_.target(h)) && facet.is_in_sphere(second_.target(h));
  };
  const auto take = [&](std::uint32_t h) { facet.take(second_.target(best = h)); };
  const std::uint32_t start = best;
  for (std::uint32_t h = second_.turned_left(best); is_better(h); h = second_.turned_left(h)) take(h);
  if (best == start)
    for (std::uint32_t h = second_.turned_right(best); is_better(h); h = second_.turned_right(h)) take(h);
  return spoke_[b] = best;
}

/// The tetrahedron at half edge h of the first plane and `spoke` of the second one; linked to its list.
std::uint32_t Builder::add_step(std::uint32_t h, std::uint32_t spoke) {
  const std::uint32_t t = mesh_.size(), a1 = first_.source(h), a2 = first_.target(h);
  mesh_.vertices.push_back({a1, a2, second_.source(spoke), second_.target(spoke)});
  mesh_.neighbours.push_back({kNone, kNone, kNone, kNone});
  const std::uint32_t edge = second_.edge(spoke);
  result_.edges.push_back({first_.edge(h), edge});
  const Step step =
      spoke < second_.twin(spoke) ? Step{a1, a2, 0, 1, steps_at_[edge]} : Step{a2, a1, 1, 0, steps_at_[edge]};
  steps_at_[edge] = static_cast<std::uint32_t>(steps_.size());
  steps_.push_back(step);
  return t;
}

/// The fan of the edge, from the tetrahedron at the triangle on the left of h. Where the apex of the one on
/// the right is known, it ends there; else that is found.
bool Builder::walk(std::uint32_t h) {
  const std::uint32_t a1 = first_.source(h), a2 = first_.target(h), across = first_.twin(h);
  const bool ends = !first_.has_triangle(across);
  const std::uint32_t right = ends ? kNone : first_.target(next_in_triangle(across));
  std::uint32_t t = h / 3, slot = slot_across(h), b = mesh_.vertices[t][3];
  while (turns_ < kTurns * (mesh_.size() + std::size_t{64})) {
    if (!ends && mesh_.vertices[across / 3][3] == b)
      return link(t, slot, across / 3, slot_across(across)), true;
    Facet facet(predicates_, a1, a2, b);
    const std::uint32_t spoke = best_spoke(facet, b);
    if (spoke == kNone && ends) return true;
    if (spoke == kNone || (!ends && facet.is_in_sphere(right))) {
      std::uint32_t& apex = mesh_.vertices[across / 3][3];
      if (apex != kNone) return false;
      apex = b;
      pending_.push_back(across / 3);
      continue;
    }
    const std::uint32_t u = add_step(h, spoke);
    link(t, slot, u, 3);
    t = u, slot = 2, b = second_.target(spoke);
  }
  return false;
}

/// Finds the apexes of the first plane's triangles and all tetrahedra with an edge in each plane.
bool Builder::spread_over_first() {
  mesh_.vertices[0][3] = first_apex();
  pending_.assign(1, 0);
  while (!pending_.empty()) {
    const std::uint32_t t = pending_.back();
    pending_.pop_back();
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
      if (mesh_.neighbours[t][slot_across(h)] == kNone && !walk(h)) return false;
  }
  return true;
}

/// The fan of half edge h begins at the triangle on its left, with a facet to a.
bool Builder::end_fan(std::uint32_t h, std::uint32_t a, std::uint32_t tet, std::uint32_t slot) {
  if (!second_.has_triangle(h)) return true;
  const std::uint32_t triangle = first_.triangle_count() + h / 3;
  std::uint32_t& apex = mesh_.vertices[triangle][3];
  if (apex != kNone && apex != a) return false;
  if (apex == kNone) pending_.push_back(h / 3);
  apex = a;
  link(triangle, slot_across(h), tet, slot);
  return true;
}

/// Puts the steps of an edge into a row. False if they are not one.
bool Builder::join_steps_of(std::uint32_t h) {
  const std::uint32_t base = first_.triangle_count() + second_.triangle_count();
  const std::uint32_t list = steps_at_[second_.edge(h)];
  for (std::uint32_t k = list; k != kNone; k = steps_[k].next)
    leaves_[steps_[k].from] = comes_[steps_[k].to] = k;
  unsigned starts = 0, ends = 0;
  bool good = true;
  for (std::uint32_t k = list; k != kNone; k = steps_[k].next) {
    const Step& step = steps_[k];
    const std::uint32_t next = leaves_[step.to];
    if (next != kNone)
      link(base + k, step.from_slot, base + next, steps_[next].to_slot);
    else
      ++ends, good &= end_fan(second_.twin(h), step.to, base + k, step.from_slot);
    if (comes_[step.from] == kNone) ++starts, good &= end_fan(h, step.from, base + k, step.to_slot);
  }
  for (std::uint32_t k = list; k != kNone; k = steps_[k].next)
    leaves_[steps_[k].from] = comes_[steps_[k].to] = kNone;
  return good && (list == kNone || (starts == 1 && ends == 1));
}

bool Builder::join_steps() {
  for (std::uint32_t h = 0; h < 3 * second_.triangle_count(); ++h)
    if (h < second_.twin(h) && !join_steps_of(h)) return false;
  return true;
}

/// Across an edge without steps the apex is the same.
bool Builder::spread_over_second() {
  const std::uint32_t base = first_.triangle_count();
  std::uint32_t found = 0;
  while (!pending_.empty()) {
    const std::uint32_t t = pending_.back(), apex = mesh_.vertices[base + t][3];
    pending_.pop_back();
    ++found;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t across = second_.twin(h);
      if (steps_at_[second_.edge(h)] != kNone || !second_.has_triangle(across)) continue;
      std::uint32_t& other = mesh_.vertices[base + across / 3][3];
      if (other == kNone) other = apex, pending_.push_back(across / 3);
      if (other != apex) return false;
      link(base + t, slot_across(h), base + across / 3, slot_across(across));
    }
  }
  return found == second_.triangle_count();
}

bool Builder::run() {
  const std::uint32_t triangles = first_.triangle_count() + second_.triangle_count();
  mesh_.vertices.reserve(2 * std::size_t{triangles});
  mesh_.neighbours.reserve(2 * std::size_t{triangles});
  steps_.reserve(triangles);
  result_.edges.reserve(triangles);
  mesh_.vertices.resize(triangles);
  mesh_.neighbours.resize(triangles, {kNone, kNone, kNone, kNone});
  start_triangles(first_, 0);
  start_triangles(second_, first_.triangle_count());
  return spread_over_first() && join_steps() && spread_over_second();
}

}  // namespace

bool delaunay_between_planes(std::span<const LatticePoint> points, const std::array<PlaneSide, 2>& planes,
                             BetweenPlanes& result) {
  result = {};
  return Builder(points, planes, result).run();
}

}  // namespace crossloft
