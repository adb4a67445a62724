#include "reconstruct.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "../arrangement/data_box.h"
#include "../prune/links.h"
#include "../prune/verify.h"
#include "assemble.h"
#include "branching.h"
#include "cell_builder.h"
#include "flats.h"
#include "numbering.h"
#include "observer.h"
#include "parallel.h"
#include "self_check.h"

namespace crossloft {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// What a cell leaves behind once it is pruned.
struct CellResult {
  std::vector<std::array<std::uint32_t, 4>> tets;  ///< kept, by final vertex numbers
  CellReport report;
  double delaunay_seconds = 0, pruning_seconds = 0;
  Error error;
  bool failed = false;
  BuiltCell built;       ///< only for an observer
  PruneResult pruned;
};

class Pipeline {
 public:
  Pipeline(const Sections& sections, const Options& options, const Context& context, Observer* observer)
      : sections_(sections), options_(options), context_(context), observer_(observer) {}
  Result<Reconstruction> run();

 private:
  Result<Done> check_input() const;
  Result<Done> frame();
  Result<Done> arrange();
  Result<Done> triangulate_faces();
  Result<Done> add_samples();
  Result<Done> refine_faces(std::span<const std::vector<LatticePoint>> samples);
  void finish_faces();
  Result<Done> prune_cells();
  Result<Done> glue_cells();
  std::vector<FaceId> inner_faces(CellId id) const;
  std::vector<CellFace> cell_faces(std::span<const FaceId> ids) const;
  Result<Done> branch(CellId id, CellBranching& branching);
  void prune_cell(CellId id, CellResult& result);
  void cover(CellId id, std::span<const FaceId> face_ids, const BuiltCell& cell, const PruneResult& pruned);
  void report_crossings();
  void explain_empty();
  Error cancelled() const { return make_error(ErrorCode::cancelled, "cancelled"); }
  void warn(std::string text) {
    context_.warn(text);
    result_.report.warnings.push_back(std::move(text));
  }

  const Sections& sections_;
  const Options& options_;
  const Context& context_;
  Observer* observer_;
  Stopwatch watch_;
  LatticePointStore store_;
  FramedSections framed_;
  std::unique_ptr<Arrangement> arrangement_;
  SectionGraph graph_;
  std::vector<FaceInput> inputs_;         ///< by face of the arrangement, like faces_
  std::vector<FaceTriangulation> faces_;
  std::vector<std::vector<WallEnds>> wall_ends_;  ///< what locators_ look at
  std::vector<SectionLocator> locators_;          ///< by plane
  std::unique_ptr<LineEdges> line_edges_;
  Numbering numbering_;
  std::vector<std::unique_ptr<CellTriangulation>> triangulations_;  ///< by cell; null until it is needed
  std::vector<std::array<std::uint32_t, 4>> tets_;
  Reconstruction result_;
};

/// Volumes and areas of coordinates beyond this would overflow a double.
constexpr double kLargestCoordinate = 1e100;

Result<Done> Pipeline::check_input() const {
  for (const double tolerance : {options_.match_tolerance, options_.on_tolerance})
    if (!(tolerance >= 0 && tolerance <= 1))
      return make_error(ErrorCode::usage, "a tolerance is a fraction of the diagonal, between 0 and 1");
  for (std::uint32_t p = 0; p < sections_.planes.size(); ++p)
    for (const Vec3& v : sections_.planes[p].vertices)
      if (std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}) > kLargestCoordinate && is_finite(v))
        return Error{ErrorCode::too_large, "a coordinate is beyond 1e100", {}, sections_.planes[p].line, p, kNone};
  return Done{};
}

Result<Done> Pipeline::frame() {
  if (auto good = check_input(); !good) return good.error();
  auto framed = frame_sections(sections_, options_.plane_tolerance, context_);
  if (!framed) return framed.error();
  framed_ = std::move(framed).value();
  Report& report = result_.report;
  report.diagonal = framed_.diagonal;
  report.notes = framed_.notes;
  report.warnings = framed_.warnings;
  for (const FramedPlane& plane : framed_.planes) {
    report.displacement = std::max(report.displacement, plane.displacement);
    report.off_plane = std::max(report.off_plane, plane.off_plane);
  }
  report.seconds.input = watch_.lap();
  return Done{};
}

void Pipeline::report_crossings() {
  Report& report = result_.report;
  const CrossingStatistics& s = graph_.statistics;
  report.on_line_vertices = s.on_line;
  report.crossings = s.crossings;
  report.matched_crossings = s.matched;
  report.largest_match_gap = s.largest_gap * framed_.grid.unit();
  report.disagreeing_vertices = s.disagreeing;
  report.merged_collinear = s.merged_collinear;
  for (const Mismatch& m : s.unmatched) {
    const Vec3 p = framed_.grid.from_lattice(m.point);
    report.unmatched.push_back({framed_.planes[m.plane].sources[0], framed_.planes[m.other].sources[0], p.x, p.y, p.z});
  }
  if (!report.unmatched.empty())
    warn(std::to_string(report.unmatched.size()) +
         " crossings of contours with other planes have no partner there: the sections disagree");
  if (s.disagreeing != 0)
    warn(std::to_string(s.disagreeing) + " common points of planes are inside one section and outside another");
}

Result<Done> Pipeline::arrange() {
  std::vector<LatticePlane> planes;
  for (const FramedPlane& plane : framed_.planes) planes.push_back(plane.plane);
  auto arrangement = build_arrangement(planes, data_box(framed_), store_, context_);
  if (!arrangement) return arrangement.error();
  arrangement_ = std::make_unique<Arrangement>(std::move(arrangement).value());
  if (auto good = self_check("arrangement", [&] { return arrangement_->verify(); }); !good) return good.error();
  Report& report = result_.report;
  report.arrangement_cells = arrangement_->cell_count();
  report.arrangement_faces = arrangement_->face_count();
  report.arrangement_vertices = arrangement_->vertex_count();
  report.seconds.arrangement = watch_.lap();
  const double unit = framed_.grid.unit();
  const CrossingTolerances tolerances{options_.on_tolerance * framed_.diagonal / unit,
                                      options_.match_tolerance * framed_.diagonal / unit};
  auto graph = build_section_graph(framed_, *arrangement_, store_, tolerances, context_);
  if (!graph) return graph.error();
  graph_ = std::move(graph).value();
  if (auto good = self_check("sections", [&] { return verify(graph_, *arrangement_); }); !good) return good.error();
  report_crossings();
  report.seconds.crossings = watch_.lap();
  if (observer_) observer_->on_sections(framed_, *arrangement_, graph_);
  return Done{};
}

Result<Done> Pipeline::triangulate_faces() {
  inputs_ = face_inputs(graph_, *arrangement_);
  wall_ends_.resize(graph_.planes.size());
  for (std::uint32_t p = 0; p < graph_.planes.size(); ++p) locators_.push_back(graph_.locator(p, wall_ends_[p]));
  faces_.resize(inputs_.size());
  std::vector<Error> errors(inputs_.size());
  const bool complete = parallel_for(inputs_.size(), context_, "faces", [&](std::size_t f) {
    const FaceId id{static_cast<std::uint32_t>(f)};
    if (arrangement_->on_box(id)) return;
    auto face = triangulate_face(graph_, *arrangement_, locators_[arrangement_->plane_of(id).value], inputs_[f]);
    if (face)
      faces_[f] = std::move(face).value();
    else
      errors[f] = face.error();
  });
  if (!complete) return cancelled();
  for (const Error& error : errors)
    if (!error.message.empty()) return error;
  numbering_ = number_vertices(graph_, faces_);
  result_.report.seconds.faces = watch_.lap();
  return Done{};
}

/// Faces are final: their edges on lines get their kinds, and the sections are what the faces say.
void Pipeline::finish_faces() {
  line_edges_ = std::make_unique<LineEdges>(graph_);
  for (const FaceTriangulation& face : faces_) line_edges_->add(face);
  line_edges_->finish();
  for (FaceTriangulation& face : faces_)
    for (FaceEdge& e : face.edges)
      if (e.b < face.vertices.size() && line_edges_->on_line(face.vertices[e.a], face.vertices[e.b]))
        e.kind = line_edges_->kind(face.vertices[e.a], face.vertices[e.b]);
  for (const FaceTriangulation& face : faces_) {
    result_.report.edge_splits += static_cast<std::uint32_t>(face.added.size()) - face.samples;
    result_.report.branching_samples += face.samples;
    result_.report.branching_faces += face.samples != 0;
  }
  if (observer_)
    for (const FaceTriangulation& face : faces_)
      if (face.face.valid()) observer_->on_face(face, numbering_);
  result_.sections = assemble_sections(framed_, graph_, *arrangement_, faces_, numbering_);
  result_.report.seconds.faces += watch_.lap();
}

std::vector<FaceId> Pipeline::inner_faces(CellId id) const {
  std::vector<FaceId> ids;
  for (const FaceId f : arrangement_->faces_of(id))
    if (!arrangement_->on_box(f)) ids.push_back(f);
  return ids;
}

std::vector<CellFace> Pipeline::cell_faces(std::span<const FaceId> ids) const {
  std::vector<CellFace> faces;
  for (const FaceId f : ids) faces.push_back({&faces_[f.value], numbering_.of_face[f.value]});
  return faces;
}

/// Samples of the branching diagrams of one cell; its triangulation is kept if it was made.
Result<Done> Pipeline::branch(CellId id, CellBranching& branching) {
  const std::vector<FaceId> ids = inner_faces(id);
  const std::vector<CellFace> faces = cell_faces(ids);
  if (!has_section(faces)) return Done{};
  BranchingCell cell(graph_, *arrangement_, locators_, id, ids, faces, numbering_.points, options_.branching);
  if (!cell.may_branch()) return Done{};
  auto triangulation = std::make_unique<CellTriangulation>(faces.size());
  if (auto done = triangulation->add(faces, numbering_.points); !done) return done.error();
  if (triangulation->dimension() == 3) branching = cell.run(*triangulation);
  triangulations_[id.value] = std::move(triangulation);
  return Done{};
}

Result<Done> Pipeline::add_samples() {
  triangulations_.resize(arrangement_->cell_count());
  if (options_.branching.mode == Branching::off) {
    finish_faces();
    return Done{};
  }
  std::vector<CellBranching> cells(triangulations_.size());
  std::vector<Error> errors(cells.size());
  const bool complete = parallel_for(cells.size(), context_, "branching", [&](std::size_t c) {
    if (auto done = branch(CellId{static_cast<std::uint32_t>(c)}, cells[c]); !done) errors[c] = done.error();
  });
  if (!complete) return cancelled();
  for (const Error& error : errors)
    if (!error.message.empty()) return error;
  std::vector<std::vector<LatticePoint>> samples(faces_.size());
  for (const CellBranching& cell : cells) {
    result_.report.seconds.branching += cell.seconds;
    for (const FaceBranching& face : cell.faces) {
      result_.report.branching_arcs += static_cast<std::uint32_t>(face.arcs.size());
      samples[face.face.value].insert(samples[face.face.value].end(), face.samples.begin(), face.samples.end());
    }
  }
  if (observer_)
    for (const CellBranching& cell : cells)
      for (const FaceBranching& face : cell.faces) observer_->on_branching(face, faces_[face.face.value], numbering_);
  watch_.lap();
  if (auto done = refine_faces(samples); !done) return done.error();
  finish_faces();
  return Done{};
}

/// Faces with samples are triangulated anew; what is there keeps its place in every order.
Result<Done> Pipeline::refine_faces(std::span<const std::vector<LatticePoint>> samples) {
  std::vector<Error> errors(faces_.size());
  const bool complete = parallel_for(faces_.size(), context_, "faces", [&](std::size_t f) {
    if (samples[f].empty()) return;
    const auto& locator = locators_[faces_[f].plane];
    auto face = refine_face(graph_, *arrangement_, locator, inputs_[f], faces_[f], distinct_samples(samples[f]));
    if (face)
      faces_[f] = std::move(face).value();
    else
      errors[f] = face.error();
  });
  if (!complete) return cancelled();
  for (const Error& error : errors)
    if (!error.message.empty()) return error;
  const Numbering before = std::move(numbering_);
  numbering_ = number_vertices(graph_, faces_);
  const std::vector<std::uint32_t> renumbered = renumbering(before, numbering_);
  for (const auto& triangulation : triangulations_)
    if (triangulation) triangulation->renumber(renumbered);
  return Done{};
}

/// Marks the section triangles that kept tetrahedra stand on; each cell has its own side of each face.
void Pipeline::cover(CellId id, std::span<const FaceId> face_ids, const BuiltCell& cell,
                     const PruneResult& pruned) {
  for (std::size_t t = 0; t < pruned.kept.size(); ++t)
    for (const GroundTriangle& ground : cell.ground[t]) {
      if (pruned.kept[t] == 0 || ground.face == kNone) continue;
      const FaceId face = face_ids[ground.face];
      const std::size_t side = arrangement_->cells_of(face)[0] == id ? 0 : 1;
      faces_[face.value].covered[side][ground.triangle] = 1;
    }
}

void Pipeline::prune_cell(CellId id, CellResult& result) {
  const std::vector<FaceId> face_ids = inner_faces(id);
  const std::vector<CellFace> faces = cell_faces(face_ids);
  if (!has_section(faces)) return;
  std::unique_ptr<CellTriangulation> triangulation = std::move(triangulations_[id.value]);
  if (!triangulation) triangulation = std::make_unique<CellTriangulation>(faces.size());
  const auto fail = [&](const Error& error) {
    result.error = error;
    result.failed = true;
  };
  if (auto done = triangulation->add(faces, numbering_.points); !done) return fail(done.error());
  auto built = build_cell(faces, *triangulation, *line_edges_, numbering_.graph_vertex);
  if (!built) return fail(built.error());
  triangulation.reset();
  BuiltCell& cell = *built;
  if (cell.complex.mesh.size() == 0) return;
  Stopwatch watch;
  PruneResult pruned = prune(cell.complex, options_.mode);
  const auto good = self_check("pruning", [&] {
    const bool may_fail = options_.mode == PruneMode::paper_literal;  // its Step 3 breaks solidity, as documented
    return verify(cell.complex) && (may_fail || verify(cell.complex, pruned)) ? "" : "a cell is not solid";
  });
  if (!good) return fail(good.error());
  CellReport& report = result.report;
  report.faces = static_cast<std::uint32_t>(faces.size());
  report.vertices = cell.complex.vertex_count;
  report.tets_r0 = pruned.r0, report.tets_r1 = pruned.r1, report.tets_r2 = pruned.r2, report.tets_r3 = pruned.r3;
  report.bad_links = census_links(cell.complex, pruned.kept).bad_links();
  result.pruning_seconds = watch.lap();
  result.delaunay_seconds = cell.delaunay_seconds;
  cover(id, face_ids, cell, pruned);
  for (std::size_t t = 0; t < pruned.kept.size(); ++t)
    if (pruned.kept[t] != 0) {
      std::array<std::uint32_t, 4> tet;
      for (std::size_t i = 0; i < 4; ++i) tet[i] = cell.vertices[cell.complex.mesh.vertices[t][i]];
      result.tets.push_back(tet);
    }
  if (observer_) result.built = std::move(cell), result.pruned = std::move(pruned);
}

Result<Done> Pipeline::prune_cells() {
  std::vector<CellResult> cells(arrangement_->cell_count());
  const bool complete = parallel_for(cells.size(), context_, "cells", [&](std::size_t c) {
    prune_cell(CellId{static_cast<std::uint32_t>(c)}, cells[c]);
  });
  if (!complete) return cancelled();
  Report& report = result_.report;
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    CellResult& cell = cells[c];
    if (cell.failed) return cell.error;
    if (cell.report.tets_r0 == 0) continue;
    report.cells.push_back(cell.report);
    report.bad_links += cell.report.bad_links;
    report.seconds.delaunay += cell.delaunay_seconds;
    report.seconds.pruning += cell.pruning_seconds;
    tets_.insert(tets_.end(), cell.tets.begin(), cell.tets.end());
    if (observer_) observer_->on_cell(CellId{c}, cell.built, cell.pruned);
  }
  watch_.lap();
  return Done{};
}

Result<Done> Pipeline::glue_cells() {
  result_.solid = assemble_solid(tets_, numbering_, framed_.grid);
  auto glued = glue(tets_);
  if (!glued) return glued.error();
  const auto good = self_check("gluing", [&] {
    const auto count = static_cast<std::uint32_t>(glued->vertices.size());
    return verify_surface(count, glued->triangles) ? "" : "the surface is not a manifold";
  });
  if (!good) return good.error();
  result_.surface = assemble_surface(*glued, numbering_, framed_.grid);
  if (observer_) observer_->on_solid(tets_, numbering_);
  Report& report = result_.report;
  report.pinched_vertices = glued->pinched_vertices;
  report.pinched_edges = glued->pinched_edges;
  report.split_edges = glued->split_edges;
  report.vertex_copies = glued->copies;
  report.solid_tets = static_cast<std::uint32_t>(result_.solid.tets.size());
  report.surface_triangles = static_cast<std::uint32_t>(result_.surface.triangles.size());
  report.surface_vertices = static_cast<std::uint32_t>(result_.surface.points.size());
  report.volume = enclosed_volume(result_.surface);
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
  report.seconds.gluing = watch_.lap();
  return Done{};
}

void Pipeline::explain_empty() {
  if (!result_.surface.triangles.empty()) {
    if (result_.report.flat_regions != 0)
      warn(std::to_string(result_.report.flat_regions) +
           " section regions stay bare on both sides: the solid does not contain them");
    return;
  }
  std::size_t filled = 0;
  for (const auto& walls : graph_.walls) filled += !walls.empty();
  if (filled == 0)
    warn("the surface is empty: no plane has a section");
  else if (filled == 1)
    warn("the surface is empty: only one plane has a section, so there is nothing to join it to");
  else
    warn("the surface is empty: no two sections face each other within one cell of the arrangement");
}

Result<Reconstruction> Pipeline::run() {
  Stopwatch total;
  Report& report = result_.report;
  report.mode = options_.mode == PruneMode::joint ? "joint" : options_.mode == PruneMode::paper ? "paper" : "paper-literal";
  if (auto done = frame(); !done) return done.error();
  if (!framed_.planes.empty())
    for (const auto step : {&Pipeline::arrange, &Pipeline::triangulate_faces, &Pipeline::add_samples, &Pipeline::prune_cells,
                            &Pipeline::glue_cells}) {
      if (context_.cancelled()) return cancelled();
      if (auto done = (this->*step)(); !done) return done.error();
    }
  explain_empty();
  report.seconds.total = total.lap();
  return std::move(result_);
}

}  // namespace

Result<Reconstruction> reconstruct(const Sections& sections, const Options& options, const Context& context,
                                   Observer* observer) {
  auto result = Pipeline(sections, options, context, observer).run();
  if (!result && result.error().file.empty()) result.error().file = sections.source;
  return result;
}

}  // namespace crossloft
