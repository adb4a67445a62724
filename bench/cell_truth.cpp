#include "cell_truth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../geom/disjoint_sets.h"
#include "../geom/ids.h"

namespace crossloft::bench {
namespace {

/// Coordinates of the solids are within about 1, and mesh vertices and crossings thousandths apart.
constexpr double kTolerance = 1e-7;

double height(const CuttingPlane& plane, Vec3 p) { return dot(plane.normal, p) + plane.offset; }

/// Where the plane meets the segment; from its lower end, so that both polygons at it get the same point.
Vec3 crossing(const CuttingPlane& plane, Vec3 a, Vec3 b) {
  if (height(plane, a) > height(plane, b)) std::swap(a, b);
  const double from = height(plane, a), to = height(plane, b);
  return a + (from / (from - to)) * (b - a);
}

using Pair = std::array<std::uint32_t, 2>;

/// Each place once, with the smallest one that it is joined with.
std::vector<Pair> pieces_of(const std::vector<Pair>& joined) {
  std::vector<Pair> pieces;
  for (const Pair& p : joined) pieces.push_back({p[0], 0});
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  const auto index = [&](std::uint32_t place) {
    return static_cast<std::uint32_t>(std::lower_bound(pieces.begin(), pieces.end(), Pair{place, 0}) -
                                      pieces.begin());
  };
  DisjointSets sets(pieces.size());
  for (const auto& [a, b] : joined) sets.join(index(a), index(b));
  for (std::uint32_t i = 0; i < pieces.size(); ++i) pieces[i][1] = pieces[sets.find(i)][0];
  return pieces;
}

}  // namespace

Places::Box Places::box_of(Vec3 p) const {
  const auto floor = [&](double x) { return static_cast<std::int64_t>(std::floor(x / tolerance_)); };
  return {floor(p.x), floor(p.y), floor(p.z)};
}

std::uint32_t Places::find(Vec3 p) const {
  const Box box = box_of(p);
  for (int k = 0; k < 27; ++k) {
    const auto found = boxes_.find({box[0] + k % 3 - 1, box[1] + k / 3 % 3 - 1, box[2] + k / 9 - 1});
    if (found == boxes_.end()) continue;
    for (const std::uint32_t i : found->second)
      if (norm(points_[i] - p) <= tolerance_) return i;
  }
  return kNone;
}

std::uint32_t Places::add(Vec3 p) {
  std::uint32_t place = find(p);
  if (place != kNone) return place;
  place = size();
  points_.push_back(p);
  boxes_[box_of(p)].push_back(place);
  return place;
}

CellTruth::CellTruth(const Surface& mesh, std::vector<CuttingPlane> planes)
    : planes_(std::move(planes)), places_(kTolerance) {
  Sides sides;
  for (const auto& [a, b, c] : mesh.triangles) part({mesh.points[a], mesh.points[b], mesh.points[c]}, sides);
  for (const auto& [cell, joined] : joined_) pieces_[cell] = pieces_of(joined);
  joined_.clear();
}

/// By the planes from number sides.size() on.
void CellTruth::part(Polygon polygon, Sides& sides) {
  if (sides.size() == planes_.size()) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      joined_[sides].push_back({places_.add(polygon[i]), places_.add(polygon[(i + 1) % polygon.size()])});
    return;
  }
  const CuttingPlane& plane = planes_[sides.size()];
  std::array<Polygon, 2> halves;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const bool above = height(plane, a) >= 0, goes_on_above = height(plane, b) >= 0;
    halves[above ? 1 : 0].push_back(a);
    if (above != goes_on_above)
      for (Polygon& half : halves) half.push_back(crossing(plane, a, b));
  }
  for (const bool above : {false, true}) {
    if (halves[above ? 1 : 0].empty()) continue;
    sides.push_back(above);
    part(std::move(halves[above ? 1 : 0]), sides);
    sides.pop_back();
  }
}

CellTruth::Sides CellTruth::sides_of(Vec3 p) const {
  Sides sides;
  for (const CuttingPlane& plane : planes_) sides.push_back(height(plane, p) >= 0);
  return sides;
}

std::uint32_t CellTruth::piece_at(const Sides& cell, Vec3 contour_vertex) const {
  const auto pieces = pieces_.find(cell);
  const std::uint32_t place = places_.find(contour_vertex);
  if (pieces == pieces_.end() || place == kNone) return kNone;
  const auto& list = pieces->second;
  const auto found = std::lower_bound(list.begin(), list.end(), Pair{place, 0});
  return found != list.end() && (*found)[0] == place ? (*found)[1] : kNone;
}

}  // namespace crossloft::bench
