#pragma once
/// Layers of regions in a plane, each bounded by loose closed chains of segments (even-odd): areas of all
/// their combinations, and what covers a point.

#include <array>
#include <cstdint>
#include <vector>

#include "../geom/box_tree.h"

namespace crossloft {

inline constexpr unsigned kLayers = 3;
/// Bit k is set where layer k covers.
using LayerMask = unsigned;

/// A piece of a layer's boundary in the plane z = 0.
struct LayerSegment {
  Vec3 a, b;
  unsigned layer = 0;
};

/// areas[m]: of the points that exactly the layers of mask m cover; areas[0] is not set. A sweep over the
/// strips between successive segment ends, split where segments cross: there all segments are linear, so the
/// middle line gives the exact area but for rounding. Crossings by less than `tolerance` are ignored, which
/// costs at most that times the length of the boundaries. O(n log n + strips * active).
std::array<double, 1u << kLayers> layer_areas(const std::vector<LayerSegment>& segments, double tolerance);

/// Point location by rays towards +x, O(log n + segments on the ray).
class LayerCover {
 public:
  explicit LayerCover(const std::vector<LayerSegment>& segments);
  LayerMask at(const Vec3& p) const;

 private:
  const std::vector<LayerSegment>& segments_;
  BoxTree tree_;
};

}  // namespace crossloft
