#include "canvas.h"

namespace crossloft::cli {
namespace {

std::uint8_t srgb(float linear) {
  const double v = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

}  // namespace

View view_from(Vec3 toward) {
  View view;
  int exponent = 0;  // of any length
  toward = to_unit_size(toward, exponent);
  view.toward = (1 / norm(toward)) * toward;
  view.right = cross({0, 0, 1}, view.toward);
  if (view.right == Vec3{}) view.right = {view.toward.z, 0, 0};
  view.right = (1 / norm(view.right)) * view.right;
  view.up = cross(view.toward, view.right);
  return view;
}

Canvas::Canvas(int width, int height)
    : width_(kSamples * width),
      height_(kSamples * height),
      end_x_(width_),
      colour_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Rgb{1, 1, 1}),
      depth_(colour_.size(), kNowhere),
      fragments_(static_cast<std::size_t>(height_)) {}

void Canvas::blend_row(int y) {
  std::vector<Fragment>& row = fragments_[static_cast<std::size_t>(y)];
  std::stable_sort(row.begin(), row.end(), [](const Fragment& a, const Fragment& b) {
    return a.x != b.x ? a.x < b.x : a.depth < b.depth;
  });
  for (const Fragment& f : row) {
    const std::size_t i = at(f.x, y);
    if (f.depth >= depth_[i]) colour_[i] = (1 - f.alpha) * colour_[i] + f.alpha * f.colour;
  }
  row.clear();
}

Image Canvas::develop() {
  for (int y = 0; y < height_; ++y) blend_row(y);
  Image image{
      static_cast<std::uint32_t>(width_ / kSamples), static_cast<std::uint32_t>(height_ / kSamples), {}};
  for (int y = 0; y < height_; y += kSamples) {
    for (int x = 0; x < width_; x += kSamples) {
      Rgb sum;
      for (int k = 0; k < kSamples * kSamples; ++k)
        sum = sum + colour_[at(x + k % kSamples, y + k / kSamples)];
      const Rgb mean = (1.0f / (kSamples * kSamples)) * sum;
      image.rgb.insert(image.rgb.end(), {srgb(mean.r), srgb(mean.g), srgb(mean.b)});
    }
  }
  return image;
}

}  // namespace crossloft::cli
