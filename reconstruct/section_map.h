#pragma once
/// The section on one face in rounded plane coordinates: what branching samples are placed by. What is
/// decided here is where to look; that a sample is inside is tested exactly afterwards.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/ids.h"
#include "../geom/vec2.h"
#include "../moebius/arc_sampling.h"
#include "face_triangulation.h"

namespace crossloft {

/// Internal triangles and the edges that bound them, in strips of y.
class SectionMap {
 public:
  /// `points`: plane coordinates by local vertex of the face; mirrored if seen from the negative side of its
  /// plane.
  SectionMap(const FaceTriangulation& face, std::vector<Vec2> points, bool mirrored);

  bool empty() const { return triangles_.empty(); }
  /// The internal triangle of the face that holds a, kNone outside the section. O(sqrt n) expected.
  std::uint32_t triangle_at(Vec2 a) const;
  /// Square of the distance from a to the border of the section, `limit` if that is smaller.
  double squared_distance_to_border(Vec2 a, double limit) const;
  /// Calls act(a, b, length) for each edge of the section's border, local vertices of the face, the section
  /// on the left.
  template <class Act>
  void for_each_border_edge(Act&& act) const {
    for (const auto& [a, b] : border_)
      act(a, b, std::sqrt(dot(points_[b] - points_[a], points_[b] - points_[a])));
  }
  /// Plane coordinates of a local vertex of the face.
  Vec2 point(std::uint32_t v) const { return points_[v]; }
  /// Around the section; low > high if that is empty.
  Box2 box() const { return box_; }

 private:
  /// Items in strips: those of strip s are items[begin[s] .. begin[s + 1]).
  struct Strips {
    std::vector<std::uint32_t> begin, items;
  };
  std::uint32_t strip_of(double y) const;
  template <class Range>
  Strips sort_into_strips(std::size_t count, Range&& range) const;

  std::vector<Vec2> points_;
  std::vector<std::uint32_t> numbers_;                   ///< of the internal triangles in the face
  std::vector<std::array<std::uint32_t, 3>> triangles_;  ///< the internal ones, counter-clockwise
  std::vector<std::array<std::uint32_t, 2>> border_;     ///< the section on the left of a -> b
  Box2 box_{{1, 1}, {0, 0}};
  double per_height_ = 0;
  std::uint32_t strip_count_ = 1;
  Strips triangle_strips_, border_strips_;
};

/// Square of the distance from a to the segment pq.
double squared_distance(Vec2 a, Vec2 p, Vec2 q);

}  // namespace crossloft
