#pragma once
/// Drawings as SVG text: paths of lines and circular arcs, dots, text, groups.
///
/// Coordinates are those of the drawing's plane, y up; the file is in pixels, y down. Numbers are the
/// shortest decimals that read back as the same float (up to nine digits), the same bytes on every machine.

#include <string>
#include <string_view>

#include "../geom/vec2.h"

namespace crossloft {

struct CurvePiece;

/// The rectangle of the plane that a drawing shows. low < high in both coordinates.
struct ViewBox {
  Vec2 low, high;
  Vec2 size() const { return high - low; }
};

/// Where the plane lies on the page: `width` pixels for the width of the box, the same scale upwards.
class PageMap {
 public:
  PageMap(const ViewBox& box, double width) : box_(box), scale_(width / box.size().x) {}

  Vec2 place(Vec2 p) const { return {scale_ * (p.x - box_.low.x), scale_ * (box_.high.y - p.y)}; }
  double length(double plane_length) const { return scale_ * plane_length; }
  Vec2 size() const { return scale_ * box_.size(); }
  const ViewBox& box() const { return box_; }

 private:
  ViewBox box_;
  double scale_;
};

/// The outline of a shape, or several of them: the `d` of an SVG path.
class SvgPath {
 public:
  explicit SvgPath(const PageMap& map) : map_(&map) {}

  SvgPath& move(Vec2 to);
  SvgPath& line(Vec2 to);
  /// A line or an arc of less than half a turn, from the present point, which is its beginning. An arc is
  /// drawn as a line where no eye can tell.
  SvgPath& piece(const CurvePiece& piece);
  SvgPath& close();

  bool empty() const { return data_.empty(); }
  const std::string& data() const { return data_; }

 private:
  void point(char command, Vec2 to);

  const PageMap* map_;
  std::string data_;
};

/// Builds one SVG file from its elements, painted in the order they are added. `attributes` is written as it
/// is, e.g. `fill="none"`; a title, if any, is escaped, and shown by browsers as the element's tooltip.
class SvgWriter {
 public:
  /// A white page of the map's size; `title` names the drawing.
  SvgWriter(const PageMap& map, std::string_view title);

  void open_group(std::string_view attributes);
  void close_group();
  void path(const SvgPath& path, std::string_view attributes, std::string_view title = {});
  void circle(Vec2 centre, double radius, std::string_view attributes, std::string_view title = {});
  /// A circle or a square whose half width is in pixels.
  void dot(Vec2 centre, double pixels, std::string_view attributes, std::string_view title = {});
  void square(Vec2 centre, double pixels, std::string_view attributes, std::string_view title = {});
  /// The text begins `offset` pixels right of and above the point.
  void text(Vec2 at, Vec2 offset, std::string_view text, std::string_view attributes = {});

  const PageMap& map() const { return map_; }
  /// The whole file. REQUIRES: every group is closed.
  std::string finish() &&;

 private:
  void begin(std::string_view name);
  void number(std::string_view name, double pixels);
  void end(std::string_view name, std::string_view attributes, std::string_view content);

  PageMap map_;
  std::string text_;
  int depth_ = 1;
};

/// Appends a number in pixels as the shortest decimal of the nearest float, never "-0"; beyond 1e30 that.
void append_pixels(std::string& text, double value);

/// With & < > " as entities, and without control characters.
std::string xml_escaped(std::string_view text);

}  // namespace crossloft
