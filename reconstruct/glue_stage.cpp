/// The kept tetrahedra of all cells become one solid and its surface.

#include "pipeline.h"

#include "assemble.h"
#include "contacts.h"
#include "flats.h"
#include "mend.h"
#include "section_confinement.h"
#include "self_check.h"

namespace crossloft {
namespace {

/// Of moves that the user has asked for.
constexpr int kHalvings = 8, kRounds = 8;

/// Sections may change.
struct Anywhere : Confinement {
  bool may_move(const Umbrella&) const override { return true; }
  bool admit(const Umbrella&, Vec3&) const override { return true; }
};

}  // namespace

Result<Done> Pipeline::glue_cells() {
  result_.solid = assemble_solid(tets_, numbering_, framed_.grid);
  if (!glued_) {
    auto made = glue(tets_, context_);
    if (!made) return made.error();
    glued_ = std::make_unique<GluedSurface>(std::move(made).value());
  }
  const GluedSurface* const glued = glued_.get();
  const auto good = self_check("gluing", [&] {
    const auto count = static_cast<std::uint32_t>(glued->vertices.size());
    return verify_surface(count, glued->triangles) ? "" : "the surface is not a manifold";
  });
  if (!good) return good.error();
  result_.surface = assemble_surface(*glued, numbering_, framed_.grid);
  if (observer_) observer_->on_solid(tets_, numbering_);
  Report& report = result_.report;
  report.volume = enclosed_volume(result_.surface);
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
  report.seconds.gluing = watch_.lap();
  separate(*glued);
  if (context_.cancelled()) return cancelled();
  report.seconds.separating = watch_.lap();
  return Done{};
}

/// Vertices whose coordinates are not exact: points of lines, midpoints, and all where the grid is finer than
/// doubles.
std::vector<std::uint8_t> Pipeline::rounded_vertices(const GluedSurface& glued) const {
  std::vector<std::uint8_t> rounded;
  for (const SurfaceVertex& v : glued.vertices) {
    const bool exact = framed_.grid.exact() && !v.is_midpoint() && numbering_.points[v.a].is_explicit();
    rounded.push_back(exact ? 0 : 1);
  }
  return rounded;
}

void Pipeline::mend(const GluedSurface& glued) {
  Report& report = result_.report;
  const Mending mending = mend_crossings(result_.surface, glued.vertices, rounded_vertices(glued), context_);
  report.crossing_pairs = mending.found;
  report.crossing_pairs_left = mending.left;
  report.mended_vertices = mending.moved;
  report.mending = mending.largest;
  if (mending.left != 0)
    warn(std::to_string(mending.left) + " pairs of triangles cross after rounding and could not be mended");
}

/// Moves vertices of the surface alone: the solid keeps its points, and the report its volume.
void Pipeline::separate(const GluedSurface& glued) {
  Report& report = result_.report;
  report.touching_copies = glued.copies;
  if (glued.copies == 0) return;
  const auto take = [&](const Separation& separation) {
    report.separated_copies += separation.separated;
    report.touching_copies = separation.touching;
    report.separation = std::max(report.separation, separation.largest);
  };
  SeparationEffort effort;
  if (options_.separation > 0) effort.longest = options_.separation * framed_.diagonal;
  if (options_.separate)
    take(separate_copies(result_.surface, glued.vertices,
                         SectionConfinement(graph_, faces_, numbering_, framed_.grid, glued), effort,
                         context_));
  if (options_.separation == 0) return;
  effort.halvings = kHalvings, effort.rounds = kRounds;
  take(separate_copies(result_.surface, glued.vertices, Anywhere{}, effort, context_));
  if (context_.cancelled()) return;
  report.contacts = find_contacts(result_.surface).size();
  if (report.contacts != 0)
    warn(std::to_string(report.contacts) + " pairs of triangles touch: " +
         std::to_string(report.touching_copies) + " vertices could not be moved apart");
}

/// Section and flat area, plane by plane.
void Pipeline::report_planes() {
  Report& report = result_.report;
  const Flats flats = measure_flats(faces_, numbering_, framed_.grid, graph_.planes.size());
  report.flat_regions = flats.regions;
  for (std::size_t p = 0; p < flats.planes.size(); ++p) {
    const FramedPlane& plane = framed_.planes[p];
    PlaneReport out;
    out.plane = plane.sources[0];
    out.vertices = static_cast<std::uint32_t>(result_.sections.planes[p].vertices.size());
    out.edges = static_cast<std::uint32_t>(result_.sections.planes[p].edges.size());
    out.area = flats.planes[p].section;
    out.flat_area = flats.planes[p].flat;
    out.displacement = plane.displacement;
    out.off_plane = plane.off_plane;
    report.section_area += out.area;
    report.flat_area += out.flat_area;
    report.planes.push_back(out);
  }
}

}  // namespace crossloft
