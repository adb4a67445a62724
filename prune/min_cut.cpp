#include "min_cut.h"

#include <algorithm>

#include "star.h"

namespace crossloft {
namespace {

constexpr std::uint32_t kFree = kNone;  ///< level of what is not in the forest

/// Parent of a node: a facet 0..3, or one of these.
constexpr std::uint8_t kSource = 4;    ///< the source itself: excess > 0, level 0
constexpr std::uint8_t kNoParent = 5;  ///< free, or an orphan in want of a parent

struct Node {
  std::int64_t excess;  ///< what is left of the terminal's capacity, signed like it
  std::uint32_t level;  ///< arcs on the shortest path from a node with excess > 0
  std::uint8_t parent;  ///< facet across which that path comes
  std::uint8_t entry;   ///< the same facet, as a slot of the parent
};

/// The forest of shortest residual paths from the source, grown level by level.
///
/// Between augmentations a node is in the forest iff it has excess > 0 (a root), or an arc with residual
/// capacity leads to it from its parent, one level nearer. Nodes before level `depth_` have no such arc to a
/// free node; those of `front_` at that level may have; `next_` holds all at the level after. Either list may
/// also hold nodes that have left the level.
///
/// Levels are exact and never sink: augmenting paths are shortest, so they add arcs from a level to the one
/// before only. Hence a node is relabelled less than n times and an arc saturated less than n times.
class AugmentingForest {
 public:
  explicit AugmentingForest(const CutProblem& problem)
      : neighbours_(problem.neighbours),
        capacity_(problem.capacity),
        cancel_(problem.cancel),
        flow_(neighbours_.size()),
        nodes_(neighbours_.size()) {
    for (std::uint32_t t = 0; t < nodes_.size(); ++t) {
      const std::int64_t terminal = problem.terminal[t];
      nodes_[t] = {terminal, kFree, kNoParent, 0};
      if (terminal <= 0) continue;
      nodes_[t] = {terminal, 0, kSource, 0};
      front_.push_back(t);
    }
  }

  MinCut run() {
    for (; !front_.empty() && !is_raised(cancel_); ++depth_) {
      orphans_.resize(depth_ + std::size_t{2});
      for (const std::uint32_t t : front_)
        if (!is_raised(cancel_)) scan(t);
      front_.swap(next_);
      next_.clear();
    }
    MinCut cut{std::vector<std::uint8_t>(nodes_.size()), value_, std::move(flow_)};
    for (std::uint32_t t = 0; t < nodes_.size(); ++t) cut.kept[t] = nodes_[t].level != kFree ? 1 : 0;
    return cut;
  }

 private:
  /// Residual capacity out of t through facet i, and into t.
  std::int64_t outward(std::uint32_t t, unsigned i) const { return capacity_[t][i] - flow_[t][i]; }
  std::int64_t inward(std::uint32_t t, unsigned i) const { return capacity_[t][i] + flow_[t][i]; }

  std::uint8_t facet_to(std::uint32_t t, std::uint32_t n) const {
    return static_cast<std::uint8_t>(slot_of(neighbours_[t], n));
  }

  /// Sends flow to the sink, or takes the neighbour in, until no arc leads from t to a free node.
  void scan(std::uint32_t t) {
    for (std::uint8_t i = 0; i < 4; ++i) {
      const std::uint32_t n = neighbours_[t][i];
      // An augmentation saturates the arc, or uses up n, or makes an orphan on the way to t, which may move
      // t.
      while (nodes_[t].level == depth_ && outward(t, i) > 0 && nodes_[n].level == kFree) {
        if (nodes_[n].excess < 0) {
          augment(t, i);
        } else {
          nodes_[n] = {0, depth_ + 1, facet_to(n, t), i};
          next_.push_back(n);
        }
      }
    }
  }

  void augment(std::uint32_t t, std::uint8_t facet) {
    const std::uint32_t sink = neighbours_[t][facet];
    const std::int64_t flow = std::min({bottleneck(t), outward(t, facet), -nodes_[sink].excess});
    value_ += flow;
    nodes_[sink].excess += flow;
    flow_[t][facet] += flow;
    flow_[sink][facet_to(sink, t)] -= flow;
    while (nodes_[t].parent != kSource) {
      const Node node = nodes_[t];
      const std::uint32_t parent = neighbours_[t][node.parent];
      flow_[parent][node.entry] += flow;
      flow_[t][node.parent] -= flow;
      if (inward(t, node.parent) == 0) make_orphan(t);
      t = parent;
    }
    nodes_[t].excess -= flow;
    if (nodes_[t].excess == 0) make_orphan(t);
    adopt();
  }

  /// The largest flow that the path from the source to t can take.
  std::int64_t bottleneck(std::uint32_t t) const {
    std::int64_t flow = kUncuttable;
    for (; nodes_[t].parent != kSource; t = neighbours_[t][nodes_[t].parent])
      flow = std::min(flow, inward(t, nodes_[t].parent));
    return std::min(flow, nodes_[t].excess);
  }

  void make_orphan(std::uint32_t t) {
    nodes_[t].parent = kNoParent;
    orphans_[nodes_[t].level].push_back(t);
    lowest_orphan_ = std::min(lowest_orphan_, nodes_[t].level);
  }

  /// Gives each orphan a parent or frees it. By rising level, so that what lies before is settled.
  void adopt() {
    for (; lowest_orphan_ < orphans_.size(); ++lowest_orphan_) {
      for (const std::uint32_t t : orphans_[lowest_orphan_]) settle(t);
      orphans_[lowest_orphan_].clear();
    }
  }

  /// An orphan keeps its level if an arc comes from one level nearer. Else its level rises to what its
  /// neighbours allow, which are lower bounds as long as some of them are orphans, and its turn comes again.
  void settle(std::uint32_t t) {
    Node& node = nodes_[t];
    std::uint32_t nearest = depth_ + 1;
    for (std::uint8_t i = 0; i < 4; ++i) {
      if (inward(t, i) == 0) continue;
      const std::uint32_t n = neighbours_[t][i];
      if (nodes_[n].level >= nearest) continue;
      nearest = nodes_[n].level;
      if (nearest + 1 != node.level) continue;
      node.parent = i;
      node.entry = facet_to(n, t);
      return;
    }
    orphan_children(t);
    node.level = nearest > depth_ ? kFree : nearest + 1;
    if (node.level == kFree) return;
    if (node.level == depth_ + 1) next_.push_back(t);
    make_orphan(t);
  }

  void orphan_children(std::uint32_t t) {
    for (std::uint8_t i = 0; i < 4; ++i) {
      const std::uint32_t n = neighbours_[t][i];
      if (n == kNone || nodes_[n].parent >= 4 || nodes_[n].entry != i) continue;
      if (neighbours_[n][nodes_[n].parent] == t) make_orphan(n);
    }
  }

  std::span<const std::array<std::uint32_t, 4>> neighbours_;
  std::span<const std::array<std::int64_t, 4>> capacity_;
  const CancelFlag cancel_;
  std::vector<std::array<std::int64_t, 4>> flow_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> front_;
  std::vector<std::uint32_t> next_;
  std::vector<std::vector<std::uint32_t>> orphans_;  ///< by level, up to depth_ + 1
  std::uint32_t lowest_orphan_ = 0;
  std::uint32_t depth_ = 0;
  std::int64_t value_ = 0;
};

/// True iff no arc of t carries more than its capacity, and one direction the negative of the other.
bool is_feasible(const CutProblem& problem, const MinCut& cut, std::uint32_t t) {
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t n = problem.neighbours[t][i];
    const std::int64_t flow = cut.flow[t][i];
    if (flow > problem.capacity[t][i] || flow < -problem.capacity[t][i]) return false;
    if (n != kNone && cut.flow[n][slot_of(problem.neighbours[n], t)] != -flow) return false;
  }
  return true;
}

/// What t takes from the source, negative into the sink: all that leaves through its facets.
std::int64_t net_outflow(const MinCut& cut, std::uint32_t t) {
  const auto& flow = cut.flow[t];
  return flow[0] + flow[1] + flow[2] + flow[3];
}

/// What t adds to the value of the cut: its facets to dropped tetrahedra, or its own price.
std::int64_t price_of(const CutProblem& problem, const MinCut& cut, std::uint32_t t) {
  if (cut.kept[t] == 0) return std::max<std::int64_t>(problem.terminal[t], 0);
  std::int64_t price = std::max<std::int64_t>(-problem.terminal[t], 0);
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t n = problem.neighbours[t][i];
    if (n != kNone && cut.kept[n] == 0) price += problem.capacity[t][i];
  }
  return price;
}

/// The tetrahedra to which the source can still send.
std::vector<std::uint8_t> reached_from_source(const CutProblem& problem, const MinCut& cut) {
  std::vector<std::uint8_t> reached(cut.kept.size());
  std::vector<std::uint32_t> queue;
  const auto reach = [&](std::uint32_t t) {
    if (reached[t] == 0) queue.push_back(t);
    reached[t] = 1;
  };
  for (std::uint32_t t = 0; t < reached.size(); ++t)
    if (problem.terminal[t] > std::max<std::int64_t>(net_outflow(cut, t), 0)) reach(t);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::uint32_t t = queue[head];
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = problem.neighbours[t][i];
      if (n != kNone && cut.flow[t][i] < problem.capacity[t][i]) reach(n);
    }
  }
  return reached;
}

}  // namespace

MinCut minimum_cut(const CutProblem& problem) { return AugmentingForest(problem).run(); }

bool verify(const CutProblem& problem, const MinCut& cut) {
  const std::size_t n = problem.neighbours.size();
  if (cut.kept.size() != n || cut.flow.size() != n) return false;
  std::int64_t flow_value = 0;
  std::int64_t cut_value = 0;
  for (std::uint32_t t = 0; t < n; ++t) {
    if (!is_feasible(problem, cut, t)) return false;
    const std::int64_t flow = net_outflow(cut, t);
    const std::int64_t terminal = problem.terminal[t];
    if (flow < std::min<std::int64_t>(terminal, 0) || flow > std::max<std::int64_t>(terminal, 0))
      return false;
    flow_value += std::max<std::int64_t>(flow, 0);
    cut_value += price_of(problem, cut, t);
    if (std::max(flow_value, cut_value) > cut.value) return false;
  }
  return flow_value == cut.value && cut_value == cut.value && reached_from_source(problem, cut) == cut.kept;
}

}  // namespace crossloft
