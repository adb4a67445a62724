#pragma once
/// How alike two closed surfaces are: volumes, overlap, distance, topology.

#include <cstdint>

#include "../reconstruct/surface.h"

namespace crossloft {

struct CompareOptions {
  std::uint32_t rays = 512;  ///< rays along each of the two shorter sides of the common box (at most 8192)
  std::uint32_t samples = 50000;  ///< points on each surface that distances are measured from
};

/// Lengths in input units; volumes in their cube, which is infinite or 0 for sizes beyond 1e102 or below
/// 1e-107.
struct CompareReport {
  double volume_a = 0, volume_b = 0;          ///< signed, from the triangles
  double ray_volume_a = 0, ray_volume_b = 0;  ///< from the rays, as are the next three
  double intersection = 0, union_volume = 0;
  double iou = 0;                           ///< intersection over union; 1 if both are empty
  double distance_ab = 0, distance_ba = 0;  ///< largest from samples of one to the other surface
  double mean_ab = 0, mean_ba = 0;          ///< area-weighted means of the same
  double diagonal = 0;                      ///< of the common box of all triangles
  std::uint32_t components_a = 0, components_b = 0;
  std::int64_t genus_a = 0, genus_b = 0;  ///< sums over manifold components

  double hausdorff() const { return distance_ab > distance_ba ? distance_ab : distance_ba; }
  double mean() const { return 0.5 * (mean_ab + mean_ba); }
};

/// Overlap: a grid of rays along the longest side of the common box, inside by even-odd, lengths exact along
/// the ray; a ray through an edge meets exactly one of its triangles. Distance: samples in proportion to area
/// and every vertex, or every k-th where that is still as many as samples; nearest triangle by a box tree;
/// infinite if one is empty. The same at any size: measured at size 1 and scaled back. Points of no triangle
/// don't count. Deterministic; the error of the volumes falls with rays^-1.5 or faster.
/// O((n + samples) log n + rays^2). REQUIRES: indices in range, finite coordinates.
CompareReport compare(const Surface& a, const Surface& b, const CompareOptions& options = {});

}  // namespace crossloft
