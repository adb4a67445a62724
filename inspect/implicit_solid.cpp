#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "../geom/ids.h"
#include "solids.h"

namespace crossloft {
namespace {

constexpr double kKeepAway = 0.02;  // of an edge, so that triangles don't degenerate

using Cell = std::array<std::uint32_t, 3>;

/// A corner of a tetrahedron: a grid vertex, and which of the cube's corners it is (bit k: one step along
/// axis k).
struct Node {
  std::size_t grid = 0;
  unsigned corner = 0;
};

/// Every cube is cut into the six tetrahedra that walk from corner 0 to corner 7 one axis at a time (Kuhn);
/// their edges run in the seven directions 1..7, and neighbouring cubes agree on their common face.
class MarchingTetrahedra {
 public:
  MarchingTetrahedra(const std::function<double(const Vec3&)>& field, const Bounds& box, std::uint32_t cells)
      : low_(box.low) {
    const Vec3 size = box.high - box.low;
    step_ = std::max({size.x, size.y, size.z}) / cells;
    count_ = {steps(size.x), steps(size.y), steps(size.z)};
    sample(field);
    vertex_.assign(7 * value_.size(), kNone);
  }

  Surface run() {
    Cell c{};
    for (c[2] = 0; c[2] < count_[2]; ++c[2])
      for (c[1] = 0; c[1] < count_[1]; ++c[1])
        for (c[0] = 0; c[0] < count_[0]; ++c[0]) march_cube(c);
    return std::move(mesh_);
  }

 private:
  std::uint32_t steps(double length) const {
    return std::max(1u, static_cast<std::uint32_t>(std::ceil(length / step_ - 1e-9)));
  }
  std::size_t grid_index(const Cell& c) const {
    return (std::size_t{c[2]} * (count_[1] + 1) + c[1]) * (count_[0] + 1) + c[0];
  }
  Vec3 position(const Cell& c) const { return low_ + step_ * Vec3{double(c[0]), double(c[1]), double(c[2])}; }
  static Cell corner_of(const Cell& c, unsigned corner) {
    return {c[0] + (corner & 1), c[1] + (corner >> 1 & 1), c[2] + (corner >> 2 & 1)};
  }
  bool inside(std::size_t grid) const { return value_[grid] < 0; }

  /// Vertices on the box's sides are outside, so the surface closes.
  void sample(const std::function<double(const Vec3&)>& field) {
    value_.reserve((count_[0] + 1) * std::size_t{count_[1] + 1} * (count_[2] + 1));
    Cell c{};
    for (c[2] = 0; c[2] <= count_[2]; ++c[2])
      for (c[1] = 0; c[1] <= count_[1]; ++c[1])
        for (c[0] = 0; c[0] <= count_[0]; ++c[0]) {
          const bool border = c[0] % count_[0] == 0 || c[1] % count_[1] == 0 || c[2] % count_[2] == 0;
          const double f = field(position(c));
          value_.push_back(border ? std::max(f, kKeepAway * step_) : f);
        }
  }

  void march_cube(const Cell& c) {
    int count = 0;
    for (unsigned k = 0; k < 8; ++k) count += inside(grid_index(corner_of(c, k)));
    if (count == 0 || count == 8) return;
    std::array<unsigned, 3> axes{0, 1, 2};
    do {
      const unsigned first = 1u << axes[0], second = first | 1u << axes[1];
      std::array<Node, 4> tet;
      const std::array<unsigned, 4> path{0, first, second, 7};
      for (std::size_t k = 0; k < 4; ++k) tet[k] = {grid_index(corner_of(c, path[k])), path[k]};
      const bool positive = (axes[0] + 1) % 3 == axes[1];  // the even permutations
      if (!positive) std::swap(tet[0], tet[1]);
      march_tet(c, tet);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  /// Brings the inner corners to the front by an even permutation, then there are three cases up to a turn.
  void march_tet(const Cell& c, const std::array<Node, 4>& tet) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::stable_partition(order.begin(), order.end(), [&](std::size_t k) { return inside(tet[k].grid); });
    bool odd = false;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) odd ^= order[i] > order[j];
    const auto inner = std::count_if(tet.begin(), tet.end(), [&](const Node& n) { return inside(n.grid); });
    if (odd) inner == 3 ? std::swap(order[0], order[1]) : std::swap(order[2], order[3]);
    const auto at = [&](std::size_t i, std::size_t j) { return crossing(c, tet[order[i]], tet[order[j]]); };
    if (inner == 1) add({at(0, 1), at(0, 2), at(0, 3)});
    if (inner == 3) add({at(3, 0), at(3, 1), at(3, 2)});
    if (inner == 2) add_quadrilateral({at(0, 2), at(0, 3), at(1, 3), at(1, 2)});
  }

  std::uint32_t crossing(const Cell& c, Node a, Node b) {
    if (a.corner > b.corner) std::swap(a, b);  // along a path the corner numbers ascend
    std::uint32_t& known = vertex_[7 * a.grid + (a.corner ^ b.corner) - 1];
    if (known != kNone) return known;
    const double fa = value_[a.grid], fb = value_[b.grid];
    const double t = std::clamp(fa / (fa - fb), kKeepAway, 1 - kKeepAway);
    const Vec3 pa = position(corner_of(c, a.corner)), pb = position(corner_of(c, b.corner));
    mesh_.points.push_back(pa + t * (pb - pa));
    return known = static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  /// By one list: its elements are made in order, arguments are not, and crossings are numbered as they are
  /// made.
  void add(const std::array<std::uint32_t, 3>& triangle) { mesh_.triangles.push_back(triangle); }

  void add_quadrilateral(const std::array<std::uint32_t, 4>& q) {
    const auto length = [&](std::size_t i, std::size_t j) {
      return norm(mesh_.points[q[i]] - mesh_.points[q[j]]);
    };
    const std::size_t s = length(0, 2) <= length(1, 3) ? 0 : 1;
    add({q[s], q[s + 1], q[s + 2]});
    add({q[s], q[s + 2], q[(s + 3) % 4]});
  }

  Vec3 low_;
  double step_ = 0;
  Cell count_{};                       // cubes along each axis
  std::vector<double> value_;          // per grid vertex
  std::vector<std::uint32_t> vertex_;  // of the edge from grid vertex g in direction d, at 7 g + d - 1
  Surface mesh_;
};

}  // namespace

Surface implicit_solid(const std::function<double(const Vec3&)>& field, const Bounds& box,
                       std::uint32_t cells) {
  return MarchingTetrahedra(field, box, cells).run();
}

}  // namespace crossloft
