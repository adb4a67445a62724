#include "svg.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "curve_piece.h"

namespace crossloft {
namespace {

/// Pixels that an arc may be off its chord and still be drawn as a line: renderers work with floats, in which
/// the circle of so flat an arc is lost.
constexpr double kFlat = 1.0 / 256;

std::string title_element(std::string_view title) {
  return title.empty() ? std::string() : "<title>" + xml_escaped(title) + "</title>";
}

}  // namespace

void append_pixels(std::string& text, double value) {
  constexpr double kFarOff = 1e30;  // a number that no float can hold would not be SVG
  char digits[32];
  const float rounded = static_cast<float>(std::clamp(value, -kFarOff, kFarOff)) + 0.0f;  // -0 becomes 0
  text.append(digits, std::to_chars(digits, digits + sizeof digits, rounded).ptr);
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (static_cast<unsigned char>(c) >= ' ' || c == '\n')
      escaped += c;
  }
  return escaped;
}

void SvgPath::point(char command, Vec2 to) {
  const Vec2 p = map_->place(to);
  data_ += command;
  append_pixels(data_, p.x);
  append_pixels(data_ += ' ', p.y);
}

SvgPath& SvgPath::move(Vec2 to) { return point('M', to), *this; }

SvgPath& SvgPath::line(Vec2 to) { return point('L', to), *this; }

SvgPath& SvgPath::close() { return data_ += 'Z', *this; }

SvgPath& SvgPath::piece(const CurvePiece& piece) {
  const Vec2 chord = piece.to - piece.from;
  const bool flat = piece.is_line || map_->length(dot(chord, chord)) < 8 * kFlat * piece.radius;
  if (flat) return line(piece.to);
  data_ += 'A';
  append_pixels(data_, map_->length(piece.radius));
  append_pixels(data_ += ' ', map_->length(piece.radius));
  // No rotation, the smaller of the two arcs; y points down on the page, so counter-clockwise is SVG's sweep
  // 0.
  data_ += piece.ccw ? " 0 0 0 " : " 0 0 1 ";
  const Vec2 p = map_->place(piece.to);
  append_pixels(data_, p.x);
  append_pixels(data_ += ' ', p.y);
  return *this;
}

SvgWriter::SvgWriter(const PageMap& map, std::string_view title) : map_(map) {
  std::string width, height;
  append_pixels(width, map.size().x);
  append_pixels(height, map.size().y);
  text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
          width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + ' ' + height + "\">\n";
  if (!title.empty()) text_ += "  <title>" + xml_escaped(title) + "</title>\n";
  text_ += "  <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";  // dark viewers show nothing as black
}

void SvgWriter::begin(std::string_view name) {
  text_.append(2 * static_cast<std::size_t>(depth_), ' ');
  text_ += '<';
  text_ += name;
}

void SvgWriter::number(std::string_view name, double pixels) {
  text_ += ' ';
  text_ += name;
  append_pixels(text_ += "=\"", pixels);
  text_ += '"';
}

void SvgWriter::end(std::string_view name, std::string_view attributes, std::string_view content) {
  if (!attributes.empty()) text_ += ' ';
  text_ += attributes;
  if (content.empty()) {
    text_ += "/>\n";
    return;
  }
  text_ += '>';
  text_ += content;
  text_ += "</";
  text_ += name;
  text_ += ">\n";
}

void SvgWriter::open_group(std::string_view attributes) {
  begin("g");
  if (!attributes.empty()) text_ += ' ';
  text_ += attributes;
  text_ += ">\n";
  ++depth_;
}

void SvgWriter::close_group() {
  --depth_;
  text_.append(2 * static_cast<std::size_t>(depth_), ' ');
  text_ += "</g>\n";
}

void SvgWriter::path(const SvgPath& path, std::string_view attributes, std::string_view title) {
  begin("path");
  text_ += " d=\"" + path.data() + '"';
  end("path", attributes, title_element(title));
}

void SvgWriter::dot(Vec2 centre, double pixels, std::string_view attributes, std::string_view title) {
  const Vec2 at = map_.place(centre);
  begin("circle");
  number("cx", at.x);
  number("cy", at.y);
  number("r", pixels);
  end("circle", attributes, title_element(title));
}

void SvgWriter::circle(Vec2 centre, double radius, std::string_view attributes, std::string_view title) {
  dot(centre, map_.length(radius), attributes, title);
}

void SvgWriter::square(Vec2 centre, double pixels, std::string_view attributes, std::string_view title) {
  const Vec2 at = map_.place(centre);
  begin("rect");
  number("x", at.x - pixels);
  number("y", at.y - pixels);
  number("width", 2 * pixels);
  number("height", 2 * pixels);
  end("rect", attributes, title_element(title));
}

void SvgWriter::text(Vec2 at, Vec2 offset, std::string_view content, std::string_view attributes) {
  const Vec2 place = map_.place(at);
  begin("text");
  number("x", place.x + offset.x);
  number("y", place.y - offset.y);
  end("text", attributes, xml_escaped(content));
}

std::string SvgWriter::finish() && { return std::move(text_ += "</svg>\n"); }

}  // namespace crossloft
