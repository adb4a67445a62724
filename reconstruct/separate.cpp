#include "separate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "../geom/box_tree.h"
#include "../geom/predicates.h"
#include "../geom/triangle_meeting.h"
#include "lists.h"

namespace crossloft {
namespace {

constexpr double kStep = 0.02;  ///< of the shortest edge at the copy
constexpr int kDirectionRounds = 64;

Bounds widened(Bounds box, double by) { return {box.low - Vec3{by, by, by}, box.high + Vec3{by, by, by}}; }

/// What a triangle of an umbrella sweeps: (old place, new place, a, b).
struct Swept {
  explicit Swept(const std::array<Vec3, 4>& corners)
      : tet(corners), box(bounds_of(tet)), turn(orient3d(tet[0], tet[1], tet[2], tet[3])) {}

  std::array<Vec3, 4> tet;
  Bounds box;
  int turn;
};

/// The closed tetrahedron contains p; its corners don't count, and a flat one contains nothing.
bool holds(const Swept& swept, const Vec3& p) {
  const auto& t = swept.tet;
  const int turn = swept.turn;
  if (turn == 0 || !overlap(swept.box, {p, p}) || std::find(t.begin(), t.end(), p) != t.end()) return false;
  return orient3d(p, t[1], t[2], t[3]) * turn >= 0 && orient3d(t[0], p, t[2], t[3]) * turn >= 0 &&
         orient3d(t[0], t[1], p, t[3]) * turn >= 0 && orient3d(t[0], t[1], t[2], p) * turn >= 0;
}

/// What is known of vertices with regard to the triangles that an umbrella sweeps and becomes. A vertex has
/// some six triangles, and most questions are near to undecided: each is asked once.
class SweptSides {
 public:
  /// `row_of` by vertex, all kNone, as it is left.
  SweptSides(const std::vector<Swept>& swept, const std::vector<Vec3>& points,
             std::vector<std::uint32_t>& row_of)
      : swept_(swept), points_(points), row_of_(row_of) {}
  SweptSides(const SweptSides&) = delete;
  SweptSides& operator=(const SweptSides&) = delete;
  ~SweptSides() { forget(); }

  /// Where the answers of the three vertices are, until others are asked for.
  std::array<std::uint32_t, 3> rows(const std::array<std::uint32_t, 3>& v) {
    if (sides_.size() + 3 * swept_.size() > kMostAnswers) forget();
    return {row(v[0]), row(v[1]), row(v[2])};
  }
  /// Of the plane of triangle i as moved.
  int side(std::uint32_t row, std::uint32_t i) {
    std::int8_t& known = sides_[row * swept_.size() + i];
    const auto& t = swept_[i].tet;
    if (known == kUnknown) known = static_cast<std::int8_t>(side_of({t[1], t[2], t[3]}, place(row)));
    return known;
  }
  bool is_held(std::uint32_t row, std::uint32_t i) {
    std::int8_t& known = held_[row * swept_.size() + i];
    if (known == kUnknown) known = holds(swept_[i], place(row)) ? 1 : 0;
    return known != 0;
  }

 private:
  static constexpr std::int8_t kUnknown = 2;
  /// Two hubs of n triangles at one place have n^2: then some are asked again.
  static constexpr std::size_t kMostAnswers = std::size_t{1} << 20;

  void forget() {
    for (const std::uint32_t v : vertices_) row_of_[v] = kNone;
    vertices_.clear(), sides_.clear(), held_.clear();
  }
  std::uint32_t row(std::uint32_t v) {
    if (row_of_[v] == kNone) {
      row_of_[v] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(v);
      sides_.resize(sides_.size() + swept_.size(), kUnknown);
      held_.resize(held_.size() + swept_.size(), kUnknown);
    }
    return row_of_[v];
  }
  const Vec3& place(std::uint32_t row) const { return points_[vertices_[row]]; }

  const std::vector<Swept>& swept_;
  const std::vector<Vec3>& points_;
  std::vector<std::uint32_t>& row_of_;
  std::vector<std::uint32_t> vertices_;    ///< by row
  std::vector<std::int8_t> sides_, held_;  ///< [row][triangle]
};

/// Sides of one triangle's plane, each place asked once.
class SidesOfPlaces {
 public:
  explicit SidesOfPlaces(const std::vector<Vec3>& places) : places_(places), sides_(places.size()) {}

  void start(const Corners& triangle) {
    triangle_ = triangle;
    std::fill(sides_.begin(), sides_.end(), kUnknown);
  }
  int of(std::size_t place) {
    std::int8_t& known = sides_[place];
    if (known == kUnknown) known = static_cast<std::int8_t>(side_of(triangle_, places_[place]));
    return known;
  }
  bool is_beside() {
    return beside(triangle_, places_, [&](std::size_t place) { return of(place); });
  }

 private:
  static constexpr std::int8_t kUnknown = 2;

  const std::vector<Vec3>& places_;
  std::vector<std::int8_t> sides_;
  Corners triangle_;
};

class Separator {
 public:
  Separator(Surface& surface, std::span<const SurfaceVertex> origins, const Confinement& confinement,
            const SeparationEffort& effort, const Context& context)
      : surface_(surface),
        points_(surface.points),
        origins_(origins),
        confinement_(confinement),
        effort_(effort),
        context_(context) {}

  Separation run() {
    find_copies();
    if (copies_.empty()) return result_;
    find_umbrellas();
    for (std::size_t k = 0; k < copies_.size(); ++k) reach_.push_back(reach(k));
    find_neighbours();
    row_of_.assign(points_.size(), kNone);
    for (std::size_t k = 0; k < copies_.size(); ++k)
      if (reach_[k] != 0 && !context_.cancelled() && (effort_.rounds == 0 || touches(k)))
        move(k, direction(k));
    bool some = true;
    for (int round = 0; round < effort_.rounds && some; ++round) some = move_touching();
    find_touching();
    return result_;
  }

 private:
  using Triple = std::array<std::uint32_t, 3>;

  bool same_origin(std::size_t v, std::size_t w) const {
    return w < origins_.size() && origins_[v] == origins_[w];
  }
  Corners corners(std::uint32_t t) const {
    const Triple& c = surface_.triangles[t];
    return {points_[c[0]], points_[c[1]], points_[c[2]]};
  }
  Umbrella umbrella(std::size_t k) const { return {copies_[k], umbrellas_.of(k)}; }
  /// The triangle's other two vertices, in its orientation after v.
  std::array<std::uint32_t, 2> spokes(std::uint32_t t, std::uint32_t v) const {
    const Triple& c = surface_.triangles[t];
    const std::size_t at = c[0] == v ? 0 : c[1] == v ? 1 : 2;
    return {c[(at + 1) % 3], c[(at + 2) % 3]};
  }

  void find_copies() {
    number_.assign(points_.size(), kNone);
    for (std::uint32_t v = 0; v < origins_.size(); ++v) {
      if (!same_origin(v, v + std::size_t{1}) && (v == 0 || !same_origin(v, v - std::size_t{1}))) continue;
      number_[v] = static_cast<std::uint32_t>(copies_.size());
      copies_.push_back(v);
    }
  }

  void find_umbrellas() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (const std::uint32_t v : surface_.triangles[t])
        if (number_[v] != kNone) found.emplace_back(number_[v], t);
    std::sort(found.begin(), found.end());
    umbrellas_ = Lists(copies_.size(), found);
  }

  /// Half the room that the copy may take; 0 if it stays.
  double reach(std::size_t k) const {
    if (!confinement_.may_move(umbrella(k))) return 0;
    double shortest = Bounds::kFar;
    for (const std::uint32_t t : umbrellas_.of(k))
      shortest = std::min(shortest, norm(points_[spokes(t, copies_[k])[0]] - points_[copies_[k]]));
    return std::min(kStep * shortest, effort_.longest);
  }

  double reach_of(std::uint32_t v) const { return number_[v] == kNone ? 0 : reach_[number_[v]]; }
  Bounds room(std::size_t k) const {
    const Vec3& p = points_[copies_[k]];
    return widened({p, p}, 2 * reach_[k]);
  }
  /// Holds the triangle wherever its corners may come to lie.
  Bounds room_of_triangle(std::uint32_t t) const {
    Bounds box;
    for (const std::uint32_t v : surface_.triangles[t])
      box.join(widened({points_[v], points_[v]}, 2 * reach_of(v)));
    return box;
  }

  /// All triangles that a copy which may move can meet, its own ones included. One tree of those copies, and
  /// every triangle asks it: there are few of them.
  void find_neighbours() {
    std::vector<Bounds> boxes;
    std::vector<std::uint32_t> moving;
    for (std::uint32_t k = 0; k < copies_.size(); ++k) {
      if (reach_[k] == 0) continue;
      Bounds box;
      for (const std::uint32_t t : umbrellas_.of(k)) box.join(room_of_triangle(t));
      boxes.push_back(box);
      moving.push_back(k);
    }
    const BoxTree tree(boxes);
    neighbours_.resize(copies_.size());
    std::vector<bool> is_crowded(copies_.size(), false);
    for (std::uint32_t t = 0; t < surface_.triangles.size() && !tree.empty(); ++t)
      tree.for_overlaps(room_of_triangle(t), [&](std::uint32_t i) {
        if (is_crowded[moving[i]]) return;
        auto& around = neighbours_[moving[i]];
        around.push_back(t);
        if (around.size() > effort_.most_around) is_crowded[moving[i]] = true, around = {};
      });
    for (const std::uint32_t k : moving) {
      if (!is_crowded[k]) continue;
      reach_[k] = 0;
      if (touches(k)) result_.crowded.push_back(copies_[k]);
    }
  }

  /// Normals of the umbrella's triangles, of length 1 and towards the side on which `inside` mostly lies.
  std::vector<Vec3> normals(std::size_t k, const Vec3& inside) const {
    std::vector<Vec3> normals;
    double sum = 0;
    for (const std::uint32_t t : umbrellas_.of(k)) {
      const auto [a, b] = spokes(t, copies_[k]);
      const Vec3 n = cross(points_[a] - points_[copies_[k]], points_[b] - points_[copies_[k]]);
      normals.push_back(1 / norm(n) * n);
      sum += dot(normals.back(), inside);
    }
    if (sum < 0)
      for (Vec3& n : normals) n = -n;
    return normals;
  }

  /// A unit vector into the umbrella's cone: the mean of the spokes, turned towards the worst triangle again
  /// and again (Rosenblatt's perceptron), so that all triangles have it on the same side if there is such a
  /// vector and the rounds suffice; the best one met otherwise. Only a proposal, so rounding does no harm.
  Vec3 direction(std::size_t k) const {
    const Vec3& from = points_[copies_[k]];
    Vec3 d, best;
    for (const std::uint32_t t : umbrellas_.of(k)) {
      const Vec3 spoke = points_[spokes(t, copies_[k])[0]] - from;
      d = d + 1 / norm(spoke) * spoke;
    }
    const std::vector<Vec3> sides = normals(k, d);
    if (norm(d) == 0) d = sides[0];  // spokes that cancel: any side will do
    double margin = -2;
    for (int round = 0; round < kDirectionRounds; ++round) {
      const double length = norm(d);
      if (length == 0) break;
      d = 1 / length * d;
      std::size_t worst = 0;
      double least = dot(sides[0], d);
      for (std::size_t i = 1; i < sides.size(); ++i)
        if (const double value = dot(sides[i], d); value < least) least = value, worst = i;
      if (least > margin) margin = least, best = d;
      d = d + 0.25 * sides[worst];
    }
    return best;
  }

  /// False if the way is not free at any step.
  bool move(std::size_t k, const Vec3& d) {
    if (reach_[k] == 0) return false;
    const Vec3 from = points_[copies_[k]];
    const Bounds allowed = room(k);
    double step = reach_[k];
    for (int i = 0; i <= effort_.halvings; ++i, step *= 0.5) {
      Vec3 to = from + step * d;
      if (!is_finite(to) || !confinement_.admit(umbrella(k), to)) continue;
      if (to == from || !overlap(allowed, {to, to}) || !is_free(k, to)) continue;
      points_[copies_[k]] = to;
      ++result_.separated;
      result_.largest = std::max(result_.largest, norm(to - from));
      return true;
    }
    return false;
  }

  /// Another copy is at its place.
  bool touches(std::size_t k) const {
    const auto is_here = [&](std::size_t i) { return points_[copies_[i]] == points_[copies_[k]]; };
    for (std::size_t i = k; i > 0 && same_origin(copies_[i - 1], copies_[k]); --i)
      if (is_here(i - 1)) return true;
    for (std::size_t i = k + 1; i < copies_.size() && same_origin(copies_[i], copies_[k]); ++i)
      if (is_here(i)) return true;
    return false;
  }

  /// Those still touching, along other directions; false if none moved.
  bool move_touching() {
    bool some = false;
    for (std::size_t k = 0; k < copies_.size(); ++k) {
      if (reach_[k] == 0 || !touches(k)) continue;
      for (const Vec3& d : directions(k))
        if (!context_.cancelled() && is_free_at_first(k, d) && move(k, d)) {
          some = true;
          break;
        }
    }
    return some;
  }

  /// The shortest step first: most directions fail, and fail there.
  bool is_free_at_first(std::size_t k, const Vec3& d) {
    Vec3 to = points_[copies_[k]] + std::ldexp(reach_[k], -effort_.halvings) * d;
    return is_finite(to) && confinement_.admit(umbrella(k), to) && is_free(k, to);
  }

  /// Into the cone, against it, and to all points of a grid around.
  std::vector<Vec3> directions(std::size_t k) const {
    const Vec3 d = direction(k);
    std::vector<Vec3> list{d, -d};
    constexpr int kHalf = 3;
    for (int x = -kHalf; x <= kHalf; ++x)
      for (int y = -kHalf; y <= kHalf; ++y)
        for (int z = -kHalf; z <= kHalf; ++z) {
          const Vec3 v{double(x), double(y), double(z)};
          if (norm(v) > 0) list.push_back(1 / norm(v) * v);
        }
    return list;
  }

  /// What the umbrella sweeps on the way to `to`, triangle by triangle.
  std::vector<Swept> sweep(std::size_t k, const Vec3& to) const {
    std::vector<Swept> swept;
    for (const std::uint32_t t : umbrellas_.of(k)) {
      const auto [a, b] = spokes(t, copies_[k]);
      swept.emplace_back(std::array{points_[copies_[k]], to, points_[a], points_[b]});
    }
    return swept;
  }

  /// A tree of what is swept, for vertices with a thousand triangles around them.
  bool is_free(std::size_t k, const Vec3& to) {
    const auto own = umbrellas_.of(k);
    const auto swept = sweep(k, to);
    std::vector<Bounds> boxes;
    std::vector<Vec3> places{points_[copies_[k]], to};  // all corners of what is swept
    for (const Swept& s : swept) {
      if (collinear({s.tet[1], s.tet[2], s.tet[3]})) return false;
      boxes.push_back(s.box);
      places.push_back(s.tet[2]);
    }
    const BoxTree tree(boxes);
    const std::vector<std::uint32_t> ends = ends_of(k);
    SweptSides sides(swept, points_, row_of_);
    SidesOfPlaces of_places(places);
    const auto own_blocks = [&](std::size_t at) {
      const Corners moved{to, swept[at].tet[2], swept[at].tet[3]};
      bool hit = false;
      tree.for_overlaps(bounds_of(moved), [&](std::uint32_t i) {
        hit = hit || (i != at && meeting({to, swept[i].tet[2], swept[i].tet[3]}, moved) != Meeting::none);
      });
      return hit;
    };
    const auto blocks = [&](std::uint32_t t) {
      const auto at = std::lower_bound(own.begin(), own.end(), t);
      if (at != own.end() && *at == t) return own_blocks(static_cast<std::size_t>(at - own.begin()));
      const Corners other = corners(t);
      const Bounds box = bounds_of(other);
      if (overlap(box, {to, to}) && contains(other, to)) return true;
      of_places.start(other);
      if (of_places.is_beside()) return false;  // as most are, around a vertex of many triangles
      const Triple row = sides.rows(surface_.triangles[t]);
      bool hit = false;
      tree.for_overlaps(box, [&](std::uint32_t i) {
        if (hit) return;
        const Sides side{sides.side(row[0], i), sides.side(row[1], i), sides.side(row[2], i)};
        if (may_meet(side))
          hit = meeting({to, swept[i].tet[2], swept[i].tet[3]},
                        {of_places.of(1), of_places.of(2 + std::size_t{i}), of_places.of(ends[i])}, other,
                        side) != Meeting::none;
        hit = hit || sides.is_held(row[0], i) || sides.is_held(row[1], i) || sides.is_held(row[2], i);
      });
      return hit;
    };
    // What is in the way of one place is mostly in the way of the next: it is asked first from then on.
    auto& neighbours = neighbours_[k];
    const auto blocker = std::find_if(neighbours.begin(), neighbours.end(), blocks);
    if (blocker == neighbours.end()) return true;
    std::rotate(neighbours.begin(), blocker, blocker + 1);
    return false;
  }

  /// For each triangle of the umbrella, where its second spoke is among the places of is_free: there two
  /// places come before the first spokes of all.
  std::vector<std::uint32_t> ends_of(std::size_t k) const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> first;
    for (const std::uint32_t t : umbrellas_.of(k))
      first.emplace_back(spokes(t, copies_[k])[0], static_cast<std::uint32_t>(2 + first.size()));
    std::sort(first.begin(), first.end());
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t t : umbrellas_.of(k)) {
      const std::pair<std::uint32_t, std::uint32_t> spoke{spokes(t, copies_[k])[1], 0};
      ends.push_back(std::lower_bound(first.begin(), first.end(), spoke)->second);
    }
    return ends;
  }

  /// In each run of copies, those at a place that a copy before them has.
  void find_touching() {
    for (std::size_t first = 0, last = 0; first < copies_.size(); first = last) {
      while (last < copies_.size() && same_origin(copies_[first], copies_[last])) ++last;
      for (std::size_t i = first; i < last; ++i)
        if (std::any_of(copies_.begin() + static_cast<std::ptrdiff_t>(first),
                        copies_.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](std::uint32_t v) { return points_[v] == points_[copies_[i]]; }))
          result_.touching.push_back(copies_[i]);
    }
  }

  Surface& surface_;
  std::vector<Vec3>& points_;
  std::span<const SurfaceVertex> origins_;
  const Confinement& confinement_;
  const SeparationEffort& effort_;
  const Context& context_;
  std::vector<std::uint32_t> number_;  ///< by vertex: its place in copies_, kNone if it has no other copy
  std::vector<std::uint32_t> copies_;  ///< ascending
  Lists umbrellas_;                    ///< by copy
  std::vector<double> reach_;          ///< by copy
  std::vector<std::vector<std::uint32_t>> neighbours_;  ///< by copy: triangles, what was in the way first
  std::vector<std::uint32_t> row_of_;                   ///< by vertex: of SweptSides
  Separation result_;
};

}  // namespace

Separation separate_copies(Surface& surface, std::span<const SurfaceVertex> origins,
                           const Confinement& confinement, const SeparationEffort& effort,
                           const Context& context) {
  return Separator(surface, origins, confinement, effort, context).run();
}

}  // namespace crossloft
