#include "confidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pair.h"
#include "star.h"

namespace crossloft {
namespace {

/// The points of a tetrahedron where it is measured: its centroid, then the middles from there to its
/// vertices. By twos, with the centroid a second time as the last one.
constexpr std::size_t kPoints = 5, kPairs = 3;
using Lanes = std::array<Pair, kPairs>;

struct Points {
  Lanes x, y, z;

  void set(std::size_t k, Vec3 p) { x[k / 2][k % 2] = p.x, y[k / 2][k % 2] = p.y, z[k / 2][k % 2] = p.z; }
  Vec3 at(std::size_t k) const { return {x[k / 2][k % 2], y[k / 2][k % 2], z[k / 2][k % 2]}; }
};

/// Squared distances to the two parts of the cell's boundary.
struct Distances {
  Lanes in, out;
};

/// To a vertex, which is in both parts.
void take_vertex(const Points& p, Vec3 a, Lanes& least) {
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Pair x = p.x[k] - a.x, y = p.y[k] - a.y, z = p.z[k] - a.z;
    least[k] = least_of(x * x + y * y + z * z, least[k]);
  }
}

void take_edge(const Points& p, Vec3 a, Vec3 b, bool is_contour, Distances& d) {
  const Vec3 along = b - a;
  const double length = dot(along, along);
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Pair x = p.x[k] - a.x, y = p.y[k] - a.y, z = p.z[k] - a.z;
    Pair t = (x * along.x + y * along.y + z * along.z) / length;
    t = t < both(0) ? both(0) : t;
    t = least_of(both(1), t);
    const Pair u = x - t * along.x, v = y - t * along.y, w = z - t * along.z;
    const Pair square = u * u + v * v + w * w;
    d.in[k] = least_of(square, d.in[k]);
    if (is_contour) d.out[k] = least_of(square, d.out[k]);
  }
}

/// To the vertices and the grounded edges of t.
Distances to_contours(const CellComplex& complex, const CellShape& shape, std::uint32_t t, const Points& p) {
  const auto& v = complex.mesh.vertices[t];
  Distances d;
  d.in.fill(both(std::numeric_limits<double>::infinity()));
  for (const std::uint32_t corner : v) take_vertex(p, shape.points[corner], d.in);
  d.out = d.in;
  for (unsigned e = 0; e < 6; ++e) {
    const EdgeKind kind = complex.edges[t][e];
    if (kind == EdgeKind::free) continue;
    take_edge(p, shape.points[v[kEdgeSlots[e][0]]], shape.points[v[kEdgeSlots[e][1]]],
              kind == EdgeKind::contour, d);
  }
  return d;
}

/// Asks the section only where the face is nearer than what was found before.
void take_face(const FacePlane& face, const SectionRows& section, const Points& p, Distances& d) {
  for (std::size_t pair = 0; pair < kPairs; ++pair) {
    const Pair height =
        face.normal.x * p.x[pair] + face.normal.y * p.y[pair] + face.normal.z * p.z[pair] + face.offset;
    const Pair square = height * height;
    const auto nearer = square < (d.in[pair] < d.out[pair] ? d.out[pair] : d.in[pair]);
    if ((nearer[0] | nearer[1]) == 0) continue;
    for (std::size_t k = 0; k < 2 && 2 * pair + k < kPoints; ++k) {
      const bool nearer_in = square[k] < d.in[pair][k], nearer_out = square[k] < d.out[pair][k];
      if (!nearer_in && !nearer_out) continue;
      const bool in = !section.empty() && section.contains(p.at(2 * pair + k) - height[k] * face.normal);
      if (in ? nearer_in : nearer_out) (in ? d.in : d.out)[pair][k] = square[k];
    }
  }
}

/// No point is farther from the sections or the rest than this.
double reach_of(const Distances& d) {
  Pair largest = d.out[0];  // not below d.in: contour edges are in both parts
  for (std::size_t k = 1; k < kPairs; ++k) largest = largest_of(d.out[k], largest);
  return std::sqrt(std::max(largest[0], largest[1]));
}

/// The mean of (out - in) / (out + in).
std::int32_t mean_of(const Distances& d) {
  double sum = 0;
  for (std::size_t k = 0; k < kPoints; ++k) {
    const double in = std::sqrt(d.in[k / 2][k % 2]), out = std::sqrt(d.out[k / 2][k % 2]);
    sum += (k == 0 ? 0.4 : 0.15) * (in + out > 0 ? (out - in) / (out + in) : 0);
  }
  return static_cast<std::int32_t>(std::floor(sum * kCertain + 0.5));
}

}  // namespace

ConfidenceMeter::ConfidenceMeter(const CellComplex& complex, const Ground& ground, const CellShape& shape)
    : complex_(complex), shape_(shape), sections_(section_rows(complex, ground, shape)) {
  double scale = 0;
  for (const Vec3& p : shape.points) scale = std::max(scale, std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
  for (const FacePlane& face : shape.faces) scale = std::max(scale, std::fabs(face.offset));
  slack_ = scale * 0x1p-44;
}

/// Faces that come nearer to some point than `reach`, the nearest one first: it answers for most points.
/// `radius`: of the points around the centroid. A height is off by less than 8 units of 2^-53 of `scale`, far
/// less than the slack.
void ConfidenceMeter::find_near_faces(Vec3 centroid, double radius, double reach) {
  const double limit = (radius + reach) * (1 + 0x1p-40) + slack_;
  near_.clear();
  for (std::uint32_t f = 0; f < sections_.size(); ++f) {
    const double height = shape_.faces[f].height(centroid);
    if (height > limit) continue;
    near_.push_back({height, f});
    for (std::size_t k = near_.size() - 1; k > 0 && near_[k].height < near_[k - 1].height; --k)
      std::swap(near_[k], near_[k - 1]);
  }
}

std::int32_t ConfidenceMeter::measure(std::uint32_t t) {
  // Sorted, so that rounding does not depend on the order of the vertices.
  const auto v = sorted_vertices(complex_.mesh, t);
  const auto& at = shape_.points;
  const Vec3 centroid = 0.25 * ((at[v[0]] + at[v[1]]) + (at[v[2]] + at[v[3]]));
  Points p;
  p.set(0, centroid);
  double farthest = 0;
  for (std::size_t k = 1; k < kPoints; ++k) {
    const Vec3 point = 0.5 * (centroid + at[v[k - 1]]), away = point - centroid;
    p.set(k, point);
    farthest = std::max(farthest, dot(away, away));
  }
  p.set(kPoints, centroid);
  Distances d = to_contours(complex_, shape_, t, p);
  find_near_faces(centroid, std::sqrt(farthest), reach_of(d));
  for (const NearFace& near : near_) take_face(shape_.faces[near.face], sections_[near.face], p, d);
  return mean_of(d);
}

std::vector<std::int32_t> confidences(const CellComplex& complex, const CellShape& shape,
                                      const std::vector<std::uint8_t>& wanted) {
  ConfidenceMeter meter(complex, Ground(complex), shape);
  std::vector<std::int32_t> confidence(complex.mesh.size(), -kCertain);
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    if (wanted[t] != 0) confidence[t] = meter.measure(t);
  return confidence;
}

}  // namespace crossloft
