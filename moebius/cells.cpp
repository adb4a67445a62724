#include "cells.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "cell_geometry.h"

namespace crossloft {
namespace {

std::uint32_t site_of(const MoebiusDiagram& diagram, CellStep step) {
  return diagram.arcs[step.arc].sites[step.backwards];
}

/// Steps as numbers: two for each arc.
CellStep step_of(std::uint32_t number) { return {number / 2, number % 2 != 0}; }

Vec2 direction(const MoebiusDiagram& diagram, CellStep step) {
  const Vec2 d = diagram.arcs[step.arc].curve.direction;
  return step.backwards ? -d : d;
}

/// Which step follows a step around its cell.
class Successors {
 public:
  explicit Successors(const MoebiusDiagram& diagram)
      : diagram_(diagram), leaving_(diagram.vertices.size(), {kNone, kNone, kNone}) {
    for (std::uint32_t s = 0; s < 2 * diagram.arcs.size(); ++s) {
      const CellStep step = step_of(s);
      const std::uint32_t v = begin_vertex(diagram, step);
      if (v != kNone)
        *std::find(leaving_[v].begin(), leaving_[v].end(), kNone) = s;
      else if (diagram.arcs[step.arc].curve.is_line)
        from_infinity_.push_back({site_of(diagram, step), s});
    }
    std::sort(from_infinity_.begin(), from_infinity_.end());
  }

  std::uint32_t next(std::uint32_t s) const {
    const CellStep step = step_of(s);
    const std::uint32_t v = end_vertex(diagram_, step);
    if (v == kNone) return diagram_.arcs[step.arc].curve.is_line ? next_from_infinity(step) : s;
    const std::uint32_t site = site_of(diagram_, step);
    return *std::find_if(leaving_[v].begin(), leaving_[v].end(),
                         [&](std::uint32_t t) { return site_of(diagram_, step_of(t)) == site; });
  }

 private:
  struct Entry {
    std::uint32_t site, step;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  /// At infinity a cell is one of a power diagram, so it is convex and comes from there twice only if it is a
  /// strip: then it is bounded by parallel lines, and the next one comes from where this one goes.
  std::uint32_t next_from_infinity(CellStep step) const {
    const std::uint32_t site = site_of(diagram_, step);
    std::uint32_t best = kNone;
    double alignment = -std::numeric_limits<double>::infinity();
    for (auto at = std::lower_bound(from_infinity_.begin(), from_infinity_.end(), Entry{site, 0});
         at != from_infinity_.end() && at->site == site; ++at) {
      const double a = dot(direction(diagram_, step), -direction(diagram_, step_of(at->step)));
      if (best == kNone || a > alignment) best = at->step, alignment = a;
    }
    return best;
  }

  const MoebiusDiagram& diagram_;
  std::vector<std::array<std::uint32_t, 3>> leaving_;  ///< steps from each vertex
  std::vector<Entry> from_infinity_;                   ///< sorted
};

/// Arcs that hang together; all that reach infinity hang together there.
class ArcGroups {
 public:
  explicit ArcGroups(const MoebiusDiagram& diagram)
      : arcs_(static_cast<std::uint32_t>(diagram.arcs.size())), parent_(arcs_ + diagram.vertices.size() + 1) {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::uint32_t a = 0; a < arcs_; ++a)
      for (const std::uint32_t v : {diagram.arcs[a].from, diagram.arcs[a].to}) {
        if (v != kNone) join(a, arcs_ + v);
        if (v == kNone && diagram.arcs[a].curve.is_line) join(a, infinity());
      }
  }

  std::uint32_t of(std::uint32_t arc) { return root(arc); }
  bool reaches_infinity(std::uint32_t arc) { return root(arc) == root(infinity()); }

 private:
  std::uint32_t infinity() const { return static_cast<std::uint32_t>(parent_.size() - 1); }
  std::uint32_t root(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  std::uint32_t arcs_;
  std::vector<std::uint32_t> parent_;  ///< arcs, vertices, infinity
};

/// The site that is nearest far away in all directions: least lambda, then largest mu. REQUIRES: no arc
/// reaches infinity.
std::uint32_t site_at_infinity(const std::vector<MoebiusSite>& sites) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < sites.size(); ++i) {
    const MoebiusSite &a = sites[i], &b = sites[best];
    if (a.lambda < b.lambda || (a.lambda == b.lambda && a.mu > b.mu)) best = i;
  }
  return sites.empty() ? kNone : best;
}

struct LoopDraft {
  std::uint32_t site = kNone, group = kNone;
  std::vector<CellStep> steps;
  double area = std::numeric_limits<double>::infinity();  ///< infinite if the group reaches infinity
  bool is_hole = false;
  std::uint32_t outer = kNone;  ///< of a hole: the outer loop of its component, kNone if that has none
};

class CellBuilder {
 public:
  explicit CellBuilder(const MoebiusDiagram& diagram) : diagram_(diagram), groups_(diagram) {}

  MoebiusCells build() {
    trace_loops();
    mark_holes();
    std::stable_sort(loops_.begin(), loops_.end(), [](const LoopDraft& a, const LoopDraft& b) {
      return a.site != b.site ? a.site < b.site : a.is_hole < b.is_hole;
    });
    bool bounded = true;
    for (const LoopDraft& loop : loops_)
      bounded = bounded && loop.area < std::numeric_limits<double>::infinity();
    const std::uint32_t surrounding = bounded ? site_at_infinity(diagram_.sites) : kNone;
    cells_.first_component.push_back(0);
    std::size_t end = 0;
    for (std::uint32_t site = 0; site < diagram_.sites.size(); ++site) {
      const std::size_t begin = end;
      while (end < loops_.size() && loops_[end].site == site) ++end;
      add_cell(site, begin, end, site == surrounding);
      cells_.first_component.push_back(static_cast<std::uint32_t>(cells_.components.size()));
    }
    return std::move(cells_);
  }

 private:
  void trace_loops() {
    const Successors successors(diagram_);
    std::vector<bool> done(2 * diagram_.arcs.size());
    for (std::uint32_t s = 0; s < done.size(); ++s) {
      if (done[s]) continue;
      LoopDraft loop;
      for (std::uint32_t at = s; !done[at]; at = successors.next(at)) {
        done[at] = true;
        loop.steps.push_back(step_of(at));
      }
      loop.site = site_of(diagram_, loop.steps.front());
      const std::uint32_t arc = loop.steps.front().arc;
      loop.group = groups_.of(arc);
      if (!groups_.reaches_infinity(arc)) loop.area = signed_area(diagram_, loop.steps);
      loops_.push_back(std::move(loop));
    }
  }

  /// A group of arcs is a connected planar graph, each of its loops goes around one of its faces: one of them
  /// around the outer face. If it reaches infinity, no loop does: there the outer face ends.
  void mark_holes() {
    std::vector<LoopDraft*> by_group;
    for (LoopDraft& loop : loops_)
      if (loop.area < std::numeric_limits<double>::infinity()) by_group.push_back(&loop);
    std::stable_sort(by_group.begin(), by_group.end(), [](const LoopDraft* a, const LoopDraft* b) {
      return a->group != b->group ? a->group < b->group : a->area < b->area;
    });
    for (std::size_t k = 0; k < by_group.size(); ++k)
      by_group[k]->is_hole = k == 0 || by_group[k]->group != by_group[k - 1]->group;
  }

  /// The innermost of the cell's outer loops around the hole; kNone for the piece without one.
  std::uint32_t outer_of(const LoopDraft& hole, std::size_t begin, std::size_t holes, bool surrounds) const {
    if (holes - begin + surrounds == 1) return surrounds ? kNone : static_cast<std::uint32_t>(begin);
    const CellStep step = hole.steps.front();
    const std::uint32_t v = begin_vertex(diagram_, step);
    const MoebiusCurve& curve = diagram_.arcs[step.arc].curve;
    const Vec2 point = v != kNone ? diagram_.vertices[v] : curve.centre + Vec2{curve.radius, 0};
    std::uint32_t best = kNone;
    for (std::size_t k = begin; k < holes; ++k)
      if (winding_number(diagram_, loops_[k].steps, point) > 0 &&
          (best == kNone || loops_[k].area < loops_[best].area))
        best = static_cast<std::uint32_t>(k);
    return best == kNone && !surrounds ? static_cast<std::uint32_t>(begin) : best;
  }

  /// The components of one cell from its loops, outer ones before holes.
  void add_cell(std::uint32_t site, std::size_t begin, std::size_t end, bool surrounds) {
    std::size_t holes = begin;
    while (holes < end && !loops_[holes].is_hole) ++holes;
    for (std::size_t k = holes; k < end; ++k) loops_[k].outer = outer_of(loops_[k], begin, holes, surrounds);
    for (std::size_t k = begin; k < holes; ++k)
      add_component(site, static_cast<std::uint32_t>(k), holes, end);
    if (surrounds) add_component(site, kNone, holes, end);
  }

  void add_component(std::uint32_t site, std::uint32_t outer, std::size_t holes, std::size_t end) {
    const auto first = static_cast<std::uint32_t>(cells_.loops.size());
    if (outer != kNone) add_loop(loops_[outer]);
    for (std::size_t k = holes; k < end; ++k)
      if (loops_[k].outer == outer) add_loop(loops_[k]);
    cells_.components.push_back(
        {site, first, static_cast<std::uint32_t>(cells_.loops.size()) - first, outer != kNone});
  }

  void add_loop(const LoopDraft& loop) {
    cells_.loops.push_back({static_cast<std::uint32_t>(cells_.steps.size()),
                            static_cast<std::uint32_t>(loop.steps.size()),
                            static_cast<std::uint32_t>(cells_.components.size()), loop.is_hole});
    cells_.steps.insert(cells_.steps.end(), loop.steps.begin(), loop.steps.end());
  }

  const MoebiusDiagram& diagram_;
  ArcGroups groups_;
  std::vector<LoopDraft> loops_;
  MoebiusCells cells_;
};

}  // namespace

std::uint32_t begin_vertex(const MoebiusDiagram& diagram, CellStep step) {
  return step.backwards ? diagram.arcs[step.arc].to : diagram.arcs[step.arc].from;
}

std::uint32_t end_vertex(const MoebiusDiagram& diagram, CellStep step) {
  return step.backwards ? diagram.arcs[step.arc].from : diagram.arcs[step.arc].to;
}

MoebiusCells moebius_cells(const MoebiusDiagram& diagram) { return CellBuilder(diagram).build(); }

}  // namespace crossloft
