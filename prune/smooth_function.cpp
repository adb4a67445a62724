#include "smooth_function.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
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
  static constexpr std::size_t kPanel = 8;  ///< rows that are taken off at a time

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

  /// Pivot k; in the rows below it the factor by which it is taken off comes into column k, and columns
  /// before `end` are done. False if it is too small.
  bool eliminate(std::size_t k, std::size_t end) {
    constexpr double kSmallestPivot = 1e-11;
    bring_pivot(k);
    const double* from = row(k);
    if (!(std::fabs(from[k]) > kSmallestPivot)) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      double* to = row(i);
      to[k] /= from[k];
      for (std::size_t j = k + 1; j < end; ++j) to[j] -= to[k] * from[j];
    }
    return true;
  }

  /// Takes rows `first` to first + kPanel off row i, in the columns from there on: in this order, as one by
  /// one.
  void take_panel(std::size_t first, std::size_t i) {
    std::array<double, kPanel> factor;
    for (std::size_t k = 0; k < kPanel; ++k) factor[k] = row(i)[first + k];
    const double* from = row(first) + first + kPanel;
    double* to = row(i) + first + kPanel;
    const std::size_t width = n + 1, count = width - first - kPanel;
    std::size_t j = 0;
    for (; j + 2 <= count; j += 2) {
      Pair x;
      std::memcpy(&x, to + j, sizeof x);
      for (std::size_t k = 0; k < kPanel; ++k) {
        Pair y;
        std::memcpy(&y, from + k * width + j, sizeof y);
        x -= factor[k] * y;
      }
      std::memcpy(to + j, &x, sizeof x);
    }
    for (; j < count; ++j)
      for (std::size_t k = 0; k < kPanel; ++k) to[j] -= factor[k] * from[k * width + j];
  }

  /// The rest of the panel's own rows, then all below: each row is read and written once for all of them.
  void update_below(std::size_t first) {
    const std::size_t end = first + kPanel;
    for (std::size_t i = first + 1; i < end; ++i)
      for (std::size_t k = first; k < i; ++k)
        for (std::size_t j = end; j <= n; ++j) row(i)[j] -= row(i)[k] * row(k)[j];
    for (std::size_t i = end; i < n; ++i) take_panel(first, i);
  }

  /// Gauss, with the largest pivot of each column. Empty if one is too small.
  std::vector<double> solve() {
    for (std::size_t first = 0; first < n; first += kPanel) {
      const bool is_last = first + kPanel > n;
      for (std::size_t k = first; k < std::min(first + kPanel, n); ++k)
        if (!eliminate(k, is_last ? n + 1 : first + kPanel)) return {};
      if (!is_last) update_below(first);
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
