/// First step: every plane goes through its vertices, and no plane is there twice.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "../geom/unit_plane.h"
#include "plane_records.h"
#include "repair_steps.h"
#include "section_edit.h"

namespace crossloft::repair_steps {
namespace {

/// A plane with the other sign of D is taken if it is this much nearer to its vertices.
constexpr double kClearlyBetter = 0.1;

/// Turned to its vertices, a plane may not move further over the data than this many times their distance
/// from it. A small section fits any plane up to its noise, a triangle even exactly.
constexpr double kMostLeverage = 8;

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

UnitPlane unit_of(const WorkPlane& plane) { return {plane.normal, plane.offset}; }

/// How far two planes are apart at most over the data.
double distance_over_data(const Work& work, const UnitPlane& a, const UnitPlane& b) {
  const double side = dot(a.normal, b.normal) < 0 ? -1 : 1;
  const Vec3 difference = a.normal - side * b.normal;
  return std::fabs(dot(difference, work.middle) + a.offset - side * b.offset) +
         norm(difference) * work.diagonal / 2;
}

/// Turns the plane to its vertices if that halves their spread, and if they are spread wide enough to tell.
void fit(Work& work, WorkPlane& plane) {
  const std::vector<Vec3> vertices = used_vertices(plane.section);
  const Vec3 normal = fitted_normal(plane, vertices);
  const Spread before = spread_along(plane.normal, vertices), after = spread_along(normal, vertices);
  if (!(after.high - after.low < (before.high - before.low) / 2)) return;
  const UnitPlane fitted{normal, -(after.low / 2 + after.high / 2)};
  const double off = (before.high - before.low) / 2;
  if (distance_over_data(work, unit_of(plane), fitted) > work.capped(kMostLeverage * off)) return;
  replace_plane(plane.section, fitted);
  settle_plane(plane);
  work.note({RepairKind::plane_fitted, plane.source, kNone, kNone, 1, off, vertices[0],
             "the plane was turned to its vertices"});
}

/// D of the file, for the normal of the work plane.
double offset_in_file(const WorkPlane& plane) {
  const UnitPlane file = unit_plane(plane.section.normal, plane.section.offset);
  return dot(file.normal, plane.normal) < 0 ? -file.offset : file.offset;
}

/// D where more than half of the vertices are, if there is one.
std::optional<double> offset_of_most(const WorkPlane& plane, double tolerance) {
  std::vector<double> heights;
  for (const Vec3& v : used_vertices(plane.section)) heights.push_back(dot(plane.normal, v));
  std::sort(heights.begin(), heights.end());
  const double median = heights[(heights.size() - 1) / 2];
  const auto near = std::count_if(heights.begin(), heights.end(),
                                  [&](double h) { return std::fabs(h - median) <= tolerance; });
  if (2 * static_cast<std::size_t>(near) <= heights.size()) return std::nullopt;
  return -median;
}

/// Gives the file the D that the vertices are moved to.
void tell_shifted(Work& work, WorkPlane& plane, double before) {
  replace_plane(plane.section, unit_of(plane));
  work.note({RepairKind::plane_fitted, plane.source, kNone, kNone, 1, std::fabs(plane.offset - before),
             used_vertices(plane.section)[0], "the plane was shifted to its vertices"});
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

/// D stays as the file has it where that is as good.
void move_onto(Work& work, WorkPlane& plane, double tolerance) {
  PlaneSection& p = plane.section;
  const double in_file = offset_in_file(plane);
  if (std::fabs(in_file - plane.offset) <= tolerance) plane.offset = in_file;
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
  if (!moved.empty() && in_file != plane.offset) tell_shifted(work, plane, in_file);
  plane.torn = !left.empty();
  for (const auto& [contour, m] : moved) tell_moved(work, plane, contour, m, true);
  for (const auto& [contour, m] : left) tell_moved(work, plane, contour, m, false);
}

}  // namespace

void settle_plane(WorkPlane& plane) {
  if (plane.torn) return;
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
    // A few vertices beside a plane that the others are on don't turn it or drag it along.
    if (const auto offset = offset_of_most(plane, tolerance))
      plane.offset = *offset;
    else
      fit(work, plane);
    if (off_plane(plane) > tolerance) move_onto(work, plane, tolerance);
    settle_plane(plane);
  }
}

namespace {

/// A plane that is one with another.
struct Twin {
  WorkPlane* plane = nullptr;
  double apart = 0;  ///< over the data
};

/// By position and not by the order of the file: which of equal planes stays must not depend on that.
std::vector<WorkPlane*> in_canonical_order(Work& work) {
  std::vector<WorkPlane*> order;
  for (WorkPlane& plane : work.planes) order.push_back(&plane);
  const auto key = [](const WorkPlane* w) {
    return std::tuple(w->section.edges.empty(), w->normal, w->offset, used_vertices(w->section));
  };
  std::sort(order.begin(), order.end(), [&](auto* a, auto* b) { return key(a) < key(b); });
  return order;
}

void append(WorkPlane& first, const PlaneSection& from, FileNumbers& numbers) {
  PlaneSection& to = first.section;
  const auto shift = static_cast<std::uint32_t>(to.vertices.size());
  numbers.vertices_begin = shift;
  numbers.vertices_end = shift + static_cast<std::uint32_t>(from.vertices.size());
  first.edited = true;
  to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
  for (ContourEdge e : from.edges) {
    e.a += shift, e.b += shift;
    to.edges.push_back(e);
  }
}

void tell_united(Work& work, const WorkPlane& first, const Twin& twin, bool even_odd) {
  const std::string text =
      "the plane is plane " + std::to_string(first.source) + ": " +
      (even_odd ? "their contours were read together, by even-odd" : "their sections were united");
  work.note({RepairKind::planes_united, twin.plane->source, kNone, kNone, 1, twin.apart, {}, text});
}

void tell_covered(Work& work, const std::vector<WorkPlane*>& planes, const CoveredContour& c) {
  const WorkPlane& plane = *planes[c.section];
  work.note({RepairKind::contour_left_out, plane.source, c.contour, c.vertex, c.edges, 0,
             plane.section.vertices[c.vertex],
             "it lies within the section of plane " + std::to_string(planes[c.by]->source) +
                 ", which is the same plane, and was left out"});
}

/// The sections of each group become that of its first plane.
bool unite_groups(Work& work, const std::vector<WorkPlane*>& planes, const PlaneRecords& records) {
  bool changed = false;
  for (std::uint32_t g = 0; g < planes.size(); ++g) {
    std::vector<const PlaneSection*> others;
    for (std::uint32_t s = g + 1; s < planes.size(); ++s)
      if (records.group[s] == g) others.push_back(&planes[s]->section);
    if (!others.empty())
      changed |= edit_section(planes[g]->section, work.chart(*planes[0]), {}, others, work.context).changed;
  }
  return changed;
}

void move_into(Work& work, const WorkPlane& first, PlaneSection& twin) {
  double& most = work.result.largest_displacement;
  for (const Vec3& v : used_vertices(twin)) most = std::max(most, std::fabs(unit_of(first).height(v)));
  for (Vec3& v : twin.vertices) v = v - unit_of(first).height(v) * first.normal;
}

/// Gives the contours of a twin numbers that the first plane does not have.
void renumber_contours(WorkPlane& first, WorkPlane& twin) {
  const std::uint32_t begin = first.numbers.back().contours_end;
  first.numbers.push_back({twin.source, begin, begin + twin.numbers[0].contours_end, 0, 0});
  for (ContourEdge& e : twin.section.edges)
    if (e.contour != kNone) e.contour += begin;
}

/// The first plane gets the sections of its twins.
void unite(Work& work, WorkPlane& first, const std::vector<Twin>& twins) {
  std::vector<WorkPlane*> planes{&first};
  for (const Twin& twin : twins) {
    planes.push_back(twin.plane);
    move_into(work, first, twin.plane->section);
  }
  std::vector<const PlaneSection*> sections;
  for (const WorkPlane* plane : planes) sections.push_back(&plane->section);
  const PlaneRecords records = compare_records(sections, work.chart(first), work.context);
  for (std::size_t t = 0; t < twins.size(); ++t)
    tell_united(work, first, twins[t], records.group[t + 1] != 0 && !sections[t + 1]->edges.empty());
  for (const CoveredContour& c : records.covered) tell_covered(work, planes, c);
  for (const Twin& twin : twins) renumber_contours(first, *twin.plane);
  first.edited |= unite_groups(work, planes, records);
  for (std::uint32_t s = 1; s < planes.size(); ++s)
    if (records.group[s] == s && !sections[s]->edges.empty()) append(first, *sections[s], first.numbers[s]);
  join_equal_vertices(first.section);  // groups touch at points
}

}  // namespace

void unite_planes(Work& work) {
  const double tolerance = work.capped(work.options.same_plane * work.diagonal);
  const std::vector<WorkPlane*> order = in_canonical_order(work);
  std::vector<bool> gone(work.planes.size(), false);
  const auto number = [&](const WorkPlane* plane) {
    return static_cast<std::size_t>(plane - work.planes.data());
  };
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (gone[number(order[i])] || work.context.cancelled()) continue;
    std::vector<Twin> twins;
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const double apart = distance_over_data(work, unit_of(*order[i]), unit_of(*order[j]));
      if (gone[number(order[j])] || apart > tolerance) continue;
      gone[number(order[j])] = true;
      twins.push_back({order[j], apart});
    }
    if (!twins.empty()) unite(work, *order[i], twins);
  }
  std::size_t p = 0;
  std::erase_if(work.planes, [&](const WorkPlane&) { return gone[p++]; });
}

}  // namespace crossloft::repair_steps
