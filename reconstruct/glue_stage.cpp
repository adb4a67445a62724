/// The kept tetrahedra of all cells become one solid and its surface.

#include "pipeline.h"

#include <algorithm>

#include "assemble.h"
#include "contacts.h"
#include "flats.h"
#include "mend.h"
#include "messages.h"
#include "resize.h"
#include "section_confinement.h"
#include "self_check.h"
#include "window.h"

namespace crossloft {
namespace {

/// Of moves that the user has asked for.
constexpr int kHalvings = 8, kRounds = 8;
constexpr std::uint32_t kMostAround = 1U << 14;

/// Sections may change.
struct Anywhere : Confinement {
  bool may_move(const Umbrella&) const override { return true; }
  bool admit(const Umbrella&, Vec3&) const override { return true; }
};

}  // namespace

/// Places of all tetrahedra: of each cell, then of its bridges, which are loose.
SolidInCells Pipeline::make_room() {
  SolidInCells solid;
  std::uint32_t next = 0;
  for (CellState& cell : cells_) {
    cell.first_tet = next;
    cell.tet_count = static_cast<std::uint32_t>(cell.tets.size());
    next += cell.tet_count;
    for (std::size_t k = 0; k < cell.bridge_tets.size(); ++k) solid.known.loose.push_back(next++);
  }
  resize(solid.tets, next, context_);
  solid.known.partner.resize(4 * std::size_t{next});
  return solid;
}

/// Two cells meet in the triangles of their common face, each of which has a facet on either side: the cell
/// that comes first leaves word which one is its. Cells keep what they know of their facets, and where their
/// tetrahedra are: they may have to have them back.
SolidInCells Pipeline::take_solid() {
  SolidInCells solid = make_room();
  std::size_t triangles = 0;
  std::vector<std::size_t> begin;  // by face: number of its first triangle
  for (const FaceTriangulation& face : faces_) {
    begin.push_back(triangles);
    triangles += face.triangles.size();
  }
  std::vector<std::uint32_t> first(triangles, kNone);  // by triangle: the facet on it in the first cell
  const auto for_feet = [&](std::uint32_t c, bool in_first, const auto& use) {
    const CellState& cell = cells_[c];
    const std::vector<FaceId> ids = inner_faces(CellId{c});
    for (std::size_t i = 0; i < cell.feet.size(); ++i) {
      const FaceId face = ids[cell.ground[i].face];
      const auto& cells = arrangement_->cells_of(face);
      if ((std::min(cells[0].value, cells[1].value) == c) == in_first)
        use(first[begin[face.value] + cell.ground[i].triangle], 4 * cell.first_tet + cell.feet[i]);
    }
  };
  parallel_for(cells_.size(), context_, "gluing", [&](std::size_t c) {
    cells_[c].move_to(solid);
    for_feet(static_cast<std::uint32_t>(c), true,
             [](std::uint32_t& other, std::uint32_t here) { other = here; });
  });
  parallel_for(cells_.size(), context_, "gluing", [&](std::size_t c) {
    for_feet(static_cast<std::uint32_t>(c), false, [&](std::uint32_t other, std::uint32_t here) {
      if (other != kNone) solid.known.partner[here] = other, solid.known.partner[other] = here;
    });
  });
  return solid;
}

/// With its bridges. Facets on faces are left to the solid.
void CellState::move_to(SolidInCells& solid) {
  const auto to = std::copy(tets.begin(), tets.end(), solid.tets.begin() + first_tet);
  std::copy(bridge_tets.begin(), bridge_tets.end(), to);
  tets = {};
  const std::uint32_t base = 4 * first_tet;
  std::uint32_t* partner = solid.known.partner.data() + base;
  for (const auto& facets : partners)
    for (const std::uint32_t f : facets) *partner++ = f == kNone ? kNone : base + f;
  std::fill_n(partner, 4 * bridge_tets.size(), kNone);
}

/// Cells that have been pruned again have theirs already.
void Pipeline::give_tets_back() {
  if (tets_.empty()) return;
  for (CellState& cell : cells_) {
    const auto first = tets_.begin() + cell.first_tet;
    if (cell.tets.empty()) cell.tets.assign(first, first + cell.tet_count);
  }
  tets_ = {};
}

Result<Done> Pipeline::glue_cells() {
  if (!glued_) {
    auto made = glue(tets_, std::move(known_), context_, window_ != nullptr);
    if (!made) return made.error();
    glued_ = std::make_unique<GluedSurface>(std::move(made).value());
  }
  if (window_) locate_surface();
  // Another order: what was known of their facets is of no use from here on.
  sort_tets(tets_, numbering_.points.size(), context_);
  if (context_.cancelled()) return cancelled();
  if (observer_) observer_->on_solid(tets_, numbering_);
  result_.solid = assemble_solid(std::move(tets_), numbering_, framed_.grid, context_);
  if (context_.cancelled()) return cancelled();
  const GluedSurface* const glued = glued_.get();
  const auto good = self_check("gluing", [&] {
    const auto count = static_cast<std::uint32_t>(glued->vertices.size());
    return verify_surface(count, glued->triangles) ? "" : "the surface is not a manifold";
  });
  if (!good) return good.error();
  result_.surface = assemble_surface(*glued_, numbering_, framed_.grid, context_);
  if (context_.cancelled()) return cancelled();
  Report& report = result_.report;
  // Where all of the solid is thinner than doubles tell it may come out negative.
  report.volume = std::max(0.0, enclosed_volume(result_.surface, context_));
  mend(*glued);
  if (context_.cancelled()) return cancelled();
  report.pinched_vertices = glued->pinched_vertices;
  report.pinched_edges = glued->pinched_edges;
  report.split_edges = glued->split_edges;
  report.vertex_copies = glued->copies;
  report.solid_tets = static_cast<std::uint32_t>(result_.solid.tets.size());
  report.surface_triangles = static_cast<std::uint32_t>(result_.surface.triangles.size());
  report.surface_vertices = static_cast<std::uint32_t>(result_.surface.points.size());
  report_planes();
  if (context_.cancelled()) return cancelled();
  report.seconds.gluing = watch_.lap();
  separate(*glued);
  if (context_.cancelled()) return cancelled();
  report.seconds.separating = watch_.lap();
  return Done{};
}

/// Rounded may be points of lines, midpoints, and all where the grid is finer than doubles; exact are those
/// points of planes whose doubles are their very places.
Rounding Pipeline::rounding(const GluedSurface& glued) const {
  const bool all = framed_.grid.exact();
  const std::size_t count = glued.vertices.size();
  Rounding rounding{std::vector<std::uint8_t>(count), std::vector<std::uint8_t>(count)};
  for_blocks(count, context_, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const SurfaceVertex& v = glued.vertices[i];
      const bool is_explicit = !v.is_midpoint() && numbering_.points[v.a].is_explicit();
      rounding.rounded[i] = is_explicit && all ? 0 : 1;
      rounding.exact[i] = is_explicit && framed_.grid.exact_at(numbering_.points[v.a]) ? 1 : 0;
    }
  });
  return rounding;
}

void Pipeline::mend(const GluedSurface& glued) {
  Report& report = result_.report;
  const Mending mending = mend_crossings(result_.surface, glued.vertices, rounding(glued), context_);
  report.crossing_pairs = mending.found;
  report.crossing_pairs_left = mending.left;
  report.mended_vertices = mending.moved;
  report.merged_vertices = mending.merged;
  report.mending = mending.largest;
  if (mending.merged != 0) warn(tell_merged(mending.merged));
}

/// Moves vertices of the surface alone: the solid keeps its points, and the report its volume.
void Pipeline::separate(const GluedSurface& glued) {
  Report& report = result_.report;
  report.touching_copies = glued.copies;
  if (glued.copies == 0) return;
  Separation last;
  const auto take = [&](Separation separation) {
    report.separated_copies += separation.separated;
    report.touching_copies = static_cast<std::uint32_t>(separation.touching.size());
    report.separation = std::max(report.separation, separation.largest);
    last = std::move(separation);
  };
  SeparationEffort effort;
  if (options_.separation > 0) effort.longest = options_.separation * framed_.diagonal;
  if (options_.separate)
    take(separate_copies(result_.surface, glued.vertices,
                         SectionConfinement(graph_, faces_, numbering_, framed_.grid, glued), effort,
                         context_));
  const auto tell_of_crowded = [&] {
    if (!last.crowded.empty()) warn(tell_crowded(last.crowded.size()));
    if (window_) window_->crowded_slab = slabs_of(last.crowded);
  };
  if (options_.separation == 0) return tell_of_crowded();
  effort.halvings = kHalvings, effort.rounds = kRounds, effort.most_around = kMostAround;
  take(separate_copies(result_.surface, glued.vertices, Anywhere{}, effort, context_));
  if (context_.cancelled()) return;
  tell_of_crowded();
  const auto contacts = find_contacts(result_.surface, context_);
  if (context_.cancelled()) return;
  report.contacts = contacts.size();
  if (window_) window_->touching_slab = slabs_of(last.touching);
  if (window_)
    for (const auto& [a, b] : contacts)
      window_->contact_slab.push_back(std::min(window_->triangle_slab[a], window_->triangle_slab[b]));
  if (report.contacts != 0) warn(tell_contacts(report.contacts, report.touching_copies));
}

/// Section and flat area, plane by plane.
void Pipeline::report_planes() {
  Report& report = result_.report;
  const std::size_t planes = graph_.planes.size();
  const auto areas = measure_flats(faces_, numbering_, framed_.grid, planes, context_);
  const auto is_flat = [&](std::size_t f, std::size_t t) { return faces_[f].is_flat(t); };
  const auto flat = count_regions(faces_, numbering_, planes, is_flat, context_);
  for (std::size_t p = 0; p < planes; ++p) {
    const FramedPlane& plane = framed_.planes[p];
    PlaneReport out;
    out.plane = plane.sources[0];
    out.vertices = static_cast<std::uint32_t>(result_.sections.planes[p].vertices.size());
    out.edges = static_cast<std::uint32_t>(result_.sections.planes[p].edges.size());
    out.area = areas[p].section;
    out.flat_area = areas[p].flat;
    out.flat_regions = flat[p];
    if (!thickened_.empty()) out.thickened_regions = thickened_[p];
    out.displacement = plane.displacement;
    out.off_plane = plane.off_plane;
    report.section_area += out.area;
    report.flat_area += out.flat_area;
    report.flat_regions += out.flat_regions;
    report.thickened_regions += out.thickened_regions;
    report.planes.push_back(out);
  }
}

}  // namespace crossloft
