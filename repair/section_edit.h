#pragma once
/// A section combined with patches or with other sections of its plane, in the terms of the file: vertices
/// and edges that stay are the same to the bit.

#include <cstdint>
#include <span>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "overlay.h"

namespace crossloft {

/// A part of the plane that becomes inside or outside: the inside, by even-odd, of a closed chain.
struct Patch {
  LayerKind kind = LayerKind::added;
  std::vector<Vec3> corners;
  std::vector<bool> fixed;  ///< [corner] its coordinates go into the section as they are
};

struct SectionEdit {
  bool changed = false;
  std::vector<std::uint32_t> contours;  ///< that lost edges or pieces of edges, ascending
  std::uint32_t borders = 0;            ///< edges between two materials that were left out
  Vec3 point;                           ///< one of the first place that changed
};

/// True iff exactly one side of the edge is outside.
inline bool is_wall(const ContourEdge& e) { return (e.material_a == 0) != (e.material_b == 0); }

/// By vertex: the edges that end there, those from a vertex to itself twice.
std::vector<std::vector<std::uint32_t>> edges_by_vertex(const PlaneSection& section);

/// Edges that name vertices of equal coordinates name the first of them.
void join_equal_vertices(PlaneSection& section);

/// Replaces the section by (section or added) and not removed, each by even-odd. `others` are sections of the
/// same plane to be united with it. Edges that stay whole keep their place, ends and materials; parts of
/// edges take over the material; new edges get that of the nearest wall and the contour kNone. Borders
/// between materials stay where they still end at other edges. Vertices are appended; none is taken away.
/// Points in one step of the chart become one vertex. Cancelled, it changes nothing.
SectionEdit edit_section(PlaneSection& section, const PlaneChart& chart, std::span<const Patch> patches,
                         std::span<const PlaneSection* const> others = {}, const Context& context = {});

/// Vertices that no edge names go, the others keep their order; contours are numbered by connected component
/// in order of first appearance.
void tidy_section(PlaneSection& section);

}  // namespace crossloft
