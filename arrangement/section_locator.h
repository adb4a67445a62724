#pragma once
/// Exact even-odd tests against the contours of one plane.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "../geom/lattice.h"

namespace crossloft {

/// A wall as two point indices; the section is on exactly one side of it.
struct WallEnds {
  std::uint32_t a = 0, b = 0;
};

/// Answers where a point of the plane is relative to the section bounded by closed chains of walls.
///
/// A ray argument in exact arithmetic: the walls whose span contains the level of the point are counted on
/// one side of it. Level = projected coordinates in lexicographic order, that is, the ray direction is turned
/// by an infinitesimal angle, so that no wall is parallel to the ray and each wall owns its lower end only.
/// Walls are kept in strips of the second projected axis: a query costs the walls that cross its strip. Where
/// these are many on average there are strips of the first one, too, and the shorter one is asked.
class SectionLocator {
 public:
  using Pairs = std::vector<std::array<std::uint32_t, 2>>;
  enum class Place : std::uint8_t { outside, boundary, inside };

  /// Of no plane, to be assigned to.
  SectionLocator() = default;
  /// The spans must outlive the locator. REQUIRES: all points on `plane`; every point has an even number of
  /// walls.
  SectionLocator(const LatticePlane& plane, std::span<const LatticePoint> points,
                 std::span<const WallEnds> walls);

  /// Where p is; p on a wall or an end of one is boundary.
  Place locate(const LatticePoint& p) const;
  /// True iff the points of the segment from p towards q that are near p are inside. A wall along the segment
  /// does not count, but then the two sides differ: only use inside_left() for walls.
  bool inside_toward(const LatticePoint& p, const LatticePoint& q) const;
  /// True iff the section is on the left of wall w, looking from its a to its b from the side the normal
  /// points to. REQUIRES: no other wall crosses or overlaps w.
  bool inside_left(std::uint32_t w) const;

  /// All pairs of walls (first < second, sorted) that share a point which is not an end of both.
  Pairs conflicts() const;
  /// Pairs (wall, point), sorted, of a wall and an end of another wall that is not an end of it but within
  /// `tolerance` (in the units of the points) of its interior. Distances are rounded; meant for a few lattice
  /// steps.
  Pairs near_touches(double tolerance) const;

 private:
  struct Count {
    bool odd = false;      ///< parity of walls on the counted side
    bool on_wall = false;  ///< the point is on a wall
  };
  /// Of the rounded coordinates of a wall's ends. Rounding is monotone: what is apart here is apart.
  struct Box {
    double low = 0, high = 0;    ///< of the axis second_: levels
    double left = 0, right = 0;  ///< of first_

    bool meets(const Box& b) const {
      return low <= b.high && b.low <= high && left <= b.right && b.left <= right;
    }
    /// Up to a margin around it.
    bool holds(double at, double level, double margin) const {
      return level >= low - margin && level <= high + margin && at >= left - margin && at <= right + margin;
    }
  };
  /// The first and last strip of a wall.
  struct Strips {
    std::uint32_t first = 0, last = 0;
  };

  /// With strips of the second projected axis alone; swapped: of the first one.
  SectionLocator(const LatticePlane& plane, std::span<const LatticePoint> points,
                 std::span<const WallEnds> walls, bool swapped);
  void measure();
  void fill_strips(std::uint32_t strips);
  bool is_crowded() const;
  int compare_level(const LatticePoint& p, const LatticePoint& q) const;
  std::uint32_t strip_of(double level) const;
  std::span<const std::uint32_t> strip(std::uint32_t s) const {
    return {items_.data() + starts_[s], items_.data() + starts_[s + 1]};
  }
  std::span<const std::uint32_t> strip_at(const LatticePoint& p) const { return strip(strip_of(p[second_])); }
  bool asks_other(const LatticePoint& p) const {
    return other_ && other_->strip_at(p).size() < strip_at(p).size();
  }
  /// How many a search for conflicts of w meets.
  std::size_t walls_around(std::uint32_t w) const;
  /// Parity at p moved by an infinitesimal step towards q; wall `skip` is left out.
  Count count(const LatticePoint& p, const LatticePoint* toward, std::uint32_t skip) const;
  int side_of(std::uint32_t w, const LatticePoint& p) const;
  bool in_conflict(std::uint32_t v, std::uint32_t w) const;
  void find_conflicts(Pairs& found) const;
  void find_conflicts_of(std::uint32_t v, Pairs& found) const;
  void find_near_walls(std::uint32_t v, double tolerance, Pairs& found) const;
  bool overlap_on_line(std::uint32_t v, std::uint32_t w) const;
  bool near_interior(std::uint32_t w, std::uint32_t v, double tolerance) const;
  const LatticePoint& low(std::uint32_t w) const { return points_[ordered_[w].a]; }
  const LatticePoint& high(std::uint32_t w) const { return points_[ordered_[w].b]; }

  LatticePlane plane_;
  std::span<const LatticePoint> points_;
  std::span<const WallEnds> walls_;
  int first_ = 0, second_ = 1;     ///< projected axes; levels are second_, then first_
  int left_side_ = 1;              ///< of a wall followed upward: the sign of a point at less of first_
  std::vector<WallEnds> ordered_;  ///< walls with the lower level first
  std::vector<Box> boxes_;         ///< by wall
  std::vector<Strips> strips_;     ///< by wall
  double origin_ = 0, inverse_ = 0, last_strip_ = 0;
  std::vector<std::uint32_t> starts_, items_;
  std::unique_ptr<SectionLocator> other_;  ///< swapped, if strips are crowded
};

}  // namespace crossloft
