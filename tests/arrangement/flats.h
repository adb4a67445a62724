#pragma once
/// Referee for arrangements: exact rational coordinates, and the numbers of elements by counting flats.
///
/// Shares nothing with the library but the planes' integers.

#include <gmpxx.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "../../arrangement/complex.h"

namespace crossloft::flats {

using Integer3 = std::array<mpz_class, 3>;
using Rational3 = std::array<mpq_class, 3>;

/// n.x = d.
struct Equation {
  Integer3 n;
  mpz_class d;
};

inline mpz_class big(std::int64_t v) { return mpz_class(static_cast<signed long>(v)); }

inline Equation equation(const LatticePlane& p) {
  Equation e;
  for (std::size_t k = 0; k < 3; ++k) e.n[k] = big(p.normal[k]), e.d += e.n[k] * big(p.origin[k]);
  return e;
}

inline Integer3 cross(const Integer3& a, const Integer3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline mpz_class det(const Integer3& a, const Integer3& b, const Integer3& c) {
  const Integer3 x = cross(b, c);
  return a[0] * x[0] + a[1] * x[1] + a[2] * x[2];
}

inline std::optional<Rational3> meet(const Equation& a, const Equation& b, const Equation& c) {
  const mpz_class w = det(a.n, b.n, c.n);
  if (w == 0) return std::nullopt;
  Rational3 x;
  for (std::size_t k = 0; k < 3; ++k) {
    Integer3 ra = a.n, rb = b.n, rc = c.n;
    ra[k] = a.d, rb[k] = b.d, rc[k] = c.d;
    x[k] = mpq_class(det(ra, rb, rc), w);
    x[k].canonicalize();
  }
  return x;
}

inline int side(const Equation& e, const Rational3& p) {
  const mpq_class s = e.n[0] * p[0] + e.n[1] * p[1] + e.n[2] * p[2] - e.d;
  return sgn(s);
}

/// The planes through a vertex, those of the box included.
inline std::vector<PlaneId> planes_through(const Arrangement& a, ArrVertexId v) {
  std::vector<PlaneId> planes;
  for (std::uint32_t p = 0; p < a.plane_count(); ++p)
    if (has_bit(a.signs(v).zero, PlaneId(p))) planes.emplace_back(p);
  for (std::uint32_t j = 0; j < 6; ++j)
    if (a.box_mask(v) >> j & 1) planes.emplace_back(a.plane_count() + j);
  return planes;
}

/// Exact coordinates from the tag alone.
inline Rational3 coordinates(const Arrangement& a, ArrVertexId v) {
  const auto planes = planes_through(a, v);
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j)
      for (std::size_t k = j + 1; k < planes.size(); ++k)
        if (const auto x = meet(equation(a.plane(planes[i])), equation(a.plane(planes[j])),
                                equation(a.plane(planes[k]))))
          return *x;
  return {};
}

inline std::vector<Rational3> all_coordinates(const Arrangement& a) {
  std::vector<Rational3> x;
  for (std::uint32_t v = 0; v < a.vertex_count(); ++v) x.push_back(coordinates(a, ArrVertexId(v)));
  return x;
}

/// Six times the volume of a cell, from the exact coordinates of all vertices.
inline mpq_class six_volumes(const Arrangement& a, CellId c, const std::vector<Rational3>& x) {
  mpq_class sum;
  for (const FaceId f : a.faces_of(c)) {
    const auto loop = a.vertices_of(f);
    const Rational3& p = x[loop[0].value];
    mpq_class fan;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Rational3 &q = x[loop[i].value], &r = x[loop[i + 1].value];
      fan += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
             p[2] * (q[0] * r[1] - q[1] * r[0]);
    }
    if (a.cells_of(f)[0] == c)
      sum += fan;
    else
      sum -= fan;
  }
  return sum;
}

/// Numbers of elements that are not on the box.
struct Counts {
  std::size_t vertices = 0, edges = 0, faces = 0, cells = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
};

inline Counts counts(const Arrangement& a) {
  Counts c;
  for (std::uint32_t i = 0; i < a.vertex_count(); ++i) c.vertices += a.on_box(ArrVertexId(i)) ? 0 : 1;
  for (std::uint32_t i = 0; i < a.edge_count(); ++i) c.edges += a.on_box(ArrEdgeId(i)) ? 0 : 1;
  for (std::uint32_t i = 0; i < a.face_count(); ++i) c.faces += a.on_box(FaceId(i)) ? 0 : 1;
  c.cells = a.cell_count();
  return c;
}

/// The flats (planes, lines, points) that meet the open box, found by brute force over pairs and triples.
class Flats {
 public:
  Flats(const std::vector<LatticePlane>& planes, const LatticeBox& box) {
    for (const LatticePlane& p : planes) equations_.push_back(equation(p));
    for (std::size_t k = 0; k < 3; ++k) lower_[k] = big(box.lower[k]), upper_[k] = big(box.upper[k]);
    collect();
  }

  /// Zaslavsky's theorem in an open convex set: every flat adds the modulus of its Moebius number, to cells
  /// over the flats of space, to faces over those of each plane, to edges over those of each line.
  Counts expected() const {
    Counts c{points_.size(), lines_.size(), planes_, 1 + planes_};
    for (const auto& line : lines_) c.cells += line.size() - 1, c.faces += line.size();
    for (const auto& [x, through] : points_) {
      std::set<std::vector<std::size_t>> lines;
      for (const std::size_t p : through)
        for (const std::size_t q : through)
          if (p < q && !parallel(equations_[p], equations_[q])) lines.insert(line_of(p, q));
      c.edges += lines.size();
      c.cells += 1, c.cells -= through.size();
      c.faces -= through.size();
      for (const auto& line : lines) c.cells += line.size() - 1, c.faces += line.size();
    }
    return c;
  }

 private:
  static bool parallel(const Equation& a, const Equation& b) { return cross(a.n, b.n) == Integer3{}; }

  /// A point and the direction of the line of two crossing planes.
  static std::pair<Rational3, Integer3> parametric(const Equation& a, const Equation& b) {
    const Integer3 d = cross(a.n, b.n);
    return {*meet(a, b, {d, 0}), d};
  }

  /// All planes through the line of two crossing planes, ascending.
  std::vector<std::size_t> line_of(std::size_t p, std::size_t q) const {
    const auto [point, d] = parametric(equations_[p], equations_[q]);
    std::vector<std::size_t> all;
    for (std::size_t r = 0; r < equations_.size(); ++r) {
      const Equation& e = equations_[r];
      const mpz_class slope = e.n[0] * d[0] + e.n[1] * d[1] + e.n[2] * d[2];
      if (slope == 0 && side(e, point) == 0) all.push_back(r);
    }
    return all;
  }

  bool plane_crosses(const Equation& e) const {
    bool low = false, high = false;
    for (unsigned corner = 0; corner < 8; ++corner) {
      Rational3 x;
      for (std::size_t k = 0; k < 3; ++k) x[k] = corner >> k & 1 ? upper_[k] : lower_[k];
      const int s = side(e, x);
      low = low || s < 0, high = high || s > 0;
    }
    return low && high;
  }

  bool line_crosses(const Equation& a, const Equation& b) const {
    const auto [x, d] = parametric(a, b);
    std::optional<mpq_class> from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      if (d[k] == 0) {
        if (x[k] <= lower_[k] || x[k] >= upper_[k]) return false;
        continue;
      }
      mpq_class t = (lower_[k] - x[k]) / d[k], u = (upper_[k] - x[k]) / d[k];
      if (t > u) std::swap(t, u);
      if (!from || t > *from) from = t;
      if (!to || u < *to) to = u;
    }
    return *from < *to;
  }

  void collect() {
    std::set<std::vector<std::size_t>> lines;
    for (std::size_t p = 0; p < equations_.size(); ++p) {
      if (plane_crosses(equations_[p])) ++planes_;
      for (std::size_t q = p + 1; q < equations_.size(); ++q) {
        if (parallel(equations_[p], equations_[q])) continue;
        if (line_crosses(equations_[p], equations_[q])) lines.insert(line_of(p, q));
      }
      for (std::size_t q = p + 1; q < equations_.size(); ++q)
        for (std::size_t r = q + 1; r < equations_.size(); ++r) collect_point(p, q, r);
    }
    lines_.assign(lines.begin(), lines.end());
  }

  void collect_point(std::size_t p, std::size_t q, std::size_t r) {
    const auto x = meet(equations_[p], equations_[q], equations_[r]);
    if (!x) return;
    for (std::size_t k = 0; k < 3; ++k)
      if ((*x)[k] <= lower_[k] || (*x)[k] >= upper_[k]) return;
    points_[*x].insert({p, q, r});
  }

  std::vector<Equation> equations_;
  Rational3 lower_, upper_;
  std::size_t planes_ = 0;
  std::vector<std::vector<std::size_t>> lines_;
  std::map<Rational3, std::set<std::size_t>> points_;
};

}  // namespace crossloft::flats
