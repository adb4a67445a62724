#pragma once
/// The surface of a stack, put together from its windows.

#include <array>
#include <cstdint>
#include <vector>

#include "seam.h"
#include "shells.h"
#include "stack.h"

namespace crossloft {

/// Takes windows from the lowest to the highest, of each the part between two planes at which it fits its
/// neighbours.
class Stitcher {
 public:
  /// Volumes are summed relative to `origin`.
  Stitcher(SurfaceSink& sink, Vec3 origin) : sink_(sink), origin_(origin) {}

  /// Hands on what is above plane `lower` and below plane `upper` of the window; kNone: up to its end.
  /// REQUIRES: `lower` is the `upper` of the last call. Errors: of the sink, too_large from 2^31 - 1 points
  /// on.
  Result<Done> take(const Window& window, std::uint32_t lower, std::uint32_t upper);

  std::uint64_t points() const { return points_; }
  std::uint64_t triangles() const { return triangles_; }
  Shells::Totals totals() { return shells_.totals(); }

 private:
  /// What is known of a vertex that is handed on, or was.
  struct Known {
    std::uint32_t number = kNone, shell = kNone;
  };
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Triangle> between(const Window& window, std::uint32_t lower, std::uint32_t upper) const;
  void count_shells(const Window& window, const std::vector<Triangle>& triangles,
                    const std::vector<std::uint32_t>& fresh, std::vector<Known>& known);

  SurfaceSink& sink_;
  Vec3 origin_;
  Shells shells_;
  std::vector<Known> seam_;  ///< by vertex of the plane up to which all has been taken
  std::uint64_t points_ = 0, triangles_ = 0;
};

}  // namespace crossloft
