#include "reconstruct.h"

#include <algorithm>

#include "../arrangement/normalise.h"
#include "../geom/failing.h"
#include "messages.h"
#include "pipeline.h"
#include "pruning_input.h"
#include "self_check.h"
#include "window.h"

namespace crossloft {
namespace {

Result<Done> check_natural(const NaturalOptions& options) {
  for (const double confidence : {options.join_confidence, options.dome_confidence, options.alone_confidence,
                                  options.cavity_confidence})
    if (!(confidence >= -1 && confidence <= 1))
      return make_error(ErrorCode::usage, "a confidence is between -1 and 1");
  if (!(options.smooth_weight >= 0 && options.smooth_weight <= kLargestSmoothWeight))
    return make_error(ErrorCode::usage, "the weight of smoothness is between 0 and 1e9");
  return Done{};
}

/// No numbers that were made into choices.
bool are_choices(const Options& options) {
  return options.mode <= PruneMode::paper_literal && options.branching.mode <= Branching::all &&
         options.natural.divide <= InCells::all && options.natural.look_around <= InCells::all;
}

}  // namespace

Result<Done> check_options(const Options& options) {
  for (const double tolerance :
       {options.match_tolerance, options.on_tolerance, options.simplify, options.thicken, options.separation})
    if (!(tolerance >= 0 && tolerance <= 1))
      return make_error(ErrorCode::usage, "a tolerance is a fraction of the diagonal, between 0 and 1");
  if (auto good = check_plane_tolerance(options.plane_tolerance); !good) return good;
  if (!are_choices(options)) return make_error(ErrorCode::usage, "an option has none of its values");
  if (auto good = check_against_each_other(options.joins); !good) return good;
  return check_natural(options.natural);
}

/// A window has all requests of the stack, which has checked them: also those that name planes elsewhere.
Result<Done> Pipeline::check_joins() const {
  if (window_) return Done{};
  for (const JoinRequest& r : options_.joins) {
    if (auto good = check_named(plane_at(sections_, r.plane_a), r.plane_a, r.contour_a); !good) return good;
    if (auto good = check_named(plane_at(sections_, r.plane_b), r.plane_b, r.contour_b); !good) return good;
  }
  return Done{};
}

Result<Done> Pipeline::check_input() const {
  if (auto good = check_part(sections_); !good) return good;
  if (auto good = check_options(options_); !good) return good;
  if (auto good = check_joins(); !good) return good;
  return check_size(sections_);
}

Result<Done> Pipeline::frame() {
  if (auto good = check_input(); !good) return good.error();
  auto framed = frame_sections(sections_, options_.plane_tolerance, context_);
  if (!framed) return framed.error();
  framed_ = std::move(framed).value();
  Report& report = result_.report;
  report.diagonal = framed_.diagonal;
  for (const std::string& text : framed_.notes) note(text);
  for (const std::string& text : framed_.warnings) warn(text);
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
  report.undone_matches = s.undone;
  report.disagreeing_vertices = s.disagreeing;
  report.merged_collinear = s.merged_collinear;
  report.simplified_vertices = s.simplified;
  report.simplify_deviation = s.deviation * framed_.grid.unit();
  for (const Mismatch& m : s.unmatched) {
    const Vec3 p = framed_.grid.from_lattice(m.point);
    report.unmatched.push_back(
        {framed_.planes[m.plane].sources[0], framed_.planes[m.other].sources[0], p.x, p.y, p.z});
  }
  if (!report.unmatched.empty())
    warn(std::to_string(report.unmatched.size()) +
         " crossings of contours with other planes have no partner there: the sections disagree");
  if (s.disagreeing != 0)
    warn(std::to_string(s.disagreeing) +
         " common points of planes are inside one section and outside another");
}

Result<Done> Pipeline::arrange() {
  std::vector<LatticePlane> planes;
  for (const FramedPlane& plane : framed_.planes) planes.push_back(plane.plane);
  auto arrangement = build_arrangement(planes, data_box(framed_), store_, context_);
  if (!arrangement) return arrangement.error();
  arrangement_ = std::make_unique<Arrangement>(std::move(arrangement).value());
  if (auto good = self_check("arrangement", [&] { return arrangement_->verify(); }); !good)
    return good.error();
  Report& report = result_.report;
  report.arrangement_cells = arrangement_->cell_count();
  report.arrangement_faces = arrangement_->face_count();
  report.arrangement_vertices = arrangement_->vertex_count();
  report.seconds.arrangement = watch_.lap();
  const double unit = framed_.grid.unit();
  const CrossingTolerances tolerances{options_.on_tolerance * framed_.diagonal / unit,
                                      options_.match_tolerance * framed_.diagonal / unit,
                                      options_.simplify * framed_.diagonal / unit};
  auto graph = build_section_graph(framed_, *arrangement_, store_, tolerances, context_);
  if (!graph) return graph.error();
  graph_ = std::move(graph).value();
  if (auto good = self_check("sections", [&] { return verify(graph_, *arrangement_); }); !good)
    return good.error();
  report_crossings();
  report.seconds.crossings = watch_.lap();
  if (observer_) observer_->on_sections(framed_, *arrangement_, graph_);
  for (FramedPlane& plane : framed_.planes) plane.vertices = {}, plane.input = {}, plane.walls = {};
  return Done{};
}

/// Before the cells go.
void Pipeline::find_heard_requests() {
  if (options_.joins.empty() || options_.mode != PruneMode::natural) return;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    if (cells_[c].report.tets_r0 == 0) continue;
    const CellContours contours(cell_faces(CellId{c}, inner_faces(CellId{c})));
    for (std::size_t i = 0; i < heard_.size(); ++i) {
      const JoinRequest& r = options_.joins[i];
      if (!contours.vertices(r.plane_a, r.contour_a).empty() &&
          !contours.vertices(r.plane_b, r.contour_b).empty())
        heard_[i] = 1;
    }
  }
}

/// A window leaves it to the stack: others may have a cell with both.
void Pipeline::explain_requests() {
  if (window_)
    window_->heard = std::move(heard_);
  else
    for (std::string& text : why_unheard(options_.joins, options_.mode, heard_)) warn(std::move(text));
}

void Pipeline::explain_empty() {
  if (!result_.surface.triangles.empty()) {
    if (result_.report.flat_regions != 0) warn(tell_flats(result_.report.flat_regions));
    return;
  }
  std::size_t filled = 0;
  for (const auto& walls : graph_.walls) filled += !walls.empty();
  warn(why_empty(filled));
}

Result<Reconstruction> Pipeline::run() {
  Stopwatch total;
  Report& report = result_.report;
  report.mode = name_of(options_.mode);
  heard_.assign(options_.joins.size(), 0);
  if (auto done = frame(); !done) return done.error();
  if (!framed_.planes.empty())
    for (const auto step :
         {&Pipeline::arrange, &Pipeline::triangulate_faces, &Pipeline::fill_cells, &Pipeline::glue_cells}) {
      if (context_.cancelled()) return cancelled();
      if (auto done = (this->*step)(); !done) return done.error();
    }
  explain_requests();
  explain_empty();
  report.seconds.total = total.lap();
  return std::move(result_);
}

Result<Reconstruction> reconstruct(const Sections& sections, const Options& options, const Context& context,
                                   Observer* observer) {
  return or_out_of_memory([&]() -> Result<Reconstruction> {
    auto result = Pipeline(sections, options, context, observer).run();
    if (!result && result.error().file.empty()) result.error().file = sections.source;
    return result;
  });
}

}  // namespace crossloft
