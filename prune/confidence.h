#pragma once
/// How likely a tetrahedron is part of the solid, from distances alone: the nearest-point rule of Amini,
/// Boissonnat and Memari made soft. A point nearer to the sections than to the rest of the cell's boundary
/// would be inside by that rule.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "../geom/box_tree.h"
#include "cell_complex.h"
#include "cell_shape.h"
#include "section_rows.h"

namespace crossloft {

/// Confidences are integers, kCertain = 1: equal on every platform and in any order of summation.
inline constexpr std::int32_t kCertain = 1 << 20;
/// REQUIRES: -1..1.
inline std::int32_t as_integer(double confidence) {
  return static_cast<std::int32_t>(std::floor(confidence * kCertain + 0.5));
}

/// A confidence is not less than `low` and not more than `high`.
struct ConfidenceBounds {
  std::int32_t low = -kCertain, high = kCertain;
};

/// The contours of a cell, for points that may be far from any.
class ContourEdges {
 public:
  ContourEdges(const CellComplex& complex, const CellShape& shape);
  /// To the nearest one, if that is less than the bound. Expected O(log n).
  double squared_distance(Vec3 p, double bound) const;

 private:
  std::vector<std::array<Vec3, 2>> ends_;
  BoxTree tree_;
};

/// Confidences by the names of their tetrahedra.
class KnownConfidences {
 public:
  /// That of the name; where there is none yet, what measure() returns. Expected O(1).
  template <class Measure>
  std::int32_t get(const TetName& name, Measure measure) {
    if (2 * count_ >= entries_.size()) grow();
    Entry& entry = entries_[place_of(name)];
    if (entry.name != name) entry = {name, measure()}, ++count_;
    return entry.confidence;
  }

  /// Nothing if there is none yet.
  const std::int32_t* find(const TetName& name) const {
    if (entries_.empty()) return nullptr;
    const Entry& entry = entries_[place_of(name)];
    return entry.name == name ? &entry.confidence : nullptr;
  }

 private:
  struct Entry {
    TetName name{kNone, kNone, kNone, kNone};
    std::int32_t confidence = 0;
  };

  std::size_t place_of(const TetName& name) const;
  void grow();

  std::vector<Entry> entries_;  ///< a power of two, half of them free
  std::size_t count_ = 0;
};

/// What is the same for a cell however points inside divide it: its sections and contours, its hull, and the
/// confidences of tetrahedra that stay. REQUIRES: such points come after all vertices.
struct CellMemory {
  std::vector<SectionRows> sections;     ///< by face
  std::optional<ContourEdges> contours;  ///< once a tetrahedron has a vertex inside the cell
  KnownConfidences known;
  std::uint32_t hull_parts = kNone;  ///< outside (walls.h), once they have been counted
  bool has_walls = false;            ///< R1 lacked none, as far as is known
};

/// The mean over five points p of the tetrahedron (its centroid, 0.4, and the middles from there to its
/// vertices, 0.15 each) of (d_out - d_in) / (d_out + d_in), where d_in is the distance to the sections and
/// d_out that to the rest of the boundary: +kCertain on a section, -kCertain on the boundary outside.
///
/// Distances to faces are heights, told apart by whether the foot is in the section. Those to contours are
/// taken to the tetrahedron's own vertices and grounded edges: in a Delaunay triangulation of the contours
/// the nearest ones are there or not far away. Edges outside of sections, which R1 does not have, lower d_in:
/// external tetrahedra look surer than they are, and what divides them (interior_places.h) reckons with that.
class ConfidenceMeter {
 public:
  /// As section_rows(), if the memory of the shape has no sections yet. Without one it has its own.
  ConfidenceMeter(const CellComplex& complex, const Ground& ground, const CellShape& shape);
  ConfidenceMeter(const ConfidenceMeter&) = delete;
  ConfidenceMeter& operator=(const ConfidenceMeter&) = delete;

  /// O(faces), with a handful of questions to the sections; O(1) once it is known. Not by two threads at
  /// once.
  std::int32_t measure(std::uint32_t t);
  /// What the face nearest to the centroid says of it, a tenth of the work.
  ConfidenceBounds bounds(std::uint32_t t) const;

 private:
  struct NearFace {
    double height;
    std::uint32_t face;
  };

  Vec3 centroid_of(const TetName& v) const;
  std::int32_t measure_new(std::uint32_t t, const TetName& name);
  void find_near_faces(Vec3 centroid, double radius, double reach);

  const CellComplex& complex_;
  const CellShape& shape_;
  CellMemory own_;
  CellMemory& memory_;
  bool has_interior_ = false;  ///< some vertex is inside the cell
  double slack_ = 0;
  std::vector<NearFace> near_;  ///< of the tetrahedron that is measured
};

/// Of all tetrahedra; external ones (`wanted` 0) are left at -kCertain.
std::vector<std::int32_t> confidences(const CellComplex& complex, const CellShape& shape,
                                      const std::vector<std::uint8_t>& wanted);

}  // namespace crossloft
