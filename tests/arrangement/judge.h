#pragma once
/// Builds an arrangement and judges it by verify(), by counting flats and by exact volumes.

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "flats.h"

namespace crossloft {

inline Arrangement build(const std::vector<LatticePlane>& planes, const LatticeBox& box,
                         LatticePointStore& store) {
  auto result = build_arrangement(planes, box, store);
  REQUIRE(result.ok());
  REQUIRE(result->verify() == "");
  return std::move(result).value();
}

/// All cells have a positive volume and together that of the box, exactly.
inline void check_volumes(const Arrangement& a) {
  const auto x = flats::all_coordinates(a);
  mpq_class sum, box = 6;
  bool positive = true;
  for (std::uint32_t c = 0; c < a.cell_count(); ++c) {
    const mpq_class volume = flats::six_volumes(a, CellId(c), x);
    positive = positive && volume > 0;
    sum += volume;
  }
  for (std::size_t k = 0; k < 3; ++k) box *= flats::big(a.box().upper[k] - a.box().lower[k]);
  CHECK(positive);
  CHECK(sum == box);
}

inline Arrangement build_and_judge(const std::vector<LatticePlane>& planes, const LatticeBox& box,
                                   LatticePointStore& store) {
  Arrangement a = build(planes, box, store);
  CHECK(flats::counts(a) == flats::Flats(planes, box).expected());
  check_volumes(a);
  return a;
}

}  // namespace crossloft
