#include "face_split.h"

#include <algorithm>

#include "../geom/lattice_rounding.h"

namespace crossloft {

FaceSplitter::FaceSplitter(const SectionGraph& graph, const Arrangement& arrangement, FaceId face,
                           std::uint32_t plane, std::span<const Wall> walls,
                           std::vector<LatticePoint>& points)
    : plane_(graph.planes[plane]), face_(graph, arrangement, face), walls_(walls), points_(&points) {}

/// New points are asked one by one until there are so many.
constexpr std::uint32_t kFewPoints = 64;

/// Trees of all points: new ones come into one with those that are no more than they.
void FaceSplitter::plant() {
  const auto end = static_cast<std::uint32_t>(points_->size());
  std::uint32_t begin = groves_.empty() ? 0 : groves_.back().end;
  if (end - begin < kFewPoints) return;
  for (; !groves_.empty() && begin - groves_.back().begin <= end - begin; groves_.pop_back())
    begin = groves_.back().begin;
  std::vector<Bounds> boxes(end - begin);
  for (std::uint32_t v = begin; v < end; ++v) boxes[v - begin].add(real((*points_)[v]));
  groves_.push_back({begin, end, BoxTree(boxes)});
}

/// visit(v) for all of those in the closed box.
template <class Visit>
void FaceSplitter::for_points_in(const Bounds& box, Visit&& visit) const {
  for (const Grove& grove : groves_)
    grove.tree.for_overlaps(box, [&](std::uint32_t i) { visit(grove.begin + i); });
  for (std::uint32_t v = groves_.empty() ? 0 : groves_.back().end; v < points_->size(); ++v) {
    const Vec3 p = real((*points_)[v]);
    if (overlap(box, {p, p})) visit(v);
  }
}

/// No vertex in the triangle a, b, c but its corners: replacing ab by ac, cb then crosses no contour.
bool FaceSplitter::sweeps_nothing(std::uint32_t a, std::uint32_t b, const LatticePoint& c) const {
  const LatticePoint &p = (*points_)[a], &q = (*points_)[b];
  const int turn = orient2d(plane_, p, q, c);
  Bounds box;
  for (const LatticePoint* corner : {&p, &q, &c}) box.add(real(*corner));
  bool nothing = true;
  for_points_in(box, [&](std::uint32_t v) {
    if (!nothing || v == a || v == b) return;
    const LatticePoint& x = (*points_)[v];
    nothing = !equal(x, c) && (turn == 0 || orient2d(plane_, p, q, x) * turn < 0 ||
                               orient2d(plane_, q, c, x) * turn < 0 || orient2d(plane_, c, p, x) * turn < 0);
  });
  return nothing;
}

std::uint32_t FaceSplitter::operator()(const SplitRequest& request) {
  plant();
  const LatticePoint from = (*points_)[request.from], to = (*points_)[request.to];
  const Vec3 target = real(from) + request.t * (real(to) - real(from));
  const auto [u0, v0] = nearest_coordinates(plane_, target);
  struct Candidate {
    double way;
    LatticePoint point;
  };
  std::vector<Candidate> candidates;
  for (std::int64_t u = u0 - 2; u <= u0 + 2; ++u)
    for (std::int64_t v = v0 - 2; v <= v0 + 2; ++v) {
      const LatticePoint p = plane_point(plane_, u, v);
      candidates.push_back({norm(real(p) - target), p});
    }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return x.way != y.way ? x.way < y.way : compare_lex(x.point, y.point) < 0;
  });
  const int inside = walls_[request.segment].inside_left != request.reversed ? 1 : -1;
  for (const Candidate& c : candidates) {
    if (orient2d(plane_, from, to, c.point) * inside > 0 || !face_.contains(c.point)) continue;
    if (!sweeps_nothing(request.from, request.to, c.point)) continue;
    points_->push_back(c.point);
    return static_cast<std::uint32_t>(points_->size() - 1);
  }
  return kNone;
}

}  // namespace crossloft
