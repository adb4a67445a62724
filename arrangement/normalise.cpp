#include "normalise.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace crossloft {
namespace {

/// A contour narrower than this fraction of the diagonal has no area: the frames resolve some 1e-11.
constexpr double kNoWidth = 1e-12;

/// Where an error is, in words of the file.
Error error_at(ErrorCode code, std::string message, const Sections& in, std::uint32_t plane,
               std::uint32_t contour = kNone, std::uint32_t line = 0) {
  return {code, std::move(message), in.source, line ? line : in.planes[plane].line, plane, contour};
}

bool is_wall(const ContourEdge& e) { return (e.material_a == 0) != (e.material_b == 0); }

double largest(Vec3 v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// Length without overflow of the squares.
double safe_norm(Vec3 v) {
  const double m = largest(v);
  if (m == 0 || !std::isfinite(m)) return m;
  int e = 0;
  std::frexp(m, &e);
  return std::ldexp(norm({std::ldexp(v.x, -e), std::ldexp(v.y, -e), std::ldexp(v.z, -e)}), e);
}

/// Contour and line of the first edge at a vertex, for messages.
const ContourEdge* edge_at(const PlaneSection& plane, std::uint32_t vertex) {
  for (const ContourEdge& e : plane.edges)
    if (e.a == vertex || e.b == vertex) return &e;
  return nullptr;
}

Result<Done> check_numbers(const Sections& in) {
  for (std::uint32_t i = 0; i < in.planes.size(); ++i) {
    const PlaneSection& p = in.planes[i];
    if (!is_finite(p.normal) || !std::isfinite(p.offset))
      return error_at(ErrorCode::not_finite, "the plane's coefficients are not finite", in, i);
    if (p.normal == Vec3{}) return error_at(ErrorCode::zero_normal, "the plane's normal is zero", in, i);
    for (const ContourEdge& e : p.edges)
      if (std::max(e.a, e.b) >= p.vertices.size())
        return error_at(ErrorCode::index_out_of_range,
                        "an edge names vertex " + std::to_string(std::max(e.a, e.b)) + " of " +
                            std::to_string(p.vertices.size()),
                        in, i, e.contour, e.line);
    for (std::uint32_t v = 0; v < p.vertices.size(); ++v)
      if (!is_finite(p.vertices[v])) {
        const ContourEdge* e = edge_at(p, v);
        return error_at(ErrorCode::not_finite, "vertex " + std::to_string(v) + " is not finite", in, i,
                        e ? e->contour : kNone, e ? e->line : 0);
      }
  }
  return Done{};
}

/// The section of one plane: walls between distinct vertices, all of them still there.
WallSection collect_walls(const PlaneSection& plane, std::uint32_t source) {
  WallSection s;
  s.source = source;
  int exponent = 0;
  std::frexp(largest(plane.normal), &exponent);
  const auto scaled = [&](double c) { return std::ldexp(c, -exponent); };
  s.normal = {scaled(plane.normal.x), scaled(plane.normal.y), scaled(plane.normal.z)};
  s.offset = scaled(plane.offset);

  const auto plain = [](Vec3 v) { return v + Vec3{}; };  // turns -0 into 0
  for (const Vec3& v : plane.vertices) s.vertices.push_back(plain(v));
  std::sort(s.vertices.begin(), s.vertices.end());
  s.vertices.erase(std::unique(s.vertices.begin(), s.vertices.end()), s.vertices.end());
  const auto index_of = [&](Vec3 v) {
    return static_cast<std::uint32_t>(std::lower_bound(s.vertices.begin(), s.vertices.end(), plain(v)) -
                                      s.vertices.begin());
  };
  for (const ContourEdge& e : plane.edges) {
    if (!is_wall(e)) continue;
    const std::uint32_t a = index_of(plane.vertices[e.a]), b = index_of(plane.vertices[e.b]);
    s.walls.push_back({std::min(a, b), std::max(a, b), source, e.contour, e.line});
  }
  return s;
}

/// Drops vertices without wall and renumbers, keeping the order.
void drop_isolated(WallSection& s) {
  std::vector<std::uint32_t> index(s.vertices.size(), kNone);
  for (const WallEdge& w : s.walls) index[w.a] = index[w.b] = 0;
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < index.size(); ++v)
    if (index[v] != kNone) {
      index[v] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(s.vertices[v]);
    }
  for (WallEdge& w : s.walls) w.a = index[w.a], w.b = index[w.b];
  s.vertices = std::move(kept);
}

/// A wall at a vertex of odd degree, or none.
const WallEdge* open_end(const WallSection& s) {
  std::vector<std::uint8_t> odd(s.vertices.size(), 0);
  for (const WallEdge& w : s.walls) odd[w.a] ^= 1, odd[w.b] ^= 1;
  for (const WallEdge& w : s.walls)
    if (odd[w.a] || odd[w.b]) return &w;
  return nullptr;
}

void find_extent(NormalisedSections& out) {
  bool first = true;
  for (const WallSection& s : out.sections)
    for (const Vec3& v : s.vertices) {
      if (first) out.low = out.high = v;
      first = false;
      out.low = {std::min(out.low.x, v.x), std::min(out.low.y, v.y), std::min(out.low.z, v.z)};
      out.high = {std::max(out.high.x, v.x), std::max(out.high.y, v.y), std::max(out.high.z, v.z)};
    }
  out.diagonal = safe_norm(out.high - out.low);
}

/// The wall at a vertex that comes first in the file. REQUIRES: there is one.
const WallEdge& first_wall_at(const WallSection& s, std::uint32_t v) {
  const WallEdge* first = nullptr;
  for (const WallEdge& w : s.walls)
    if ((w.a == v || w.b == v) && (!first || w.line < first->line)) first = &w;
  return *first;
}

std::string three_digits(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x, std::chars_format::general, 3).ptr};
}

/// The distances of the vertices from the plane; an error beyond the tolerance.
Result<Done> check_distances(const Sections& in, WallSection& s, double tolerance) {
  const double length = norm(s.normal);
  for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
    const double distance = std::fabs(dot(s.normal, s.vertices[v]) + s.offset) / length;
    s.off_plane = std::max(s.off_plane, distance);
    if (distance <= tolerance) continue;
    const WallEdge& w = first_wall_at(s, v);
    return error_at(ErrorCode::off_plane,
                    "a vertex is " + three_digits(distance) + " off its plane; the plane tolerance is " +
                        three_digits(tolerance),
                    in, s.source, w.contour, w.line);
  }
  return Done{};
}

/// True iff the walls, all of one contour, are closed and lie within `width` of one line.
bool has_no_area(const WallSection& s, const std::vector<const WallEdge*>& walls, double width) {
  std::map<std::uint32_t, int> degree;
  for (const WallEdge* w : walls) ++degree[w->a], ++degree[w->b];
  for (const auto& [v, d] : degree)
    if (d % 2 != 0) return false;
  const Vec3 a = s.vertices[degree.begin()->first];
  Vec3 along;
  double length = 0;
  for (const auto& [v, d] : degree)
    if (const double l = safe_norm(s.vertices[v] - a); l > length) length = l, along = s.vertices[v] - a;
  if (length <= width) return true;
  const Vec3 unit = {along.x / length, along.y / length, along.z / length};
  return std::all_of(degree.begin(), degree.end(), [&](const auto& entry) {
    return safe_norm(cross(unit, s.vertices[entry.first] - a)) <= width;
  });
}

using ContourSet = std::set<std::uint32_t>;
ContourSet contours_of(const WallSection& s) {
  ContourSet set;
  for (const WallEdge& w : s.walls) set.insert(w.contour);
  return set;
}

void drop_flat_contours(WallSection& s, double width) {
  std::map<std::uint32_t, std::vector<const WallEdge*>> by_contour;
  for (const WallEdge& w : s.walls) by_contour[w.contour].push_back(&w);
  ContourSet flat;
  for (const auto& [contour, walls] : by_contour)
    if (has_no_area(s, walls, width)) flat.insert(contour);
  std::erase_if(s.walls, [&](const WallEdge& w) { return flat.contains(w.contour); });
}

void warn_of_dropped(const ContourSet& before, const WallSection& s, std::vector<std::string>& warnings) {
  const ContourSet after = contours_of(s);
  for (const std::uint32_t c : before)
    if (!after.contains(c))
      warnings.push_back("plane " + std::to_string(s.source) + ", contour " + std::to_string(c) +
                         ": dropped, it encloses no area");
}

void note_materials(const Sections& in, std::vector<std::string>& notes) {
  std::set<std::int32_t> materials;
  for (const PlaneSection& p : in.planes)
    for (const ContourEdge& e : p.edges) materials.insert(e.material_a), materials.insert(e.material_b);
  materials.erase(0);
  if (materials.size() > 1)
    notes.push_back("the sections have " + std::to_string(materials.size()) +
                    " materials; inside means any of them");
}

}  // namespace

void cancel_pairs(std::vector<WallEdge>& walls) {
  const auto key = [](const WallEdge& w) { return std::tie(w.a, w.b, w.plane, w.contour, w.line); };
  std::sort(walls.begin(), walls.end(), [&](const auto& x, const auto& y) { return key(x) < key(y); });
  std::vector<WallEdge> kept;
  for (std::size_t i = 0, next = 0; i < walls.size(); i = next) {
    while (next < walls.size() && walls[next].a == walls[i].a && walls[next].b == walls[i].b) ++next;
    if ((next - i) % 2 == 1 && walls[i].a != walls[i].b) kept.push_back(walls[i]);
  }
  walls = std::move(kept);
}

Result<NormalisedSections> normalise(const Sections& in, double plane_tolerance) {
  if (in.planes.empty()) return Error{ErrorCode::no_plane, "there is no cutting plane", in.source};
  if (Result<Done> ok = check_numbers(in); !ok) return ok.error();
  NormalisedSections out;
  note_materials(in, out.notes);
  std::vector<ContourSet> contours;
  for (std::uint32_t i = 0; i < in.planes.size(); ++i) {
    WallSection& s = out.sections.emplace_back(collect_walls(in.planes[i], i));
    if (const WallEdge* w = open_end(s))
      return error_at(ErrorCode::open_chain, "the contour is not closed", in, i, w->contour, w->line);
    contours.push_back(contours_of(s));
    cancel_pairs(s.walls);
    drop_isolated(s);
  }
  find_extent(out);
  for (std::size_t i = 0; i < out.sections.size(); ++i) {
    WallSection& s = out.sections[i];
    if (Result<Done> ok = check_distances(in, s, plane_tolerance * out.diagonal); !ok) return ok.error();
    drop_flat_contours(s, kNoWidth * out.diagonal);
    drop_isolated(s);
    warn_of_dropped(contours[i], s, out.warnings);
  }
  find_extent(out);
  return out;
}

}  // namespace crossloft
