#include "complex.h"

#include <algorithm>
#include <numeric>

#include "assembly.h"
#include "growing_complex.h"

namespace crossloft {
namespace {

/// The primitive normal of the plane's non-oriented direction: first non-zero component positive.
LatticeVector direction_of(const LatticePlane& plane) {
  LatticeVector n = plane.normal;
  std::int64_t divisor = std::gcd(std::gcd(n[0], n[1]), n[2]);
  if (n < LatticeVector{}) divisor = -divisor;
  for (std::int64_t& c : n) c /= divisor;
  return n;
}

/// Indices of the planes by direction, then along it: independent of order, orientation and frames.
std::vector<std::uint32_t> insertion_order(std::span<const LatticePlane> planes) {
  std::vector<LatticeVector> directions;
  for (const LatticePlane& plane : planes) directions.push_back(direction_of(plane));
  std::vector<std::uint32_t> order(planes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (directions[a] != directions[b]) return directions[a] < directions[b];
    const int side = side_of_plane(planes[b], make_point(planes[a].origin));
    return planes[b].normal < LatticeVector{} ? side > 0 : side < 0;
  });
  return order;
}

Error cancelled() { return {ErrorCode::cancelled, "cancelled while inserting planes", {}}; }

constexpr std::int64_t kBoxLimit = kLatticeLimit / 2;

Result<Done> check_box(const LatticeBox& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.lower[k] >= box.upper[k]) return make_error(ErrorCode::usage, "the box is empty");
    if (box.lower[k] < -kBoxLimit || box.upper[k] > kBoxLimit)
      return make_error(ErrorCode::too_large, "the box reaches beyond 2^49 units");
  }
  return Done{};
}

}  // namespace

LatticeBox centred_box(std::int64_t bound) { return {{-bound, -bound, -bound}, {bound, bound, bound}}; }

std::size_t first_slot(SignView signs, std::size_t slots) {
  // Multiply and fold per word (the finaliser of MurmurHash3's family); quality matters little here.
  std::uint64_t h = 0x9E3779B97F4A7C15u;
  for (std::size_t w = 0; w < signs.pos.size(); ++w)
    for (const SignWord word : {signs.pos[w], signs.zero[w]}) {
      h = (h ^ word) * 0xFF51AFD7ED558CCDu;
      h ^= h >> 32;
    }
  return static_cast<std::size_t>(h) & (slots - 1);
}

Location Arrangement::locate(SignView signs) const {
  std::size_t slot = first_slot(signs, by_signs_.size());
  while (by_signs_[slot] != kNone && !equal_signs(row(by_signs_[slot]), signs))
    slot = (slot + 1) & (by_signs_.size() - 1);
  const std::uint32_t found = by_signs_[slot];
  if (found == kNone) return {};
  if (found < first_edge_row()) return {0, found};
  if (found < first_face_row()) return {1, found - first_edge_row()};
  if (found < first_cell_row()) return {2, found - first_face_row()};
  return {3, found - first_cell_row()};
}

Location Arrangement::locate(const LatticePoint& p) const {
  for (std::uint32_t j = 0; j < 6; ++j)
    if (side_of_plane(planes_[plane_count_ + j], p) != (j % 2 == 0 ? 1 : -1)) return {};
  std::vector<SignWord> pos(words_), zero(words_);
  for (std::uint32_t i = 0; i < plane_count_; ++i) {
    const int sign = side_of_plane(planes_[i], p);
    if (sign > 0) set_bit(pos, PlaneId(i));
    if (sign == 0) set_bit(zero, PlaneId(i));
  }
  return locate(SignView{pos, zero});
}

Result<Arrangement> build_arrangement(std::span<const LatticePlane> planes, const LatticeBox& box,
                                      LatticePointStore& store, const Context& context) {
  if (auto good = check_box(box); !good) return good.error();
  std::vector<LatticePlane> all(planes.begin(), planes.end());
  for (int axis = 0; axis < 3; ++axis) {
    all.push_back(make_axis_plane(axis, box.lower[static_cast<std::size_t>(axis)]));
    all.push_back(make_axis_plane(axis, box.upper[static_cast<std::size_t>(axis)]));
  }
  GrowingComplex grown(all, box, store);
  std::size_t done = 0;
  for (const std::uint32_t p : insertion_order(planes)) {
    if (context.cancelled()) return cancelled();
    if (!grown.insert(p))
      return Error{ErrorCode::too_large, "the arrangement of the planes has too many elements", {}};
    context.report("arrangement", static_cast<double>(++done) / static_cast<double>(planes.size()));
  }
  if (context.cancelled()) return cancelled();
  return ArrangementAssembly(grown).run(all, box);
}

}  // namespace crossloft
