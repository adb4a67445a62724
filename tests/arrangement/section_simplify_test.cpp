/// The step of build_section_graph that leaves out contour vertices (arrangement/section_simplify.cpp).

#include <algorithm>
#include <map>
#include <set>

#include "../../arrangement/section_steps.h"
#include "../../geom/lattice_rounding.h"
#include "built_graph.h"
#include "polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Built simplified(const Sections& sections, double tolerance) {
  Built b = build(sections, 2e-3, 1e-9, tolerance);
  REQUIRE(b.graph.ok());
  return b;
}

double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return norm(p - a - t * d);
}

/// Input units: the largest distance of a contour vertex of `all` from the walls of its plane in `fewer`.
double deviation(const Built& all, const Built& fewer) {
  double largest = 0;
  for (std::uint32_t p = 0; p < all.graph->planes.size(); ++p)
    for (const Wall& wall : all.graph->walls[p])
      for (const std::uint32_t v : {wall.a, wall.b}) {
        double nearest = INFINITY;
        for (const Wall& w : fewer.graph->walls[p])
          nearest = std::min(nearest, distance(real(all.graph->points[v]), real(fewer.graph->points[w.a]),
                                               real(fewer.graph->points[w.b])));
        largest = std::max(largest, nearest);
      }
  return largest * all.framed.grid.unit();
}

/// The loops of plane p as vertices in turn. REQUIRES: all degrees 2.
std::vector<std::vector<std::uint32_t>> loops(const SectionGraph& graph, std::uint32_t p) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> next;
  for (const Wall& w : graph.walls[p]) next[w.a].push_back(w.b), next[w.b].push_back(w.a);
  std::vector<std::vector<std::uint32_t>> found;
  std::set<std::uint32_t> seen;
  for (const auto& [start, around] : next) {
    if (seen.count(start) != 0) continue;
    std::vector<std::uint32_t> loop{start};
    for (std::uint32_t v = around[0], before = start; v != start;) {
      loop.push_back(v);
      const std::uint32_t w = next[v][next[v][0] == before ? 1 : 0];
      before = v, v = w;
    }
    seen.insert(loop.begin(), loop.end());
    found.push_back(loop);
  }
  return found;
}

/// In a plane z = const, lattice units.
double area(const SectionGraph& graph, const std::vector<std::uint32_t>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = real(graph.points[loop[0]]), b = real(graph.points[loop[i]]),
               c = real(graph.points[loop[(i + 1) % loop.size()]]);
    sum += cross(b - a, c - a).z / 2;
  }
  return std::fabs(sum);
}

bool holds(const SectionGraph& graph, std::uint32_t p, const LatticePoint& point) {
  std::vector<WallEnds> ends;
  return graph.locator(p, ends).locate(point) == SectionLocator::Place::inside;
}

bool same(const SectionGraph& a, const SectionGraph& b) {
  if (a.size() != b.size()) return false;
  for (std::uint32_t v = 0; v < a.size(); ++v)
    if (!equal(a.points[v], b.points[v])) return false;
  for (std::uint32_t p = 0; p < a.planes.size(); ++p)
    if (!std::equal(a.walls[p].begin(), a.walls[p].end(), b.walls[p].begin(), b.walls[p].end(),
                    [](const Wall& x, const Wall& y) { return x.a == y.a && x.b == y.b && x.inside_left == y.inside_left; }))
      return false;
  return true;
}

Sections one_plane(const std::vector<std::vector<Vec3>>& contours) {
  Sections s;
  s.planes = {plane_at({0, 0, 1}, {0, 0, 0})};
  for (std::uint32_t c = 0; c < contours.size(); ++c) add_contour(s.planes[0], contours[c], c);
  return s;
}

/// Nested star-shaped contours around a point of z = 0 with random ripples, closer to each other than some tolerances.
/// `steps` > 0 puts the vertices on a grid of that many steps a unit: deviations come out equal in plenty.
std::vector<std::vector<Vec3>> ripples(std::mt19937_64& random, double x, int rings, int corners, double steps) {
  std::vector<std::vector<Vec3>> contours;
  for (int ring = 0; ring < rings; ++ring) {
    const double radius = 1 - 0.03 * ring;
    std::vector<Vec3> points;
    for (int i = 0; i < corners; ++i) {
      const double t = 6.283185307179586 * i / corners, r = radius + 0.012 * uniform(random);
      Vec3 p{x + r * std::cos(t), r * std::sin(t), 0};
      if (steps > 0) p = {std::round(p.x * steps) / steps, std::round(p.y * steps) / steps, 0};
      if (points.empty() || points.back() != p) points.push_back(p);
    }
    contours.push_back(points);
  }
  return contours;
}

/// What simplify_contours promises, step by step and by brute force: always the best of the vertices that may go.
class ByBruteForce {
 public:
  ByBruteForce(const SectionGraph& graph, double tolerance) : graph_(graph), tolerance_(tolerance) {}
  /// The walls that are left in plane p.
  std::set<std::pair<std::uint32_t, std::uint32_t>> run(std::uint32_t p) {
    next_.clear();
    replaced_.clear();
    plane_ = p;
    for (const Wall& w : graph_.walls[p]) next_[w.a].insert(w.b), next_[w.b].insert(w.a);
    while (step()) {
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> walls;
    for (const auto& [v, around] : next_)
      for (const std::uint32_t w : around) walls.insert(std::minmax(v, w));
    return walls;
  }

 private:
  using Key = std::tuple<double, std::size_t, std::uint32_t>;

  std::vector<std::uint32_t> replaced_without(std::uint32_t v, std::uint32_t u, std::uint32_t w) {
    std::vector<std::uint32_t> all = replaced_[std::minmax(u, v)];
    const auto& more = replaced_[std::minmax(v, w)];
    all.insert(all.end(), more.begin(), more.end());
    all.push_back(v);
    return all;
  }
  bool may_go(std::uint32_t v, std::uint32_t u, std::uint32_t w) const {
    if (graph_.common_planes(v, v) != 1 || graph_.common_planes(u, w) != 1 || next_.at(u).count(w) != 0) return false;
    const auto& [a, b, c] = std::tie(graph_.points[u], graph_.points[v], graph_.points[w]);
    const LatticePlane& plane = graph_.planes[plane_];
    const int turn = orient2d(plane, a, b, c);
    for (const auto& [x, around] : next_) {
      const LatticePoint& d = graph_.points[x];
      if (turn != 0 && x != u && x != v && x != w && turn * orient2d(plane, a, b, d) >= 0 &&
          turn * orient2d(plane, b, c, d) >= 0 && turn * orient2d(plane, c, a, d) >= 0)
        return false;
      if (x != u && x != v && x != w && grazes(real(a), real(c), real(d))) return false;
    }
    return true;
  }
  /// A segment that passes p, not at an end, at most at 1/1024 of the distance from the nearer end.
  static bool grazes(const Vec3& a, const Vec3& b, const Vec3& p) {
    const Vec3 d = b - a;
    if (dot(p - a, d) <= 0 || dot(p - b, d) >= 0) return false;
    return away(a, b, p) <= std::min(norm(p - a), norm(p - b)) / 1024;
  }
  static double away(const Vec3& a, const Vec3& b, const Vec3& p) {
    const Vec3 d = b - a;
    const double along = dot(p - a, d);
    return along <= 0 ? norm(p - a) : along >= dot(d, d) ? norm(p - b) : norm(cross(p - a, d)) / std::sqrt(dot(d, d));
  }
  bool step() {
    Key best{tolerance_, graph_.size(), kNone};
    for (const auto& [v, around] : next_) {
      if (around.size() != 2) continue;
      const std::uint32_t u = *around.begin(), w = *around.rbegin();
      double largest = 0;
      const auto all = replaced_without(v, u, w);
      for (const std::uint32_t x : all)
        largest = std::max(largest, away(real(graph_.points[u]), real(graph_.points[w]), real(graph_.points[x])));
      const Key key{largest, all.size(), v};
      if (key < best && may_go(v, u, w)) best = key;
    }
    const std::uint32_t v = std::get<2>(best);
    if (v == kNone) return false;
    const std::uint32_t u = *next_[v].begin(), w = *next_[v].rbegin();
    replaced_[std::minmax(u, w)] = replaced_without(v, u, w);
    next_.erase(v);
    next_[u].erase(v), next_[w].erase(v);
    next_[u].insert(w), next_[w].insert(u);
    return true;
  }

  const SectionGraph& graph_;
  double tolerance_;
  std::uint32_t plane_ = 0;
  std::map<std::uint32_t, std::set<std::uint32_t>> next_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> replaced_;
};

}  // namespace

TEST_CASE("off by default: nothing changes") {
  Sections s = one_plane({polygon({0, 0, 1}, {0, 0, 0}, 1, 100)});
  CHECK(build(s).graph->size() == 100);
  CHECK(build(s).graph->statistics.simplified == 0);
}

TEST_CASE("a circle keeps as many vertices as the tolerance asks for, and the deviation is the true one") {
  const Sections s = one_plane({polygon({0, 0, 1}, {0, 0, 0}, 1, 1000)});
  const Built all = build(s);
  std::size_t before = 1000;
  for (const double tolerance : {1e-5, 1e-4, 1e-3, 1e-2}) {
    CAPTURE(tolerance);
    const Built few = simplified(s, tolerance);
    const double limit = tolerance * few.framed.diagonal;
    const double reported = few.graph->statistics.deviation * few.framed.grid.unit();
    CHECK(few.graph->statistics.simplified == 1000 - few.graph->size());
    CHECK(reported <= limit);
    CHECK(reported > limit / 8);
    CHECK(deviation(all, few) == doctest::Approx(reported));
    // An edge over the angle 2 t is off by 1 - cos t; greedy removal leaves less than twice the fewest edges.
    const double fewest = 3.141592653589793 / std::acos(1 - limit);
    CHECK(few.graph->size() >= std::floor(fewest));
    CHECK(few.graph->size() <= 2 * fewest + 1);
    CHECK(few.graph->size() < before);
    before = few.graph->size();
  }
}

TEST_CASE("points on lines of planes stay, and with them what planes share") {
  Sections s;
  for (const Vec3& n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 2, 3}})
    s.planes.push_back(disk(n, {0, 0, 0}, 1, 400));
  const Built all = build(s), few = simplified(s, 0.05);
  CHECK(few.graph->size() < all.graph->size() / 10);
  std::vector<LatticePoint> pinned[2];
  for (const Built* b : {&all, &few})
    for (std::uint32_t v = 0; v < b->graph->size(); ++v)
      if (b->graph->common_planes(v, v) > 1) pinned[b == &few].push_back(b->graph->points[v]);
  CHECK(pinned[0].size() >= 12);
  CHECK(std::equal(pinned[0].begin(), pinned[0].end(), pinned[1].begin(), pinned[1].end(), equal));
  CHECK(few.graph->statistics.matched == all.graph->statistics.matched);
  // No wall came to lie on a line: a lobe keeps a vertex however flat it is.
  for (const auto& walls : few.graph->walls)
    for (const Wall& w : walls) CHECK(few.graph->common_planes(w.a, w.b) == 1);
  CHECK(deviation(all, few) <= 0.05 * few.framed.diagonal);
}

TEST_CASE("a lobe that pokes through another plane by less than the tolerance keeps poking") {
  Sections s;
  s.planes = {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({1, 0, 0}, {0.999, 0, 0})};
  add_contour(s.planes[0], polygon({0, 0, 1}, {0, 0, 0}, 1, 200));
  const Built few = simplified(s, 0.05);
  const auto beyond = [&](std::uint32_t v) { return few.graph->points[v].x; };
  std::uint32_t poking = 0;
  std::uint32_t upright = few.graph->planes[0].normal[0] != 0 ? 0 : 1;
  for (std::uint32_t v = 0; v < few.graph->size(); ++v)
    poking += side_of_plane(few.graph->planes[upright], few.graph->points[v]) ==
              side_of_plane(few.graph->planes[upright], make_point({kLatticeLimit, 0, 0}));
  CHECK(poking == 1);
  CHECK(beyond(few.graph->size() - 1) > 0);
}

TEST_CASE("nested contours closer than the tolerance stay nested and never touch") {
  // The outer one has its corners over the middles of the inner one's edges and, coarse, would cut through it.
  std::vector<Vec3> inner = polygon({0, 0, 1}, {0, 0, 0}, 0.999, 300), outer;
  for (int i = 0; i < 300; ++i) {
    const Vec3 middle = 0.5 * (inner[i] + inner[(i + 1) % 300]);
    outer.push_back((1 / norm(middle)) * middle);
  }
  for (const double tolerance : {1e-3, 1e-2, 0.1, 1.0}) {
    CAPTURE(tolerance);
    const Built few = simplified(one_plane({outer, inner}), tolerance);  // verify() finds none that cross
    CHECK(few.graph->size() < 300);
    const auto rings = loops(*few.graph, 0);
    REQUIRE(rings.size() == 2);
    for (const auto& ring : rings) CHECK(ring.size() >= 3);
    const std::size_t large = area(*few.graph, rings[0]) > area(*few.graph, rings[1]) ? 0 : 1;
    std::vector<WallEnds> ends;
    for (std::size_t i = 0; i < rings[large].size(); ++i)
      ends.push_back({rings[large][i], rings[large][(i + 1) % rings[large].size()]});
    const SectionLocator locator(few.graph->planes[0], few.graph->points, ends);
    for (const std::uint32_t v : rings[1 - large])
      CHECK(locator.locate(few.graph->points[v]) == SectionLocator::Place::inside);
  }
}

TEST_CASE("no wall that replaces others passes a vertex within a thousandth of its length") {
  const double hair = 1e-12;  // the upper contour's long side would pass the lower one's middle this near
  const Sections sections = one_plane({{{0, 1, 0}, {2, 1.1, 0}, {4, 1, 0}, {4, 3, 0}, {0, 3, 0}},
                                       {{0, 0, 0}, {4, 0, 0}, {2, 1 - hair, 0}}});
  const Built b = simplified(sections, 0.1);
  CHECK(b.graph->walls[0].size() == 8);
}

TEST_CASE("loops that would vanish stay as triangles that have an area") {
  std::vector<std::vector<Vec3>> contours{square(0, 0, 0, 1)};
  for (int i = 0; i < 5; ++i) contours.push_back(polygon({0, 0, 1}, {-0.8 + 0.4 * i, 0.1 * i, 0}, 1e-3, 3 + 7 * i));
  const Built few = simplified(one_plane(contours), 0.1);
  const auto rings = loops(*few.graph, 0);
  CHECK(rings.size() == 6);
  for (const auto& ring : rings) {
    CHECK(ring.size() >= 3);
    CHECK(area(*few.graph, ring) > 0);
  }
}

TEST_CASE("contours that touch keep the point they share") {
  std::vector<Vec3> left, right;
  for (const Vec3& p : polygon({0, 0, 1}, {0, 0, 0}, 1, 64)) left.push_back(p - Vec3{1, 0, 0}), right.push_back({1 - p.x, p.y, 0});
  left[16] = right[16] = {0, 0, 0};  // the corner furthest along x
  const Built few = simplified(one_plane({left, right}), 0.01);
  std::vector<int> degree(few.graph->size(), 0);
  for (const Wall& w : few.graph->walls[0]) ++degree[w.a], ++degree[w.b];
  CHECK(std::count(degree.begin(), degree.end(), 4) == 1);
  CHECK(few.graph->size() < 60);
}

TEST_CASE("exactly straight runs go at no deviation, however long") {
  std::vector<Vec3> points;
  const int n = 3000;
  for (const auto& [from, step] : {std::pair{Vec3{0, 0, 0}, Vec3{1, 0, 0}}, std::pair{Vec3{n, 0, 0}, Vec3{-1, 1, 0}},
                                   std::pair{Vec3{0, n, 0}, Vec3{0, -1, 0}}})
    for (int i = 0; i < n; ++i) points.push_back(from + i * step);
  const Built few = simplified(one_plane({points}), 1e-12);
  CHECK(few.graph->size() == 3);
  CHECK(few.graph->statistics.deviation == 0);
}

TEST_CASE("as by brute force, on ripples and on a grid where most deviations are equal") {
  const std::uint64_t seed = 3;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 24; ++round) {
    CAPTURE(round);
    Sections s = one_plane(ripples(random, 0, 3, 60 + 2 * round, round % 2 == 0 ? 0 : 256));
    if (round % 3 == 0) s.planes.push_back(plane_at({1, 0.25, 0}, {0.3, 0, 0}));
    const double tolerance = round % 4 == 0 ? 1e-3 : round % 4 == 1 ? 3e-3 : round % 4 == 2 ? 1e-2 : 0.1;
    Built all = build(s);
    if (!all.graph.ok()) continue;  // the grid made the ripples cross
    SectionGraph& graph = *all.graph;
    const double limit = tolerance * all.framed.diagonal / all.framed.grid.unit();
    std::vector<std::set<std::pair<std::uint32_t, std::uint32_t>>> expected;
    for (std::uint32_t p = 0; p < graph.planes.size(); ++p) expected.push_back(ByBruteForce(graph, limit).run(p));
    const std::vector<LatticePoint> before = graph.points;
    section_steps::simplify_contours(graph, limit);
    for (std::uint32_t p = 0; p < graph.planes.size(); ++p) {
      CHECK(graph.walls[p].size() == expected[p].size());
      std::size_t w = 0;
      for (const auto& [a, b] : expected[p]) {
        if (w == graph.walls[p].size()) break;
        CHECK(equal(graph.points[graph.walls[p][w].a], before[a]));
        CHECK(equal(graph.points[graph.walls[p][w].b], before[b]));
        ++w;
      }
    }
    const Built few = simplified(s, tolerance);
    CHECK(few.graph->statistics.simplified > 0);
    CHECK(deviation(build(s), few) <= few.graph->statistics.deviation * few.framed.grid.unit() * (1 + 1e-9));
  }
}

TEST_CASE("where a contour starts, which way it runs and the order of contours leave no trace") {
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (const double steps : {0.0, 512.0}) {
    auto contours = ripples(random, 0, 2, 150, steps);
    for (auto& more : ripples(random, 3, 2, 150, steps)) contours.push_back(more);
    const Built reference = simplified(one_plane(contours), 3e-3);
    CHECK(reference.graph->statistics.simplified > 100);
    for (int round = 0; round < 10; ++round) {
      for (auto& contour : contours) {
        std::rotate(contour.begin(), contour.begin() + static_cast<std::ptrdiff_t>(random() % contour.size()), contour.end());
        if (random() % 2 != 0) std::reverse(contour.begin(), contour.end());
      }
      std::swap(contours[random() % 4], contours[random() % 4]);
      CHECK(same(*simplified(one_plane(contours), 3e-3).graph, *reference.graph));
    }
  }
}

TEST_CASE("inside stays inside: points further from the contours than the tolerance are where they were") {
  const std::uint64_t seed = 9;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Sections s = one_plane(ripples(random, 0, 5, 200, 0));
  const Built all = build(s), few = simplified(s, 5e-3);
  const double limit = 5e-3 * few.framed.diagonal / few.framed.grid.unit();
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const LatticePoint p = plane_point(
        all.graph->planes[0], static_cast<std::int64_t>(uniform(random) * 0x1p49), static_cast<std::int64_t>(uniform(random) * 0x1p49));
    double nearest = INFINITY;
    for (const Wall& w : all.graph->walls[0])
      nearest = std::min(nearest, distance(real(p), real(all.graph->points[w.a]), real(all.graph->points[w.b])));
    if (nearest <= limit) continue;
    ++compared;
    CHECK(holds(*all.graph, 0, p) == holds(*few.graph, 0, p));
  }
  CHECK(compared > 100);
}
