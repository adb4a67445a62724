#include "mend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "../geom/box_tree.h"
#include "../geom/triangle_meeting.h"
#include "close_pairs.h"
#include "lists.h"
#include "merge_places.h"

namespace crossloft {
namespace {

using Pair = std::array<std::uint32_t, 2>;

constexpr double kUlp = 0x1p-52;
constexpr double kLongest = 1e-6;  ///< of the diagonal: a step, where the last place is not coarser still
constexpr double kFewPlaces = 8;
/// Pairs of triangles asked for moves: at least so many, and so many for each that was asked to find what
/// crosses. Where thousands of needles run along one line, each move asks millions.
constexpr std::uint64_t kLeastEffort = 1U << 26;
constexpr std::uint64_t kEffort = 2;

class Mender {
 public:
  Mender(Surface& surface, std::span<const SurfaceVertex> origins, const Rounding& rounding,
         const Context& context)
      : surface_(surface),
        points_(surface.points),
        origins_(origins),
        rounded_(rounding.rounded),
        exact_(rounding.exact),
        context_(context) {}

  Mending run() {
    if (std::find(rounded_.begin(), rounded_.end(), std::uint8_t{1}) == rounded_.end()) return result_;
    std::vector<Pair> bad = find_bad();
    result_.found = result_.left = bad.size();
    if (bad.empty()) return result_;
    const std::vector<Vec3> written = points_;
    umbrellas_ = umbrellas_of(points_.size(), surface_.triangles);
    most_asked_ = asked_ + std::max(kLeastEffort, kEffort * asked_);
    const double place = last_place();
    const double longest = std::max(kLongest * bounds_of(points_).diagonal(), kFewPlaces * place);
    for (double reach = place; reach <= longest && goes_on(bad); reach *= 2)
      for (std::size_t before = bad.size() + 1; bad.size() < before && goes_on(bad);) {
        before = bad.size();
        mend(bad, reach);
        bad = find_bad();
      }
    result_.left = bad.size();
    if (!bad.empty() && !context_.cancelled())
      result_.merged = merge_crossing_places(surface_, std::move(bad), exact_, context_).merged;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (points_[v] == written[v]) continue;
      ++result_.moved;
      result_.largest = std::max(result_.largest, norm(points_[v] - written[v]));
    }
    return result_;
  }

 private:
  bool goes_on(const std::vector<Pair>& bad) const { return !bad.empty() && has_time(); }
  bool has_time() const { return asked_ < most_asked_ && !context_.cancelled(); }

  /// Of the largest coordinate; not 0.
  double last_place() const {
    double largest = 0x1p-1022;
    for (const Vec3& p : points_)
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    return kUlp * largest;
  }

  Corners corners(std::uint32_t t) const {
    const auto& c = surface_.triangles[t];
    return {points_[c[0]], points_[c[1]], points_[c[2]]};
  }
  bool is_suspect(std::uint32_t t) const {
    const auto& c = surface_.triangles[t];
    return rounded_[c[0]] != 0 || rounded_[c[1]] != 0 || rounded_[c[2]] != 0;
  }
  bool is_bad(std::uint32_t s, std::uint32_t t) const {
    return meeting(corners(s), corners(t)) != Meeting::none;
  }

  /// Pairs with a suspect triangle that cross or overlap, ascending; some of them if cancelled.
  std::vector<Pair> find_bad() const {
    std::vector<std::uint8_t> suspect;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) suspect.push_back(is_suspect(t) ? 1 : 0);
    std::vector<Pair> bad;
    for_close_pairs(surface_, suspect, SameCorner::place, context_.cancel,
                    [&](std::uint32_t s, std::uint32_t t) {
                      ++asked_;
                      if (is_bad(s, t)) bad.push_back({std::min(s, t), std::max(s, t)});
                    });
    std::sort(bad.begin(), bad.end());
    return bad;
  }

  /// Boxes with room for moves by `reach` of each corner.
  BoxTree roomy_tree(double reach) const {
    const Vec3 room{reach, reach, reach};
    std::vector<Bounds> boxes;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      const Bounds b = bounds_of(corners(t));
      boxes.push_back({b.low - room, b.high + room});
    }
    return BoxTree(boxes);
  }

  void mend(const std::vector<Pair>& bad, double reach) {
    const BoxTree tree = roomy_tree(4 * reach);
    std::vector<std::uint32_t> vertices;
    for (const Pair& pair : bad)
      for (const std::uint32_t t : pair)
        for (const std::uint32_t v : surface_.triangles[t])
          if (rounded_[v] != 0) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (const std::uint32_t v : vertices) {
      if (!has_time()) return;
      const std::vector<std::uint32_t> copies = copies_of(v);
      if (!improve(tree, copies, reach) && copies.size() > 1) improve(tree, {v}, reach);
    }
  }

  /// All vertices of v's origin that are still at its place.
  std::vector<std::uint32_t> copies_of(std::uint32_t v) const {
    std::uint32_t first = v;
    while (first > 0 && origins_[first - 1] == origins_[v]) --first;
    std::vector<std::uint32_t> copies;
    for (; first < origins_.size() && origins_[first] == origins_[v]; ++first)
      if (points_[first] == points_[v]) copies.push_back(first);
    return copies;
  }

  /// Moves the vertices, all at one place, to the best of 26 places around; false if none is better than
  /// theirs.
  bool improve(const BoxTree& tree, const std::vector<std::uint32_t>& vertices, double reach) {
    std::vector<std::uint32_t> around;
    for (const std::uint32_t v : vertices)
      around.insert(around.end(), umbrellas_.of(v).begin(), umbrellas_.of(v).end());
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    const Vec3 from = points_[vertices[0]];
    Vec3 best = from;
    std::size_t least = count_bad(tree, around, kAll);
    if (least == 0) return true;
    for (int i = 0; i < 27 && least != 0; ++i) {
      const Vec3 to = from + reach * Vec3{double(i % 3 - 1), double(i / 3 % 3 - 1), double(i / 9 - 1)};
      put(vertices, to);
      const std::size_t found = count_bad(tree, around, least);
      if (found < least) least = found, best = to;
    }
    put(vertices, best);
    return !(best == from);
  }

  void put(const std::vector<std::uint32_t>& vertices, const Vec3& place) {
    for (const std::uint32_t v : vertices) points_[v] = place;
  }

  static constexpr std::size_t kAll = static_cast<std::size_t>(-1);

  /// Bad pairs with one of the triangles (ascending), and triangles of them without area; `enough` if there
  /// are as many.
  std::size_t count_bad(const BoxTree& tree, const std::vector<std::uint32_t>& around,
                        std::size_t enough) const {
    std::size_t count = 0;
    for (const std::uint32_t t : around) {
      if (count >= enough) return enough;
      count += collinear(corners(t)) ? 1U : 0U;
      tree.for_overlaps(bounds_of(corners(t)), [&](std::uint32_t s) {
        if (s == t || (s < t && std::binary_search(around.begin(), around.end(), s))) return;
        ++asked_;  // of all that meet, in whatever order, so that the effort is the same everywhere
        if (count < enough) count += is_bad(s, t) ? 1U : 0U;
      });
    }
    return count;
  }

  Surface& surface_;
  std::vector<Vec3>& points_;
  std::span<const SurfaceVertex> origins_;
  std::span<const std::uint8_t> rounded_, exact_;
  const Context& context_;
  Lists umbrellas_;                  ///< by vertex
  mutable std::uint64_t asked_ = 0;  ///< pairs of triangles whose boxes meet
  std::uint64_t most_asked_ = 0;
  Mending result_;
};

}  // namespace

Mending mend_crossings(Surface& surface, std::span<const SurfaceVertex> origins, const Rounding& rounding,
                       const Context& context) {
  return Mender(surface, origins, rounding, context).run();
}

}  // namespace crossloft
