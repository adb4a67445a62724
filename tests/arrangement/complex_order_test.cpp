// The same planes in another order, with other frames and orientations, give the same complex.
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "judge.h"
#include "plane_sets.h"

using namespace crossloft;

namespace {

/// The same planes differently: plane i of the result is plane `from[i]`, turned over where `flipped[i]`.
struct Disguise {
  std::vector<LatticePlane> planes;
  std::vector<std::uint32_t> from;
  std::vector<bool> flipped;
};

Disguise disguise(const std::vector<LatticePlane>& planes, std::mt19937_64& random) {
  Disguise d;
  d.from.resize(planes.size());
  std::iota(d.from.begin(), d.from.end(), 0u);
  for (std::size_t i = d.from.size(); i > 1; --i) std::swap(d.from[i - 1], d.from[random() % i]);
  for (const std::uint32_t source : d.from) {
    LatticePlane p = planes[source];
    for (std::size_t k = 0; k < 3; ++k) p.origin[k] += p.e1[k] - 2 * p.e2[k];
    d.flipped.push_back(random() % 2 == 0);
    d.planes.push_back(d.flipped.back() ? make_lattice_plane(p.origin, p.e2, p.e1) : p);
  }
  return d;
}

class SameComplex {
 public:
  SameComplex(const Arrangement& a, const Arrangement& b, const Disguise& d) : a_(a), b_(b), d_(d) {}

  void check() const {
    REQUIRE(a_.vertex_count() == b_.vertex_count());
    REQUIRE(a_.edge_count() == b_.edge_count());
    REQUIRE(a_.face_count() == b_.face_count());
    REQUIRE(a_.cell_count() == b_.cell_count());
    for (std::uint32_t i = 0; i < a_.vertex_count(); ++i) {
      REQUIRE(equal(a_.point(ArrVertexId(i)), b_.point(ArrVertexId(i))));
      REQUIRE(same_signs(ArrVertexId(i)));
    }
    for (std::uint32_t i = 0; i < a_.edge_count(); ++i) {
      REQUIRE(a_.ends(ArrEdgeId(i)) == b_.ends(ArrEdgeId(i)));
      REQUIRE(same_signs(ArrEdgeId(i)));
    }
    for (std::uint32_t i = 0; i < a_.face_count(); ++i) same_face(FaceId(i));
    for (std::uint32_t i = 0; i < a_.cell_count(); ++i) {
      const auto f = a_.faces_of(CellId(i)), g = b_.faces_of(CellId(i));
      REQUIRE(std::equal(f.begin(), f.end(), g.begin(), g.end()));
      REQUIRE(same_signs(CellId(i)));
    }
  }

 private:
  template <class Id>
  bool same_signs(Id id) const {
    for (std::uint32_t p = 0; p < b_.plane_count(); ++p) {
      const int sign = sign_at(a_.signs(id), PlaneId(d_.from[p]));
      if (sign_at(b_.signs(id), PlaneId(p)) != (d_.flipped[p] ? -sign : sign)) return false;
    }
    return true;
  }

  void same_face(FaceId f) const {
    const PlaneId p = b_.plane_of(f);
    const bool flipped = !b_.is_box(p) && d_.flipped[p.value];
    REQUIRE(a_.plane_of(f).value == (b_.is_box(p) ? p.value : d_.from[p.value]));
    std::vector<ArrVertexId> loop(b_.vertices_of(f).begin(), b_.vertices_of(f).end());
    auto cells = b_.cells_of(f);
    if (flipped) {
      std::reverse(loop.begin() + 1, loop.end());
      std::swap(cells[0], cells[1]);
    }
    const auto expected = a_.vertices_of(f);
    REQUIRE(std::equal(loop.begin(), loop.end(), expected.begin(), expected.end()));
    REQUIRE(a_.cells_of(f) == cells);
    REQUIRE(same_signs(f));
  }

  const Arrangement &a_, &b_;
  const Disguise& d_;
};

void compare_disguises(const std::vector<LatticePlane>& planes, const LatticeBox& box,
                       std::mt19937_64& random) {
  LatticePointStore store;
  const Arrangement a = build(planes, box, store);
  for (int round = 0; round < 3; ++round) {
    const Disguise d = disguise(planes, random);
    LatticePointStore other;
    const Arrangement b = build(d.planes, box, other);
    SameComplex(a, b, d).check();
  }
}

}  // namespace

TEST_CASE("order, frames and orientation of the planes do not matter") {
  std::mt19937_64 random(2007);
  compare_disguises(plane_sets::random_planes(random, 14, std::int64_t{1} << 46, 1 << 18),
                    centred_box(std::int64_t{1} << 49), random);
  for (int round = 0; round < 10; ++round)
    compare_disguises(plane_sets::distinct(plane_sets::random_planes(random, 12, 4, 2)), centred_box(8),
                      random);
  compare_disguises(plane_sets::cylinder_tangents(70, 1 << 20), centred_box(1 << 21), random);
}
