#pragma once
/// Stacks of parallel planes that are too many to be held at once: sections are read as they are needed, and
/// the surface is handed on piece by piece.
///
/// What memory holds grows with the vertices of a few planes, not with the stack, but for the figures of each
/// plane and slab in the report. The stack is reconstructed in windows that overlap by a few planes, each
/// with the frame of the whole; two neighbours are joined at a plane at which they agree about every triangle
/// around every vertex, which is checked (README, "Streams").

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "reconstruct.h"

namespace crossloft {

/// Sections that are read when they are needed, some of them more than once.
class SectionSource {
 public:
  virtual ~SectionSource() = default;
  /// For messages, may be empty.
  virtual std::string name() const = 0;
  virtual std::uint32_t plane_count() const = 0;
  /// The plane at a position below plane_count(), the same each time.
  virtual Result<PlaneSection> read(std::uint32_t position) = 0;
};

/// Takes a surface piece by piece.
class SurfaceSink {
 public:
  virtual ~SurfaceSink() = default;
  /// Points are numbered on from those that came before, and triangles, counter-clockwise seen from outside,
  /// name any of them.
  virtual Result<Done> take(std::span<const Vec3> points,
                            std::span<const std::array<std::uint32_t, 3>> triangles) = 0;
};

struct StackOptions {
  Options options;
  /// Contour vertices of a window, but for its overlaps.
  std::uint64_t window_vertices = 100000;
};

/// As far as they can be told piece by piece, the figures of Report.
struct StackReport {
  double diagonal = 0;
  std::uint32_t windows = 0;  ///< that were reconstructed, also those that were united with others then
  /// From the lowest to the highest along their normal, its first component that is not 0 being positive.
  std::vector<PlaneReport> planes;
  std::vector<CellReport> cells;    ///< likewise
  TopologyReport topology;          ///< but for bridges and open edges
  std::uint64_t surface_vertices = 0, surface_triangles = 0, solid_tets = 0;
  /// Shells of the surface that enclose a volume above 0, and the others; handles of all of them together.
  std::uint64_t bodies = 0, cavities = 0, genus = 0;
  double volume = 0;  ///< that the surface encloses
  double section_area = 0, flat_area = 0;
  std::uint32_t flat_regions = 0, thickened_regions = 0;
  double displacement = 0, off_plane = 0;
  double seconds = 0;
  std::vector<std::string> notes, warnings;
};

/// Reconstructs a stack. The surface is the one that reconstruct() makes of all planes at once, in another
/// order of vertices and triangles, but that the second look (README) sees a window only: a cavity that is
/// higher than what two windows share may be left closed, and a chain of bodies of one plane each, as high,
/// may be joined along other tetrahedra.
///
/// The result depends on the planes, their order in the file and window_vertices, not on the threads. Errors:
/// usage for planes that are not parallel, with plane and line, and for options that ask all planes
/// (NaturalOptions::divide and look_around = all); those of the source and the sink; those of reconstruct().
/// Every plane is read twice, those between windows three times; once more each if it has contours that may
/// have no area, if the normal that frames fit may put it in another place (stack_planes.h), and for each
/// contour in a request to join; more often only where windows do not fit and are united. O(n log n) for n
/// vertices.
Result<StackReport> reconstruct_stack(SectionSource& source, SurfaceSink& sink,
                                      const StackOptions& options = {}, const Context& context = {});

}  // namespace crossloft
