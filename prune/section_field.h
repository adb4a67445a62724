#pragma once
/// Signed distances around a cell, from the sections of all planes: what a smooth function is to go through.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "../geom/box_tree.h"
#include "cell_shape.h"
#include "section_rows.h"

namespace crossloft {

/// A point of a plane and its distance to the nearest contour: positive within the section, 0 on a contour.
struct FieldSample {
  Vec3 at;
  double distance = 0;
};

/// A plane with the pieces of its contours.
struct FieldPlane {
  FacePlane plane;
  std::vector<std::array<Vec3, 2>> contour;
};

/// All sections of a reconstruction in one unit of length, for any number of cells.
class SectionField {
 public:
  static constexpr std::size_t kMostSamples = 220;
  /// Samples are a ball's radius over this apart, or farther if there would be too many.
  static constexpr double kStepsPerRadius = 6;

  /// Everything in canonical order. O(n log n) for n pieces of contours.
  explicit SectionField(std::vector<FieldPlane> planes);

  /// Samples in a ball, kMostSamples at the most: on contours, then on a triangular grid in each plane, as
  /// dense as that allows and no closer to each other than about half of its step.
  /// O(k + m s) for each density that is tried, a few, and what of the sections is in a sample's row, for k
  /// planes, s samples and m pieces of contours in the ball's box.
  std::vector<FieldSample> samples(Vec3 centre, double radius) const;

 private:
  struct Grid;
  bool place(Grid& grid, std::span<const std::uint32_t> pieces) const;
  bool place_on_contours(Grid& grid, std::span<const std::uint32_t> pieces) const;
  bool place_on_plane(Grid& grid, std::uint32_t p) const;
  double distance_to_contours(Vec3 p) const;

  std::vector<FacePlane> planes_;
  std::vector<SectionRows> sections_;  ///< by plane
  std::vector<std::array<Vec3, 2>> pieces_;
  BoxTree tree_;  ///< of the pieces
};

/// A field that is made when it is first asked for: large stacks rarely have a join in doubt.
class LazySectionField {
 public:
  explicit LazySectionField(std::function<SectionField()> make) : make_(std::move(make)) {}
  /// On any thread.
  const SectionField& get() const {
    std::call_once(made_, [&] { field_.emplace(make_()); });
    return *field_;
  }

 private:
  std::function<SectionField()> make_;
  mutable std::once_flag made_;
  mutable std::optional<SectionField> field_;
};

}  // namespace crossloft
