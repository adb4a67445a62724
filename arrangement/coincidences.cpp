#include "coincidences.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace crossloft {
namespace {

/// Planes at less than this sine meet in no line, or a line in no point, that doubles could tell.
constexpr double kParallel = 1e-9;

double distance(const WantedPlane& p, Vec3 x) { return dot(p.normal, x) - p.offset; }

struct Line {
  Vec3 point, direction;
};

/// The line of two planes, if it comes into the ball.
bool meet(const WantedPlane& a, const WantedPlane& b, double radius, Line& line) {
  const Vec3 c = cross(a.normal, b.normal);
  const double sine2 = dot(c, c);
  if (sine2 < kParallel * kParallel) return false;
  line.point = (1 / sine2) * (a.offset * cross(b.normal, c) + b.offset * cross(c, a.normal));
  line.direction = (1 / std::sqrt(sine2)) * c;
  return norm(line.point) <= radius;
}

class Finder {
 public:
  Finder(const std::vector<WantedPlane>& planes, double radius, double tolerance)
      : planes_(planes),
        radius_(radius),
        tolerance_(tolerance),
        pencils_of_(planes.size()),
        points_of_(planes.size()) {}

  Coincidences run() {
    const auto k = static_cast<std::uint32_t>(planes_.size());
    for (std::uint32_t i = 0; i < k; ++i)
      for (std::uint32_t j = i + 1; j < k; ++j)
        if (Line line; !in_one_pencil(i, j) && meet(planes_[i], planes_[j], radius_, line)) visit(i, j, line);
    std::erase_if(found_.points, [&](const CommonPoint& p) { return follows_from_pencils(p); });
    return std::move(found_);
  }

 private:
  struct Crossing {
    double t;
    std::uint32_t plane;
    bool operator<(const Crossing& o) const { return t != o.t ? t < o.t : plane < o.plane; }
  };

  Vec3 at(const Line& line, double t) const { return line.point + t * line.direction; }

  bool in_one_pencil(std::uint32_t i, std::uint32_t j) const {
    return std::any_of(pencils_of_[i].begin(), pencils_of_[i].end(), [&](std::size_t p) {
      return std::binary_search(found_.pencils[p].planes.begin(), found_.pencils[p].planes.end(), j);
    });
  }

  /// Later planes that contain the line make a pencil, several that cross it in one place a common point.
  void visit(std::uint32_t i, std::uint32_t j, const Line& line) {
    std::vector<std::uint32_t> around{i, j};
    std::vector<Crossing> crossings;
    for (std::uint32_t k = j + 1; k < planes_.size(); ++k) {
      const double low = distance(planes_[k], at(line, -radius_)),
                   high = distance(planes_[k], at(line, radius_));
      if (std::max(std::fabs(low), std::fabs(high)) <= tolerance_)
        around.push_back(k);
      else if (std::fabs(high - low) > kParallel * radius_ && (low <= 0) != (high <= 0))
        crossings.push_back({radius_ * (low + high) / (low - high), k});
    }
    if (around.size() > 2) {
      for (const std::uint32_t k : around) pencils_of_[k].push_back(found_.pencils.size());
      found_.pencils.push_back({around, line.point, line.direction});
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t first = 0; first < crossings.size();) first = add_group(around, line, crossings, first);
  }

  /// The crossings from `first` on that are one point; the first after them.
  std::size_t add_group(const std::vector<std::uint32_t>& around, const Line& line,
                        const std::vector<Crossing>& crossings, std::size_t first) {
    const Vec3 x = at(line, crossings[first].t);
    std::size_t end = first + 1;
    while (end < crossings.size() && std::fabs(distance(planes_[crossings[end].plane], x)) <= tolerance_ &&
           crossings[end].t - crossings[first].t <= 1e3 * tolerance_)
      ++end;
    if (end - first + around.size() < 4 || end - first < 2) return end;
    std::vector<std::uint32_t> planes = around;
    for (std::size_t c = first; c < end; ++c) planes.push_back(crossings[c].plane);
    std::sort(planes.begin(), planes.end());
    add_point(std::move(planes), x);
    return end;
  }

  void add_point(std::vector<std::uint32_t> planes, Vec3 x) {
    for (const std::size_t p : points_of_[planes.front()])
      if (CommonPoint& known = found_.points[p]; norm(known.point - x) <= 1e3 * tolerance_)
        return extend(p, planes);
    for (const std::uint32_t k : planes) points_of_[k].push_back(found_.points.size());
    found_.points.push_back({std::move(planes), x});
  }

  void extend(std::size_t point, const std::vector<std::uint32_t>& planes) {
    std::vector<std::uint32_t>& known = found_.points[point].planes;
    for (const std::uint32_t k : planes) {
      const auto place = std::lower_bound(known.begin(), known.end(), k);
      if (place != known.end() && *place == k) continue;
      known.insert(place, k);
      points_of_[k].push_back(point);
    }
  }

  /// A pencil pins its planes in the point as two of them do; three planes always meet.
  bool follows_from_pencils(const CommonPoint& p) const {
    std::set<std::size_t> pencils;
    for (const std::uint32_t k : p.planes) pencils.insert(pencils_of_[k].begin(), pencils_of_[k].end());
    std::size_t free = p.planes.size();
    for (const std::size_t q : pencils) {
      const auto& members = found_.pencils[q].planes;
      const auto common =
          static_cast<std::size_t>(std::count_if(p.planes.begin(), p.planes.end(), [&](auto k) {
            return std::binary_search(members.begin(), members.end(), k);
          }));
      if (common > 2) free -= common - 2;
    }
    return free <= 3;
  }

  const std::vector<WantedPlane>& planes_;
  double radius_, tolerance_;
  Coincidences found_;
  std::vector<std::vector<std::size_t>> pencils_of_, points_of_;
};

}  // namespace

std::vector<std::uint32_t> find_equal_planes(const std::vector<WantedPlane>& planes, double radius,
                                             double tolerance) {
  std::vector<std::uint32_t> first(planes.size());
  for (std::uint32_t j = 0; j < planes.size(); ++j) {
    first[j] = j;
    for (std::uint32_t i = 0; i < j; ++i) {
      // Normals have canonical signs, but near the border between two signs equal planes may be opposite.
      const double sign = dot(planes[i].normal, planes[j].normal) < 0 ? -1 : 1;
      const Vec3 turn = planes[i].normal - sign * planes[j].normal;
      const double gap = std::fabs(planes[i].offset - sign * planes[j].offset);
      if (gap + radius * norm(turn) > tolerance) continue;
      const std::uint32_t from = std::max(first[i], first[j]), to = std::min(first[i], first[j]);
      for (std::uint32_t k = 0; k <= j; ++k)
        if (first[k] == from) first[k] = to;
    }
  }
  return first;
}

Coincidences find_coincidences(const std::vector<WantedPlane>& planes, double radius, double tolerance) {
  return Finder(planes, radius, tolerance).run();
}

}  // namespace crossloft
