#include "confidence.h"

#include <algorithm>
#include <cmath>

#include "section_rows.h"
#include "star.h"

namespace crossloft {
namespace {

double squared(Vec3 a) { return dot(a, a); }

double squared_distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a, from = p - a;
  const double t = std::clamp(dot(from, along) / dot(along, along), 0.0, 1.0);
  return squared(from - t * along);
}

/// Squared distances to the two parts of the cell's boundary.
struct Distances {
  double in, out;
};

class ConfidenceMeter {
 public:
  ConfidenceMeter(const CellComplex& complex, const CellShape& shape)
      : complex_(complex), shape_(shape), sections_(section_rows(complex, shape)) {}

  std::int32_t measure(std::uint32_t t) {
    // Sorted, so that rounding does not depend on the order of the vertices.
    const auto v = sorted_vertices(complex_.mesh, t);
    const auto& p = shape_.points;
    const Vec3 centroid = 0.25 * ((p[v[0]] + p[v[1]]) + (p[v[2]] + p[v[3]]));
    double sum = 0.4 * at(centroid, t);
    for (const std::uint32_t corner : v) sum += 0.15 * at(0.5 * (centroid + p[corner]), t);
    return static_cast<std::int32_t>(std::floor(sum * kCertain + 0.5));
  }

 private:
  double at(Vec3 p, std::uint32_t t) const {
    const Distances squares = to_faces(p, to_contours(p, t));
    const double in = std::sqrt(squares.in), out = std::sqrt(squares.out);
    return in + out > 0 ? (out - in) / (out + in) : 0;
  }

  /// To the vertices, which are in both parts, and the grounded edges of t.
  Distances to_contours(Vec3 p, std::uint32_t t) const {
    const auto& v = complex_.mesh.vertices[t];
    double nearest = squared(p - shape_.points[v[0]]);
    for (unsigned i = 1; i < 4; ++i) nearest = std::min(nearest, squared(p - shape_.points[v[i]]));
    Distances d{nearest, nearest};
    for (unsigned e = 0; e < 6; ++e) {
      const EdgeKind kind = complex_.edges[t][e];
      if (kind == EdgeKind::free) continue;
      const double s = squared_distance_to_segment(p, shape_.points[v[kEdgeSlots[e][0]]],
                                                   shape_.points[v[kEdgeSlots[e][1]]]);
      d.in = std::min(d.in, s);
      if (kind == EdgeKind::contour) d.out = std::min(d.out, s);
    }
    return d;
  }

  Distances to_faces(Vec3 p, Distances d) const {
    for (std::size_t f = 0; f < sections_.size(); ++f) {
      const double height = shape_.faces[f].height(p), square = height * height;
      if (square >= std::max(d.in, d.out)) continue;
      if (square < d.in && square < d.out) {
        (is_in_section(f, p, height) ? d.in : d.out) = square;
      } else if (square < d.in) {
        if (is_in_section(f, p, height)) d.in = square;
      } else if (!is_in_section(f, p, height)) {
        d.out = square;
      }
    }
    return d;
  }

  bool is_in_section(std::size_t f, Vec3 p, double height) const {
    return !sections_[f].empty() && sections_[f].contains(p - height * shape_.faces[f].normal);
  }

  const CellComplex& complex_;
  const CellShape& shape_;
  std::vector<SectionRows> sections_;
};

}  // namespace

std::vector<std::int32_t> confidences(const CellComplex& complex, const CellShape& shape,
                                      const std::vector<std::uint8_t>& wanted) {
  ConfidenceMeter meter(complex, shape);
  std::vector<std::int32_t> confidence(complex.mesh.size(), -kCertain);
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    if (wanted[t] != 0) confidence[t] = meter.measure(t);
  return confidence;
}

}  // namespace crossloft
