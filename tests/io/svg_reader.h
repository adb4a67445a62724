#pragma once
/// Reads back the SVG that the library writes: elements with their attributes, paths with their arcs.

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "../../geom/vec2.h"

namespace svg {

using crossloft::Vec2;

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string title;  ///< of a <title> child
  std::string text;
  std::string group;  ///< the id of the innermost group around it

  double number(const std::string& key) const { return std::strtod(attributes.at(key).c_str(), nullptr); }
};

struct Document {
  Element root;
  std::vector<Element> elements;  ///< but for groups and titles
  bool well_formed = false;       ///< tags nest and close
};

inline std::string unescaped(std::string text) {
  const std::pair<const char*, const char*> entities[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};
  for (const auto& [entity, character] : entities) {
    for (std::size_t i = 0; (i = text.find(entity, i)) != std::string::npos; ++i) {
      text.replace(i, std::string(entity).size(), character);
    }
  }
  return text;
}

/// Name and attributes of "name a="b" c="d"".
inline Element parse_tag(const std::string& tag) {
  Element element;
  std::size_t i = tag.find_first_of(" /");
  element.name = tag.substr(0, i);
  while (i != std::string::npos && (i = tag.find_first_not_of(" /", i)) != std::string::npos) {
    const std::size_t equals = tag.find("=\"", i), end = tag.find('"', equals + 2);
    if (equals == std::string::npos || end == std::string::npos) break;
    element.attributes[tag.substr(i, equals - i)] = unescaped(tag.substr(equals + 2, end - equals - 2));
    i = end + 1;
  }
  return element;
}

/// The subset of XML that is written: tags, attributes in double quotes, text, one declaration.
inline Document parse(const std::string& text) {
  Document document;
  std::vector<Element> open;
  std::size_t at = 0;
  while ((at = text.find('<', at)) != std::string::npos) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return document;
    const std::string tag = text.substr(at + 1, end - at - 1);
    const std::string content = unescaped(text.substr(end + 1, text.find('<', end) - end - 1));
    at = end + 1;
    if (tag[0] == '?') continue;
    if (tag[0] != '/') {
      open.push_back(parse_tag(tag));
      open.back().text = content;
      for (const Element& outer : open) {
        if (outer.name == "g" && outer.attributes.count("id") != 0)
          open.back().group = outer.attributes.at("id");
      }
    } else if (open.empty() || tag.substr(1) != open.back().name) {
      return document;
    }
    if (tag[0] != '/' && tag.back() != '/') continue;
    const Element done = open.back();
    open.pop_back();
    if (done.name == "title" && !open.empty())
      open.back().title = done.text;
    else if (done.name == "svg")
      document.root = done;
    else if (done.name != "g")
      document.elements.push_back(done);
  }
  document.well_formed = open.empty() && document.root.name == "svg";
  return document;
}

/// A line (radius 0) or an arc of a path, in pixels, y down.
struct Segment {
  Vec2 from, to, centre;
  double radius = 0;
  bool sweep = false;  ///< clockwise on the page
};

/// The centre of an arc by its definition in SVG 1.1, appendix F.6.5; large arcs are not written.
inline Vec2 arc_centre(Vec2 from, Vec2 to, double radius, bool sweep) {
  const Vec2 chord = to - from;
  const double square = dot(chord, chord), height = std::sqrt(std::max(0.0, radius * radius / square - 0.25));
  const Vec2 across{-chord.y, chord.x};
  return 0.5 * (from + to) + (sweep ? height : -height) * across;
}

/// The segments of a path, closing ones included. Commands M L A Z, absolute.
inline std::vector<Segment> parse_path(const std::string& data) {
  std::vector<Segment> segments;
  Vec2 start, here;
  const char* at = data.c_str();
  const auto number = [&at] {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    at = end;
    return value;
  };
  const auto point = [&number] {
    const double x = number();
    return Vec2{x, number()};
  };
  while (*at != '\0') {
    const char command = *at++;
    Segment segment;
    segment.from = here;
    if (command == 'M') {
      start = here = point();
      continue;
    }
    if (command == 'A') {
      segment.radius = number();
      number(), number(), number();
      segment.sweep = number() != 0;
    }
    segment.to = command == 'Z' ? start : point();
    if (command == 'A') segment.centre = arc_centre(segment.from, segment.to, segment.radius, segment.sweep);
    here = segment.to;
    if (segment.from != segment.to) segments.push_back(segment);
  }
  return segments;
}

/// How often the ray from a point to the right crosses the segment.
inline int crossings(const Segment& s, Vec2 p) {
  if (s.radius == 0) {
    if ((s.from.y > p.y) == (s.to.y > p.y)) return 0;
    return s.from.x + (p.y - s.from.y) / (s.to.y - s.from.y) * (s.to.x - s.from.x) > p.x ? 1 : 0;
  }
  const double dy = p.y - s.centre.y, square = s.radius * s.radius - dy * dy;
  int count = 0;
  if (square <= 0) return 0;
  for (const double dx : {-std::sqrt(square), std::sqrt(square)}) {
    const Vec2 at{dx, dy}, a = s.from - s.centre, b = s.to - s.centre;
    const bool on_arc = s.sweep ? cross(a, at) > 0 && cross(at, b) > 0 : cross(a, at) < 0 && cross(at, b) < 0;
    if (on_arc && s.centre.x + dx > p.x) ++count;
  }
  return count;
}

/// Inside by the even-odd rule.
inline bool fills(const std::vector<Segment>& path, Vec2 p) {
  int count = 0;
  for (const Segment& segment : path) count += crossings(segment, p);
  return count % 2 != 0;
}

}  // namespace svg
