#include "write_face_svg.h"
#include "../geom/failing.h"

#include <algorithm>

#include "atomic_file.h"

namespace crossloft {
namespace {

using Polygons = std::vector<std::vector<Vec2>>;

std::vector<Vec2> points_of(const Polygons& polygons) {
  std::vector<Vec2> points;
  for (const std::vector<Vec2>& polygon : polygons)
    points.insert(points.end(), polygon.begin(), polygon.end());
  return points;
}

/// What the page is to show.
std::vector<Vec2> shown_points(const FaceDrawing& drawing) {
  std::vector<Vec2> points = points_of(drawing.section);
  for (const auto& [from, to] : drawing.contour) points.insert(points.end(), {from, to});
  points.insert(points.end(), drawing.samples.begin(), drawing.samples.end());
  if (points.empty()) points = points_of(drawing.face);
  return points;
}

/// The box of the points with a margin; neither side is less than a tenth of the other.
ViewBox view_of(const std::vector<Vec2>& points) {
  if (points.empty()) return {{0, 0}, {1, 1}};
  ViewBox box{points[0], points[0]};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  constexpr double kMargin = 0.05, kLeastAspect = 0.1;
  const double larger = std::max(box.size().x, box.size().y), extent = larger > 0 ? larger : 1;
  const auto widening = [extent](double side) {
    return kMargin * extent + 0.5 * std::max(kLeastAspect * extent - side, 0.0);
  };
  const Vec2 margin{widening(box.size().x), widening(box.size().y)};
  return {box.low - margin, box.high + margin};
}

PageMap map_of(const ViewBox& box) {
  constexpr double kPixels = 800;
  return {box, kPixels * box.size().x / std::max(box.size().x, box.size().y)};
}

SvgPath outlines(const Polygons& polygons, const PageMap& map) {
  SvgPath path(map);
  for (const std::vector<Vec2>& polygon : polygons) {
    if (polygon.empty()) continue;
    path.move(polygon.front());
    for (std::size_t i = 1; i < polygon.size(); ++i) path.line(polygon[i]);
    path.close();
  }
  return path;
}

/// A box that hides the ends of what is cut at it.
ViewBox around(const ViewBox& box) {
  constexpr double kMargin = 0.02;
  const Vec2 margin = kMargin * box.size();
  return {box.low - margin, box.high + margin};
}

void draw_arcs(SvgWriter& out, const std::vector<ArcShape>& arcs) {
  const ViewBox box = around(out.map().box());
  out.open_group(R"(id="arcs" fill="none" stroke="#2060b0" stroke-width="1")");
  for (const ArcShape& arc : arcs) {
    SvgPath path(out.map());
    for (const CurveRun& run : clip(trace(arc, box), box)) {
      path.move(run.pieces.front().from);
      for (const CurvePiece& piece : run.pieces) path.piece(piece);
    }
    if (!path.empty()) out.path(path, {});
  }
  out.close_group();
}

void draw_dots(SvgWriter& out, const std::vector<Vec2>& points, double pixels, std::string_view group) {
  out.open_group(group);
  for (const Vec2 p : points) out.dot(p, pixels, {});
  out.close_group();
}

}  // namespace

std::string format_face_svg(const FaceDrawing& drawing) {
  SvgWriter out(map_of(view_of(shown_points(drawing))), drawing.title);
  const auto draw = [&out](const SvgPath& path, std::string_view group) {
    out.open_group(group);
    if (!path.empty()) out.path(path, {});
    out.close_group();
  };
  draw(outlines(drawing.section, out.map()), R"(id="section" fill="#f4e7a6" fill-rule="evenodd")");
  draw(outlines(drawing.face, out.map()), R"(id="face" fill="none" stroke="#909090" stroke-width="1")");
  draw_arcs(out, drawing.arcs);
  SvgPath contour(out.map());
  for (const auto& [from, to] : drawing.contour) contour.move(from).line(to);
  draw(contour, R"(id="contour" fill="none" stroke="#303030" stroke-width="1.5" stroke-linecap="round")");
  draw_dots(out, drawing.sites, 1.5, R"(id="sites" fill="#2060b0")");
  draw_dots(out, drawing.samples, 2.5, R"(id="samples" fill="#c02030")");
  return std::move(out).finish();
}

Result<Done> write_face_svg(const std::string& path, const FaceDrawing& drawing) {
  return or_out_of_memory([&]() -> Result<Done> { return write_file(path, format_face_svg(drawing)); });
}

}  // namespace crossloft
