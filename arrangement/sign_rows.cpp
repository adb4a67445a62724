#include "sign_rows.h"

#include <algorithm>
#include <bit>

#include "../geom/inline_filters.h"

namespace crossloft {
namespace {

/// The order of the table shows nowhere.
std::size_t hash_of(SignView signs) {
  std::uint64_t hash = 0x9E3779B97F4A7C15u;
  for (std::size_t w = 0; w < signs.pos.size(); ++w)
    for (const SignWord word : {signs.pos[w], signs.zero[w]}) {
      hash = (hash ^ word) * 0xFF51AFD7ED558CCDu;
      hash ^= hash >> 32;
    }
  return static_cast<std::size_t>(hash);
}

}  // namespace

SignRows::SignRows(std::span<const LatticePlane> planes)
    : planes_(planes.begin(), planes.end()),
      words_(sign_words(planes.size())),
      asked_pos_(words_, 0),
      asked_zero_(words_, 0) {
  for (const LatticePlane& plane : planes) in_doubles_.push_back(in_doubles(plane));
}

inline void SignRows::ask(const LatticePoint& point, std::uint32_t plane) {
  int side = kInlineFilters ? side_of_plane_filter(in_doubles_[plane], point) : 0;
  if (side == 0) side = side_of_plane(planes_[plane], point);
  const SignWord bit = SignWord{1} << (plane % 64);
  SignWord &pos = asked_pos_[plane / 64], &zero = asked_zero_[plane / 64];
  pos = side > 0 ? pos | bit : pos & ~bit;
  zero = side == 0 ? zero | bit : zero & ~bit;
}

std::uint32_t SignRows::of(const LatticePoint& point) {
  for (std::uint32_t p = 0; p < planes_.size(); ++p) ask(point, p);
  return keep_asked();
}

std::uint32_t SignRows::of(const LatticePoint& point, std::uint32_t like,
                           std::span<const std::uint32_t> across) {
  const SignView signs = (*this)[like];
  std::copy(signs.pos.begin(), signs.pos.end(), asked_pos_.begin());
  std::copy(signs.zero.begin(), signs.zero.end(), asked_zero_.begin());
  for (const std::uint32_t p : across) ask(point, p);
  return keep_asked();
}

std::uint32_t SignRows::keep_asked() {
  if (last_ != kNone && is_asked(last_)) return last_;
  if (slots_.size() <= 2 * std::size_t{size()}) grow();
  std::size_t slot = hash_of({asked_pos_, asked_zero_}) & (slots_.size() - 1);
  while (slots_[slot] != kNone && !is_asked(slots_[slot])) slot = (slot + 1) & (slots_.size() - 1);
  if (slots_[slot] == kNone) {
    slots_[slot] = size();
    int through = 0;
    for (const SignWord word : asked_zero_) through += std::popcount(word);
    planes_through_.push_back(static_cast<std::uint32_t>(through));
    pos_.insert(pos_.end(), asked_pos_.begin(), asked_pos_.end());
    zero_.insert(zero_.end(), asked_zero_.begin(), asked_zero_.end());
  }
  return last_ = slots_[slot];
}

void SignRows::grow() {
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), kNone);
  for (std::uint32_t row = 0; row < size(); ++row) {
    std::size_t slot = hash_of((*this)[row]) & (slots_.size() - 1);
    while (slots_[slot] != kNone) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = row;
  }
}

}  // namespace crossloft
