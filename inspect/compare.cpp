#include "compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "../geom/box_tree.h"
#include "surface_topology.h"
#include "triangle_distance.h"
#include "unit_scale.h"

namespace crossloft {
namespace {

/// A point in the frame of the rays: (u, v) across, w along.
struct Projected {
  double u = 0, v = 0, w = 0;
};

struct RayTriangle {
  std::array<Projected, 3> p;
  double low = 0, high = 0;  // extent in v
  int mesh = 0;
};

struct Hit {
  std::uint32_t column = 0;
  double w = 0;
  int mesh = 0;
  friend bool operator<(const Hit& a, const Hit& b) {
    return std::tie(a.column, a.w, a.mesh) < std::tie(b.column, b.w, b.mesh);
  }
};

/// Lengths inside both solids along rays in the middles of a grid of cells, row by row.
class RayVolumes {
 public:
  RayVolumes(const Surface& a, const Surface& b, const Bounds& box, std::uint32_t rays)
      : rays_(std::clamp(rays, 1u, 8192u)) {
    const Vec3 size = box.high - box.low;
    along_ = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
    const Projected low = project(box.low), high = project(box.high);
    u0_ = low.u, v0_ = low.v;
    du_ = (high.u - low.u) / rays_, dv_ = (high.v - low.v) / rays_;
    add(a, 0);
    add(b, 1);
    std::sort(triangles_.begin(), triangles_.end(),
              [](const RayTriangle& x, const RayTriangle& y) { return x.low < y.low; });
  }

  void run(CompareReport& report) {
    std::size_t next = 0;
    for (std::uint32_t row = 0; row < rays_; ++row) {
      const double v = v0_ + (row + 0.5) * dv_;
      while (next < triangles_.size() && triangles_[next].low <= v) active_.push_back(&triangles_[next++]);
      std::erase_if(active_, [v](const RayTriangle* t) { return t->high <= v; });
      hits_.clear();
      for (const RayTriangle* t : active_) cut_row(*t, v);
      std::sort(hits_.begin(), hits_.end());
      add_lengths();
    }
    const double cell = du_ * dv_;
    report.ray_volume_a = cell * length_[0];
    report.ray_volume_b = cell * length_[1];
    report.intersection = cell * both_;
    report.union_volume = cell * (length_[0] + length_[1] - both_);
  }

 private:
  Projected project(const Vec3& p) const {
    return along_ == 0   ? Projected{p.y, p.z, p.x}
           : along_ == 1 ? Projected{p.z, p.x, p.y}
                         : Projected{p.x, p.y, p.z};
  }

  void add(const Surface& mesh, int number) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Corners c = corners(mesh, t);
      RayTriangle r{{project(c[0]), project(c[1]), project(c[2])}, 0, 0, number};
      std::tie(r.low, r.high) = std::minmax({r.p[0].v, r.p[1].v, r.p[2].v});
      triangles_.push_back(r);
    }
  }

  /// Both triangles of an edge compute its point in the same order, hence the same one: rays between rows of
  /// triangles neither slip through nor count twice.
  static Projected edge_point(Projected a, Projected b, double v) {
    if (std::tie(b.v, b.u, b.w) < std::tie(a.v, a.u, a.w)) std::swap(a, b);
    const double t = (v - a.v) / (b.v - a.v);
    return {a.u + t * (b.u - a.u), v, a.w + t * (b.w - a.w)};
  }

  void cut_row(const RayTriangle& t, double v) {
    std::array<Projected, 2> ends;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const Projected &a = t.p[k], &b = t.p[k == 2 ? 0 : k + 1];
      if ((a.v > v) != (b.v > v)) ends[count++] = edge_point(a, b, v);
    }
    if (count != 2) return;
    const auto [from, to] =
        ends[0].u <= ends[1].u ? std::pair(ends[0], ends[1]) : std::pair(ends[1], ends[0]);
    for (std::uint32_t i = column_from(from.u); i < column_from(to.u); ++i) {
      const double s = (ray_at(i) - from.u) / (to.u - from.u);
      hits_.push_back({i, from.w + s * (to.w - from.w), t.mesh});
    }
  }

  double ray_at(std::uint32_t column) const { return u0_ + (column + 0.5) * du_; }

  /// The first ray at or after u.
  std::uint32_t column_from(double u) const {
    const double guess = std::clamp((u - u0_) / du_, 0.0, static_cast<double>(rays_));
    auto i = static_cast<std::uint32_t>(guess);
    while (i > 0 && ray_at(i - 1) >= u) --i;
    while (i < rays_ && ray_at(i) < u) ++i;
    return i;
  }

  void add_lengths() {
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      if (i == 0 || hits_[i].column != hits_[i - 1].column)
        inside_ = {false, false};
      else
        add_length(hits_[i].w - hits_[i - 1].w);
      const auto mesh = static_cast<std::size_t>(hits_[i].mesh);
      inside_[mesh] = !inside_[mesh];
    }
  }

  void add_length(double length) {
    for (std::size_t mesh = 0; mesh < 2; ++mesh)
      if (inside_[mesh]) length_[mesh] += length;
    if (inside_[0] && inside_[1]) both_ += length;
  }

  std::uint32_t rays_;
  int along_ = 2;
  double u0_ = 0, v0_ = 0, du_ = 0, dv_ = 0;
  std::vector<RayTriangle> triangles_;  // by low end
  std::vector<const RayTriangle*> active_;
  std::vector<Hit> hits_;  // of one row
  std::array<bool, 2> inside_{};
  std::array<double, 2> length_{};
  double both_ = 0;
};

/// Distance to a surface.
class NearestTriangle {
 public:
  explicit NearestTriangle(const Surface& mesh) : mesh_(mesh), tree_(boxes(mesh)) {}

  /// Successive points are near each other, so the last triangle found gives a good bound to start from.
  double distance(const Vec3& p) {
    if (tree_.empty()) return Bounds::kFar;
    double best = squared_distance(p, corners(mesh_, last_));
    best = tree_.nearest(
        p,
        [&, nearest = best](std::uint32_t t) mutable {
          const double d = squared_distance(p, corners(mesh_, t));
          if (d < nearest) nearest = d, last_ = t;
          return d;
        },
        best);
    return std::sqrt(best);
  }

 private:
  static std::vector<Bounds> boxes(const Surface& mesh) {
    std::vector<Bounds> out;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) out.push_back(bounds_of(corners(mesh, t)));
    return out;
  }

  const Surface& mesh_;
  BoxTree tree_;
  std::uint32_t last_ = 0;
};

struct Distances {
  double largest = 0, mean = 0;
};

/// Calls visit(point) for `count` points, equal parts of the area apart in the order of the triangles; within
/// them after the additive recurrence of the plastic number (Roberts 2018), folded into the triangle.
template <class Visit>
void for_area_samples(const Surface& mesh, std::uint32_t count, Visit&& visit) {
  std::vector<double> sums;
  double sum = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners(mesh, t);
    sums.push_back(sum += 0.5 * norm(cross(c[1] - c[0], c[2] - c[0])));
  }
  if (!(sum > 0)) return;
  std::uint32_t t = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    while (t + 1 < sums.size() && sums[t] < sum * (k + 0.5) / count) ++t;
    double u = (k + 1) * 0.75487766624669276, v = (k + 1) * 0.56984029099805327;
    u -= std::floor(u), v -= std::floor(v);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Corners c = corners(mesh, t);
    visit(c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]));
  }
}

/// Numbers of the points that triangles use, ascending.
std::vector<std::uint32_t> used_points(const Surface& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) used[v] = true;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (used[v]) numbers.push_back(v);
  return numbers;
}

Distances distances(const Surface& from, const Surface& to, std::uint32_t samples) {
  NearestTriangle nearest(to);
  Distances out;
  double sum = 0;
  for_area_samples(from, samples, [&](const Vec3& p) {
    const double d = nearest.distance(p);
    sum += d;
    out.largest = std::max(out.largest, d);
  });
  out.mean = samples > 0 ? sum / samples : 0;
  const std::vector<std::uint32_t> vertices = used_points(from);
  const std::size_t step = std::max<std::size_t>(1, vertices.size() / std::max(samples, 1u));
  for (std::size_t k = 0; k < vertices.size(); k += step)
    out.largest = std::max(out.largest, nearest.distance(from.points[vertices[k]]));
  return out;
}

struct Shape {
  double volume = 0;
  std::uint32_t components = 0;
  std::int64_t genus = 0;
};

Shape shape_of(const Surface& mesh) {
  CheckReport report;
  check_topology(mesh, report);
  Shape shape{0, static_cast<std::uint32_t>(report.components.size()), report.genus};
  const Vec3 center = bounds_of_triangles(mesh).center();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners(mesh, t);
    shape.volume += dot(c[0] - center, cross(c[1] - center, c[2] - center)) / 6;
  }
  return shape;
}

Bounds common_box(const Surface& a, const Surface& b) {
  Bounds box = bounds_of_triangles(a);
  box.join(bounds_of_triangles(b));
  return box;
}

/// REQUIRES: all that triangles use of size 1, where no product leaves the range of doubles.
CompareReport compare_at_unit(const Surface& a, const Surface& b, const CompareOptions& options) {
  CompareReport report;
  const Shape shape_a = shape_of(a), shape_b = shape_of(b);
  report.volume_a = shape_a.volume, report.volume_b = shape_b.volume;
  report.components_a = shape_a.components, report.components_b = shape_b.components;
  report.genus_a = shape_a.genus, report.genus_b = shape_b.genus;
  const Bounds box = common_box(a, b);
  report.diagonal = box.diagonal();
  if (!box.empty()) RayVolumes(a, b, box, options.rays).run(report);
  report.iou = report.union_volume > 0 ? report.intersection / report.union_volume : 1;
  const Distances ab = distances(a, b, options.samples), ba = distances(b, a, options.samples);
  report.distance_ab = ab.largest, report.mean_ab = ab.mean;
  report.distance_ba = ba.largest, report.mean_ba = ba.mean;
  return report;
}

}  // namespace

CompareReport compare(const Surface& a, const Surface& b, const CompareOptions& options) {
  const UnitScale scale(common_box(a, b));
  CompareReport r = compare_at_unit(scale.to_unit(a), scale.to_unit(b), options);
  for (double* volume :
       {&r.volume_a, &r.volume_b, &r.ray_volume_a, &r.ray_volume_b, &r.intersection, &r.union_volume})
    *volume = scale.volume(*volume);
  for (double* length : {&r.distance_ab, &r.distance_ba, &r.mean_ab, &r.mean_ba, &r.diagonal})
    *length = scale.length(*length);
  return r;
}

}  // namespace crossloft
