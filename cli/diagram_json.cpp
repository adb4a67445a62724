#include "diagram_json.h"

#include <nlohmann/json.hpp>

namespace crossloft::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(Vec2 p) { return {p.x, p.y}; }

/// The number of a vertex; null at infinity and on a whole circle.
Json vertex_json(std::uint32_t vertex) { return vertex == kNone ? Json(nullptr) : Json(vertex); }

Json site_json(const MoebiusSite& site, std::span<const CellComponent> pieces) {
  Json holes = Json::array();
  for (const CellComponent& piece : pieces) holes.push_back(piece.hole_count());
  return {{"p", to_json(site.p)},
          {"lambda", site.lambda},
          {"mu", site.mu},
          {"pieces", pieces.size()},
          {"holes", holes}};
}

Json arc_json(const MoebiusArc& arc) {
  Json json = {{"sites", arc.sites}, {"from", vertex_json(arc.from)}, {"to", vertex_json(arc.to)}};
  if (arc.curve.is_line)
    json["line"] = {{"point", to_json(arc.curve.centre)}, {"direction", to_json(arc.curve.direction)}};
  else
    json["circle"] = {{"centre", to_json(arc.curve.centre)}, {"radius", arc.curve.radius}};
  return json;
}

/// The elements of a list, one a line.
template <class Items, class ToJson>
std::string list(const Items& items, ToJson to_json_of) {
  std::string text;
  for (const auto& item : items) text += (text.empty() ? "\n    " : ",\n    ") + to_json_of(item).dump();
  return "[" + text + (text.empty() ? "]" : "\n  ]");
}

}  // namespace

std::string diagram_json(const MoebiusDiagram& diagram, const MoebiusCells& cells, const std::string& file) {
  const auto site = [&](const MoebiusSite& s) {
    return site_json(s, cells.components_of(static_cast<std::uint32_t>(&s - diagram.sites.data())));
  };
  const auto invalid = Json::error_handler_t::replace;  // a file name need not be UTF-8
  return "{\n  \"diagram_version\": " + std::to_string(kDiagramVersion) +
         ",\n  \"file\": " + Json(file).dump(-1, ' ', false, invalid) +
         ",\n  \"sites\": " + list(diagram.sites, site) +
         ",\n  \"vertices\": " + list(diagram.vertices, to_json) +
         ",\n  \"arcs\": " + list(diagram.arcs, arc_json) + "\n}\n";
}

}  // namespace crossloft::cli
