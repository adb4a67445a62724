#include "section_field.h"

#include <algorithm>
#include <cmath>

namespace crossloft {
namespace {

Bounds box_of(const std::array<Vec3, 2>& piece) {
  Bounds box;
  for (const Vec3& p : piece) box.add(p);
  return box;
}

std::vector<std::array<Vec3, 2>> all_pieces(std::span<const FieldPlane> planes) {
  std::vector<std::array<Vec3, 2>> pieces;
  for (const FieldPlane& p : planes) pieces.insert(pieces.end(), p.contour.begin(), p.contour.end());
  return pieces;
}

std::vector<Bounds> boxes_of(std::span<const std::array<Vec3, 2>> pieces) {
  std::vector<Bounds> boxes;
  for (const auto& piece : pieces) boxes.push_back(box_of(piece));
  return boxes;
}

double squared_distance(Vec3 p, const std::array<Vec3, 2>& piece) {
  const Vec3 along = piece[1] - piece[0], from = p - piece[0];
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(from, along) / square, 0.0, 1.0) : 0;
  const Vec3 gap = from - t * along;
  return dot(gap, gap);
}

}  // namespace

/// Places of samples so far, and how dense they are to be.
struct SectionField::Grid {
  static constexpr std::uint32_t kOnContour = UINT32_MAX;
  struct Place {
    Vec3 at;
    std::uint32_t plane = kOnContour;
  };

  Vec3 centre;
  double radius = 0, step = 0;
  std::vector<Place> places;

  /// False once there are too many. Not beyond the ball nor near another place: most often that is one of the
  /// last.
  bool add(Vec3 p, double gap, std::uint32_t plane) {
    const Vec3 d = p - centre;
    const bool fits =
        dot(d, d) <= radius * radius && std::none_of(places.rbegin(), places.rend(), [&](const Place& s) {
          const Vec3 e = p - s.at;
          return dot(e, e) < gap * gap;
        });
    if (fits) places.push_back({p, plane});
    return places.size() <= kMostSamples;
  }
};

SectionField::SectionField(std::vector<FieldPlane> planes)
    : pieces_(all_pieces(planes)), tree_(boxes_of(pieces_)) {
  for (const FieldPlane& p : planes) {
    planes_.push_back(p.plane);
    sections_.push_back(rows_of_contour(p.plane.normal, p.contour));
  }
}

double SectionField::distance_to_contours(Vec3 p) const {
  return std::sqrt(tree_.nearest(p, [&](std::uint32_t i) { return squared_distance(p, pieces_[i]); }));
}

/// False if there are too many; as the next two.
bool SectionField::place_on_contours(Grid& grid, std::span<const std::uint32_t> pieces) const {
  for (const std::uint32_t i : pieces) {
    const auto& [a, b] = pieces_[i];
    const double parts = std::clamp(std::ceil(4 * norm(b - a) / grid.step), 1.0, 256.0);
    for (double k = 0; k < parts; ++k)
      if (!grid.add(a + (k / parts) * (b - a), 0.5 * grid.step, Grid::kOnContour)) return false;
  }
  return true;
}

bool SectionField::place_on_plane(Grid& grid, std::uint32_t p) const {
  const Vec3 n = planes_[p].normal;
  const double height = planes_[p].height(grid.centre);
  if (std::fabs(height) >= grid.radius) return true;
  const Vec3 foot = grid.centre - height * n;
  const Vec3 side = std::fabs(n.x) < 0.7 ? cross(n, Vec3{1, 0, 0}) : cross(n, Vec3{0, 1, 0});
  const Vec3 u = (grid.step / norm(side)) * side, v = 0.866 * cross(n, u);
  const int rows = static_cast<int>(std::ceil(grid.radius / grid.step)) + 1;
  for (int i = -rows; i <= rows; ++i)
    for (int j = -rows; j <= rows; ++j)
      if (!grid.add(foot + (i + 0.5 * (j & 1)) * u + j * v, 0.4 * grid.step, p)) return false;
  return true;
}

bool SectionField::place(Grid& grid, std::span<const std::uint32_t> pieces) const {
  grid.places.clear();
  if (!place_on_contours(grid, pieces)) return false;
  for (std::uint32_t p = 0; p < planes_.size(); ++p)
    if (!place_on_plane(grid, p)) return false;
  return true;
}

std::vector<FieldSample> SectionField::samples(Vec3 centre, double radius) const {
  const Vec3 reach{radius, radius, radius};
  Bounds box;
  box.add(centre - reach);
  box.add(centre + reach);
  std::vector<std::uint32_t> pieces;
  tree_.for_overlaps(box, [&](std::uint32_t i) { pieces.push_back(i); });
  std::sort(pieces.begin(), pieces.end());
  Grid grid{centre, radius, radius / kStepsPerRadius, {}};
  while (!place(grid, pieces)) grid.step *= 1.2;
  std::vector<FieldSample> samples;
  for (const Grid::Place& p : grid.places) {
    const double distance = p.plane == Grid::kOnContour ? 0 : distance_to_contours(p.at);
    samples.push_back({p.at, distance == 0 || sections_[p.plane].contains(p.at) ? distance : -distance});
  }
  return samples;
}

}  // namespace crossloft
