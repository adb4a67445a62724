#include "face_split.h"

#include <algorithm>
#include <cmath>

namespace crossloft {
namespace {

Vec3 real(const LatticeVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

Vec3 real(const LatticePoint& p) { return {p.x, p.y, p.z}; }

LatticePoint lattice_point(const LatticePlane& plane, std::int64_t u, std::int64_t v) {
  LatticeVector c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = plane.origin[k] + u * plane.e1[k] + v * plane.e2[k];
  return make_point(c);
}

/// Plane coordinates of a point near the plane, rounded: e1 and e2 are Gauss-reduced, so their Gram matrix is
/// well conditioned and the error stays below a quarter step for |target| <= 2^50.
std::array<std::int64_t, 2> nearest_coordinates(const LatticePlane& plane, Vec3 target) {
  const Vec3 e1 = real(plane.e1), e2 = real(plane.e2), d = target - real(plane.origin);
  const double a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), p = dot(d, e1), q = dot(d, e2);
  const double det = a * c - b * b;
  return {std::llround((c * p - b * q) / det), std::llround((a * q - b * p) / det)};
}

}  // namespace

FaceSplitter::FaceSplitter(const SectionGraph& graph, const Arrangement& arrangement, FaceId face,
                           std::uint32_t plane, std::span<const Wall> walls, std::vector<LatticePoint>& points)
    : plane_(graph.planes[plane]), walls_(walls), points_(&points) {
  for (const ArrEdgeId edge : arrangement.edges_of(face))
    for (const PlaneId p : arrangement.planes_of(edge))
      if (p.value != plane && !arrangement.is_box(p))
        sides_.emplace_back(graph.planes[p.value], sign_at(arrangement.signs(face), p));
}

bool FaceSplitter::inside_face(const LatticePoint& p) const {
  return std::all_of(sides_.begin(), sides_.end(),
                     [&](const auto& side) { return side_of_plane(side.first, p) == side.second; });
}

/// No vertex in the triangle a, b, c but its corners: replacing ab by ac, cb then crosses no contour.
bool FaceSplitter::sweeps_nothing(std::uint32_t a, std::uint32_t b, const LatticePoint& c) const {
  const LatticePoint &p = (*points_)[a], &q = (*points_)[b];
  const int turn = orient2d(plane_, p, q, c);
  const auto outside_box = [&](const LatticePoint& v) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({p[k], q[k], c[k]});
      if (v[k] < low || v[k] > high) return true;
    }
    return false;
  };
  for (std::uint32_t v = 0; v < points_->size(); ++v) {
    const LatticePoint& x = (*points_)[v];
    if (v == a || v == b || outside_box(x)) continue;
    if (equal(x, c)) return false;
    if (turn != 0 && orient2d(plane_, p, q, x) * turn >= 0 && orient2d(plane_, q, c, x) * turn >= 0 &&
        orient2d(plane_, c, p, x) * turn >= 0)
      return false;
  }
  return true;
}

std::uint32_t FaceSplitter::operator()(const SplitRequest& request) {
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
      const LatticePoint p = lattice_point(plane_, u, v);
      candidates.push_back({norm(real(p) - target), p});
    }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
    return x.way != y.way ? x.way < y.way : compare_lex(x.point, y.point) < 0;
  });
  const int inside = walls_[request.segment].inside_left != request.reversed ? 1 : -1;
  for (const Candidate& c : candidates) {
    if (orient2d(plane_, from, to, c.point) * inside > 0 || !inside_face(c.point)) continue;
    if (!sweeps_nothing(request.from, request.to, c.point)) continue;
    points_->push_back(c.point);
    return static_cast<std::uint32_t>(points_->size() - 1);
  }
  return kNone;
}

}  // namespace crossloft
