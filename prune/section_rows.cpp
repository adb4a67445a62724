#include "section_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "star.h"

namespace crossloft {
namespace {

constexpr std::size_t kMostRows = 4096;
/// Pieces in a row, on average, from which on rows go the other way if that has far fewer: all pieces of a
/// flat section may be in one row. With less all answers are rounded as ever.
constexpr std::uint64_t kCrowd = 64, kFarFewer = 4;

/// 2^20 times the pieces that are in a row along the other coordinate, on average. Integers, so that the sum
/// does not depend on the order of the pieces.
std::uint64_t crowd_along(std::span<const SectionRows::Segment> contour, std::size_t coordinate) {
  double low = contour[0][coordinate], high = low;
  for (const SectionRows::Segment& s : contour) {
    low = std::min({low, s[coordinate], s[coordinate + 2]});
    high = std::max({high, s[coordinate], s[coordinate + 2]});
  }
  std::uint64_t sum = 0;
  for (const SectionRows::Segment& s : contour)
    if (high > low)
      sum += static_cast<std::uint64_t>(std::fabs(s[coordinate + 2] - s[coordinate]) / (high - low) * 0x1p20);
  return sum;
}

int dominant_axis(Vec3 n) {
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

std::array<double, 2> project(Vec3 p, int axis) {
  return axis == 0 ? std::array{p.y, p.z} : axis == 1 ? std::array{p.z, p.x} : std::array{p.x, p.y};
}

using Contours = std::vector<std::vector<SectionRows::Segment>>;

/// The side from its smaller vertex, as rounding depends on where it starts.
SectionRows::Segment side_of(const CellShape& shape, std::uint32_t a, std::uint32_t b, int axis) {
  const auto from = project(shape.points[std::min(a, b)], axis),
             to = project(shape.points[std::max(a, b)], axis);
  return {from[0], from[1], to[0], to[1]};
}

/// By face: the sides of its ground triangles that no other one on the face has.
Contours contours_of(const CellComplex& complex, const Ground& ground, const CellShape& shape) {
  std::vector<std::uint32_t> face_of(ground.size());
  const auto vertices = [&](std::uint32_t g) {
    const Facet& f = ground.facet(g);
    const auto& v = complex.mesh.vertices[f.tet];
    const auto& slots = kFacetSlots[f.facet];
    return std::array{v[slots[0]], v[slots[1]], v[slots[2]]};
  };
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    const auto v = vertices(g);
    face_of[g] = complex.common_face(v[0], v[1], v[2]);
  }
  Contours contours(shape.faces.size());
  for (std::uint32_t g = 0; g < ground.size(); ++g)
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t other = ground.neighbour(g, k);
      if (other != kNone && face_of[other] == face_of[g]) continue;
      const auto v = vertices(g);
      const int axis = dominant_axis(shape.faces[face_of[g]].normal);
      contours[face_of[g]].push_back(side_of(shape, v[k], v[(k + 1) % 3], axis));
    }
  return contours;
}

}  // namespace

SectionRows::SectionRows(int dropped_axis, std::span<const Segment> contour) : axis_(dropped_axis) {
  if (contour.empty()) return;
  const std::uint64_t crowd = crowd_along(contour, 1);
  turned_ = crowd > kCrowd << 20U && crowd > kFarFewer * crowd_along(contour, 0);
  std::vector<Segment> turned;
  if (turned_)
    for (const Segment& s : contour) turned.push_back({s[1], s[0], s[3], s[2]});
  fill(turned_ ? turned : contour);
}

void SectionRows::fill(std::span<const Segment> contour) {
  low_ = high_ = contour[0][1];
  for (const Segment& s : contour) {
    low_ = std::min({low_, s[1], s[3]});
    high_ = std::max({high_, s[1], s[3]});
  }
  rows_ = std::clamp<std::size_t>(contour.size(), 1, kMostRows);
  rows_per_unit_ = high_ > low_ ? static_cast<double>(rows_) / (high_ - low_) : 0;
  fill_rows(contour);
}

void SectionRows::fill_rows(std::span<const Segment> contour) {
  const auto for_rows = [&](const Segment& s, auto visit) {
    const auto [first, last] = std::minmax({row_of(s[1]), row_of(s[3])});
    for (std::size_t r = first; r <= last; ++r) visit(r);
  };
  std::vector<std::uint32_t> count(rows_, 0);
  for (const Segment& s : contour) for_rows(s, [&](std::size_t r) { ++count[r]; });
  begin_.reserve(rows_ + 1);
  begin_.push_back(0);
  for (const std::uint32_t pieces : count) begin_.push_back(begin_.back() + (pieces + 1) / 2);
  const Pair nowhere = both(std::numeric_limits<double>::infinity());
  pieces_.assign(begin_.back(), {nowhere, nowhere, nowhere, nowhere});
  for (const Segment& s : contour)
    for_rows(s, [&](std::size_t r) {
      const std::uint32_t place = --count[r];
      TwoPieces& two = pieces_[begin_[r] + place / 2];
      const std::uint32_t k = place % 2;
      two.u0[k] = s[0], two.v0[k] = s[1], two.u1[k] = s[2], two.v1[k] = s[3];
    });
}

std::size_t SectionRows::row_of(double v) const {
  const double row = (v - low_) * rows_per_unit_;
  return row >= static_cast<double>(rows_) ? rows_ - 1 : static_cast<std::size_t>(row);
}

bool SectionRows::contains(Vec3 p) const {
  const auto [u, v] = project(p, axis_);
  return contains(u, v);
}

bool SectionRows::contains(double u, double v) const {
  if (turned_) std::swap(u, v);
  if (!(v >= low_ && v < high_)) return false;
  const std::size_t row = row_of(v);
  // Without branches: which pieces cross the line of p can't be predicted.
  const Pair at_u = both(u), at_v = both(v);
  auto inside = at_u < at_u;  // in neither lane
  for (std::uint32_t i = begin_[row]; i < begin_[row + 1]; ++i) {
    const TwoPieces& s = pieces_[i];
    const auto crosses = (s.v0 <= at_v) ^ (s.v1 <= at_v);
    const auto beyond = at_u < s.u0 + (at_v - s.v0) / (s.v1 - s.v0) * (s.u1 - s.u0);
    inside ^= crosses & beyond;
  }
  return ((inside[0] ^ inside[1]) & 1) != 0;
}

SectionRows rows_of_contour(Vec3 normal, std::span<const std::array<Vec3, 2>> contour) {
  const int axis = dominant_axis(normal);
  std::vector<SectionRows::Segment> segments;
  for (const auto& [a, b] : contour) {
    const auto from = project(a, axis), to = project(b, axis);
    segments.push_back({from[0], from[1], to[0], to[1]});
  }
  return {axis, segments};
}

std::vector<SectionRows> section_rows(const CellComplex& complex, const Ground& ground,
                                      const CellShape& shape) {
  const Contours contours = contours_of(complex, ground, shape);
  std::vector<SectionRows> rows;
  for (std::size_t f = 0; f < contours.size(); ++f)
    rows.emplace_back(dominant_axis(shape.faces[f].normal), contours[f]);
  return rows;
}

}  // namespace crossloft
