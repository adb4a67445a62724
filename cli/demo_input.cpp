#include "demo_input.h"

#include <string_view>

namespace crossloft::cli {
namespace {

/// The file in pieces, since compilers limit the length of a literal.
constexpr std::string_view kPieces[] = {
#include "demo_contour.inc"
};

}  // namespace

std::string demo_input() {
  std::string text;
  for (std::string_view piece : kPieces) text += piece;
  return text;
}

std::vector<CuttingPlane> demo_planes(const Bounds& box) {
  std::vector<CuttingPlane> planes;
  const Vec3 size = box.high - box.low;
  const auto add = [&](const Vec3& normal, const Vec3& through) {
    planes.push_back({normal, -dot(normal, through)});
  };
  constexpr int kLevels = 13, kSweep = 7;
  for (int k = 0; k < kLevels; ++k) {  // up the body, rocking to and fro
    const double t = (k + 0.5) / kLevels, rock = k % 2 == 0 ? 0.12 : -0.10;
    add({rock * (1 - t), 0.04 + 0.01 * k, 1}, {box.center().x, box.center().y, box.low.z + t * size.z});
  }
  for (int k = 0; k < kSweep; ++k) {  // from side to side, turning like an ultrasound probe
    const double t = (k + 0.5) / kSweep;
    add({1, 0.25 - 0.06 * k, 0.5 * (0.5 - t)}, {box.low.x + t * size.x, box.center().y, box.center().z});
  }
  return planes;
}

}  // namespace crossloft::cli
