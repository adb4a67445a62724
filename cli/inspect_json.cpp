#include "inspect_json.h"

#include <nlohmann/json.hpp>

namespace crossloft::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const ComponentReport& c) {
  Json json = {{"triangles", c.triangles}, {"vertices", c.vertices}, {"edges", c.edges},
               {"manifold", c.manifold},   {"euler", c.euler},       {"genus", c.genus},
               {"volume", c.volume},       {"depth", c.depth},       {"cavity", c.cavity()},
               {"inverted", c.inverted()}};
  if (!c.manifold) json["genus"] = nullptr;
  if (!c.depth_known) json["depth"] = nullptr;
  return json;
}

Json surface_part(const CheckReport& r) {
  Json json = {{"triangles", r.triangles},
               {"points", r.points},
               {"unused_points", r.unused_points},
               {"bad_indices", r.bad_indices},
               {"bad_coordinates", r.bad_coordinates},
               {"closed", r.closed()},
               {"oriented", r.oriented()},
               {"manifold", r.manifold()},
               {"open_edges", r.open_edges},
               {"crowded_edges", r.crowded_edges},
               {"misoriented_edges", r.misoriented_edges},
               {"nonmanifold_vertices", r.nonmanifold_vertices},
               {"repeated_indices", r.repeated_indices},
               {"repeated_points", r.repeated_points},
               {"flat_triangles", r.flat_triangles},
               {"crossings", r.crossings},
               {"overlaps", r.overlaps},
               {"crossing_pairs", r.crossing_pairs},
               {"cavities", r.cavities},
               {"inverted", r.inverted},
               {"unknown_depths", r.unknown_depths},
               {"genus", r.genus},
               {"volume", r.volume},
               {"area", r.area},
               {"components", Json::array()}};
  if (!r.good_topology()) json["genus"] = nullptr;
  for (const ComponentReport& c : r.components) json["components"].push_back(to_json(c));
  return json;
}

Json to_json(const PlaneCheck& p) {
  return {{"plane", p.plane},
          {"area", p.section_area},
          {"surface_area", p.surface_area},
          {"missing_area", p.missing_area},
          {"extra_area", p.extra_area},
          {"distance", p.distance},
          {"surface_off_plane", p.off_plane},
          {"displacement", p.section_displacement},
          {"off_plane", p.section_off_plane}};
}

Json sections_part(const SectionCheck& check) {
  Json json = {{"diagonal", check.diagonal},           {"section_area", check.section_area},
               {"missing_area", check.missing_area},   {"extra_area", check.extra_area},
               {"missing_share", check.missing_share}, {"extra_share", check.extra_share},
               {"distance", check.distance},           {"displacement", check.section_displacement},
               {"off_plane", check.section_off_plane}, {"planes", Json::array()}};
  for (const PlaneCheck& p : check.planes) json["planes"].push_back(to_json(p));
  return json;
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string check_json(const CheckReport& surface, const SectionCheck* sections, const CheckOrigin& origin,
                       const std::vector<std::string>& broken) {
  Json json;
  json["check_version"] = kCheckVersion;
  json["program"] = "crossloft " CROSSLOFT_VERSION;
  json["file"] = origin.surface;
  if (sections) {
    json["sections_file"] = origin.sections;
    json["options"] = {{"on_plane", origin.options.on_plane},
                       {"plane_tolerance", origin.options.plane_tolerance},
                       {"max_distance", origin.max_distance},
                       {"max_missing", origin.max_missing},
                       {"max_extra", origin.max_extra}};
  }
  json["good"] = broken.empty();
  json["broken"] = broken;
  json["surface"] = surface_part(surface);
  if (sections) json["sections"] = sections_part(*sections);
  return text_of(json);
}

std::string compare_json(const CompareReport& r, const std::string& a, const std::string& b) {
  Json json;
  json["compare_version"] = kCompareVersion;
  json["program"] = "crossloft " CROSSLOFT_VERSION;
  json["a"] = {{"file", a},
               {"volume", r.volume_a},
               {"ray_volume", r.ray_volume_a},
               {"components", r.components_a},
               {"genus", r.genus_a},
               {"distance", r.distance_ab},
               {"mean_distance", r.mean_ab}};
  json["b"] = {{"file", b},
               {"volume", r.volume_b},
               {"ray_volume", r.ray_volume_b},
               {"components", r.components_b},
               {"genus", r.genus_b},
               {"distance", r.distance_ba},
               {"mean_distance", r.mean_ba}};
  json["diagonal"] = r.diagonal;
  json["intersection"] = r.intersection;
  json["union"] = r.union_volume;
  json["iou"] = r.iou;
  json["hausdorff"] = r.hausdorff();
  json["mean_distance"] = r.mean();
  return text_of(json);
}

}  // namespace crossloft::cli
