#include "cell_outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "arc_trace.h"

namespace crossloft {
namespace {

/// True if a vertex lies so near to the border that it could be taken to be inside for one arc and outside
/// for another.
bool has_vertex_at_border(const MoebiusDiagram& diagram, const ViewBox& box) {
  constexpr double kNear = 1e-9;
  const Vec2 reach = kNear * box.size();
  return std::any_of(diagram.vertices.begin(), diagram.vertices.end(), [&](Vec2 v) {
    const auto near = [](double a, double b, double most) { return std::abs(a - b) <= most; };
    return near(v.x, box.low.x, reach.x) || near(v.x, box.high.x, reach.x) || near(v.y, box.low.y, reach.y) ||
           near(v.y, box.high.y, reach.y);
  });
}

ViewBox box_around(const MoebiusDiagram& diagram, const ViewBox& view) {
  constexpr double kMargin = 0.02, kStep = 0.00037;
  constexpr int kMostSteps = 20;
  ViewBox box = view;
  for (int i = 0; i < kMostSteps; ++i) {
    const Vec2 margin = (kMargin + i * kStep) * view.size();
    box = {view.low - margin, view.high + margin};
    if (!has_vertex_at_border(diagram, box)) break;
  }
  return box;
}

constexpr double kSamePosition = 1e-7;  ///< of the border, a fraction of a side

/// Where an arc crosses the border, and which cells have the border before and after it, counter-clockwise.
struct Crossing {
  double position;
  std::uint32_t arc, run;
  bool leaves;  ///< the arc, walked forwards, leaves the box here
  std::uint32_t before, after;
  Vec2 at;
};

std::vector<Crossing> find_crossings(const MoebiusDiagram& diagram, const DiagramInBox& clipped) {
  std::vector<Crossing> crossings;
  for (std::uint32_t a = 0; a < clipped.arcs.size(); ++a) {
    const auto [left, right] = diagram.arcs[a].sites;
    for (std::uint32_t r = 0; r < clipped.arcs[a].size(); ++r) {
      const CurveRun& run = clipped.arcs[a][r];
      const Vec2 in = run.pieces.front().from, out = run.pieces.back().to;
      // Looking out of the box, what follows counter-clockwise is on the left.
      if (run.enters) crossings.push_back({border_position(in, clipped.box), a, r, false, left, right, in});
      if (run.leaves) crossings.push_back({border_position(out, clipped.box), a, r, true, right, left, out});
    }
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.position, a.arc, a.run, a.leaves) < std::tie(b.position, b.arc, b.run, b.leaves);
  });
  return crossings;
}

/// Puts crossings at nearly the same place in the order in which every stretch of the border has the same
/// cell at both ends.
void settle_order(std::vector<Crossing>& crossings) {
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const std::ptrdiff_t here = static_cast<std::ptrdiff_t>(i);
    const double last = crossings[i].position + kSamePosition;
    const auto end = std::find_if(crossings.begin() + here, crossings.end(),
                                  [last](const Crossing& c) { return c.position > last; });
    const auto fit =
        std::find_if(crossings.begin() + here, end,
                     [owner = crossings[i - 1].after](const Crossing& c) { return c.before == owner; });
    if (fit != end) std::rotate(crossings.begin() + here, fit, fit + 1);
  }
}

/// The border from one position counter-clockwise to another, which is less than 4 more.
Outline border_between(Vec2 from, double from_position, Vec2 to, double to_position, const ViewBox& box) {
  Outline pieces;
  for (unsigned corner = static_cast<unsigned>(from_position) + 1; corner < to_position; ++corner) {
    const Vec2 next = border_corner(corner % 4, box);
    pieces.push_back({from, next, true, {}, 0, false});
    from = next;
  }
  pieces.push_back({from, to, true, {}, 0, false});
  return pieces;
}

/// A part of the outline of one cell, which is on its left, from node to node.
struct Step {
  std::uint32_t begin, site, end;
  Outline pieces;
};

/// Nodes are the vertices, then one for each arc (where the walk along a whole circle begins and ends), then
/// the crossings. At each of them a cell begins at most one step.
class OutlineChainer {
 public:
  OutlineChainer(const MoebiusDiagram& diagram, DiagramInBox& clipped)
      : diagram_(diagram), clipped_(clipped), crossings_(find_crossings(diagram, clipped)) {
    settle_order(crossings_);
  }

  void chain() {
    add_arc_steps();
    add_border_steps();
    std::sort(steps_.begin(), steps_.end(), [](const Step& a, const Step& b) {
      return std::tie(a.begin, a.site, a.end) < std::tie(b.begin, b.site, b.end);
    });
    done_.assign(steps_.size(), false);
    for (std::size_t s = 0; s < steps_.size(); ++s) {
      if (!done_[s]) clipped_.cells[steps_[s].site].push_back(outline_from(s));
    }
  }

 private:
  using Ends = std::array<std::uint32_t, 2>;

  std::uint32_t arc_node(std::size_t arc) const {
    return static_cast<std::uint32_t>(diagram_.vertices.size() + arc);
  }
  std::uint32_t crossing_node(std::size_t crossing) const {
    return static_cast<std::uint32_t>(diagram_.vertices.size() + diagram_.arcs.size() + crossing);
  }

  /// The nodes at which each run of each arc begins and ends.
  std::vector<std::vector<Ends>> ends_of_runs() const {
    std::vector<std::vector<Ends>> ends(clipped_.arcs.size());
    for (std::size_t a = 0; a < ends.size(); ++a) {
      const auto [from, to] = std::pair(diagram_.arcs[a].from, diagram_.arcs[a].to);
      ends[a].assign(clipped_.arcs[a].size(),
                     {from != kNone ? from : arc_node(a), to != kNone ? to : arc_node(a)});
    }
    for (std::size_t c = 0; c < crossings_.size(); ++c) {
      ends[crossings_[c].arc][crossings_[c].run][crossings_[c].leaves ? 1 : 0] = crossing_node(c);
    }
    return ends;
  }

  void add_arc_steps() {
    const auto ends = ends_of_runs();
    for (std::size_t a = 0; a < ends.size(); ++a) {
      const auto [left, right] = diagram_.arcs[a].sites;
      for (std::size_t r = 0; r < ends[a].size(); ++r) {
        const auto [begin, end] = ends[a][r];
        const Outline& forwards = clipped_.arcs[a][r].pieces;
        Outline backwards;
        std::transform(forwards.rbegin(), forwards.rend(), std::back_inserter(backwards), reversed);
        steps_.push_back({begin, left, end, forwards});
        steps_.push_back({end, right, begin, std::move(backwards)});
      }
    }
  }

  void add_border_steps() {
    if (crossings_.empty()) return add_whole_border();
    for (std::size_t c = 0; c < crossings_.size(); ++c) {
      const std::size_t next = (c + 1) % crossings_.size();
      const Crossing &a = crossings_[c], &b = crossings_[next];
      const double once_around = next <= c ? 4 : 0;
      steps_.push_back({crossing_node(c), a.after, crossing_node(next),
                        border_between(a.at, a.position, b.at, b.position + once_around, clipped_.box)});
    }
  }

  void add_whole_border() {
    const std::uint32_t owner = nearest_site(diagram_.sites, clipped_.box.low);
    if (owner == kNone) return;
    steps_.push_back({crossing_node(0), owner, crossing_node(0),
                      border_between(clipped_.box.low, 0, clipped_.box.low, 4, clipped_.box)});
  }

  /// Follows the steps of a cell until they are back or, by a defect of rounding, end.
  Outline outline_from(std::size_t s) {
    Outline outline;
    while (s < steps_.size() && !done_[s]) {
      done_[s] = true;
      outline.insert(outline.end(), steps_[s].pieces.begin(), steps_[s].pieces.end());
      s = step_at(steps_[s].end, steps_[s].site);
    }
    return outline;
  }

  /// The step of a cell that begins at a node; past the end if there is none.
  std::size_t step_at(std::uint32_t node, std::uint32_t site) const {
    const auto found = std::lower_bound(
        steps_.begin(), steps_.end(), std::pair(node, site),
        [](const Step& step, const auto& wanted) { return std::pair(step.begin, step.site) < wanted; });
    const bool is_there = found != steps_.end() && found->begin == node && found->site == site;
    return is_there ? static_cast<std::size_t>(found - steps_.begin()) : steps_.size();
  }

  const MoebiusDiagram& diagram_;
  DiagramInBox& clipped_;
  std::vector<Crossing> crossings_;
  std::vector<Step> steps_;
  std::vector<bool> done_;
};

}  // namespace

DiagramInBox clip_diagram(const MoebiusDiagram& diagram, const ViewBox& view) {
  DiagramInBox clipped{box_around(diagram, view), {}, {}};
  for (const MoebiusArc& arc : diagram.arcs)
    clipped.arcs.push_back(clip(trace(shape_of(diagram, arc), clipped.box), clipped.box));
  clipped.cells.resize(diagram.sites.size());
  OutlineChainer(diagram, clipped).chain();
  return clipped;
}

std::uint32_t nearest_site(const std::vector<MoebiusSite>& sites, Vec2 x) {
  const auto distance = [x](const MoebiusSite& s) { return s.lambda * dot(x - s.p, x - s.p) - s.mu; };
  const auto nearest =
      std::min_element(sites.begin(), sites.end(),
                       [&](const MoebiusSite& a, const MoebiusSite& b) { return distance(a) < distance(b); });
  return nearest == sites.end() ? kNone : static_cast<std::uint32_t>(nearest - sites.begin());
}

std::vector<bool> sites_with_cell(const MoebiusDiagram& diagram) {
  std::vector<bool> has_cell(diagram.sites.size(), false);
  for (const MoebiusArc& arc : diagram.arcs) has_cell[arc.sites[0]] = has_cell[arc.sites[1]] = true;
  if (diagram.arcs.empty() && !diagram.sites.empty()) has_cell[nearest_site(diagram.sites, {})] = true;
  return has_cell;
}

}  // namespace crossloft
