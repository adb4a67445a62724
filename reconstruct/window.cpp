#include "window.h"

#include <algorithm>

#include "../geom/failing.h"
#include "pipeline.h"

namespace crossloft {

/// REQUIRES: parallel planes; a face of the cell is not on the box.
std::uint32_t Pipeline::slab_of(CellId id) const {
  const FaceId face = inner_faces(id).front();
  const std::uint32_t plane = arrangement_->plane_of(face).value;
  return arrangement_->cells_of(face)[1] == id ? plane + 1 : plane;
}

/// While there are cells: those of the report, and in triangle_slab, for now, the slab of each tetrahedron.
void Pipeline::note_slabs() {
  Window& window = *window_;
  window.slab_tets.assign(graph_.planes.size() + 1, 0);
  std::vector<std::uint32_t>& slabs = window.triangle_slab;
  std::vector<std::uint32_t> of_roofs;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    const CellState& cell = cells_[c];
    const std::size_t count = cell.tet_count + cell.bridge_tets.size(), roofs = cell.roof_tets.size();
    if (cell.report.tets_r0 == 0 && count + roofs == 0) continue;
    const std::uint32_t slab = slab_of(CellId{c});
    if (cell.report.tets_r0 != 0) window.cell_slab.push_back(slab);
    slabs.insert(slabs.end(), count, slab);
    of_roofs.insert(of_roofs.end(), roofs, slab);
    window.slab_tets[slab] += static_cast<std::uint32_t>(count + roofs);
  }
  slabs.insert(slabs.end(), of_roofs.begin(), of_roofs.end());
}

/// What the triangles and vertices of the surface have to do with planes and slabs.
void Pipeline::locate_surface() {
  Window& window = *window_;
  std::vector<std::uint32_t> slabs;
  slabs.reserve(glued_->tets.size());
  for (const std::uint32_t tet : glued_->tets) slabs.push_back(window.triangle_slab[tet]);
  window.triangle_slab = std::move(slabs);
  std::vector<std::uint32_t> plane(numbering_.points.size(), kNone);
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (const std::uint32_t v : numbering_.of_face[f]) plane[v] = faces_[f].plane;
  window.vertex_plane.reserve(glued_->vertices.size());
  for (const SurfaceVertex& v : glued_->vertices) {
    const bool is_between = v.is_midpoint() && plane[v.a] != plane[v.b];
    window.vertex_plane.push_back(is_between ? kNone : plane[v.a]);
  }
}

/// Of vertices of the surface; those in a plane count as in the slab above it, wherever a window ends.
std::vector<std::uint32_t> Pipeline::slabs_of(std::span<const std::uint32_t> vertices) const {
  std::vector<std::uint32_t> slabs;
  if (vertices.empty()) return slabs;
  const Window& window = *window_;
  std::vector<std::uint32_t> slab;
  for (const std::uint32_t plane : window.vertex_plane) slab.push_back(plane == kNone ? kNone : plane + 1);
  for (std::size_t t = 0; t < window.triangle_slab.size(); ++t)
    for (const std::uint32_t v : result_.surface.triangles[t])
      if (window.vertex_plane[v] == kNone) slab[v] = window.triangle_slab[t];
  for (const std::uint32_t v : vertices) slabs.push_back(slab[v]);
  return slabs;
}

Result<Reconstruction> Pipeline::run_window(Window& window) {
  window_ = &window;
  auto result = run();
  for (const FramedPlane& plane : framed_.planes) window.planes.push_back(plane.sources.front());
  window.framing_notes = std::move(framed_.notes);
  window.framing_warnings = std::move(framed_.warnings);
  return result;
}

Result<Window> reconstruct_window(const Sections& sections, const Options& options, const Context& context) {
  return or_out_of_memory([&]() -> Result<Window> {
    Window window;
    auto result = Pipeline(sections, options, context, nullptr).run_window(window);
    if (!result) {
      if (result.error().file.empty()) result.error().file = sections.source;
      return result.error();
    }
    window.surface = std::move(result->surface);
    window.report = std::move(result->report);
    return window;
  });
}

}  // namespace crossloft
