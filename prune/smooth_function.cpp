#include "smooth_function.h"

#include <cmath>
#include <utility>

namespace crossloft {
namespace {

/// Cubed.
double distance3(Vec3 p, Vec3 q) {
  const Vec3 d = p - q;
  const double square = dot(d, d);
  return square * std::sqrt(square);
}

/// Rows of equations, the right side last.
struct LinearSystem {
  std::size_t n;
  std::vector<double> rows;

  explicit LinearSystem(std::size_t size) : n(size), rows(size * (size + 1), 0) {}
  double* row(std::size_t i) { return rows.data() + i * (n + 1); }

  void bring_pivot(std::size_t k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::fabs(row(i)[k]) > std::fabs(row(best)[k])) best = i;
    if (best != k) std::swap_ranges(row(k), row(k) + n + 1, row(best));
  }

  /// Gauss, with the largest pivot of each column. Empty if one is too small.
  std::vector<double> solve() {
    constexpr double kSmallestPivot = 1e-11;
    for (std::size_t k = 0; k < n; ++k) {
      bring_pivot(k);
      const double* from = row(k);
      if (!(std::fabs(from[k]) > kSmallestPivot)) return {};
      for (std::size_t i = k + 1; i < n; ++i) {
        double* to = row(i);
        const double factor = to[k] / from[k];
        if (factor == 0) continue;
        for (std::size_t j = k + 1; j <= n; ++j) to[j] -= factor * from[j];
      }
    }
    std::vector<double> x(n);
    for (std::size_t i = n; i-- > 0;) {
      double sum = row(i)[n];
      for (std::size_t j = i + 1; j < n; ++j) sum -= row(i)[j] * x[j];
      x[i] = sum / row(i)[i];
    }
    return x;
  }
};

}  // namespace

std::optional<SmoothFunction> SmoothFunction::through(std::span<const FieldSample> samples, Vec3 centre,
                                                      double unit) {
  SmoothFunction f(centre, unit);
  const std::size_t n = samples.size();
  LinearSystem system(n + 4);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p = f.scaled(samples[i].at);
    f.points_.push_back(p);
    double* row = system.row(i);
    for (std::size_t j = 0; j < i; ++j) row[j] = system.row(j)[i] = distance3(p, f.points_[j]);
    const double linear[] = {1, p.x, p.y, p.z};
    for (std::size_t k = 0; k < 4; ++k) row[n + k] = system.row(n + k)[i] = linear[k];
    row[n + 4] = samples[i].distance / unit;
  }
  f.weights_ = system.solve();
  return f.weights_.empty() ? std::nullopt : std::optional(std::move(f));
}

std::array<double, 2> SmoothFunction::at(Vec3 p, Vec3 q) const {
  p = scaled(p), q = scaled(q);
  const Pair x{p.x, q.x}, y{p.y, q.y}, z{p.z, q.z};
  const double* linear = weights_.data() + points_.size();
  Pair sum = linear[0] + linear[1] * x + linear[2] * y + linear[3] * z;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Pair dx = x - points_[i].x, dy = y - points_[i].y, dz = z - points_[i].z;
    const Pair square = dx * dx + dy * dy + dz * dz;
    sum += weights_[i] * (square * Pair{std::sqrt(square[0]), std::sqrt(square[1])});
  }
  return {sum[0], sum[1]};
}

}  // namespace crossloft
