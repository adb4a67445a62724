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

/// Numbers (in `arcs`) of the arcs between two vertices a, a' that are neighbours on a contour, where the
/// cell of one of them within the section is connected and that of the other one is not. `sites` are all
/// sites and `arcs` all arcs of the face; `walls` are closed polygons, none if the section is the whole face,
/// or empty; `neighbours` are pairs a < a', sorted. On rounded coordinates: it steers samples and decides
/// nothing else. O((arcs + walls) log + pairs of boxes that meet).
std::vector<std::uint32_t> cutting_arcs(std::span<const NumberedSite> sites, std::span<const FaceArc> arcs,
                                        std::span<const DirectedWall> walls,
                                        std::span<const std::array<std::uint32_t, 2>> neighbours);

}  // namespace crossloft
