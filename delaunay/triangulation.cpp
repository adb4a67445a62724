#include "triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "delaunay3.h"
#include "in_parallel.h"
#include "insertion_order.h"
#include "large_pages.h"
#include "regular3.h"
#include "vec3_predicates.h"
#include "weighted_predicates.h"

namespace crossloft {
namespace {

/// The points in another order.
template <class Point>
std::vector<Point> in_order(std::span<const Point> points, const std::vector<std::uint32_t>& order,
                            unsigned threads = 1) {
  std::vector<Point> stored;
  detail::resize_in_large_pages(stored, points.size(), threads);
  detail::in_slices(threads, points.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t k = begin; k < end; ++k) stored[k] = points[order[k]];
  });
  return stored;
}

template <std::size_t N>
void renumber(std::vector<std::array<std::uint32_t, N>>& simplices, const std::vector<std::uint32_t>& number,
              unsigned threads) {
  detail::in_slices(threads, simplices.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t s = begin; s < end; ++s)
      for (std::uint32_t& v : simplices[s]) v = number[v];
  });
}

/// From numbers in `order` to those of the points given. `number` becomes, for each vertex, the lowest of the
/// points that it stands for.
template <class Kept>
void rename_vertices(Triangulation& result, const std::vector<std::uint32_t>& order, const Kept& kept,
                     unsigned threads = 1) {
  std::vector<std::uint32_t> number;
  detail::reserve_in_large_pages(number, order.size());
  number.resize(order.size(), kNone);
  for (std::uint32_t k = 0; k < order.size(); ++k)
    if (const std::uint32_t v = kept(k); v != kNone) number[v] = std::min(number[v], order[k]);
  renumber(result.tets.vertices, number, threads);
  renumber(result.triangles.vertices, number, threads);
  for (std::uint32_t& v : result.chain) v = number[v];
  result.kept.assign(order.size(), kNone);
  detail::in_slices(threads, order.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t k = begin; k < end; ++k)
      if (const std::uint32_t v = kept(static_cast<std::uint32_t>(k)); v != kNone)
        result.kept[order[k]] = number[v];
  });
}

/// Points of a plane or line: the regular triangulation knows what to do, and equal weights change nothing.
Triangulation flat_triangulation(const std::vector<Vec3>& stored, const std::vector<std::uint32_t>& order) {
  std::vector<WeightedPoint> points(stored.size());
  for (std::size_t k = 0; k < order.size(); ++k) points[order[k]] = {stored[k], 0};
  return regular_triangulation(points);
}

bool has_number(const Vec3& p) { return is_finite(p); }
bool has_number(const WeightedPoint& p) { return is_finite(p.position) && std::isfinite(p.weight); }

/// Predicates of what is no number contradict each other, and the insertion would not end well.
template <class Points>
bool all_have_numbers(const Points& points) {
  return std::all_of(points.begin(), points.end(), [](const auto& p) { return has_number(p); });
}

Triangulation nothing_of(std::size_t points) {
  Triangulation result;
  result.kept.assign(points, kNone);
  return result;
}

}  // namespace

Triangulation delaunay_triangulation(std::vector<Vec3> points, unsigned threads) {
  if (!all_have_numbers(points)) return nothing_of(points.size());
  threads = detail::useful_threads(threads, points.size());
  const std::vector<std::uint32_t> order = insertion_order(std::span<const Vec3>(points), threads);
  points = in_order(std::span<const Vec3>(points), order, threads);
  const Vec3Predicates3 predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build_in_given_order(threads);
  if (triangulation.dimension() < 3) return flat_triangulation(points, order);

  Triangulation result;
  result.dimension = 3;
  result.tets = triangulation.release_tet_mesh(threads);
  points = {};
  rename_vertices(
      result, order, [&](std::uint32_t k) { return triangulation.kept(k); }, threads);
  return result;
}

Triangulation regular_triangulation(std::span<const WeightedPoint> points) {
  if (!all_have_numbers(points)) return nothing_of(points.size());
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const WeightedPoint& p : points) places.push_back(p.position);
  const std::vector<std::uint32_t> order = insertion_order(std::span<const Vec3>(places));
  const std::vector<WeightedPoint> stored = in_order(points, order);
  const WeightedPredicates3 predicates(stored);
  Regular3 triangulation(predicates);
  triangulation.build_in_given_order();

  Triangulation result;
  result.dimension = triangulation.dimension();
  result.triangles = triangulation.tri_mesh();
  result.dropped_axis = triangulation.dropped_axis();
  result.chain = triangulation.chain();
  result.tets = triangulation.release_tet_mesh();
  rename_vertices(result, order, [&](std::uint32_t k) { return triangulation.kept(k); });
  return result;
}

}  // namespace crossloft
