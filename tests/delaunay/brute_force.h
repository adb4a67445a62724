#pragma once
/// Delaunay and regular triangulations straight from the definition, with the perturbation as numbers.

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../geom/lattice.h"

namespace brute_force {

/// Points as integers, lifted to |x|^2 - weight + 2^(-kShift rank), rank 1 for the lexicographically largest,
/// everything scaled by 2^(kShift n). REQUIRES: distinct explicit points, sorted, coordinates below 2^12 or
/// so: then the power of two is smaller than any quotient of minors.
template <std::size_t D>
class Lifted {
 public:
  static constexpr unsigned kShift = 96;

  explicit Lifted(const std::vector<crossloft::LatticePoint>& sorted, const std::vector<int>& weights = {}) {
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const crossloft::LatticeVector v = to_vector(sorted[i]);
      Row row;
      for (std::size_t k = 0; k < D; ++k) {
        row[k] = v[k];
        row[D] += row[k] * row[k];
      }
      if (!weights.empty()) row[D] -= weights[i];
      row[D] = (row[D] << kShift * sorted.size()) + (mpz_class(1) << kShift * i);
      rows_.push_back(row);
    }
  }

  /// All simplices whose ball holds no other point, ascending, sorted.
  std::vector<std::array<std::uint32_t, D + 1>> triangulate() const {
    std::vector<std::array<std::uint32_t, D + 1>> found;
    std::array<std::uint32_t, D + 1> s;
    for (std::uint32_t k = 0; k <= D; ++k) s[k] = k;
    if (size() <= D) return found;
    do {
      if (is_delaunay(s)) found.push_back(s);
    } while (advance(s));
    return found;
  }

 private:
  using Row = std::array<mpz_class, D + 1>;

  std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }

  bool advance(std::array<std::uint32_t, D + 1>& s) const {
    for (std::size_t k = D + 1; k-- > 0;) {
      if (s[k] + (D - k) + 1 >= size()) continue;
      ++s[k];
      for (std::size_t l = k + 1; l <= D; ++l) s[l] = s[l - 1] + 1;
      return true;
    }
    return false;
  }

  static mpz_class determinant(const std::vector<std::vector<mpz_class>>& m) {
    if (m.size() == 1) return m[0][0];
    mpz_class sum = 0;
    for (std::size_t row = 0; row < m.size(); ++row) {
      std::vector<std::vector<mpz_class>> minor;
      for (std::size_t r = 0; r < m.size(); ++r)
        if (r != row) minor.emplace_back(m[r].begin() + 1, m[r].end());
      const mpz_class term = m[row][0] * determinant(minor);
      sum += row % 2 ? -term : term;
    }
    return sum;
  }

  /// Sign of the determinant of rows minus that of the first, `columns` of them.
  int side(const std::vector<std::uint32_t>& points, std::size_t columns) const {
    std::vector<std::vector<mpz_class>> m;
    for (std::size_t k = 1; k < points.size(); ++k) {
      auto& row = m.emplace_back();
      for (std::size_t c = 0; c < columns; ++c) row.push_back(rows_[points[k]][c] - rows_[points[0]][c]);
    }
    return sgn(determinant(m));
  }

  /// Delaunay iff every other lifted point is above the hyperplane through the lifted simplex.
  bool is_delaunay(const std::array<std::uint32_t, D + 1>& s) const {
    std::vector<std::uint32_t> points(s.begin(), s.end());
    const int orientation = side(points, D);
    if (orientation == 0) return false;
    points.push_back(0);
    for (std::uint32_t e = 0; e < size(); ++e) {
      points.back() = e;
      if (side(points, D + 1) * orientation < 0) return false;
    }
    return true;
  }

  std::vector<Row> rows_;
};

}  // namespace brute_force
