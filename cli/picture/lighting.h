#pragma once
/// Soft light on a surface: many parallel lights, a shadow map each. Those around the key direction give a
/// soft shadow, those spread over the sky ambient occlusion. Each sample of a pixel uses its own share of the
/// lights, and their average sees them all.

#include <array>
#include <vector>

#include "../../reconstruct/surface.h"
#include "canvas.h"

namespace crossloft::cli {

/// What a parallel light sees first: a depth buffer of the surface from its direction.
class ShadowMap {
 public:
  ShadowMap(const Surface& surface, Vec3 toward_light, Vec3 center, double radius);
  /// True iff light reaches the point; `slack` is a length that forgives a surface for shadowing itself.
  bool lights(const Vec3& point, double slack) const;
  const Vec3& toward_light() const { return view_.toward; }

 private:
  static constexpr int kSize = 384;
  View view_;
  std::vector<float> depth_;
};

class Lighting {
 public:
  /// REQUIRES: radius > 0; lights up what is within it of the center.
  Lighting(const Surface& surface, Vec3 center, double radius);

  /// Light that a white matt surface sends back at a point with a unit normal; `share` in [0, kSamples^2).
  Rgb at(const Vec3& point, const Vec3& normal, int share) const;
  /// Unit vector to the middle of the key light.
  static Vec3 key();

 private:
  static constexpr int kShares = kSamples * kSamples;
  static constexpr int kKeyLights = 2, kSkyLights = 12;  ///< a share

  double slack_;
  std::array<std::vector<ShadowMap>, kShares> key_, sky_;
};

/// A unit normal for each corner of each triangle: the mean of the normals around its vertex that are within
/// 50 degrees of the triangle's own, so that creases stay sharp. Vertices with equal coordinates count as
/// one.
std::vector<std::array<Vec3, 3>> corner_normals(const Surface& surface);

}  // namespace crossloft::cli
