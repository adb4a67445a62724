// Cells against CGAL: the intersection of all halfspaces of a sign vector, in exact rationals.
#include <CGAL/Convex_hull_3/dual/halfspace_intersection_with_constructions_3.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <doctest/doctest.h>

#include <set>

#include "judge.h"
#include "plane_sets.h"

using namespace crossloft;

namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

CGAL::Gmpq convert(const mpq_class& q) { return CGAL::Gmpq(q.get_mpq_t()); }
CGAL::Gmpq convert(const mpz_class& z) { return CGAL::Gmpq(CGAL::Gmpz(z.get_mpz_t())); }

/// CGAL intersects the negative sides.
Kernel::Plane_3 halfspace(const LatticePlane& plane, int side) {
  const auto e = flats::equation(plane);
  const CGAL::Gmpq s(-side);
  return {s * convert(e.n[0]), s * convert(e.n[1]), s * convert(e.n[2]), -s * convert(e.d)};
}

std::vector<Kernel::Plane_3> halfspaces(const Arrangement& a, CellId c) {
  std::vector<Kernel::Plane_3> all;
  for (std::uint32_t p = 0; p < a.plane_count(); ++p)
    all.push_back(halfspace(a.plane(PlaneId(p)), sign_at(a.signs(c), PlaneId(p))));
  for (std::uint32_t j = 0; j < 6; ++j)
    all.push_back(halfspace(a.plane(PlaneId(a.plane_count() + j)), j % 2 == 0 ? 1 : -1));
  return all;
}

Kernel::Point_3 centroid(const Arrangement& a, CellId c, const std::vector<flats::Rational3>& x) {
  flats::Rational3 sum;
  const auto vertices = a.vertices_of(c);
  for (const ArrVertexId v : vertices)
    for (std::size_t k = 0; k < 3; ++k) sum[k] += x[v.value][k];
  for (auto& s : sum) s /= static_cast<unsigned long>(vertices.size());
  return {convert(sum[0]), convert(sum[1]), convert(sum[2])};
}

CGAL::Gmpq six_volumes(const Polyhedron& p) {
  CGAL::Gmpq sum = 0;
  const Kernel::Point_3 apex(0, 0, 0);
  for (auto f = p.facets_begin(); f != p.facets_end(); ++f) {
    const auto first = f->halfedge();
    for (auto h = first->next(); h->next() != first; h = h->next())
      sum += 6 *
             CGAL::volume(apex, first->vertex()->point(), h->vertex()->point(), h->next()->vertex()->point());
  }
  return sum;
}

void compare(const std::vector<LatticePlane>& planes, const LatticeBox& box) {
  LatticePointStore store;
  const Arrangement a = build(planes, box, store);
  const auto x = flats::all_coordinates(a);
  for (std::uint32_t i = 0; i < a.cell_count(); ++i) {
    const CellId c(i);
    const auto all = halfspaces(a, c);
    Polyhedron hull;
    CGAL::halfspace_intersection_with_constructions_3(all.begin(), all.end(), hull, centroid(a, c, x));
    CHECK(six_volumes(hull) == convert(flats::six_volumes(a, c, x)));
    // CGAL's dual hull is simplicial: a point on more than three planes is repeated.
    const std::set<Kernel::Point_3> corners(hull.points_begin(), hull.points_end());
    CHECK(corners.size() == a.vertices_of(c).size());
  }
}

}  // namespace

TEST_CASE("cells of random planes are CGAL's halfspace intersections") {
  std::mt19937_64 random(1);
  compare(plane_sets::random_planes(random, 10, std::int64_t{1} << 45, 1 << 18),
          centred_box(std::int64_t{1} << 46));
}

TEST_CASE("cells of degenerate planes are CGAL's halfspace intersections") {
  std::mt19937_64 random(2);
  for (int round = 0; round < 4; ++round)
    compare(plane_sets::distinct(plane_sets::random_planes(random, 9, 3, 2)), centred_box(6));
}
