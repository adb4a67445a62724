#pragma once
/// The cutting locus of a face: where the fibres of a contour vertex come apart (paper, section 2, Figure 4e
/// and f).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/vec2.h"
#include "face_diagram.h"

namespace crossloft {

/// A side of the section's border in the face's frame, the section on its left.
struct DirectedWall {
  Vec2 from, to;
};

/// A site of a face's diagram with the vertex that it is.
struct NumberedSite {
  std::uint32_t vertex = kNone;
  FaceSite site;
};

/// In how many pieces the section cuts the cell of each site, in step with `sites`. `sites` are all sites and
/// `arcs` all arcs of the face that the section meets; `walls` are closed polygons, the border of the section
/// also where that is the border of the face. On rounded coordinates: pieces too small to matter for samples
/// may be missed. O(arcs * walls).
std::vector<std::uint32_t> pieces_in_section(std::span<const NumberedSite> sites,
                                             std::span<const FaceArc> arcs,
                                             std::span<const DirectedWall> walls);

/// Numbers (in `arcs`) of the arcs, partly within the section, between two vertices a, a' that are neighbours
/// on a contour, where the cell of one of them within the section is connected and that of the other one is
/// not. `neighbours` are pairs a < a', sorted; the rest as above.
std::vector<std::uint32_t> cutting_arcs(std::span<const NumberedSite> sites, std::span<const FaceArc> arcs,
                                        std::span<const DirectedWall> walls,
                                        std::span<const std::array<std::uint32_t, 2>> neighbours);

}  // namespace crossloft
