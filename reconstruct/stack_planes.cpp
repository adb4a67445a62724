#include "stack_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "../arrangement/normalise.h"
#include "../geom/frame.h"

namespace crossloft {
namespace {

/// Planes this near, as a fraction of the diagonal, are one level: twice what makes them one
/// (frame_sections), so that no plane is parted.
constexpr double kOneLevel = 2e-9;
/// And those this near, as a fraction of the largest coordinate: offsets are sums of three rounded products
/// with a rounded unit vector, off by less than 9 units of 2^-53 of it, and differences by less than 18.
constexpr double kRounding = 0x1p-48;

/// The normal as frames see it: parallel planes have the same one.
struct Direction {
  LatticeVector quantised{};
  Vec3 unit;
};

/// REQUIRES: finite, not 0.
Direction direction_of(const Vec3& normal) {
  Direction d{quantise_direction(normal), {}};
  const Vec3 v{static_cast<double>(d.quantised[0]), static_cast<double>(d.quantised[1]),
               static_cast<double>(d.quantised[2])};
  d.unit = (1 / norm(v)) * v;
  return d;
}

/// Where the plane is along the direction: half way between the extreme ends of walls, as frames place it.
double offset_along(const Vec3& unit, const WallSection& plane) {
  if (plane.vertices.empty()) {
    const Vec3 n = plane.normal;
    return dot(unit, (-plane.offset / dot(n, n)) * n);
  }
  double low = dot(unit, plane.vertices[0]), high = low;
  for (const Vec3& v : plane.vertices) low = std::min(low, dot(unit, v)), high = std::max(high, dot(unit, v));
  return low / 2 + high / 2;
}

double largest_coordinate(const Bounds& box) {
  double largest = 0;
  for (const Vec3& p : {box.low, box.high})
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  return box.empty() ? 0 : largest;
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
  explicit Surveyor(std::string name) : name_(std::move(name)) {}

  Result<Done> take(PlaneSection plane) {
    const auto position = static_cast<std::uint32_t>(offsets_.size());
    Sections alone{name_, {}, PartOf{{position}, {}}};
    alone.planes.push_back(std::move(plane));
    const auto walls = walls_of(alone);
    if (!walls) return walls.error();
    const PlaneSection& p = alone.planes[0];
    const Direction direction = direction_of(p.normal);
    if (!direction_) direction_ = direction;
    if (direction.quantised != direction_->quantised) return not_parallel(name_, p, position);
    offsets_.push_back(offset_along(direction_->unit, walls->front()));
    out_.vertices.push_back(static_cast<std::uint32_t>(p.vertices.size()));
    boxes_.push_back(bounds_of(walls->front().vertices));
    triangles_.push_back(least_triangle(walls->front()));
    out_.extent.join(boxes_.back());
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
    offsets_[position] = offset_along(direction_->unit, section);
    boxes_[position] = bounds_of(section.vertices);
    return Done{};
  }

  StackPlanes finish() {
    for (const Bounds& box : boxes_) out_.wide.join(box);
    if (out_.wide.empty()) out_.wide = out_.extent;
    for (std::uint32_t p = 0; p < offsets_.size(); ++p) out_.positions.push_back(p);
    std::stable_sort(out_.positions.begin(), out_.positions.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return offsets_[a] < offsets_[b]; });
    find_levels();
    return std::move(out_);
  }

 private:
  void find_levels() {
    const double near = kOneLevel * diagonal_of(out_.wide) + kRounding * largest_coordinate(out_.wide);
    auto& positions = out_.positions;
    for (std::uint32_t r = 0; r < positions.size(); ++r)
      if (r == 0 || offsets_[positions[r]] - offsets_[positions[r - 1]] > near) out_.begin_of.push_back(r);
    out_.begin_of.push_back(static_cast<std::uint32_t>(positions.size()));
    out_.level_of.resize(positions.size());
    for (std::uint32_t l = 0; l < out_.levels(); ++l) {
      for (const std::uint32_t position : out_.level(l)) out_.level_of[position] = l;
      std::sort(positions.begin() + out_.begin_of[l], positions.begin() + out_.begin_of[l + 1]);
    }
  }

  std::string name_;
  std::optional<Direction> direction_;
  std::vector<double> offsets_, triangles_;
  std::vector<Bounds> boxes_;
  StackPlanes out_;
};

}  // namespace

Result<StackPlanes> survey(SectionSource& source, const Context& context) {
  const std::uint32_t count = source.plane_count();
  if (count == 0)
    return Error{ErrorCode::no_plane, "there is no cutting plane", source.name(), 0, kNone, kNone};
  Surveyor surveyor(source.name());
  for (std::uint32_t p = 0; p < count; ++p) {
    if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
    context.report("survey", static_cast<double>(p) / count);
    auto plane = source.read(p);
    if (!plane) return plane.error();
    if (auto good = surveyor.take(std::move(plane).value()); !good) return good.error();
  }
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
  Sections part{source.name(), {}, PartOf{{}, planes.extent, planes.wide}};
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
