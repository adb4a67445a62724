#include "report_json.h"

#include <nlohmann/json.hpp>

#include "repair_json.h"

namespace crossloft::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const StageSeconds& s) {
  return {{"input", s.input},         {"arrangement", s.arrangement},
          {"crossings", s.crossings}, {"faces", s.faces},
          {"cells", s.cells},         {"branching", s.branching},
          {"delaunay", s.delaunay},   {"pruning", s.pruning},
          {"gluing", s.gluing},       {"separating", s.separating},
          {"total", s.total}};
}

Json to_json(const PlaneReport& p) {
  return {{"plane", p.plane},
          {"vertices", p.vertices},
          {"edges", p.edges},
          {"area", p.area},
          {"flat_area", p.flat_area},
          {"flat_regions", p.flat_regions},
          {"thickened_regions", p.thickened_regions},
          {"displacement", p.displacement},
          {"off_plane", p.off_plane}};
}

Json to_json(const Vec3& p) { return {p.x, p.y, p.z}; }

Json to_json(const JoinReport& j) {
  return {{"a", to_json(j.a)}, {"b", to_json(j.b)}, {"confidence", j.confidence}, {"done", j.done}};
}

Json to_json(const CellReport& c);
Json to_json(const UnmatchedCrossing& u);

template <class T>
Json to_json(const std::vector<T>& items) {
  Json list = Json::array();
  for (const T& item : items) list.push_back(to_json(item));
  return list;
}

Json to_json(const CellReport& c) {
  return {{"faces", c.faces},
          {"vertices", c.vertices},
          {"tets_r0", c.tets_r0},
          {"tets_r1", c.tets_r1},
          {"tets_r2", c.tets_r2},
          {"tets_r3", c.tets_r3},
          {"bad_links", c.bad_links},
          {"sections", c.topology.sections},
          {"bodies", c.topology.bodies},
          {"outsides", c.topology.outsides},
          {"voids", c.topology.voids},
          {"handles", c.topology.genus},
          {"handles_before", c.genus_before},
          {"handles_asked", c.handles_asked},
          {"bare_triangles", c.topology.bare},
          {"grown", c.grown},
          {"joins", to_json(c.joins)},
          {"domes", c.domes}};
}

Json to_json(const TopologyReport& t) {
  return {{"handles", t.handles},
          {"handles_before", t.handles_before},
          {"handles_asked", t.handles_asked},
          {"grown_cells", t.grown_cells},
          {"joins", t.joins},
          {"refused_joins", t.refused_joins},
          {"weakest_join", t.weakest_join},
          {"bodies_joined", t.bodies_joined},
          {"walls_opened", t.walls_opened},
          {"spikes_dropped", t.spikes_dropped},
          {"bridges", t.bridges},
          {"bridge_handles", t.bridge_handles},
          {"open_edges", t.open_edges},
          {"walls", t.walls},
          {"voids", t.voids}};
}

Json to_json(const UnmatchedCrossing& u) {
  return {{"plane", u.plane}, {"other_plane", u.other_plane}, {"point", {u.x, u.y, u.z}}};
}

/// Of Branching and InCells.
template <class Where>
const char* name_of(Where where) {
  return where == Where::off ? "off" : where == Where::all ? "all" : "auto";
}

Json to_json(const Options& o) {
  return {{"join_confidence", o.natural.join_confidence},
          {"dome_confidence", o.natural.dome_confidence},
          {"alone_confidence", o.natural.alone_confidence},
          {"cavity_confidence", o.natural.cavity_confidence},
          {"smooth_weight", o.natural.smooth_weight},
          {"divide", name_of(o.natural.divide)},
          {"look_around", name_of(o.natural.look_around)},
          {"branching", name_of(o.branching.mode)},
          {"cutting", o.branching.cutting},
          {"match_tolerance", o.match_tolerance},
          {"plane_tolerance", o.plane_tolerance},
          {"on_tolerance", o.on_tolerance},
          {"simplify", o.simplify},
          {"thicken", o.thicken},
          {"separate", o.separate},
          {"separation", o.separation}};
}

Json input_part(const Report& r) {
  return {{"diagonal", r.diagonal},
          {"section_area", r.section_area},
          {"displacement", r.displacement},
          {"off_plane", r.off_plane},
          {"merged_collinear", r.merged_collinear},
          {"simplified_vertices", r.simplified_vertices},
          {"simplify_deviation", r.simplify_deviation},
          {"edge_splits", r.edge_splits},
          {"planes", to_json(r.planes)}};
}

Json lines_part(const Report& r) {
  return {{"crossings", r.crossings},
          {"matched", r.matched_crossings},
          {"on_line_vertices", r.on_line_vertices},
          {"largest_match_gap", r.largest_match_gap},
          {"undone_matches", r.undone_matches},
          {"disagreeing_vertices", r.disagreeing_vertices},
          {"unmatched", to_json(r.unmatched)}};
}

Json branching_part(const Report& r) {
  return {
      {"faces", r.branching_faces}, {"samples", r.branching_samples}, {"interior_points", r.interior_points}};
}

Json arrangement_part(const Report& r) {
  return {
      {"cells", r.arrangement_cells}, {"faces", r.arrangement_faces}, {"vertices", r.arrangement_vertices}};
}

Json result_part(const Report& r) {
  return {{"tetrahedra", r.solid_tets},
          {"triangles", r.surface_triangles},
          {"vertices", r.surface_vertices},
          {"vertex_copies", r.vertex_copies},
          {"separated_copies", r.separated_copies},
          {"touching_copies", r.touching_copies},
          {"separation", r.separation},
          {"contacts", r.contacts},
          {"crossing_pairs", r.crossing_pairs},
          {"crossing_pairs_left", r.crossing_pairs_left},
          {"mended_vertices", r.mended_vertices},
          {"merged_vertices", r.merged_vertices},
          {"mending", r.mending},
          {"volume", r.volume},
          {"flat_area", r.flat_area},
          {"flat_regions", r.flat_regions},
          {"thickened_regions", r.thickened_regions},
          {"thickness", r.thickness},
          {"pinched_vertices", r.pinched_vertices},
          {"pinched_edges", r.pinched_edges},
          {"split_edges", r.split_edges},
          {"bad_links", r.bad_links}};
}

Json head(const ReportOrigin& origin) {
  Json json;
  json["report_version"] = kReportVersion;
  json["program"] = "crossloft " CROSSLOFT_VERSION;
  json["file"] = origin.input;
  json["mode"] = name_of(origin.options.mode);
  json["options"] = to_json(origin.options);
  return json;
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string report_json(const Report& report, const ReportOrigin& origin, const RepairOrigin* repair) {
  Json json = head(origin);
  json["seconds"] = to_json(report.seconds);
  json["input"] = input_part(report);
  json["lines"] = lines_part(report);
  json["arrangement"] = arrangement_part(report);
  json["branching"] = branching_part(report);
  json["topology"] = to_json(report.topology);
  json["result"] = result_part(report);
  json["cells"] = to_json(report.cells);
  if (repair) json["repair"] = repair_part(repair->repair, repair->options);
  json["notes"] = report.notes;
  json["warnings"] = report.warnings;
  return text_of(json);
}

std::string report_json(const StackReport& r, const ReportOrigin& origin) {
  Json topology = to_json(r.topology);
  topology.erase("bridges");
  topology.erase("bridge_handles");
  topology.erase("open_edges");
  Json json = head(origin);
  json["seconds"] = {{"total", r.seconds}};
  json["stream"] = {{"windows", r.windows}};
  json["input"] = {{"diagonal", r.diagonal},
                   {"section_area", r.section_area},
                   {"displacement", r.displacement},
                   {"off_plane", r.off_plane},
                   {"planes", to_json(r.planes)}};
  json["topology"] = topology;
  json["result"] = {{"tetrahedra", r.solid_tets},
                    {"triangles", r.surface_triangles},
                    {"vertices", r.surface_vertices},
                    {"bodies", r.bodies},
                    {"cavities", r.cavities},
                    {"genus", r.genus},
                    {"volume", r.volume},
                    {"flat_area", r.flat_area},
                    {"flat_regions", r.flat_regions},
                    {"thickened_regions", r.thickened_regions}};
  json["cells"] = to_json(r.cells);
  json["notes"] = r.notes;
  json["warnings"] = r.warnings;
  return text_of(json);
}

}  // namespace crossloft::cli
