#include "section_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "star.h"

namespace crossloft {
namespace {

constexpr std::size_t kMostRows = 4096;

int dominant_axis(Vec3 n) {
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

std::array<double, 2> project(Vec3 p, int axis) {
  return axis == 0 ? std::array{p.y, p.z} : axis == 1 ? std::array{p.z, p.x} : std::array{p.x, p.y};
}

/// A side of an internal triangle; those that only one triangle has are the contour.
struct Side {
  std::uint32_t face, a, b;
  friend auto operator<=>(const Side&, const Side&) = default;
};

std::vector<Side> contour_sides(const CellComplex& complex) {
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    for (unsigned i = 0; i < 4; ++i) {
      if (complex.facets[t][i] != FacetKind::internal) continue;
      const Triangle v = facet_vertices(complex.mesh, t, i);
      const std::uint32_t face = complex.common_face(v[0], v[1], v[2]);
      sides.insert(sides.end(), {{face, v[0], v[1]}, {face, v[0], v[2]}, {face, v[1], v[2]}});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<Side> single;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i + 1 < sides.size() && sides[i] == sides[i + 1]) {
      ++i;
    } else {
      single.push_back(sides[i]);
    }
  }
  return single;
}

}  // namespace

SectionRows::SectionRows(int dropped_axis, std::vector<Segment> contour) : axis_(dropped_axis) {
  if (contour.empty()) return;
  low_ = high_ = contour[0][1];
  for (const Segment& s : contour) {
    low_ = std::min({low_, s[1], s[3]});
    high_ = std::max({high_, s[1], s[3]});
  }
  rows_ = std::clamp<std::size_t>(contour.size() / 2, 1, kMostRows);
  rows_per_unit_ = high_ > low_ ? static_cast<double>(rows_) / (high_ - low_) : 0;
  begin_.assign(rows_ + 1, 0);
  const auto for_rows = [&](const Segment& s, auto visit) {
    const auto [first, last] = std::minmax({row_of(s[1]), row_of(s[3])});
    for (std::size_t r = first; r <= last; ++r) visit(r);
  };
  for (const Segment& s : contour) for_rows(s, [&](std::size_t r) { ++begin_[r + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  contour_.resize(begin_.back());
  std::vector<std::uint32_t> end(begin_.begin(), begin_.end() - 1);
  for (const Segment& s : contour) for_rows(s, [&](std::size_t r) { contour_[end[r]++] = s; });
}

std::size_t SectionRows::row_of(double v) const {
  const double row = (v - low_) * rows_per_unit_;
  return row >= static_cast<double>(rows_) ? rows_ - 1 : static_cast<std::size_t>(row);
}

bool SectionRows::contains(Vec3 p) const {
  const auto [u, v] = project(p, axis_);
  if (!(v >= low_ && v < high_)) return false;
  const std::size_t row = row_of(v);
  bool inside = false;
  for (std::uint32_t i = begin_[row]; i < begin_[row + 1]; ++i) {
    const Segment& s = contour_[i];
    if ((s[1] <= v) == (s[3] <= v)) continue;
    inside ^= u < s[0] + (v - s[1]) / (s[3] - s[1]) * (s[2] - s[0]);
  }
  return inside;
}

std::vector<SectionRows> section_rows(const CellComplex& complex, const CellShape& shape) {
  const std::vector<Side> sides = contour_sides(complex);
  std::vector<SectionRows> rows;
  auto next = sides.begin();
  for (std::uint32_t f = 0; f < shape.faces.size(); ++f) {
    const int axis = dominant_axis(shape.faces[f].normal);
    std::vector<SectionRows::Segment> contour;
    for (; next != sides.end() && next->face == f; ++next) {
      const auto a = project(shape.points[next->a], axis), b = project(shape.points[next->b], axis);
      contour.push_back({a[0], a[1], b[0], b[1]});
    }
    rows.emplace_back(axis, std::move(contour));
  }
  return rows;
}

}  // namespace crossloft
