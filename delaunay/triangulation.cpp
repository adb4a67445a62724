#include "triangulation.h"

#include <algorithm>
#include <array>

#include "insertion_order.h"
#include "delaunay_core.h"
#include "regular3.h"
#include "vec3_predicates.h"
#include "weighted_predicates.h"

namespace crossloft {
namespace {

std::vector<std::uint32_t> order_of(std::span<const WeightedPoint> points) {
  std::vector<std::array<double, 3>> places;
  places.reserve(points.size());
  for (const WeightedPoint& p : points) places.push_back({p.position.x, p.position.y, p.position.z});
  return insertion_order(std::span<const std::array<double, 3>>(places));
}

/// For each vertex the lowest of the points, by their first numbers, that it stands for; kNone for others.
std::vector<std::uint32_t> first_numbers(const Regular3<WeightedPredicates3>& triangulation,
                                         const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> number(order.size(), kNone);
  for (std::uint32_t k = 0; k < order.size(); ++k)
    if (const std::uint32_t v = triangulation.kept(k); v != kNone) number[v] = std::min(number[v], order[k]);
  return number;
}

template <std::size_t N>
void renumber(std::vector<std::array<std::uint32_t, N>>& simplices,
              const std::vector<std::uint32_t>& number) {
  for (auto& simplex : simplices)
    for (std::uint32_t& v : simplex) v = number[v];
}

}  // namespace

Triangulation delaunay_triangulation(std::vector<Vec3> points, unsigned) {
  const std::vector<std::uint32_t> order = insertion_order(std::span<const Vec3>(points));
  {
    std::vector<Vec3> stored;
    stored.reserve(points.size());
    for (const std::uint32_t i : order) stored.push_back(points[i]);
    points = std::move(stored);
  }
  const Vec3Predicates3 predicates(points);
  detail::DelaunayCore<3, Vec3Predicates3> core(predicates);
  core.build_in_given_order();
  Triangulation result;
  result.dimension = core.dimension();
  core.release(result.tets.vertices, result.tets.neighbours);
  for (auto& tet : result.tets.vertices)
    for (std::uint32_t& v : tet) v = order[v];
  return result;
}

Triangulation regular_triangulation(std::span<const WeightedPoint> points) {
  const std::vector<std::uint32_t> order = order_of(points);
  std::vector<WeightedPoint> stored;
  stored.reserve(points.size());
  for (const std::uint32_t i : order) stored.push_back(points[i]);
  const WeightedPredicates3 predicates(stored);
  Regular3 triangulation(predicates);
  triangulation.build_in_given_order();

  const std::vector<std::uint32_t> number = first_numbers(triangulation, order);
  Triangulation result{triangulation.dimension(),    std::vector<std::uint32_t>(points.size(), kNone),
                              triangulation.tet_mesh(),     triangulation.tri_mesh(),
                              triangulation.dropped_axis(), triangulation.chain()};
  for (std::uint32_t k = 0; k < order.size(); ++k)
    if (const std::uint32_t v = triangulation.kept(k); v != kNone) result.kept[order[k]] = number[v];
  renumber(result.tets.vertices, number);
  renumber(result.triangles.vertices, number);
  for (std::uint32_t& v : result.chain) v = number[v];
  return result;
}

}  // namespace crossloft
