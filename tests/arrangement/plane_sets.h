#pragma once
/// Sets of planes for tests of arrangements.

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "../../geom/lattice.h"

namespace crossloft::plane_sets {

inline std::int64_t uniform(std::mt19937_64& random, std::int64_t bound) {
  return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
}

inline LatticeVector random_vector(std::mt19937_64& random, std::int64_t bound) {
  LatticeVector v;
  for (auto& c : v) c = uniform(random, bound);
  return v;
}

/// A plane through `origin` spanned by random vectors of components up to `spread`.
inline LatticePlane plane_through(std::mt19937_64& random, const LatticeVector& origin, std::int64_t spread) {
  for (;;) {
    const LatticeVector e1 = random_vector(random, spread), e2 = random_vector(random, spread);
    const LatticePlane p = make_lattice_plane(origin, e1, e2);
    if (p.normal != LatticeVector{}) return p;
  }
}

/// Planes through random points of |x| <= bound.
inline std::vector<LatticePlane> random_planes(std::mt19937_64& random, std::size_t count, std::int64_t bound,
                                               std::int64_t spread) {
  std::vector<LatticePlane> planes;
  while (planes.size() < count) planes.push_back(plane_through(random, random_vector(random, bound), spread));
  return planes;
}

/// The same point set twice is not allowed in an arrangement: keeps the first of each.
inline std::vector<LatticePlane> distinct(const std::vector<LatticePlane>& planes) {
  std::vector<LatticePlane> kept;
  for (const LatticePlane& p : planes) {
    bool fresh = true;
    for (const LatticePlane& q : kept) {
      const auto on_p = [&](const LatticeVector& e) {
        const auto& o = q.origin;
        return side_of_plane(p, make_point({o[0] + e[0], o[1] + e[1], o[2] + e[2]})) == 0;
      };
      if (on_p({}) && on_p(q.e1) && on_p(q.e2)) fresh = false;
    }
    if (fresh) kept.push_back(p);
  }
  return kept;
}

/// { n.x = d }. REQUIRES: some component of n is +-1.
inline LatticePlane plane_of(LatticeVector n, std::int64_t d) {
  std::size_t k = 0;
  while (n[k] != 1 && n[k] != -1) ++k;
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  LatticeVector origin{}, e1{}, e2{};
  origin[k] = d * n[k];
  e1[i] = 1, e1[k] = -n[i] * n[k];
  e2[j] = 1, e2[k] = -n[j] * n[k];
  return make_lattice_plane(origin, e1, e2);
}

/// `count` planes parallel to the z axis, tangent to a cylinder of about `radius` around it, their normals
/// pointing outward.
inline std::vector<LatticePlane> cylinder_tangents(std::size_t count, std::int64_t radius) {
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::llround(x)); };
  std::vector<LatticePlane> planes;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * 3.14159265358979 * (static_cast<double>(i) + 0.3) / static_cast<double>(count);
    const double c = std::cos(angle), s = std::sin(angle), r = static_cast<double>(radius);
    planes.push_back(make_lattice_plane({whole(r * c), whole(r * s), 0},
                                        {whole(-1048576 * s), whole(1048576 * c), 0}, {0, 0, 1}));
  }
  return planes;
}

}  // namespace crossloft::plane_sets
