#include "demo_input.h"

namespace crossloft::cli {
namespace {

/// The file in pieces, since compilers limit the length of a literal.
constexpr const char* kPieces[] = {
#include <demo_contour.inc>  // generated
};

}  // namespace

std::string demo_input() {
  std::string text;
  for (const char* piece : kPieces) text += piece;
  return text;
}

std::vector<CuttingPlane> demo_planes(const Bounds& box) {
  std::vector<CuttingPlane> planes;
  const Vec3 size = box.high - box.low, center = box.center();
  const auto add = [&](const Vec3& normal, const Vec3& through) {
    planes.push_back({normal, -dot(normal, through)});
  };
  constexpr int kLevels = 9, kSagittal = 6, kFrontal = 5;
  for (int k = 0; k < kLevels; ++k) {  // up the body, rocking to and fro
    const double t = (k + 0.5) / kLevels, rock = k % 2 == 0 ? 0.1 : -0.08;
    add({rock * (1 - t), 0.04 + 0.01 * k, 1}, {center.x, center.y, box.low.z + t * size.z});
  }
  for (int k = 0; k < kSagittal; ++k) {  // from side to side, turning like an ultrasound probe
    const double t = (k + 0.5) / kSagittal;
    add({1, 0.4 * (0.5 - t), 0.2 * (0.5 - t)}, {box.low.x + t * size.x, center.y, center.z});
  }
  for (int k = 0; k < kFrontal; ++k) {  // from front to back
    const double t = (k + 0.5) / kFrontal;
    add({0.16 * (t - 0.4), 1, 0.4 * (0.45 - t)}, {center.x, box.low.y + t * size.y, center.z});
  }
  return planes;
}

}  // namespace crossloft::cli
