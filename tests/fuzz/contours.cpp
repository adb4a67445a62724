#include "contours.h"

#include <algorithm>
#include <cmath>

namespace crossloft::test {
namespace {

bool is_small_integer(double x) { return std::floor(x) == x && std::fabs(x) <= 1024; }

Coordinates grid_point(ByteSource& bytes, int reach) {
  const int a = bytes.between(-reach, reach);
  return {static_cast<double>(a), static_cast<double>(bytes.between(-reach, reach))};
}

Polygon moved(Polygon polygon, Coordinates by) {
  for (Coordinates& p : polygon) p.a += by.a, p.b += by.b;
  return polygon;
}

Polygon draw_rectangle(ByteSource& bytes) {
  const Coordinates p = grid_point(bytes, 4);
  const int width = bytes.between(1, 6), height = bytes.between(1, 6);
  return rectangle(p.a, p.b, p.a + width, p.b + height);
}

Polygon draw_triangle(ByteSource& bytes) {
  const Coordinates p = grid_point(bytes, 5), q = grid_point(bytes, 5);
  return {p, q, grid_point(bytes, 5)};
}

/// Simple: the corners go round the centre.
Polygon draw_star(ByteSource& bytes) {
  static constexpr Coordinates kRound[] = {{2, 0},  {2, 1},   {1, 1},   {1, 2},  {0, 2},  {-1, 2}, {-1, 1},
                                           {-2, 0}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {2, -1}};
  Polygon star;
  for (const Coordinates& ray : kRound)
    if (const int length = bytes.between(0, 3); length != 0 || ray.b == 0)
      star.push_back({ray.a * std::max(1, length), ray.b * std::max(1, length)});
  return moved(star, grid_point(bytes, 3));
}

Polygon draw_circle(ByteSource& bytes) {
  const Coordinates centre = grid_point(bytes, 3);
  const int radius = bytes.between(1, 5);
  return circle(centre.a, centre.b, radius, 3 + bytes.below(10));
}

Polygon draw_angle(ByteSource& bytes) {
  const int w = bytes.between(1, 3), h = bytes.between(1, 3);
  const Polygon angle{{0, 0},      {3.0 + w, 0}, {3.0 + w, 1.0 * h}, {1.0 * w, 1.0 * h}, {1.0 * w, 3.0 + h},
                      {0, 3.0 + h}};
  return moved(angle, grid_point(bytes, 4));
}

Polygon draw_needle(ByteSource& bytes) {
  static constexpr double kThin[] = {1, 1e-3, 1e-6, 1e-9, 1e-12, 0.25, 1e-15, 0};
  const double thin = bytes.one_of(kThin);
  const Coordinates p = grid_point(bytes, 4);
  const int length = bytes.between(1, 8);
  return rectangle(p.a, p.b, p.a + length, p.b + thin);
}

/// Touches itself, crosses itself, has no area, repeats vertices, or runs straight through some.
Polygon draw_odd(ByteSource& bytes) {
  static const Polygon kOdd[] = {{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}},
                                 {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}},
                                 {{0, 0}, {2, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}},
                                 {{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}},
                                 {{0, 0}, {3, 3}},
                                 {{0, 0}, {4, 0}, {2, 0}, {2, 3}},
                                 {{0, 0}, {2, 2}, {2, 0}, {0, 2}},
                                 {{1, 1}},
                                 {{0, 0}, {1, 0}, {3, 0}}};
  const Polygon odd = bytes.one_of(kOdd);
  return moved(odd, grid_point(bytes, 3));
}

Polygon draw_any(ByteSource& bytes) {
  Polygon any;
  const std::uint32_t corners = 3 + bytes.below(4);
  for (std::uint32_t i = 0; i < corners; ++i) any.push_back(grid_point(bytes, 6));
  return any;
}

Polygon draw_polygon(ByteSource& bytes) {
  using Draw = Polygon (*)(ByteSource&);
  static constexpr Draw kDraws[] = {draw_rectangle, draw_circle,    draw_star,   draw_triangle,
                                    draw_angle,     draw_rectangle, draw_circle, draw_needle,
                                    draw_star,      draw_triangle,  draw_circle, draw_odd,
                                    draw_star,      draw_rectangle, draw_circle, draw_any};
  return bytes.one_of(kDraws)(bytes);
}

/// Two squares with a common corner, or with a common part of a side, or a ring with a disk inside.
std::vector<Polygon> draw_touching(ByteSource& bytes) {
  const Coordinates p = grid_point(bytes, 3);
  static const std::vector<Polygon> kTouching[] = {
      {rectangle(0, 0, 2, 2), rectangle(2, 2, 4, 4)},
      {rectangle(0, 0, 4, 4), rectangle(1, 1, 3, 3)},
      {rectangle(0, 0, 2, 2), rectangle(2, 1, 4, 3)},
      {rectangle(-1, -1, 5, 5), rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2)},
      {rectangle(0, 0, 4, 4), {{0, 0}, {3, 1}, {1, 3}}},
      {circle(0, 0, 5, 12), circle(0, 0, 2, 8)},
      {circle(0, 0, 2, 4), circle(4, 0, 2, 4)},
      {rectangle(0, 0, 2, 2), rectangle(0, 0, 2, 2)}};
  std::vector<Polygon> polygons = bytes.one_of(kTouching);
  for (Polygon& polygon : polygons) polygon = moved(polygon, p);
  return polygons;
}

}  // namespace

PlaneFrame frame_of(const Vec3& normal, const Vec3& origin) {
  const Vec3 n = normal;
  const bool integer = is_small_integer(n.x) && is_small_integer(n.y) && is_small_integer(n.z);
  const Vec3 u = n.x != 0 || n.y != 0 ? Vec3{-n.y, n.x, 0} : Vec3{1, 0, 0};
  const Vec3 v = cross(n, u);
  if (integer) return {n, origin, u, v};
  return {n, origin, (1 / norm(u)) * u, (1 / norm(v)) * v};
}

PlaneSection plane_of(const PlaneFrame& frame) {
  PlaneSection plane;
  plane.normal = frame.normal;
  plane.offset = -dot(frame.normal, frame.origin);
  return plane;
}

void add_polygon(PlaneSection& plane, const PlaneFrame& frame, const Polygon& polygon) {
  const auto first = static_cast<std::uint32_t>(plane.vertices.size()),
             n = static_cast<std::uint32_t>(polygon.size());
  const std::uint32_t contour = plane.edges.empty() ? 0 : plane.edges.back().contour + 1;
  for (const Coordinates& p : polygon) plane.vertices.push_back(frame.at(p.a, p.b));
  for (std::uint32_t i = 0; i < n; ++i)
    plane.edges.push_back({first + i, first + (i + 1) % n, 1, 0, contour, 0});
}

Polygon circle(double a, double b, double radius, std::uint32_t corners) {
  Polygon circle;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double t = 6.283185307179586 * i / corners;
    circle.push_back({a + radius * std::cos(t), b + radius * std::sin(t)});
  }
  return circle;
}

Polygon rectangle(double a0, double b0, double a1, double b1) {
  return {{a0, b0}, {a1, b0}, {a1, b1}, {a0, b1}};
}

std::vector<Polygon> draw_polygons(ByteSource& bytes) {
  if (bytes.one_in(6)) return draw_touching(bytes);
  std::vector<Polygon> polygons{draw_polygon(bytes)};
  if (bytes.one_in(4)) polygons.push_back(moved(draw_polygon(bytes), {12, 0}));
  if (bytes.one_in(8)) polygons.push_back(moved(draw_polygon(bytes), {0, 14}));
  return polygons;
}

}  // namespace crossloft::test
