#include "plane_frames.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "../geom/frame.h"
#include "../geom/parallel.h"

namespace crossloft {
namespace {

LatticeVector round(Vec3 v) {
  return {static_cast<std::int64_t>(std::floor(v.x + 0.5)), static_cast<std::int64_t>(std::floor(v.y + 0.5)),
          static_cast<std::int64_t>(std::floor(v.z + 0.5))};
}

class Framer {
 public:
  Framer(const std::vector<PlaneWish>& wishes, std::int64_t radius)
      : wishes_(wishes),
        radius_(radius),
        planes_(wishes.size()),
        anchors_(wishes.size()),
        bound_(wishes.size()) {}

  PlaneFrames run(Coincidences found, const Context& context) {
    frame_each_alone(context);
    const auto larger = [](const auto& a, const auto& b) { return a.planes.size() > b.planes.size(); };
    std::stable_sort(found.points.begin(), found.points.end(), larger);
    std::stable_sort(found.pencils.begin(), found.pencils.end(), larger);
    for (const Pencil& p : found.pencils)
      if (holds(p)) bind(p.planes);
    for (const CommonPoint& p : found.points)
      if (holds(p)) bind(p.planes);
    for (const CommonPoint& p : found.points)
      if (!holds(p)) anchor(p);
    for (const Pencil& p : found.pencils)
      if (!holds(p)) align(p);
    for (std::uint32_t i = 0; i < planes_.size(); ++i)
      if (anchors_[i] && !bound_[i]) put_through(i, planes_[i].normal, *anchors_[i]);
    return count(found);
  }

 private:
  void frame_each_alone(const Context& context) {
    std::map<LatticeVector, LatticeVector> known;
    for (const PlaneWish& w : wishes_)
      if (auto [entry, fresh] = known.try_emplace(w.direction); fresh)
        entry->second = fit_normal(w.direction, radius_);
    parallel_for(wishes_.size(), context, "sections", [&](std::size_t i) {
      const PlaneWish& w = wishes_[i];
      const LatticeVector& normal = known.find(w.direction)->second;
      planes_[i] = w.points.empty() ? plane_through(normal, w.centre, w.centre)
                                    : plane_amid(normal, w.points, w.centre);
    });
  }

  void bind(const std::vector<std::uint32_t>& planes) {
    for (const std::uint32_t i : planes) bound_[i] = true;
  }
  void put_through(std::uint32_t i, const LatticeVector& normal, const LatticeVector& point) {
    planes_[i] = plane_through(normal, point, wishes_[i].centre);
  }

  bool holds(const Pencil& p) const {
    return std::all_of(p.planes.begin() + 2, p.planes.end(), [&](std::uint32_t k) {
      return share_line(planes_[p.planes[0]], planes_[p.planes[1]], planes_[k]);
    });
  }
  bool holds(const CommonPoint& p) const {
    LatticePointStore store;
    LatticePoint x;
    return meet_of_three(p.planes, store, x) &&
           std::all_of(p.planes.begin(), p.planes.end(),
                       [&](std::uint32_t k) { return side_of_plane(planes_[k], x) == 0; });
  }
  /// The point of the first two planes that cross and the first third that makes it unique.
  bool meet_of_three(const std::vector<std::uint32_t>& p, LatticePointStore& store, LatticePoint& x) const {
    for (std::size_t j = 1; j < p.size(); ++j)
      for (std::size_t k = j + 1; k < p.size(); ++k)
        if (store.meet(planes_[p[0]], planes_[p[j]], planes_[p[k]], x)) return true;
    return false;
  }

  std::vector<std::uint32_t> bound_among(const std::vector<std::uint32_t>& planes) const {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t i : planes)
      if (bound_[i]) result.push_back(i);
    return result;
  }
  /// A lattice point near x on all of these planes, if it is easily had.
  std::optional<LatticeVector> point_on(const std::vector<std::uint32_t>& planes, Vec3 x) const {
    LatticeVector point = round(x);
    if (planes.size() == 1) point = snap_to_plane(planes_[planes[0]], point);
    for (const std::uint32_t i : planes)
      if (side_of_plane(planes_[i], make_point(point)) != 0) return std::nullopt;
    return point;
  }

  /// Gives the planes one lattice point, unless they are bound or have another one.
  void anchor(const CommonPoint& p) {
    for (const std::uint32_t i : p.planes)
      if (anchors_[i]) return;
    const std::optional<LatticeVector> point = point_on(bound_among(p.planes), p.point);
    if (!point) return;
    for (const std::uint32_t i : p.planes) anchors_[i] = point;
  }

  /// The anchor that all planes of the pencil have.
  std::optional<LatticeVector> common_anchor(const Pencil& p) const {
    for (const std::uint32_t i : p.planes)
      if (anchors_[i] != anchors_[p.planes[0]]) return std::nullopt;
    return anchors_[p.planes[0]];
  }

  /// Turns the planes of the pencil that are not bound about a lattice axis.
  void align(const Pencil& p) {
    const std::vector<std::uint32_t> bound = bound_among(p.planes);
    const LatticeVector wanted = quantise_direction(p.direction);
    LatticeVector axis;
    if (bound.empty()) {
      axis = fit_axis(wanted, radius_);
    } else if (bound.size() == 1) {
      if (!fit_axis_in_plane(wanted, planes_[bound[0]].normal, radius_, axis)) return;
    } else if (!axis_of(planes_[bound[0]], planes_[bound[1]], axis)) {
      return;
    }
    std::optional<LatticeVector> point = common_anchor(p);
    if (!point || !bound.empty()) point = point_on(bound, p.point);
    if (!point) return;
    for (const std::uint32_t i : p.planes)
      if (!bound_[i]) put_through(i, fit_normal_around(wishes_[i].direction, axis, radius_), *point);
    bind(p.planes);
  }

  PlaneFrames count(const Coincidences& found) {
    PlaneFrames result;
    for (const Pencil& p : found.pencils) ++(holds(p) ? result.pencils : result.lost_pencils);
    for (const CommonPoint& p : found.points) ++(holds(p) ? result.points : result.lost_points);
    result.planes = std::move(planes_);
    return result;
  }

  const std::vector<PlaneWish>& wishes_;
  std::int64_t radius_;
  std::vector<LatticePlane> planes_;
  std::vector<std::optional<LatticeVector>> anchors_;
  std::vector<bool> bound_;
};

}  // namespace

PlaneFrames frame_planes(const std::vector<PlaneWish>& wishes, std::int64_t radius, double tolerance,
                         const Context& context) {
  std::vector<WantedPlane> planes;
  for (const PlaneWish& w : wishes) planes.push_back(w.plane);
  return Framer(wishes, radius)
      .run(find_coincidences(planes, static_cast<double>(radius), tolerance), context);
}

}  // namespace crossloft
