#include "interior_places.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "../geom/bounds.h"
#include "../geom/disjoint_sets.h"
#include "confidence.h"
#include "walls.h"
#include "prune.h"
#include "star.h"

namespace crossloft {
namespace {

/// Least volume of a tetrahedron that is divided, in parts of the hull's: smaller ones are many, and what the
/// solid loses with them is not missed.
constexpr double kLeastVolume = 0.002;

/// Ways are not looked for between more sets of sections than these: each takes a search of its own, and
/// where there are so many they are small against the cell. Real cells have a handful.
constexpr std::size_t kMostClasses = 64;

/// Sorted vertices in all of these, so that rounding does not depend on their order.
Vec3 centroid(const CellComplex& complex, const CellShape& shape, std::uint32_t t) {
  const auto v = sorted_vertices(complex.mesh, t);
  const auto& at = shape.points;
  return 0.25 * ((at[v[0]] + at[v[1]]) + (at[v[2]] + at[v[3]]));
}

Vec3 facet_centroid(const CellComplex& complex, const CellShape& shape, std::uint32_t t, unsigned facet) {
  const Triangle v = facet_vertices(complex.mesh, t, facet);
  const auto& at = shape.points;
  return 1.0 / 3 * ((at[v[0]] + at[v[1]]) + at[v[2]]);
}

double volume(const CellComplex& complex, const CellShape& shape, std::uint32_t t) {
  const auto v = sorted_vertices(complex.mesh, t);
  const auto& at = shape.points;
  const Vec3 a = at[v[1]] - at[v[0]], b = at[v[2]] - at[v[0]], c = at[v[3]] - at[v[0]];
  return std::fabs(dot(cross(a, b), c)) / 6;
}

/// By tetrahedron, in 2^-40 of the box around the cell: integers have the same sum in any order.
std::vector<std::int64_t> volumes(const CellComplex& complex, const CellShape& shape) {
  Bounds box;
  for (const Vec3& p : shape.points) box.add(p);
  const Vec3 size = box.high - box.low;
  std::vector<std::int64_t> list(complex.mesh.size(), 0);
  const double whole = size.x * size.y * size.z;
  if (!(whole > 0)) return list;  // thinner than a unit in the last place
  const double units = 0x1p40 / whole;
  for (std::uint32_t t = 0; t < list.size(); ++t)
    list[t] = static_cast<std::int64_t>(std::floor(volume(complex, shape, t) * units + 0.5));
  return list;
}

/// Ways between sections that R1 does not connect.
class LackingWays {
 public:
  LackingWays(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& r1)
      : complex_(complex), ground_(ground), r1_(r1), connected_(ground.size()) {
    connect();
  }

  bool any() const { return classes_.size() > 1 && classes_.size() <= kMostClasses; }

  /// From each class of sections but a largest one, which the others find; calls act(t, facet) for
  /// each tetrahedron on the way and the facet of it that leads on, kNone at the end.
  template <class Act>
  void find(ConfidenceMeter& meter, std::int32_t least, Act&& act) {
    if (!any()) return;
    for (const std::uint32_t start : classes_) {
      if (is_largest(start)) continue;
      const std::vector<std::uint32_t> way = way_from(start, meter, least);
      for (std::size_t i = 0; i < way.size(); ++i)
        act(way[i], i + 1 < way.size() ? facet_towards(complex_.mesh, way[i], way[i + 1]) : kNone);
    }
  }

 private:
  /// Sections that R1 connects are one class, by its smallest ground triangle. Once there is one no more is
  /// asked.
  void connect() {
    std::vector<std::uint32_t> from(r1_.size(), kNone), stack;
    std::uint32_t classes = ground_.part_count();
    const auto see = [&](std::uint32_t t, std::uint32_t part) {
      if (r1_[t] == 0) return;
      if (from[t] == kNone) {
        from[t] = part;
        stack.push_back(t);
      } else if (connected_.find(from[t]) != connected_.find(part)) {
        connected_.join(from[t], part);
        --classes;
      }
    };
    for (std::uint32_t g = 0; g < ground_.size(); ++g) {
      connected_.join(g, ground_.part(g));
      if (classes > 1) see(ground_.facet(g).tet, ground_.part(g));
    }
    while (classes > 1 && !stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (const std::uint32_t n : complex_.mesh.neighbours[t])
        if (n != kNone) see(n, from[t]);
    }
    size_.resize(ground_.size(), 0);
    for (std::uint32_t g = 0; g < ground_.size(); ++g) {
      if (connected_.is_root(g)) classes_.push_back(g);
      ++size_[connected_.find(g)];
    }
  }

  /// Whether t stands on a section of another class.
  bool is_at_another(std::uint32_t t, std::uint32_t start) {
    for (unsigned i = 0; i < 4; ++i)
      if (ground_.is_ground(t, i) && connected_.find(ground_.at(t, i)) != start) return true;
    return false;
  }

  /// Larger than all others: what does not depend on their numbers.
  bool is_largest(std::uint32_t start) const {
    return std::all_of(classes_.begin(), classes_.end(),
                       [&](std::uint32_t c) { return c == start || size_[c] < size_[start]; });
  }

  /// Equals by their sorted vertices.
  struct Step {
    std::int32_t confidence;
    TetName name;
    std::uint32_t tet;
    friend bool operator<(const Step& x, const Step& y) {
      return x.confidence != y.confidence ? x.confidence < y.confidence : x.name > y.name;
    }
  };

  /// Always to the most confident tetrahedron next to those seen: the way to where another class is met has
  /// the best bottleneck. From its end to its start; nothing if it is less sure than `least`.
  std::vector<std::uint32_t> way_from(std::uint32_t start, ConfidenceMeter& meter, std::int32_t least) {
    std::vector<std::uint32_t> parent(r1_.size(), kNone);
    std::priority_queue<Step> queue;
    const auto see = [&](std::uint32_t t, std::uint32_t from) {
      if (parent[t] != kNone) return;
      parent[t] = from;
      const std::int32_t confidence = meter.measure(t);
      if (confidence >= least) queue.push({confidence, sorted_vertices(complex_.mesh, t), t});
    };
    for (std::uint32_t g = 0; g < ground_.size(); ++g)
      if (connected_.find(g) == start) see(ground_.facet(g).tet, ground_.facet(g).tet);
    while (!queue.empty()) {
      const std::uint32_t t = queue.top().tet;
      queue.pop();
      if (is_at_another(t, start)) return way_back(t, parent);
      for (const std::uint32_t n : complex_.mesh.neighbours[t])
        if (n != kNone) see(n, t);
    }
    return {};
  }

  static std::vector<std::uint32_t> way_back(std::uint32_t t, std::span<const std::uint32_t> parent) {
    std::vector<std::uint32_t> way{t};
    while (parent[way.back()] != way.back()) way.push_back(parent[way.back()]);
    return way;
  }

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& r1_;
  DisjointSets connected_;              ///< ground triangles
  std::vector<std::uint32_t> classes_;  ///< roots
  std::vector<std::uint32_t> size_;     ///< by root
};

/// Large external tetrahedra.
std::vector<std::uint32_t> large_ones(const CellComplex& complex, const CellShape& shape,
                                      const std::vector<std::uint8_t>& r1) {
  const std::vector<std::int64_t> size = volumes(complex, shape);
  std::int64_t hull = 0;
  for (const std::int64_t v : size) hull += v;
  const double least = std::max(1.0, kLeastVolume * static_cast<double>(hull));
  std::vector<std::uint32_t> large;
  for (std::uint32_t t = 0; t < r1.size(); ++t)
    if (r1[t] == 0 && static_cast<double>(size[t]) >= least) large.push_back(t);
  return large;
}

/// Places where walls would be, but for external tetrahedra.
void divide_walls(const CellComplex& complex, const CellShape& shape, const std::vector<std::uint8_t>& r1,
                  ConfidenceMeter& meter, std::vector<Vec3>& places) {
  if (shape.memory != nullptr && shape.memory->has_walls) return;
  const Walls found = find_walls(complex, r1, as_integer(kWallConfidence),
                                 [&](std::uint32_t t) { return meter.measure(t); });
  const std::vector<std::uint32_t>& walls = found.lacking;
  if (shape.memory != nullptr) {
    shape.memory->hull_parts = found.hull_parts;
    shape.memory->has_walls = walls.empty();
  }
  std::vector<std::uint8_t> is_in(walls.empty() ? 0 : r1.size(), 0);
  for (const std::uint32_t t : walls) is_in[t] = 1;
  for (const std::uint32_t t : walls) {
    places.push_back(centroid(complex, shape, t));
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = complex.mesh.neighbours[t][i];
      if (n != kNone && n < t && is_in[n] != 0) places.push_back(facet_centroid(complex, shape, t, i));
    }
  }
}

}  // namespace

std::vector<Vec3> interior_places(const CellComplex& complex, const CellShape& shape, const Ground& ground,
                                  std::int32_t least) {
  const std::vector<std::uint8_t> r1 = without_external(complex);
  std::vector<std::uint32_t> large;
  if (!complex.has_interior_vertices()) large = large_ones(complex, shape, r1);
  LackingWays ways(complex, ground, r1);
  std::vector<Vec3> places;
  ConfidenceMeter meter(complex, ground, shape);
  divide_walls(complex, shape, r1, meter, places);
  for (const std::uint32_t t : large)
    if (meter.measure(t) >= 0) places.push_back(centroid(complex, shape, t));
  ways.find(meter, least, [&](std::uint32_t t, std::uint32_t facet) {
    if (r1[t] != 0) return;
    places.push_back(centroid(complex, shape, t));
    if (facet != kNone && r1[complex.mesh.neighbours[t][facet]] == 0)
      places.push_back(facet_centroid(complex, shape, t, facet));
  });
  return places;
}

}  // namespace crossloft
