#pragma once
/// Which pieces of a solid's surface there are in each cell, from the mesh that was cut.

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "../inspect/slice.h"

namespace crossloft::bench {

/// Numbers for places; what is nearer than `tolerance` to an earlier place has its number.
class Places {
 public:
  explicit Places(double tolerance) : tolerance_(tolerance) {}
  /// kNone if there is none.
  std::uint32_t find(Vec3 p) const;
  std::uint32_t add(Vec3 p);
  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }

 private:
  using Box = std::array<std::int64_t, 3>;
  Box box_of(Vec3 p) const;

  double tolerance_;
  std::vector<Vec3> points_;
  std::map<Box, std::vector<std::uint32_t>> boxes_;
};

/// The mesh, parted by the planes. Two contours of a cell that are on one piece of it bound one body there.
class CellTruth {
 public:
  /// O(n k) for n triangles and k planes, and a piece for each cell that a triangle is in.
  CellTruth(const Surface& mesh, std::vector<CuttingPlane> planes);

  /// A cell by the sides of the planes that it is on.
  using Sides = std::vector<bool>;
  Sides sides_of(Vec3 p) const;
  /// The piece of a cell's surface that a contour vertex is on; kNone if it is on none.
  std::uint32_t piece_at(const Sides& cell, Vec3 contour_vertex) const;

 private:
  using Polygon = std::vector<Vec3>;
  void part(Polygon polygon, Sides& sides);

  std::vector<CuttingPlane> planes_;
  Places places_;
  std::map<Sides, std::vector<std::array<std::uint32_t, 2>>> joined_;  ///< neighbours on a piece, by place
  std::map<Sides, std::vector<std::array<std::uint32_t, 2>>> pieces_;  ///< places, ascending, and pieces
};

}  // namespace crossloft::bench
