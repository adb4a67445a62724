#pragma once
/// Moebius sites by their distance from a point: for drawing, in doubles.

#include <algorithm>
#include <cstdint>
#include <span>

#include "../moebius/diagram.h"

namespace crossloft {

inline double distance_from(const MoebiusSite& site, Vec2 x) {
  return site.lambda * dot(x - site.p, x - site.p) - site.mu;
}

/// The first of the sites that are nearest to a point; kNone if there is no site. Linear time.
inline std::uint32_t nearest_site(std::span<const MoebiusSite> sites, Vec2 x) {
  const auto nearest = std::min_element(
      sites.begin(), sites.end(),
      [x](const MoebiusSite& a, const MoebiusSite& b) { return distance_from(a, x) < distance_from(b, x); });
  return nearest == sites.end() ? kNone : static_cast<std::uint32_t>(nearest - sites.begin());
}

}  // namespace crossloft
