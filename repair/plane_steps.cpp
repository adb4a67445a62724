/// First step: every plane goes through its vertices, and no plane is there twice.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "../geom/unit_plane.h"
#include "repair_steps.h"
#include "section_edit.h"

namespace crossloft::repair_steps {
namespace {

/// A plane with the other sign of D is taken if it is this much nearer to its vertices.
constexpr double kClearlyBetter = 0.1;

struct Spread {
  double low = 0, high = 0;  ///< of normal.x over the vertices
};

/// Vertices of edges, in lexicographic order: sums over them depend on the section alone.
std::vector<Vec3> used_vertices(const PlaneSection& section) {
  std::vector<Vec3> used;
  for (const ContourEdge& e : section.edges)
    used.insert(used.end(), {section.vertices[e.a], section.vertices[e.b]});
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

Spread spread_along(Vec3 normal, const std::vector<Vec3>& vertices) {
  Spread s{dot(normal, vertices[0]), dot(normal, vertices[0])};
  for (const Vec3& v : vertices)
    s.low = std::min(s.low, dot(normal, v)), s.high = std::max(s.high, dot(normal, v));
  return s;
}

double largest_residual(const PlaneSection& p, double offset) {
  const UnitPlane plane = unit_plane(p.normal, offset);
  double largest = 0;
  for (const ContourEdge& e : p.edges) largest = std::max(largest, std::fabs(plane.height(p.vertices[e.a])));
  return largest;
}

void settle_sign(Work& work, WorkPlane& plane) {
  PlaneSection& p = plane.section;
  const double kept = largest_residual(p, p.offset), turned = largest_residual(p, -p.offset);
  if (kept <= work.options.plane_tolerance * work.diagonal || turned > kClearlyBetter * kept) return;
  p.offset = -p.offset;
  work.note({RepairKind::offset_sign, plane.source, kNone, kNone, 1, 0, p.vertices[p.edges[0].a],
             "D has the other sign than the vertices"});
}

using Matrix = std::array<std::array<double, 3>, 3>;

double determinant(const Matrix& m) {
  return dot({m[0][0], m[0][1], m[0][2]}, cross({m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}));
}

/// The plane through the vertices by least squares of the heights over the present one; its normal.
Vec3 fitted_normal(const WorkPlane& plane, const std::vector<Vec3>& vertices) {
  const Vec3 n = plane.normal;
  const Vec3 axis = std::fabs(n.x) <= 0.5   ? Vec3{1, 0, 0}
                    : std::fabs(n.y) <= 0.5 ? Vec3{0, 1, 0}
                                            : Vec3{0, 0, 1};
  Vec3 u = cross(n, axis);
  u = (1 / norm(u)) * u;
  const Vec3 v = cross(n, u);
  Matrix m{};
  std::array<double, 3> right{};
  for (const Vec3& p : vertices) {
    const Vec3 d = p - vertices[0];
    const std::array<double, 3> row{1, dot(u, d), dot(v, d)};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) m[i][j] += row[i] * row[j];
      right[i] += row[i] * dot(n, d);
    }
  }
  const double whole = determinant(m);
  if (!(std::fabs(whole) > 0)) return n;
  const auto slope = [&](std::size_t column) {
    Matrix replaced = m;
    for (std::size_t i = 0; i < 3; ++i) replaced[i][column] = right[i];
    return determinant(replaced) / whole;
  };
  const Vec3 fitted = n - slope(1) * u - slope(2) * v;
  return (1 / norm(fitted)) * fitted;
}

/// Half the spread of the vertices along the normal.
double off_plane(const WorkPlane& plane) {
  const std::vector<Vec3> vertices = used_vertices(plane.section);
  if (vertices.empty()) return 0;
  const Spread s = spread_along(plane.normal, vertices);
  return (s.high - s.low) / 2;
}

/// Gives the section the plane with the side of the normal that it has in the file, and with its length
/// unless that leaves no room for digits.
void replace_plane(PlaneSection& p, const UnitPlane& plane) {
  const double length = norm(p.normal), kept = length > 1e-290 && length < 1e300 ? length : 1;
  const double side = dot(unit_plane(p.normal, p.offset).normal, plane.normal) < 0 ? -kept : kept;
  p.normal = side * plane.normal;
  p.offset = side * plane.offset;
}

void fit(Work& work, WorkPlane& plane) {
  const std::vector<Vec3> vertices = used_vertices(plane.section);
  const Vec3 normal = fitted_normal(plane, vertices);
  const Spread before = spread_along(plane.normal, vertices), after = spread_along(normal, vertices);
  if (!(after.high - after.low < (before.high - before.low) / 2)) return;
  replace_plane(plane.section, {normal, -(after.low / 2 + after.high / 2)});
  settle_plane(plane);
  work.note({RepairKind::plane_fitted, plane.source, kNone, kNone, 1, (before.high - before.low) / 2,
             vertices[0], "the plane was turned to its vertices"});
}

/// What was moved of one contour.
struct Moved {
  std::uint32_t count = 0, first = kNone;
  double distance = 0;
};

void tell_moved(Work& work, const WorkPlane& plane, std::uint32_t contour, const Moved& m, bool within) {
  work.note({within ? RepairKind::onto_plane : RepairKind::left_as_it_is, plane.source, contour, m.first,
             m.count, m.distance, plane.section.vertices[m.first],
             count_of(m.count, "vertex", "vertices") +
                 (within ? " moved onto the plane" : " further off the plane than the limit")});
}

void move_onto(Work& work, WorkPlane& plane) {
  PlaneSection& p = plane.section;
  std::map<std::uint32_t, Moved> moved, left;
  std::vector<bool> done(p.vertices.size(), false);
  for (const ContourEdge& e : p.edges)
    for (const std::uint32_t v : {e.a, e.b}) {
      const double height = dot(plane.normal, p.vertices[v]) + plane.offset, distance = std::fabs(height);
      if (done[v] || distance <= 1e-15 * work.diagonal) continue;
      done[v] = true;
      const bool within = distance <= work.options.limit * work.diagonal;
      Moved& m = (within ? moved : left)[e.contour];
      m.first = std::min(m.first, v);
      m.distance = std::max(m.distance, distance);
      ++m.count;
      if (within) p.vertices[v] = p.vertices[v] - height * plane.normal;
    }
  replace_plane(p, {plane.normal, plane.offset});
  for (const auto& [contour, m] : moved) tell_moved(work, plane, contour, m, true);
  for (const auto& [contour, m] : left) tell_moved(work, plane, contour, m, false);
}

/// How far two planes are apart at most over the data.
double distance_over_data(const Work& work, const WorkPlane& a, const WorkPlane& b) {
  const double side = dot(a.normal, b.normal) < 0 ? -1 : 1;
  const Vec3 difference = a.normal - side * b.normal;
  return std::fabs(dot(difference, work.middle) + a.offset - side * b.offset) +
         norm(difference) * work.diagonal / 2;
}

}  // namespace

void settle_plane(WorkPlane& plane) {
  const PlaneSection& p = plane.section;
  const UnitPlane unit = unit_plane(p.normal, p.offset);
  const double sign = unit.normal < Vec3{} ? -1 : 1;
  plane.normal = sign * unit.normal + Vec3{};
  plane.offset = sign * unit.offset;
  const std::vector<Vec3> vertices = used_vertices(p);
  if (vertices.empty()) return;
  const Spread s = spread_along(plane.normal, vertices);
  plane.offset = -(s.low / 2 + s.high / 2);
}

void repair_planes(Work& work) {
  const double tolerance = work.options.plane_tolerance * work.diagonal;
  for (WorkPlane& plane : work.planes) {
    if (plane.section.edges.empty() || work.context.cancelled()) continue;
    settle_sign(work, plane);
    if (off_plane(plane) <= tolerance) continue;
    fit(work, plane);
    if (off_plane(plane) > tolerance) move_onto(work, plane);
    settle_plane(plane);
  }
}

void unite_planes(Work& work) {
  const double tolerance = work.options.same_plane * work.diagonal;
  // By position and not by the order of the file: which of the planes stays must not depend on that.
  std::vector<std::uint32_t> order;
  for (std::uint32_t p = 0; p < work.planes.size(); ++p) order.push_back(p);
  const auto key = [&](std::uint32_t p) {
    const WorkPlane& w = work.planes[p];
    return std::tuple(w.section.edges.empty(), w.normal, w.offset, used_vertices(w.section));
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<bool> gone(work.planes.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (gone[order[i]] || work.context.cancelled()) continue;
    WorkPlane& first = work.planes[order[i]];
    std::vector<PlaneSection> others;
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      WorkPlane& other = work.planes[order[j]];
      const double apart = distance_over_data(work, first, other);
      if (gone[order[j]] || apart > tolerance) continue;
      gone[order[j]] = true;
      for (Vec3& v : other.section.vertices) v = v - (dot(first.normal, v) + first.offset) * first.normal;
      work.note({RepairKind::planes_united,
                 other.source,
                 kNone,
                 kNone,
                 1,
                 apart,
                 {},
                 "the plane is plane " + std::to_string(first.source) + ": their sections were united"});
      others.push_back(std::move(other.section));
    }
    if (others.empty()) continue;
    std::vector<const PlaneSection*> pointers;
    for (const PlaneSection& s : others) pointers.push_back(&s);
    first.edited |= edit_section(first.section, work.chart(first), {}, pointers, work.context).changed;
  }
  std::size_t p = 0;
  std::erase_if(work.planes, [&](const WorkPlane&) { return gone[p++]; });
}

}  // namespace crossloft::repair_steps
