#include "stack_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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

Ends ends_along(const Vec3& unit, const WallSection& plane, const Vec3& origin) {
  if (plane.vertices.empty()) {
    const Vec3 n = plane.normal, foot = origin - ((dot(n, origin) + plane.offset) / dot(n, n)) * n;
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

/// How frames see the stack: the normal that they fit to the direction, and the origin of their grid. The
/// normal may be turned round against the direction: its first component that is not 0 is positive, and where
/// the direction has one next to 0 the normal may have none there.
struct StackFrame {
  Vec3 unit, origin;
  double tilt = 0;  ///< sine of the angle between them
};

StackFrame frame_of(const LatticeVector& direction, const Bounds& box) {
  const Vec3 unit = unit_of(direction);
  const double diagonal = box.diagonal();
  if (diagonal == 0) return {unit, {}};  // frames make nothing of it
  const WorldGrid grid(box.low, box.high);
  if (grid.unit() == 0) return {unit, {}};  // an error of frames
  const double radius = std::ceil(diagonal / grid.unit() / 2);
  const Vec3 fitted = unit_of(fit_normal(direction, static_cast<std::int64_t>(radius)));
  return {fitted, grid.from_lattice(LatticePoint{}), norm(cross(unit, fitted))};
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
    ends_.push_back(ends_along(unit_of(directions_[0]), walls->front(), {}));
    out_.vertices.push_back(static_cast<std::uint32_t>(p.vertices.size()));
    add_materials(p, out_.materials);
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
      if (may_be_flat(triangles_[p], out_.extent.diagonal())) list.push_back(p);
    return list;
  }

  /// One of those, without what is dropped.
  Result<Done> take_again(std::uint32_t position, PlaneSection plane) {
    return take_along(unit_of(directions_[0]), {}, position, std::move(plane));
  }

  /// Once all are there. Frames place a plane half way between its ends along the fitted normal. Along the
  /// direction these are off by less than the tilt times the diagonal, for each of two planes, and as much
  /// lies between their middles: the planes for which that may count.
  std::vector<std::uint32_t> fit() {
    for (const Bounds& box : boxes_) out_.wide.join(box);
    if (out_.wide.empty()) out_.wide = out_.extent;
    frame_ = frame_of(out_.direction, out_.wide);
    const Vec3 unit = unit_of(out_.direction);
    offsets_ = offsets_along(unit);
    const double reach = 4 * frame_.tilt * out_.wide.diagonal();
    if (reach <= near()) {
      frame_.unit = dot(unit, frame_.unit) < 0 ? -unit : unit;
      return {};
    }
    const std::vector<std::uint32_t> order = ascending(offsets_);
    std::vector<std::uint32_t> close;
    for (std::uint32_t r = 0; r < order.size(); ++r)
      if (boxes_[order[r]].empty() ||
          (r > 0 && offsets_[order[r]] - offsets_[order[r - 1]] <= reach + near()) ||
          (r + 1 < order.size() && offsets_[order[r + 1]] - offsets_[order[r]] <= reach + near()))
        close.push_back(order[r]);
    return close;
  }

  /// One of these.
  Result<Done> take_fitted(std::uint32_t position, PlaneSection plane) {
    return take_along(frame_.unit, frame_.origin, position, std::move(plane));
  }

  StackPlanes finish() {
    const std::vector<double> fitted = offsets_along(frame_.unit);
    out_.positions = ascending(fitted);
    find_levels(fitted);
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

  Result<Done> take_along(const Vec3& unit, const Vec3& origin, std::uint32_t position, PlaneSection plane) {
    Sections alone{name_, {}, PartOf{{position}, {}}};
    alone.planes.push_back(std::move(plane));
    auto walls = walls_of(alone);
    if (!walls) return walls.error();
    WallSection& section = walls->front();
    drop_flat(section, out_.extent.diagonal());
    ends_[position] = ends_along(unit, section, origin);
    boxes_[position] = bounds_of(section.vertices);
    return Done{};
  }

  /// What is less apart is one level.
  double near() const { return kOneLevel * out_.wide.diagonal() + kRounding * largest_coordinate(out_.wide); }

  /// By position: half way between the ends, as frames place a plane.
  std::vector<double> offsets_along(const Vec3& unit) const {
    std::vector<double> offsets;
    for (const auto& [low, high] : ends_) offsets.push_back(dot(unit, low) / 2 + dot(unit, high) / 2);
    return offsets;
  }

  static std::vector<std::uint32_t> ascending(const std::vector<double>& offsets) {
    std::vector<std::uint32_t> order(offsets.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return offsets[a] < offsets[b]; });
    return order;
  }

  /// Planes that are one along the direction are so in frames, too, wherever the fitted normal has them: what
  /// is between them then is one level with them.
  std::vector<std::uint8_t> inner_ranks() const {
    std::vector<std::uint32_t> rank(out_.positions.size());
    for (std::uint32_t r = 0; r < rank.size(); ++r) rank[out_.positions[r]] = r;
    std::vector<std::uint8_t> inner(rank.size() + 1, 0);
    const std::vector<std::uint32_t> order = ascending(offsets_);
    for (std::uint32_t r = 1; r < order.size(); ++r) {
      const std::uint32_t a = rank[order[r - 1]], b = rank[order[r]];
      if (offsets_[order[r]] - offsets_[order[r - 1]] <= near())
        std::fill(inner.begin() + std::min(a, b) + 1, inner.begin() + std::max(a, b) + 1, std::uint8_t{1});
    }
    return inner;
  }

  void find_levels(const std::vector<double>& offsets) {
    auto& positions = out_.positions;
    const std::vector<std::uint8_t> inner = inner_ranks();
    for (std::uint32_t r = 0; r < positions.size(); ++r)
      if (r == 0 || (inner[r] == 0 && offsets[positions[r]] - offsets[positions[r - 1]] > near()))
        out_.begin_of.push_back(r);
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
  std::vector<double> offsets_;  ///< along the direction
  StackFrame frame_;
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
  using Take = Result<Done> (Surveyor::*)(std::uint32_t, PlaneSection);
  const auto read_again = [&](const std::vector<std::uint32_t>& positions, Take take) -> Result<Done> {
    for (const std::uint32_t p : positions) {
      if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
      auto plane = source.read(p);
      if (!plane) return plane.error();
      if (auto good = (surveyor.*take)(p, std::move(plane).value()); !good) return good;
    }
    return Done{};
  };
  if (auto good = read_again(surveyor.in_doubt(), &Surveyor::take_again); !good) return good.error();
  if (auto good = read_again(surveyor.fit(), &Surveyor::take_fitted); !good) return good.error();
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
