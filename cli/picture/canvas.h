#pragma once
/// A canvas with depth: opaque samples by z-buffer, translucent ones sorted per sample, several samples a
/// pixel.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "../../geom/vec3.h"

namespace crossloft::cli {

/// Linear light, 0 black, 1 white.
struct Rgb {
  float r = 0, g = 0, b = 0;
  friend Rgb operator+(Rgb p, Rgb q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
  friend Rgb operator*(float s, Rgb p) { return {s * p.r, s * p.g, s * p.b}; }
  friend Rgb operator*(Rgb p, Rgb q) { return {p.r * q.r, p.g * q.g, p.b * q.b}; }
};

/// A point on the canvas in samples, x to the right, y down; larger depth is nearer to the viewer.
struct Spot {
  double x = 0, y = 0, depth = 0;
};

/// Orthographic view: `right`, `up`, `toward` the viewer are orthonormal; `center` is seen at (x, y).
struct View {
  Vec3 right, up, toward, center;
  double scale = 1;  ///< samples per input unit
  double x = 0, y = 0;

  Spot operator()(const Vec3& p) const {
    const Vec3 d = p - center;
    return {finite(x + scale * dot(d, right)), finite(y - scale * dot(d, up)),
            finite(scale * dot(d, toward))};
  }

 private:
  /// A part that is enlarged much has neighbours so far out that products of their places would overflow.
  static double finite(double v) {
    constexpr double kFar = 1e100;
    return v < kFar ? std::max(v, -kFar) : kFar;
  }
};

/// A coordinate as an integer, -1 or `size` if it lies beyond a canvas of that size.
inline int sample(double at, int size) { return at < size ? static_cast<int>(std::max(at, -1.0)) : size; }

/// The view from direction `toward` (of any length but 0) with z up; along z with x to the right from above.
View view_from(Vec3 toward);

/// Eight bits a channel, sRGB, rows from the top.
struct Image {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

inline constexpr int kSamples = 3;  ///< samples along each side of a pixel

class Canvas {
 public:
  /// Size in pixels of the final image.
  Canvas(int width, int height);

  int width() const { return width_; }    ///< in samples
  int height() const { return height_; }  ///< in samples

  /// From here on only samples with first_x <= x < end_x are drawn on.
  void clip(int first_x, int end_x) {
    first_x_ = first_x;
    end_x_ = end_x;
  }

  /// Covers a background sample, whatever its depth or the clip.
  void background(int x, int y, Rgb colour) { colour_[at(x, y)] = colour; }
  void shade(int x, int y, float factor) { colour_[at(x, y)] = factor * colour_[at(x, y)]; }
  bool in_front(int x, int y, double depth) const { return depth > depth_[at(x, y)]; }
  void opaque(int x, int y, double depth, Rgb colour) {
    if (x < first_x_ || x >= end_x_) return;
    colour_[at(x, y)] = colour;
    depth_[at(x, y)] = static_cast<float>(depth);
  }
  bool empty(int x, int y) const { return depth_[at(x, y)] == kNowhere; }
  void translucent(int x, int y, double depth, Rgb colour, float alpha) {
    if (x < first_x_ || x >= end_x_) return;
    fragments_[static_cast<std::size_t>(y)].push_back({x, static_cast<float>(depth), alpha, colour});
  }

  /// Lays the translucent samples over the opaque ones, far to near, and averages the samples of each pixel.
  Image develop();

 private:
  struct Fragment {
    int x;
    float depth, alpha;
    Rgb colour;
  };

  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  void blend_row(int y);

  static constexpr float kNowhere = -std::numeric_limits<float>::infinity();

  int width_, height_;
  int first_x_ = 0, end_x_;
  std::vector<Rgb> colour_;
  std::vector<float> depth_;
  std::vector<std::vector<Fragment>> fragments_;  ///< by row
};

/// Calls paint(x, y, wa, wb, wc) with barycentric weights for every sample in [0, width) x [0, height) whose
/// centre is in the triangle, whatever its orientation. A triangle seen edge-on has none.
template <class Paint>
void scan_triangle(const Spot& a, const Spot& b, const Spot& c, int width, int height, Paint paint) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0) return;
  const int first_y = std::max(0, sample(std::ceil(std::min({a.y, b.y, c.y}) - 0.5), height));
  const int last_y = std::min(height - 1, sample(std::floor(std::max({a.y, b.y, c.y}) - 0.5), height));
  const int first_x = std::max(0, sample(std::ceil(std::min({a.x, b.x, c.x}) - 0.5), width));
  const int last_x = std::min(width - 1, sample(std::floor(std::max({a.x, b.x, c.x}) - 0.5), width));
  for (int y = first_y; y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double wa = ((b.x - px) * (c.y - py) - (c.x - px) * (b.y - py)) / area;
      const double wb = ((c.x - px) * (a.y - py) - (a.x - px) * (c.y - py)) / area;
      const double wc = 1 - wa - wb;
      if (wa >= 0 && wb >= 0 && wc >= 0) paint(x, y, wa, wb, wc);
    }
  }
}

}  // namespace crossloft::cli
