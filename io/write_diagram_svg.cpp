#include "write_diagram_svg.h"
#include "../geom/failing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "arc_trace.h"
#include "atomic_file.h"
#include "byte_writer.h"
#include "cell_colours.h"
#include "cell_outlines.h"

namespace crossloft {
namespace {

constexpr std::array<const char*, 8> kPalette = {"#9ec5e8", "#f6c89f", "#b3dcb8", "#eeb0b5",
                                                 "#cdbfe6", "#f4e7a6", "#a5dcd9", "#dcc8b4"};

ViewBox grown(const ViewBox& box, Vec2 by) { return {box.low - by, box.high + by}; }

ViewBox joined(const ViewBox& a, const ViewBox& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

bool contains(const ViewBox& box, const ViewBox& part) {
  return part.low.x >= box.low.x && part.high.x <= box.high.x && part.low.y >= box.low.y &&
         part.high.y <= box.high.y;
}

double larger_side(const ViewBox& box) { return std::max(box.size().x, box.size().y); }

/// A whole circle, bounded by the sites' extent where they have one.
bool is_whole_and_near(const MoebiusArc& arc, const ViewBox& sites) {
  const double extent = larger_side(sites), reach = 0.5 * extent;
  const Vec2 centre = arc.curve.centre;
  return arc.from == kNone && (extent == 0 || (arc.curve.radius <= extent &&
                                               contains(grown(sites, {reach, reach}), {centre, centre})));
}

/// The sites; the vertices, and arcs of circles as a whole, within 0.3 of the sites' extent around
/// them; whole circles that are neither larger than that extent nor centred further off than half of it, and
/// any if the sites have no extent.
ViewBox box_of(const MoebiusDiagram& diagram) {
  if (diagram.sites.empty()) return {};
  ViewBox sites{diagram.sites[0].p, diagram.sites[0].p};
  for (const MoebiusSite& site : diagram.sites) sites = joined(sites, {site.p, site.p});
  const double reach = 0.3 * larger_side(sites);
  const ViewBox near = grown(sites, {reach, reach});
  ViewBox box = sites;
  for (const Vec2 v : diagram.vertices) {
    if (contains(near, {v, v})) box = joined(box, {v, v});
  }
  for (const MoebiusArc& arc : diagram.arcs) {
    if (arc.curve.is_line) continue;
    const std::vector<CurvePiece> pieces = trace(shape_of(diagram, arc), near);
    if (pieces.empty()) continue;
    const ViewBox around = bounds_of(pieces);
    if (contains(near, around) || is_whole_and_near(arc, sites)) box = joined(box, around);
  }
  return box;
}

Result<PageMap> page_for(const MoebiusDiagram& diagram, const DiagramDrawing& drawing) {
  constexpr double kMostAspect = 100;
  const ViewBox box = drawing.box.value_or(view_of(diagram));
  const Vec2 size = box.size();
  if (!is_finite(box.low) || !is_finite(box.high) || !is_finite(size) || !(size.x > 0) || !(size.y > 0))
    return make_error(ErrorCode::usage, "the box to draw must be finite, from its low to its high corner");
  if (size.x > kMostAspect * size.y || size.y > kMostAspect * size.x)
    return make_error(ErrorCode::usage,
                      "the box to draw is over 100 times longer in one direction than in the other");
  if (!std::isfinite(drawing.width) || !(drawing.width > 0))
    return make_error(ErrorCode::usage, "the width of the drawing must be a positive number of pixels");
  return PageMap(box, drawing.width);
}

/// Widths of strokes and dots that suit the room there is for each site [pixels].
struct Pens {
  double stroke, dot;
};

Pens pens_for(const PageMap& map, std::size_t sites) {
  const double room =
      std::sqrt(map.size().x * map.size().y / static_cast<double>(std::max<std::size_t>(sites, 1)));
  return {std::clamp(room / 30, 0.2, 1.25), std::clamp(room / 12, 0.4, 3.0)};
}

std::string attribute(std::string_view name, std::string_view value) {
  return std::string(name) + "=\"" + std::string(value) + '"';
}

std::string attribute(std::string_view name, double pixels) {
  std::string text;
  append_pixels(text, pixels);
  return attribute(name, text);
}

class DiagramPage {
 public:
  DiagramPage(const MoebiusDiagram& diagram, const DiagramDrawing& drawing, const PageMap& map)
      : diagram_(diagram),
        drawing_(drawing),
        map_(map),
        clipped_(clip_diagram(diagram, map.box())),
        has_cell_(sites_with_cell(diagram)),
        pens_(pens_for(map, diagram.sites.size())),
        out_(map, "Moebius diagram of " + std::to_string(diagram.sites.size()) + " sites") {}

  std::string draw() && {
    draw_cells();
    draw_arcs();
    if (drawing_.sites) draw_sites();
    if (drawing_.labels) draw_labels();
    return std::move(out_).finish();
  }

 private:
  void draw_cells() {
    const std::vector<std::uint32_t> colours = colour_cells(diagram_, kPalette.size());
    out_.open_group(R"(id="cells" fill-rule="evenodd")");
    for (std::uint32_t s = 0; s < clipped_.cells.size(); ++s) {
      if (clipped_.cells[s].empty()) continue;
      SvgPath path(map_);
      for (const Outline& outline : clipped_.cells[s]) add(path, outline).close();
      out_.path(path,
                attribute("data-site", std::to_string(s)) + ' ' + attribute("fill", kPalette[colours[s]]),
                description(s));
    }
    out_.close_group();
  }

  void draw_arcs() {
    out_.open_group(R"(id="arcs" fill="none" stroke="#303030" stroke-linecap="round" )" +
                    attribute("stroke-width", pens_.stroke));
    for (std::uint32_t a = 0; a < clipped_.arcs.size(); ++a) draw_arc(a);
    out_.close_group();
  }

  void draw_arc(std::uint32_t a) {
    const MoebiusArc& arc = diagram_.arcs[a];
    const std::vector<CurveRun>& runs = clipped_.arcs[a];
    if (runs.empty()) return;
    const std::string number = attribute("data-arc", std::to_string(a));
    const bool whole = !arc.curve.is_line && arc.from == kNone;
    if (whole && runs.size() == 1 && !runs[0].enters && !runs[0].leaves)
      return out_.circle(arc.curve.centre, arc.curve.radius, number);
    SvgPath path(map_);
    for (const CurveRun& run : runs) add(path, run.pieces);
    out_.path(path, number);
  }

  static SvgPath& add(SvgPath& path, const std::vector<CurvePiece>& pieces) {
    path.move(pieces.front().from);
    for (const CurvePiece& piece : pieces) path.piece(piece);
    return path;
  }

  void draw_sites() {
    out_.open_group(R"(id="sites" fill="#303030" stroke="#303030" )" +
                    attribute("stroke-width", pens_.dot / 3));
    for (std::uint32_t s = 0; s < diagram_.sites.size(); ++s) {
      const MoebiusSite& site = diagram_.sites[s];
      const std::string attributes =
          attribute("data-site", std::to_string(s)) + (has_cell_[s] ? "" : R"( fill="#ffffff")");
      if (site.lambda > 0)
        out_.dot(site.p, pens_.dot, attributes, description(s));
      else
        out_.square(site.p, pens_.dot, attributes, description(s));
    }
    out_.close_group();
  }

  void draw_labels() {
    const double size = std::clamp(4 * pens_.dot, 4.0, 12.0);
    out_.open_group(R"(id="labels" font-family="sans-serif" fill="#303030" )" + attribute("font-size", size));
    const Vec2 offset{1.5 * pens_.dot, 1.5 * pens_.dot};
    for (std::size_t s = 0; s < diagram_.sites.size(); ++s)
      out_.text(diagram_.sites[s].p, offset, std::to_string(s));
    out_.close_group();
  }

  /// "site 3: p = (1, 2), lambda = 1, mu = 0, 2 pieces, 1 hole"
  std::string description(std::uint32_t s) const {
    const MoebiusSite& site = diagram_.sites[s];
    std::string text = "site " + std::to_string(s) + ": p = (";
    append_decimal(text, site.p.x);
    append_decimal(text += ", ", site.p.y);
    append_decimal(text += "), lambda = ", site.lambda);
    append_decimal(text += ", mu = ", site.mu);
    return text + cell_description(s);
  }

  std::string cell_description(std::uint32_t s) const {
    if (!has_cell_[s]) return ", no cell";
    if (drawing_.cells == nullptr) return {};
    std::size_t holes = 0;
    for (const CellComponent& piece : drawing_.cells->components_of(s)) holes += piece.hole_count();
    return ", " + counted(drawing_.cells->components_of(s).size(), "piece") +
           (holes > 0 ? ", " + counted(holes, "hole") : "");
  }

  static std::string counted(std::size_t count, const char* what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
  }

  const MoebiusDiagram& diagram_;
  const DiagramDrawing& drawing_;
  PageMap map_;
  DiagramInBox clipped_;
  std::vector<bool> has_cell_;
  Pens pens_;
  SvgWriter out_;
};

}  // namespace

ViewBox view_of(const MoebiusDiagram& diagram) {
  constexpr double kMargin = 0.08, kLeastAspect = 0.5, kLeastExtent = 1e-3;
  const ViewBox box = box_of(diagram);
  double extent = larger_side(box);
  if (!(extent > 0))
    extent = std::max(1.0, kLeastExtent * std::max(std::abs(box.low.x), std::abs(box.low.y)));
  const auto widening = [extent](double side) {
    return 0.5 * std::max(kLeastAspect * extent - side, 0.0) + kMargin * extent;
  };
  return grown(box, {widening(box.size().x), widening(box.size().y)});
}

Result<std::string> format_diagram_svg(const MoebiusDiagram& diagram, const DiagramDrawing& drawing) {
  return or_out_of_memory([&]() -> Result<std::string> {
    const Result<PageMap> map = page_for(diagram, drawing);
    if (!map.ok()) return map.error();
    return DiagramPage(diagram, drawing, *map).draw();
  });
}

Result<Done> write_diagram_svg(const std::string& path, const MoebiusDiagram& diagram,
                               const DiagramDrawing& drawing) {
  return or_out_of_memory([&]() -> Result<Done> {
    const Result<std::string> text = format_diagram_svg(diagram, drawing);
    if (!text.ok()) return text.error();
    return write_file(path, *text);
  });
}

}  // namespace crossloft
