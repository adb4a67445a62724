#include "common_lines.h"

#include <cmath>
#include <map>
#include <set>

namespace crossloft {
namespace {

/// Planes at a smaller angle have no line that doubles could tell.
constexpr double kLeastSine = 1e-9;

/// False if the planes are parallel or their line misses the ball.
bool meet(const UnitPlane& p, const UnitPlane& q, const DataBall& ball, CommonLine& line) {
  const Vec3 along = cross(p.normal, q.normal);
  const double sine = norm(along);
  if (sine < kLeastSine) return false;
  const double cosine = dot(p.normal, q.normal), hp = p.height(ball.middle), hq = q.height(ball.middle);
  const double a = (hp - cosine * hq) / (sine * sine), b = (hq - cosine * hp) / (sine * sine);
  const Vec3 foot = -a * p.normal - b * q.normal;
  const double left = ball.radius * ball.radius - dot(foot, foot);
  if (!(left > 0)) return false;
  line.point = ball.middle + foot;
  line.direction = (1 / sine) * along;
  line.reach = std::sqrt(left);
  return true;
}

}  // namespace

std::vector<CommonLine> common_lines(std::span<const UnitPlane> planes, const DataBall& ball,
                                     double tolerance) {
  std::vector<CommonLine> lines;
  std::set<std::pair<std::uint32_t, std::uint32_t>> done;
  for (std::uint32_t i = 0; i < planes.size(); ++i)
    for (std::uint32_t j = i + 1; j < planes.size(); ++j) {
      CommonLine line;
      if (done.contains({i, j}) || !meet(planes[i], planes[j], ball, line)) continue;
      const Vec3 p = line.at(-line.reach), q = line.at(line.reach);
      for (std::uint32_t k = 0; k < planes.size(); ++k)
        if (k == i || k == j ||
            (std::fabs(planes[k].height(p)) <= tolerance && std::fabs(planes[k].height(q)) <= tolerance))
          line.planes.push_back(k);
      for (const std::uint32_t k : line.planes)
        for (const std::uint32_t l : line.planes) done.insert({k, l});
      lines.push_back(std::move(line));
    }
  return lines;
}

std::vector<SharedPoint> common_points(std::span<const UnitPlane> planes, std::span<const CommonLine> lines,
                                       double tolerance) {
  std::map<std::vector<std::uint32_t>, SharedPoint> points;
  for (std::uint32_t l = 0; l < lines.size(); ++l)
    for (std::uint32_t k = 0; k < planes.size(); ++k) {
      const double slope = dot(planes[k].normal, lines[l].direction);
      if (std::fabs(slope) < kLeastSine) continue;
      const double t = -planes[k].height(lines[l].point) / slope;
      if (!(std::fabs(t) <= lines[l].reach)) continue;
      SharedPoint found{lines[l].at(t), {}, {}};
      for (std::uint32_t p = 0; p < planes.size(); ++p)
        if (p == k || std::fabs(planes[p].height(found.point)) <= tolerance) found.planes.push_back(p);
      if (found.planes.size() <= lines[l].planes.size()) continue;  // it is a plane of the line
      SharedPoint& point = points.try_emplace(found.planes, found).first->second;
      if (point.lines.empty() || point.lines.back() != l) point.lines.push_back(l);
    }
  std::vector<SharedPoint> result;
  for (auto& [key, point] : points) result.push_back(std::move(point));
  return result;
}

}  // namespace crossloft
