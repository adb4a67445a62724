#pragma once
/// Contours on a plane, drawn from bytes: good ones, touching ones, bad ones.

#include <vector>

#include "../../arrangement/sections.h"
#include "byte_source.h"

namespace crossloft::test {

/// Where coordinates a, b of a plane are: origin + a u + b v.
struct PlaneFrame {
  Vec3 normal, origin, u, v;
  Vec3 at(double a, double b) const { return origin + a * u + b * v; }
};

/// Of a plane with this normal through a point. Integer normals get an integer frame, on which no coordinate
/// is rounded; others a unit one.
PlaneFrame frame_of(const Vec3& normal, const Vec3& origin);

/// The plane, without contour.
PlaneSection plane_of(const PlaneFrame& frame);

struct Coordinates {
  double a = 0, b = 0;
};
using Polygon = std::vector<Coordinates>;

/// Adds a closed contour.
void add_polygon(PlaneSection& plane, const PlaneFrame& frame, const Polygon& polygon);

Polygon circle(double a, double b, double radius, std::uint32_t corners);
Polygon rectangle(double a0, double b0, double a1, double b1);

/// One to three polygons, most of them simple and apart.
std::vector<Polygon> draw_polygons(ByteSource& bytes);

}  // namespace crossloft::test
