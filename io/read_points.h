#pragma once
/// Reads points in space, with or without weights, from text, raw doubles and the vertices of surfaces.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../geom/result.h"
#include "../geom/vec3.h"
#include "../geom/weighted_point.h"

namespace crossloft {

/// A file with more points is refused: about 6.8 tetrahedra a point, as random points have, number 2^30
/// there.
inline constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 27;

/// The points of a file in its order, by its extension in any case: text (.txt .xyz .pts), raw little-endian
/// doubles (.f64), or the vertices of a surface (.off .ply), which needs no faces. A file without points is
/// good. Linear in the size; besides the result, text and surfaces are in memory whole, raw doubles are not.
/// Errors: usage (another extension), file_not_readable, syntax (with the line: a word, or not as many
/// numbers as a point has), truncated (raw doubles that are no whole points), not_finite, too_large
/// (kMostPoints), and those of read_surface.
Result<std::vector<Vec3>> read_points(const std::string& path);

/// The same with a weight, the fourth number of each point, in units of a squared length. Surfaces have no
/// weights: ErrorCode::usage.
Result<std::vector<WeightedPoint>> read_weighted_points(const std::string& path);

/// Parses lines of "x y z" and of "x y z w"; `name` is the file name used in messages. '#' starts a comment.
Result<std::vector<Vec3>> parse_points(std::string_view text, std::string name);
Result<std::vector<WeightedPoint>> parse_weighted_points(std::string_view text, std::string name);

}  // namespace crossloft
