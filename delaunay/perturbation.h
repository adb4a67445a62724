#pragma once
/// Ties of the in-sphere and the power test, broken by perturbing the lift.
///
/// Each point is lifted to the height h(x) + eps^rank, h(x) = |x|^2 for plain points, rank 1, 2, .. from the
/// lexicographically largest point down, eps > 0 infinitely small. For a positive simplex s and a point e
/// with barycentric coordinates l_i in s, e is inside iff its height is below the hyperplane through the
/// lifted s:
///     h(e) + eps^rank(e) < sum l_i (h(s_i) + eps^rank(s_i)).
/// If the unperturbed sides are equal, the point of smallest rank with a coefficient other than 0 decides:
/// for e the left side is larger, it is outside; for s_i the sign is that of l_i, which is that of orient(s
/// with s_i replaced by e), because orient(s) > 0. Heights alone change, so points stay where they are and
/// flat stays flat; some l_i is not 0, so there is always an answer.
///
/// *Sites with heights of their own* may be hidden. If e lies in s and exactly on its hyperplane, all l_i >=
/// 0, and the largest point of those with l_i > 0 comes after e, which is a mean of them: e is below and
/// becomes a vertex. So ties hide nothing, and every site on the hull is a vertex whatever the order of
/// insertion. Two sites in one place have one rank: the sum is l_k = 1 for one k, the test compares their
/// heights, and equal ones are one site (the triangulation asks for equality first). Source: Devillers and
/// Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations (2011).

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "point_predicates.h"
#include "simplex_store.h"

namespace crossloft::detail {

template <class P>
int orient(const P& p, const Simplex<3>& s) {
  return p.orient3d(s[0], s[1], s[2], s[3]);
}
template <class P>
int orient(const P& p, const Simplex<2>& s) {
  return p.orient2d(s[0], s[1], s[2]);
}

/// Sites with heights of their own (PowerPredicates3), not plain points.
template <class P>
concept HasHeights = requires(const P& p, std::uint32_t i) {
  p.compare_height(i, i);
};

template <class P>
int raw_in_ball(const P& p, const Simplex<3>& s, std::uint32_t e) {
  if constexpr (HasHeights<P>) {
    return p.power_test(s[0], s[1], s[2], s[3], e);
  } else {
    return p.insphere(s[0], s[1], s[2], s[3], e);
  }
}
template <class P>
int raw_in_ball(const P& p, const Simplex<2>& s, std::uint32_t e) {
  if constexpr (HasHeights<P>) {
    return p.power_test(s[0], s[1], s[2], e);
  } else {
    return p.incircle(s[0], s[1], s[2], e);
  }
}

/// REQUIRES: equal positions.
template <class P>
bool equal_heights(const P& p, std::uint32_t a, std::uint32_t b) {
  if constexpr (HasHeights<P>) {
    return p.compare_height(a, b) == 0;
  } else {
    return true;
  }
}

/// True iff the points lie on one line.
template <class P>
bool collinear(const P& p, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if constexpr (HasHeights<P>) {
    return p.orient2d(a, b, c, 0) == 0 && p.orient2d(a, b, c, 1) == 0 && p.orient2d(a, b, c, 2) == 0;
  } else {
    return p.collinear(a, b, c);
  }
}

template <std::size_t N>
constexpr std::array<std::uint32_t, N> replaced(std::array<std::uint32_t, N> s, std::size_t slot,
                                                std::uint32_t v) {
  s[slot] = v;
  return s;
}

/// The perturbed answer when the raw one is 0. REQUIRES: s positive, e none of its vertices.
template <class P, std::size_t N>
[[gnu::noinline]] int break_tie(const P& p, const std::array<std::uint32_t, N>& s, std::uint32_t e) {
  std::array<std::size_t, N + 1> order{};  // slots by descending rank order; slot N is e
  const auto point = [&](std::size_t slot) { return slot == N ? e : s[slot]; };
  for (std::size_t k = 0; k <= N; ++k) {
    std::size_t at = k;
    for (; at > 0 && p.compare_lex(point(k), point(order[at - 1])) > 0; --at) order[at] = order[at - 1];
    order[at] = k;
  }
  for (const std::size_t slot : order) {
    if (slot == N) return -1;
    if (const int sign = orient(p, replaced(s, slot, e))) return sign;
  }
  return -1;
}

/// +1 if e is inside the perturbed ball of s, else -1. REQUIRES: s positive, e none of its vertices.
template <class P, std::size_t N>
int in_ball(const P& p, const std::array<std::uint32_t, N>& s, std::uint32_t e) {
  if (const int sign = raw_in_ball(p, s, e)) return sign;
  return break_tie(p, s, e);
}

}  // namespace crossloft::detail
