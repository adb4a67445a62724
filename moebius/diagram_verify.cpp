#include <algorithm>
#include <array>
#include <cmath>

#include "diagram.h"

namespace crossloft {
namespace {

/// What the rounding of curves and vertices may add up to, as a part of the coordinates that go into them.
constexpr double kTolerance = 1e-6;

/// The cells that an arc leads into and out of its ends: at `from` the border of the left cell begins and
/// that of the right one ends.
struct ArcEnd {
  std::uint32_t begins = kNone, ends = kNone;
};

struct VertexArcs {
  std::uint32_t count = 0;
  std::array<ArcEnd, 3> ends{};
};

double distance(const MoebiusCurve& curve, Vec2 p) {
  const Vec2 d = p - curve.centre;
  return std::abs(curve.is_line ? cross(curve.direction, d) : std::sqrt(dot(d, d)) - curve.radius);
}

double size(Vec2 p) { return std::abs(p.x) + std::abs(p.y); }

const char* broken_end(const MoebiusDiagram& diagram, const MoebiusArc& arc, std::uint32_t v, double extent) {
  if (v == kNone) return nullptr;
  if (v >= diagram.vertices.size()) return "vertex out of range";
  const Vec2 p = diagram.vertices[v];
  const double scale = extent + size(p) + size(arc.curve.centre) + arc.curve.radius;
  return distance(arc.curve, p) <= kTolerance * scale ? nullptr : "end off its curve";
}

const char* broken_arc(const MoebiusDiagram& diagram, const MoebiusArc& arc, double extent) {
  const auto [i, j] = arc.sites;
  if (i >= diagram.sites.size() || j >= diagram.sites.size()) return "site out of range";
  if (i == j) return "one site on both sides";
  if (arc.curve.is_line != (diagram.sites[i].lambda == diagram.sites[j].lambda)) return "wrong kind of curve";
  if (!arc.curve.is_line && (arc.from == kNone) != (arc.to == kNone)) return "circle to infinity";
  if (const char* broken = broken_end(diagram, arc, arc.from, extent)) return broken;
  return broken_end(diagram, arc, arc.to, extent);
}

/// Three arcs, and the border of each of three cells comes in and goes out once.
bool is_sound(const VertexArcs& v) {
  if (v.count != 3) return false;
  std::array<std::uint32_t, 3> begins{}, ends{};
  for (std::size_t k = 0; k < 3; ++k) begins[k] = v.ends[k].begins, ends[k] = v.ends[k].ends;
  std::sort(begins.begin(), begins.end());
  std::sort(ends.begin(), ends.end());
  return begins == ends && begins[0] != begins[1] && begins[1] != begins[2];
}

std::string at(const char* what, std::size_t index, const char* broken) {
  return std::string(what) + " " + std::to_string(index) + ": " + broken;
}

}  // namespace

std::string verify(const MoebiusDiagram& diagram) {
  std::vector<VertexArcs> vertices(diagram.vertices.size());
  const auto add = [&](std::uint32_t v, ArcEnd end) {
    if (v == kNone) return;
    if (vertices[v].count < 3) vertices[v].ends[vertices[v].count] = end;
    ++vertices[v].count;
  };
  double extent = 0;
  for (const MoebiusSite& site : diagram.sites) extent = std::max(extent, size(site.p));
  for (std::size_t a = 0; a < diagram.arcs.size(); ++a) {
    const MoebiusArc& arc = diagram.arcs[a];
    if (const char* broken = broken_arc(diagram, arc, extent)) return at("arc", a, broken);
    add(arc.from, {arc.sites[0], arc.sites[1]});
    add(arc.to, {arc.sites[1], arc.sites[0]});
  }
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!is_sound(vertices[v])) return at("vertex", v, "not three arcs around three cells");
  return "";
}

}  // namespace crossloft
