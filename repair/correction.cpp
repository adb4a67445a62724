#include "correction.h"

#include <algorithm>
#include <cmath>

namespace crossloft {

Correction::Correction(const SectionBoundary& section, const CommonLine& line, const LineTarget& target,
                       const Misfit& misfit, bool inside, double least)
    : misfit_(misfit), inside_(inside), least_(least) {
  const double most = std::max(kPush * misfit.depth, least);
  for (int k = 0; k <= kAcross; ++k) {
    const double t = misfit.begin + (misfit.end - misfit.begin) * k / kAcross;
    double& size = sizes_[static_cast<std::size_t>(k)];
    size = std::min(section.distance(line.at(t)) + std::fabs(target.blend_at(t)), most);
    reach_ = std::max(reach_, kReach * size);
  }
}

double Correction::operator()(double t, double s) const {
  const double beyond = std::max({0.0, misfit_.begin - t, t - misfit_.end});
  return size_at(t) * std::max(0.0, 1 - std::sqrt(beyond * beyond + s * s) / reach_);
}

double Correction::size_at(double t) const {
  const double s = std::clamp((t - misfit_.begin) / (misfit_.end - misfit_.begin), 0.0, 1.0) * kAcross;
  const auto k = static_cast<std::size_t>(std::min(s, kAcross - 1.0));
  return sizes_[k] + (s - static_cast<double>(k)) * (sizes_[k + 1] - sizes_[k]);
}

void Correction::add_samples(std::vector<double>& samples) const {
  samples.insert(samples.end(), {misfit_.begin - least_, misfit_.begin, misfit_.end, misfit_.end + least_});
  for (int k = 1; k < kAcross; ++k)
    samples.push_back(misfit_.begin + (misfit_.end - misfit_.begin) * k / kAcross);
  for (int k = 1; k <= kBeyond; ++k)
    samples.insert(samples.end(), {misfit_.begin - reach_ * k / kBeyond, misfit_.end + reach_ * k / kBeyond});
}

}  // namespace crossloft
