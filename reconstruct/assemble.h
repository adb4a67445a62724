#pragma once
/// From kept tetrahedra and contours by vertex number to the results in input units.

#include <array>
#include <span>

#include "../arrangement/framed_sections.h"
#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "glue.h"
#include "numbering.h"
#include "surface.h"

namespace crossloft {

/// Into their canonical order, each with its smallest vertex first and the second smallest next; orientations
/// stay. O(n log k) for k tetrahedra of one vertex. Of no use if the context has been cancelled.
void sort_tets(std::span<std::array<std::uint32_t, 4>> tets, std::size_t vertices, const Context& context);
/// Numbers the vertices that the tetrahedra use. REQUIRES: tetrahedra sorted. This and what follows are of no
/// use either if the context has been cancelled.
Solid assemble_solid(std::vector<std::array<std::uint32_t, 4>> tets, const Numbering& numbering,
                     const WorldGrid& grid, const Context& context);
/// Takes the triangles away if there are no copies: what separates copies asks for them.
Surface assemble_surface(GluedSurface& glued, const Numbering& numbering, const WorldGrid& grid,
                         const Context& context);
/// The sections as the solid meets them: snapped, merged, split; planes in canonical order with unit normals.
Sections assemble_sections(const FramedSections& framed, const SectionGraph& graph,
                           std::span<const FaceTriangulation> faces, const Numbering& numbering,
                           const Context& context);
/// Enclosed volume, summed relative to the first vertex.
double enclosed_volume(const Surface& surface, const Context& context);

}  // namespace crossloft
