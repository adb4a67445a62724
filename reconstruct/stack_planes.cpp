#include "stack_planes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "../arrangement/directions.h"
#include "../arrangement/normalise.h"
#include "../geom/frame.h"
#include "../geom/grid.h"

namespace crossloft {
namespace {

/// Planes this near, as a fraction of the diagonal, are one level: twice what makes them one
/// (frame_sections), so that no plane is parted.
constexpr double kOneLevel = 2e-9;
/// And those this near, as a fraction of the largest coordinate: offsets are sums of three rounded products
/// with a rounded unit vector, off by less than 9 units of 2^-53 of it, and differences by less than 18.
constexpr double kRounding = 0x1p-48;

/// The normal as frames see it.
Vec3 unit_of(const LatticeVector& direction) {
  const Vec3 v{static_cast<double>(direction[0]), static_cast<double>(direction[1]),
               static_cast<double>(direction[2])};
  return (1 / norm(v)) * v;
}

/// The ends of a plane's walls along its normal; twice the foot of the origin if there are none.
using Ends = std::array<Vec3, 2>;

Ends ends_along(const Vec3& unit, const WallSection& plane) {
  if (plane.vertices.empty()) {
    const Vec3 n = plane.normal, foot = (-plane.offset / dot(n, n)) * n;
    return {foot, foot};
  }
  const auto [low, high] =
      std::minmax_element(plane.vertices.begin(), plane.vertices.end(),
                          [&](const Vec3& a, const Vec3& b) { return dot(unit, a) < dot(unit, b); });
  return {*low, *high};
}

double largest_coordinate(const Bounds& box) {
  double largest = 0;
  for (const Vec3& p : {box.low, box.high})
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return box.empty() ? 0 : largest;
}

/// Frames order planes along the normal that they fit to the direction. Its first component that is not 0 is
/// positive, as that of the direction: but where the direction has one next to 0 the normal may have none
/// there, and be turned round.
bool turns_round(const LatticeVector& direction, const Bounds& box) {
  const double diagonal = diagonal_of(box);
  if (diagonal == 0) return false;  // frames make nothing of it
  const double radius = std::ceil(diagonal / WorldGrid(box.low, box.high).unit() / 2);
  return dot(unit_of(fit_normal(direction, static_cast<std::int64_t>(radius))), unit_of(direction)) < 0;
}

Error not_parallel(const std::string& file, const PlaneSection& plane, std::uint32_t position) {
  return {ErrorCode::usage,
          "the plane is not parallel to plane 0: only a stack of parallel planes can be streamed",
          file,
          plane.line,
          position,
          kNone};
}

/// Takes the planes one after the other.
class Surveyor {
 public:
  Surveyor(std::string name, std::uint32_t count) : name_(std::move(name)), count_(count) {}

  Result<Done> take(PlaneSection plane) {
    const auto position = static_cast<std::uint32_t>(ends_.size());
    Sections alone{name_, {}, PartOf{{position}, {}}};
    alone.planes.push_back(std::move(plane));
    const auto walls = walls_of(alone);
    if (!walls) return walls.error();
    const PlaneSection& p = alone.planes[0];
    if (auto good = take_direction(p, position); !good) return good;
    ends_.push_back(ends_along(unit_of(directions_[0]), walls->front()));
    out_.vertices.push_back(static_cast<std::uint32_t>(p.vertices.size()));
    boxes_.push_back(bounds_of(walls->front().vertices));
    triangles_.push_back(least_triangle(walls->front()));
    out_.extent.join(boxes_.back());
    return Done{};
  }

  /// Once all have been taken: whether they are parallel.
  Result<Done> unify() {
    std::vector<LatticeVector> unified = directions_;
    unify_directions(unified);
    for (std::size_t i = 0; i < unified.size(); ++i)
      if (unified[i] != unified[0]) return first_of_[i];
    out_.direction = unified[0];
    return Done{};
  }

  /// Planes, of all that have been taken, with contours that frames may drop: now that the size is known.
  std::vector<std::uint32_t> in_doubt() const {
    std::vector<std::uint32_t> list;
    for (std::uint32_t p = 0; p < triangles_.size(); ++p)
      if (may_be_flat(triangles_[p], diagonal_of(out_.extent))) list.push_back(p);
    return list;
  }

  /// One of those, without what is dropped.
  Result<Done> take_again(std::uint32_t position, PlaneSection plane) {
    Sections alone{name_, {}, PartOf{{position}, {}}};
    alone.planes.push_back(std::move(plane));
    auto walls = walls_of(alone);
    if (!walls) return walls.error();
    WallSection& section = walls->front();
    drop_flat(section, diagonal_of(out_.extent));
    ends_[position] = ends_along(unit_of(directions_[0]), section);
    boxes_[position] = bounds_of(section.vertices);
    return Done{};
  }

  StackPlanes finish() {
    for (const Bounds& box : boxes_) out_.wide.join(box);
    if (out_.wide.empty()) out_.wide = out_.extent;
    Vec3 unit = unit_of(out_.direction);
    if (turns_round(out_.direction, out_.wide)) unit = -unit;
    std::vector<double> offsets;  // half way between the ends, as frames place a plane
    for (const auto& [low, high] : ends_) offsets.push_back(dot(unit, low) / 2 + dot(unit, high) / 2);
    for (std::uint32_t p = 0; p < offsets.size(); ++p) out_.positions.push_back(p);
    std::stable_sort(out_.positions.begin(), out_.positions.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return offsets[a] < offsets[b]; });
    find_levels(offsets);
    return std::move(out_);
  }

 private:
  /// As many directions as there are planes can be one, each a unit from the next.
  Result<Done> take_direction(const PlaneSection& plane, std::uint32_t position) {
    const LatticeVector direction = quantise_direction(plane.normal);
    if (std::find(directions_.begin(), directions_.end(), direction) != directions_.end()) return Done{};
    directions_.push_back(direction);
    first_of_.push_back(not_parallel(name_, plane, position));
    if (difference(direction, directions_[0]) > count_) return first_of_.back();
    return Done{};
  }

  void find_levels(const std::vector<double>& offsets) {
    const double near = kOneLevel * diagonal_of(out_.wide) + kRounding * largest_coordinate(out_.wide);
    auto& positions = out_.positions;
    for (std::uint32_t r = 0; r < positions.size(); ++r)
      if (r == 0 || offsets[positions[r]] - offsets[positions[r - 1]] > near) out_.begin_of.push_back(r);
    out_.begin_of.push_back(static_cast<std::uint32_t>(positions.size()));
    out_.level_of.resize(positions.size());
    for (std::uint32_t l = 0; l < out_.levels(); ++l) {
      for (const std::uint32_t position : out_.level(l)) out_.level_of[position] = l;
      std::sort(positions.begin() + out_.begin_of[l], positions.begin() + out_.begin_of[l + 1]);
    }
  }

  std::string name_;
  std::uint32_t count_;
  std::vector<LatticeVector> directions_;  ///< different ones, in the order they came; few
  std::vector<Error> first_of_;            ///< by direction: what to say of the first plane that has it
  std::vector<Ends> ends_;                 ///< by position, like the others
  std::vector<double> triangles_;
  std::vector<Bounds> boxes_;
  StackPlanes out_;
};

}  // namespace

Result<StackPlanes> survey(SectionSource& source, const Context& context) {
  const std::uint32_t count = source.plane_count();
  if (count == 0)
    return Error{ErrorCode::no_plane, "there is no cutting plane", source.name(), 0, kNone, kNone};
  Surveyor surveyor(source.name(), count);
  for (std::uint32_t p = 0; p < count; ++p) {
    if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
    context.report("survey", static_cast<double>(p) / count);
    auto plane = source.read(p);
    if (!plane) return plane.error();
    if (auto good = surveyor.take(std::move(plane).value()); !good) return good.error();
  }
  if (auto good = surveyor.unify(); !good) return good.error();
  for (const std::uint32_t p : surveyor.in_doubt()) {
    if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
    auto plane = source.read(p);
    if (!plane) return plane.error();
    if (auto good = surveyor.take_again(p, std::move(plane).value()); !good) return good.error();
  }
  return surveyor.finish();
}

Result<Sections> read_part(SectionSource& source, const StackPlanes& planes, std::uint32_t first,
                           std::uint32_t last) {
  Sections part{source.name(), {}, PartOf{{}, planes.extent, planes.wide, planes.direction}};
  for (std::uint32_t r = planes.begin_of[first]; r < planes.begin_of[last]; ++r) {
    auto plane = source.read(planes.positions[r]);
    if (!plane) return plane.error();
    part.planes.push_back(std::move(plane).value());
    part.part_of->positions.push_back(planes.positions[r]);
  }
  return part;
}

std::vector<std::uint32_t> window_levels(const StackPlanes& planes, std::uint64_t vertices,
                                         std::uint32_t least) {
  const std::uint32_t count = planes.levels();
  std::vector<std::uint32_t> cuts{0};
  std::uint64_t sum = 0;
  for (std::uint32_t l = 0; l < count; ++l) {
    for (const std::uint32_t position : planes.level(l)) sum += planes.vertices[position];
    if (sum < vertices || l + 1 - cuts.back() < least || count - l - 1 < least) continue;
    cuts.push_back(l + 1);
    sum = 0;
  }
  cuts.push_back(count);
  return cuts;
}

}  // namespace crossloft
