/// Third step: the crossings that two sections have with their common line are made one, edge by edge of the
/// arrangement, so that none moves past an arrangement vertex.

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "../geom/plane_line.h"
#include "section_steps.h"

namespace crossloft::section_steps {
namespace {

/// A contour vertex of plane p in the interior of an arrangement edge.
struct OnEdge {
  std::uint32_t edge = 0, plane = 0, vertex = 0;
};

/// Crossings at one point of an edge, at most one of each plane.
struct Cluster {
  LatticePoint at;
  std::vector<OnEdge> members;
  double gap = 0;  ///< longest way that was closed
};

/// A vertex that was moved, and where it was; `merge` numbers the clusters.
struct Move {
  std::uint32_t vertex = 0, plane = 0, merge = 0;
  LatticePoint before;
};

double gap(const Cluster& a, const Cluster& b) {
  return norm({a.at.x - b.at.x, a.at.y - b.at.y, a.at.z - b.at.z});
}

bool disjoint_planes(const Cluster& a, const Cluster& b) {
  for (const OnEdge& x : a.members)
    for (const OnEdge& y : b.members)
      if (x.plane == y.plane) return false;
  return true;
}

/// The pairs of neighbours along an edge that may be joined: of disjoint planes, within the tolerance.
class NearPairs {
 public:
  NearPairs(const std::vector<Cluster>& clusters, double tolerance);
  /// The lower one of the nearest pair, the first along the edge on a tie; kNone if there is none.
  std::uint32_t nearest();
  std::uint32_t next(std::uint32_t m) const { return next_[m]; }
  /// To be told when m has taken in its next one, which is out of the list then.
  void joined(std::uint32_t m);

 private:
  struct Pair {
    double gap = 0;
    std::uint32_t lower = 0, version = 0;  ///< out of date if a later one begins there
    friend bool operator>(const Pair& x, const Pair& y) {
      return std::tie(x.gap, x.lower) > std::tie(y.gap, y.lower);
    }
  };
  void measure(std::uint32_t m);

  const std::vector<Cluster>& clusters_;
  double tolerance_;
  std::vector<std::uint32_t> next_, previous_, version_;  ///< kNone beyond the ends
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue_;
};

NearPairs::NearPairs(const std::vector<Cluster>& clusters, double tolerance)
    : clusters_(clusters),
      tolerance_(tolerance),
      next_(clusters.size()),
      previous_(clusters.size()),
      version_(clusters.size(), 0) {
  const auto count = static_cast<std::uint32_t>(clusters.size());
  for (std::uint32_t m = 0; m < count; ++m) {
    previous_[m] = m == 0 ? kNone : m - 1;
    next_[m] = m + 1 == count ? kNone : m + 1;
    measure(m);
  }
}

/// Puts m and its next one into the queue if they may be joined; outdates what was said of m before.
void NearPairs::measure(std::uint32_t m) {
  const std::uint32_t version = ++version_[m], n = next_[m];
  if (n == kNone) return;
  const double width = gap(clusters_[m], clusters_[n]);
  if (width <= tolerance_ && disjoint_planes(clusters_[m], clusters_[n])) queue_.push({width, m, version});
}

std::uint32_t NearPairs::nearest() {
  while (!queue_.empty()) {
    const Pair pair = queue_.top();
    queue_.pop();
    if (pair.version == version_[pair.lower]) return pair.lower;
  }
  return kNone;
}

void NearPairs::joined(std::uint32_t m) {
  const std::uint32_t gone = next_[m];
  ++version_[gone];
  next_[m] = next_[gone];
  if (next_[m] != kNone) previous_[next_[m]] = m;
  measure(m);
  if (previous_[m] != kNone) measure(previous_[m]);
}

class Matcher {
 public:
  Matcher(SectionGraph& graph, const Arrangement& arrangement, LatticePointStore& store, double tolerance)
      : graph_(graph),
        arrangement_(arrangement),
        store_(store),
        tolerance_(tolerance),
        changed_(graph.planes.size(), 0) {}
  void run(const Context& context);

 private:
  std::vector<OnEdge> collect() const;
  std::vector<Cluster> clusters(std::span<const OnEdge> items) const;
  std::vector<std::vector<Cluster>> by_edge() const;
  void merge_nearest(std::vector<Cluster>& clusters);
  bool join(std::uint32_t edge, Cluster& a, Cluster& b);
  void apply(const std::vector<Cluster>& clusters);
  void count(const std::vector<Cluster>& clusters);
  void count_unpaired(const std::vector<Cluster>& clusters);
  std::vector<std::uint32_t> missing_planes(const Cluster& cluster) const;
  bool undo_crossing_contours();
  int axis_of(std::uint32_t edge) const {
    const auto [p, q] = arrangement_.planes_of(ArrEdgeId{edge});
    return line_axis(arrangement_.plane(p), arrangement_.plane(q));
  }

  SectionGraph& graph_;
  const Arrangement& arrangement_;
  LatticePointStore& store_;
  double tolerance_;
  std::vector<Move> moves_;
  std::vector<std::uint8_t>
      changed_;  ///< by plane: its vertices have moved since it was looked at for conflicts
  std::vector<double> merge_gaps_;
};

std::vector<OnEdge> Matcher::collect() const {
  std::vector<OnEdge> found;
  std::vector<std::uint32_t> seen(graph_.size(), kNone);
  RowLocations location(graph_, arrangement_);
  for (std::uint32_t p = 0; p < graph_.planes.size(); ++p)
    for (const Wall& wall : graph_.walls[p])
      for (const std::uint32_t v : {wall.a, wall.b}) {
        if (!graph_.on_line(v) || seen[v] == p) continue;
        seen[v] = p;
        const Location at = location.of(v);
        if (at.dimension == 1 && at.found()) found.push_back({at.index, p, v});
      }
  return found;
}

/// Along the edge; several vertices of one plane at one point (contours that touch there) stay together.
std::vector<Cluster> Matcher::clusters(std::span<const OnEdge> items) const {
  std::vector<Cluster> result;
  for (const OnEdge& item : items) {
    const LatticePoint& at = graph_.points[item.vertex];
    if (result.empty() || !equal(result.back().at, at)) result.push_back({at, {}, 0});
    result.back().members.push_back(item);
  }
  return result;
}

bool Matcher::join(std::uint32_t edge, Cluster& a, Cluster& b) {
  const auto [p, q] = arrangement_.planes_of(ArrEdgeId{edge});
  const int axis = axis_of(edge);
  // Both are integers: the middle, rounded down, is between them and so past nothing.
  const double middle = std::floor((a.at[axis] + b.at[axis]) / 2);
  LatticePoint at;
  if (!line_point(store_, arrangement_.plane(p), arrangement_.plane(q), static_cast<std::int64_t>(middle),
                  at))
    return false;
  a.gap = std::max({a.gap, b.gap, gap(a, b)});
  a.at = at;
  a.members.insert(a.members.end(), b.members.begin(), b.members.end());
  return true;
}

/// Neighbours of disjoint planes, the narrowest gap first.
void Matcher::merge_nearest(std::vector<Cluster>& clusters) {
  NearPairs pairs(clusters, tolerance_);
  for (std::uint32_t m = pairs.nearest(); m != kNone; m = pairs.nearest()) {
    Cluster& gone = clusters[pairs.next(m)];
    if (!join(clusters[m].members[0].edge, clusters[m], gone)) break;
    gone.members.clear();
    pairs.joined(m);
  }
  std::erase_if(clusters, [](const Cluster& cluster) { return cluster.members.empty(); });
}

void Matcher::apply(const std::vector<Cluster>& clusters) {
  for (const Cluster& cluster : clusters) {
    if (cluster.gap == 0) continue;
    for (const OnEdge& member : cluster.members) {
      moves_.push_back({member.vertex, member.plane, static_cast<std::uint32_t>(merge_gaps_.size()),
                        graph_.points[member.vertex]});
      changed_[member.plane] = 1;
      graph_.move(member.vertex, cluster.at);
    }
    merge_gaps_.push_back(cluster.gap);
    graph_.statistics.widest_pair = std::max(graph_.statistics.widest_pair, cluster.gap);
  }
}

void Matcher::count_unpaired(const std::vector<Cluster>& clusters) {
  for (const Cluster& cluster : clusters)
    if (missing_planes(cluster).size() != 0)
      graph_.statistics.unpaired += static_cast<std::uint32_t>(cluster.members.size());
}

/// The planes through the edge whose contours do not cross it here.
std::vector<std::uint32_t> Matcher::missing_planes(const Cluster& cluster) const {
  const SignView signs = arrangement_.signs(ArrEdgeId{cluster.members[0].edge});
  std::vector<std::uint32_t> missing;
  for (std::uint32_t p = 0; p < graph_.planes.size(); ++p)
    if (has_bit(signs.zero, PlaneId{p}) && std::none_of(cluster.members.begin(), cluster.members.end(),
                                                        [&](const OnEdge& m) { return m.plane == p; }))
      missing.push_back(p);
  return missing;
}

/// Takes back every merge that has a vertex on two contour edges in conflict. True if there was one.
bool Matcher::undo_crossing_contours() {
  std::vector<std::uint32_t> merge_of(graph_.size(), kNone);
  for (const Move& m : moves_) merge_of[m.vertex] = m.merge;
  std::vector<bool> undo(merge_gaps_.size(), false);
  bool any = false;
  for (std::uint32_t p = 0; p < graph_.planes.size(); ++p) {
    if (changed_[p] == 0) continue;  // what conflicts there has not been merged
    changed_[p] = 0;
    std::vector<WallEnds> ends;
    for (const auto& pair : graph_.locator(p, ends).conflicts())
      for (const std::uint32_t w : pair)
        for (const std::uint32_t v : {ends[w].a, ends[w].b})
          if (merge_of[v] != kNone) undo[merge_of[v]] = any = true;
  }
  if (!any) return false;
  std::erase_if(moves_, [&](const Move& m) {
    if (!undo[m.merge]) return false;
    graph_.move(m.vertex, m.before);
    changed_[m.plane] = 1;
    return true;
  });
  for (std::size_t m = 0; m < undo.size(); ++m)
    if (undo[m]) {
      merge_gaps_[m] = 0;
      ++graph_.statistics.undone;
    }
  return true;
}

/// Every plane through an edge should cross it where one does.
void Matcher::count(const std::vector<Cluster>& clusters) {
  CrossingStatistics& s = graph_.statistics;
  for (const Cluster& cluster : clusters) {
    const std::vector<std::uint32_t> missing = missing_planes(cluster);
    for (const std::uint32_t p : missing) s.unmatched.push_back({cluster.members[0].plane, p, cluster.at});
    const auto members = static_cast<std::uint32_t>(cluster.members.size());
    s.crossings += members;
    if (missing.empty()) s.matched += members;
  }
}

/// The crossings edge by edge, each edge's in order along it.
std::vector<std::vector<Cluster>> Matcher::by_edge() const {
  std::vector<OnEdge> items = collect();
  std::sort(items.begin(), items.end(), [&](const OnEdge& x, const OnEdge& y) {
    if (x.edge != y.edge) return x.edge < y.edge;
    if (const int s = compare_lex(graph_.points[x.vertex], graph_.points[y.vertex])) return s < 0;
    return x.plane != y.plane ? x.plane < y.plane : x.vertex < y.vertex;
  });
  std::vector<std::vector<Cluster>> edges;
  for (std::size_t begin = 0, end; begin < items.size(); begin = end) {
    for (end = begin; end < items.size() && items[end].edge == items[begin].edge;) ++end;
    edges.push_back(clusters({items.data() + begin, items.data() + end}));
  }
  return edges;
}

void Matcher::run(const Context& context) {
  for (std::vector<Cluster>& clusters : by_edge()) {
    if (context.cancelled()) return;
    merge_nearest(clusters);
    apply(clusters);
    count_unpaired(clusters);
  }
  while (!context.cancelled() && !moves_.empty() && undo_crossing_contours()) {
  }
  for (const double g : merge_gaps_)
    graph_.statistics.largest_gap = std::max(graph_.statistics.largest_gap, g);
  for (const std::vector<Cluster>& clusters : by_edge()) count(clusters);
}

}  // namespace

void match_crossings(SectionGraph& graph, const Arrangement& arrangement, LatticePointStore& store,
                     double tolerance, const Context& context) {
  Matcher(graph, arrangement, store, tolerance).run(context);
}

}  // namespace crossloft::section_steps
