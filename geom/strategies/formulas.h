#pragma once
/// Every predicate on doubles as one formula over any numbers: rows of differences, then the determinants of
/// determinants.h and exact_rows.h. A loader says how doubles become numbers:
///   difference(to, from): to - from, exact or with the number's own account of its error;
///   weight_difference(to, from): likewise, in squares of the coordinates' unit.

#include "../exact_rows.h"
#include "../vec2.h"
#include "../weighted_point.h"

namespace crossloft::strategies {

/// A homogeneous coordinate that is 1 by its type, and one that is not.
struct One {};
template <class T>
struct Weight {
  T value;
};

template <class A>
A times_weight(A a, One) {
  return a;
}
template <class A>
auto times_weight(const A& a, const Weight<A>& w) {
  return a * w.value;
}

/// A point relative to the origin of its predicate.
template <class T>
struct PlanarRow {
  T x, y;
  One w;
  auto lift() const { return x * x + y * y; }
};
template <class T>
struct SpaceRow {
  T x, y, z;
  One w;
  auto lift() const { return x * x + y * y + z * z; }
};
template <class T, class Height>
struct LiftedRow {
  T x, y, z;
  Height height;
  One w;
  const Height& lift() const { return height; }
};

template <class Load>
auto row(const Load& load, Vec2 p, Vec2 origin) {
  auto x = load.difference(p.x, origin.x);
  return PlanarRow<decltype(x)>{std::move(x), load.difference(p.y, origin.y), {}};
}
template <class Load>
auto row(const Load& load, const Vec3& p, const Vec3& origin) {
  auto x = load.difference(p.x, origin.x);
  return SpaceRow<decltype(x)>{
      std::move(x), load.difference(p.y, origin.y), load.difference(p.z, origin.z), {}};
}
template <class Load>
auto row(const Load& load, const WeightedPoint& p, const WeightedPoint& origin) {
  auto place = row(load, p.position, origin.position);
  auto height = place.lift() - load.weight_difference(p.weight, origin.weight);
  return LiftedRow<decltype(place.x), decltype(height)>{
      std::move(place.x), std::move(place.y), std::move(place.z), std::move(height), {}};
}

template <class Load>
auto orient2d(const Load& load, Vec2 a, Vec2 b, Vec2 c) {
  return orientation_about(row(load, b, a), row(load, c, a));
}
template <class Load>
auto orient3d(const Load& load, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return det3(row(load, b, a), row(load, c, a), row(load, d, a));
}
template <class Load>
auto incircle(const Load& load, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return in_circle_about(row(load, a, d), row(load, b, d), row(load, c, d));
}
/// In-sphere of Vec3, the power test of WeightedPoint.
template <class Load, class Point>
auto insphere(const Load& load, const Point& a, const Point& b, const Point& c, const Point& d,
              const Point& e) {
  return in_sphere_about(row(load, a, e), row(load, b, e), row(load, c, e), row(load, d, e));
}

}  // namespace crossloft::strategies
