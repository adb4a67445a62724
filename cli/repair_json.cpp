#include "repair_json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace crossloft::cli {
namespace {

using Json = nlohmann::ordered_json;

void add_number(Json& json, const char* key, std::uint32_t number) {
  if (number != kNone) json[key] = number;
}

Json to_json(const RepairChange& c) {
  Json json;
  json["kind"] = name_of(c.kind);
  add_number(json, "plane", c.plane);
  add_number(json, "contour", c.contour);
  add_number(json, "vertex", c.vertex);
  json["count"] = c.count;
  json["distance"] = c.distance;
  json["point"] = {c.point.x, c.point.y, c.point.z};
  json["text"] = c.text;
  return json;
}

Json to_json(const RepairOptions& o) {
  return {{"limit", o.limit},           {"planes", o.planes},       {"plane_tolerance", o.plane_tolerance},
          {"same_plane", o.same_plane}, {"chains", o.chains},       {"close_gap", o.close_gap},
          {"repeated", o.repeated},     {"spike", o.spike},         {"crossings", o.crossings},
          {"loops", o.loops},           {"tiny_loop", o.tiny_loop}, {"collinear", o.collinear},
          {"agreement", o.agreement},   {"agree", o.agree}};
}

}  // namespace

Json repair_part(const Repair& repair, const RepairOptions& options) {
  Json json;
  json["options"] = to_json(options);
  json["diagonal"] = repair.diagonal;
  json["largest_displacement"] = repair.largest_displacement;
  json["rounds"] = repair.rounds;
  json["left"] = repair.left;
  json["planes"] = repair.sources;
  json["changes"] = Json::array();
  for (const RepairChange& c : repair.changes) json["changes"].push_back(to_json(c));
  return json;
}

std::string repair_json(const Repair& repair, const RepairOptions& options, const std::string& input) {
  Json json;
  json["repair_version"] = 1;
  json["program"] = "crossloft " CROSSLOFT_VERSION;
  json["file"] = input;
  json.update(repair_part(repair, options));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

/// As many defects are named one by one; some data have thousands.
constexpr std::size_t kMostNamed = 20;

/// "plane 0, contour 1: contour-left-out: the chain does not close"
std::string warning_of(const RepairChange& c) {
  std::string where;
  if (c.plane != kNone) where = "plane " + std::to_string(c.plane);
  if (c.contour != kNone) where += ", contour " + std::to_string(c.contour);
  return (where.empty() ? "" : where + ": ") + name_of(c.kind) + ": " + c.text;
}

/// What is still wrong or was left out, contours without area too: one warning each.
void warn_of_left(Terminal& terminal, const Repair& repair) {
  std::size_t count = 0;
  for (const RepairChange& c : repair.changes)
    if ((is_left(c.kind) || c.kind == RepairKind::no_area) && ++count <= kMostNamed)
      terminal.say(LogLevel::warning, warning_of(c));
  if (count > kMostNamed)
    terminal.say(LogLevel::warning, std::to_string(count - kMostNamed) + " more: see --report");
}

}  // namespace

void print_repair(Terminal& terminal, const Repair& repair) {
  struct Tally {
    std::size_t changes = 0;
    double distance = 0;
  };
  std::map<RepairKind, Tally> tallies;
  for (const RepairChange& c : repair.changes) {
    Tally& t = tallies[c.kind];
    ++t.changes;
    t.distance = std::max(t.distance, c.distance);
  }
  for (const auto& [kind, t] : tallies)
    terminal.print("%-18s %zu changes, up to %.3g\n", name_of(kind), t.changes, t.distance);
  warn_of_left(terminal, repair);
  if (repair.left != 0)
    terminal.print("left               %u: as it was found, or a contour left out\n", repair.left);
  terminal.print("displacement       %.3g (%.3g of the diagonal)\n", repair.largest_displacement,
                 repair.diagonal > 0 ? repair.largest_displacement / repair.diagonal : 0);
}

ExitCode exit_code(const Repair& repair) { return repair.left == 0 ? kGood : kPromiseBroken; }

}  // namespace crossloft::cli
