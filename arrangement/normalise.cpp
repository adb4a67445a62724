#include "normalise.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <tuple>

#include "../geom/parallel.h"

namespace crossloft {
namespace {

/// A contour narrower than this fraction of the diagonal has no area: the frames resolve some 1e-11.
constexpr double kNoWidth = 1e-12;

/// Where an error is, in words of the file.
Error error_at(ErrorCode code, std::string message, const Sections& in, std::uint32_t plane,
               std::uint32_t contour = kNone, std::uint32_t line = 0) {
  return {code,    std::move(message),     in.source, line ? line : in.planes[plane].line,
          position_of(in, plane), contour};
}

bool is_wall(const ContourEdge& e) { return (e.material_a == 0) != (e.material_b == 0); }

double largest(Vec3 v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// Contour and line of the first edge at a vertex, for messages.
const ContourEdge* edge_at(const PlaneSection& plane, std::uint32_t vertex) {
  for (const ContourEdge& e : plane.edges)
    if (e.a == vertex || e.b == vertex) return &e;
  return nullptr;
}

/// Puts the different ones of `all` into `distinct`, in order; returns where each of `all` is there.
std::vector<std::uint32_t> distinct_vertices(const std::vector<Vec3>& all, std::vector<Vec3>& distinct) {
  struct Numbered {
    Vec3 at;
    std::uint32_t number;
  };
  std::vector<Numbered> sorted;
  sorted.reserve(all.size());
  for (const Vec3& v : all)
    sorted.push_back({v + Vec3{}, static_cast<std::uint32_t>(sorted.size())});  // -0 is 0
  std::sort(sorted.begin(), sorted.end(), [](const Numbered& v, const Numbered& w) { return v.at < w.at; });
  std::vector<std::uint32_t> index(all.size());
  distinct.reserve(all.size());
  for (const Numbered& v : sorted) {
    if (distinct.empty() || distinct.back() != v.at) distinct.push_back(v.at);
    index[v.number] = static_cast<std::uint32_t>(distinct.size() - 1);
  }
  return index;
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

  const std::vector<std::uint32_t> index = distinct_vertices(plane.vertices, s.vertices);
  s.walls.reserve(plane.edges.size());
  for (const ContourEdge& e : plane.edges) {
    if (!is_wall(e)) continue;
    const std::uint32_t a = index[e.a], b = index[e.b];
    s.walls.push_back({std::min(a, b), std::max(a, b), source, e.contour, e.line});
  }
  return s;
}

/// Drops vertices without wall and renumbers, keeping the order.
void drop_isolated(WallSection& s) {
  std::vector<std::uint32_t> index(s.vertices.size(), kNone);
  for (const WallEdge& w : s.walls) index[w.a] = index[w.b] = 0;
  if (std::find(index.begin(), index.end(), kNone) == index.end()) return;
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

Bounds extent_of(std::span<const WallSection> sections) {
  Bounds extent;
  for (const WallSection& s : sections) extent.join(bounds_of(s.vertices));
  return extent;
}

bool holds(const Bounds& box, const Bounds& other) {
  Bounds both = box;
  both.join(other);
  return both.low == box.low && both.high == box.high;
}

/// The extent that the sections have, or the whole file if they are a part of it: `whole` is what it says.
/// Where nothing is left, what has been dropped tells the size. Error: usage for a part beyond the whole.
Result<Done> measure(const Sections& in, const Bounds PartOf::*whole, NormalisedSections& out) {
  const Bounds own = extent_of(out.sections), extent = in.part_of ? (*in.part_of).*whole : own;
  if (!holds(extent, own))
    return Error{ErrorCode::usage, "a part of a file reaches beyond the extent that is given for the file",
                 in.source};
  if (!extent.empty()) out.extent = extent;
  out.diagonal = out.extent.diagonal();
  return Done{};
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
Result<Done> check_distances(const Sections& in, std::uint32_t plane, WallSection& s, double tolerance) {
  const double length = norm(s.normal);
  for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
    const double distance = std::fabs(dot(s.normal, s.vertices[v]) + s.offset) / length;
    s.off_plane = std::max(s.off_plane, distance);
    if (distance <= tolerance) continue;
    const WallEdge& w = first_wall_at(s, v);
    return error_at(ErrorCode::off_plane,
                    "a vertex is " + three_digits(distance) + " off its plane; the plane tolerance is " +
                        three_digits(tolerance),
                    in, plane, w.contour, w.line);
  }
  return Done{};
}

/// Some walls of a section, those of one contour.
using Contour = std::span<const WallEdge* const>;

/// Twice its area; 0 if it is too large to be told.
double triangle_of(const WallSection& s, const std::array<std::uint32_t, 3>& vertices) {
  const Vec3 a = s.vertices[vertices[0]], b = s.vertices[vertices[1]], c = s.vertices[vertices[2]];
  const double area = norm(cross(b - a, c - a));
  return std::isfinite(area) ? area : 0;
}

/// The vertices of a contour, ascending, once for each wall.
std::vector<std::uint32_t> ends_of(Contour contour) {
  std::vector<std::uint32_t> ends;
  for (const WallEdge* w : contour) ends.push_back(w->a), ends.push_back(w->b);
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// True iff the contour is closed and lies so near to one line that it has no width.
bool has_no_area(const WallSection& s, Contour contour, double diagonal) {
  const std::size_t third = contour.size() / 3;
  if (!may_be_flat(triangle_of(s, {contour[0]->a, contour[third]->a, contour[2 * third]->a}), diagonal))
    return false;
  const double width = kNoWidth * diagonal;
  std::vector<std::uint32_t> ends = ends_of(contour);
  for (std::size_t i = 0, next = 0; i < ends.size(); i = next) {
    while (next < ends.size() && ends[next] == ends[i]) ++next;
    if ((next - i) % 2 != 0) return false;
  }
  const Vec3 a = s.vertices[ends[0]];
  Vec3 along;
  double length = 0;
  for (const std::uint32_t v : ends)
    if (const double l = norm(s.vertices[v] - a); l > length) length = l, along = s.vertices[v] - a;
  if (length <= width) return true;
  const Vec3 unit = {along.x / length, along.y / length, along.z / length};
  return std::all_of(ends.begin(), ends.end(),
                     [&](std::uint32_t v) { return norm(cross(unit, s.vertices[v] - a)) <= width; });
}

/// The contours without area, ascending.
std::vector<std::uint32_t> flat_contours(const WallSection& s, double diagonal) {
  std::vector<const WallEdge*> walls;
  walls.reserve(s.walls.size());
  for (const WallEdge& w : s.walls) walls.push_back(&w);
  std::sort(walls.begin(), walls.end(), [](const WallEdge* x, const WallEdge* y) {
    return x->contour != y->contour ? x->contour < y->contour : x < y;  // of one array: by place
  });
  std::vector<std::uint32_t> flat;
  for (std::size_t i = 0, next = 0; i < walls.size(); i = next) {
    while (next < walls.size() && walls[next]->contour == walls[i]->contour) ++next;
    if (has_no_area(s, {walls.data() + i, next - i}, diagonal)) flat.push_back(walls[i]->contour);
  }
  return flat;
}

/// The contours that do not close by themselves, ascending.
std::vector<std::uint32_t> open_contours(const WallSection& s) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  // contour, vertex
  for (const WallEdge& w : s.walls) ends.insert(ends.end(), {{w.contour, w.a}, {w.contour, w.b}});
  std::sort(ends.begin(), ends.end());
  std::vector<std::uint32_t> open;
  for (std::size_t i = 0, next = 0; i < ends.size(); i = next) {
    while (next < ends.size() && ends[next] == ends[i]) ++next;
    const bool odd = (next - i) % 2 != 0;
    if (odd && (open.empty() || open.back() != ends[i].first)) open.push_back(ends[i].first);
  }
  return open;
}

/// Of the walls whose contours are not among these, which are in ascending order.
Bounds extent_without(const std::vector<std::uint32_t>& contours, const WallSection& s) {
  Bounds extent;
  for (const WallEdge& w : s.walls)
    if (!std::binary_search(contours.begin(), contours.end(), w.contour))
      extent.add(s.vertices[w.a]), extent.add(s.vertices[w.b]);
  return extent;
}

void warn_of_dropped(const std::vector<std::uint32_t>& before, const WallSection& s,
                     std::vector<std::string>& warnings) {
  const std::vector<std::uint32_t> after = contours_of(s.walls);
  for (const std::uint32_t c : before)
    if (!std::binary_search(after.begin(), after.end(), c))
      warnings.push_back("plane " + std::to_string(s.source) + ", contour " + std::to_string(c) +
                         ": dropped, it encloses no area");
}

/// The sections with what is left of their walls; the contours of each before pairs were cancelled.
Result<std::vector<WallSection>> collect_all(const Sections& in,
                                             std::vector<std::vector<std::uint32_t>>& contours,
                                             const Context& context) {
  std::vector<WallSection> sections(in.planes.size());
  const auto done = for_all(in.planes.size(), context, "sections", [&](std::size_t k) -> Result<Done> {
    const auto i = static_cast<std::uint32_t>(k);
    WallSection& s = sections[i] = collect_walls(in.planes[i], position_of(in, i));
    if (const WallEdge* w = open_end(s))
      return error_at(ErrorCode::open_chain, "the contour is not closed", in, i, w->contour, w->line);
    contours[i] = contours_of(s.walls);
    cancel_pairs(s.walls);
    drop_isolated(s);
    return Done{};
  });
  if (!done) return done.error();
  return sections;
}

void note_materials(const Sections& in, std::vector<std::string>& notes) {
  std::set<std::int32_t> materials;
  for (const PlaneSection& p : in.planes) add_materials(p, materials);
  if (materials.size() > 1) notes.push_back(note_of_materials(materials.size()));
}

}  // namespace

void add_materials(const PlaneSection& plane, std::set<std::int32_t>& materials) {
  std::int32_t last = 0;
  for (const ContourEdge& e : plane.edges)
    for (const std::int32_t m : {e.material_a, e.material_b})
      if (m != 0 && m != last) materials.insert(last = m);
}

std::string note_of_materials(std::size_t count) {
  return "the sections have " + std::to_string(count) + " materials: inside is any of them";
}

Result<Done> check_part(const Sections& in) {
  if (!in.part_of || in.part_of->positions.size() == in.planes.size()) return Done{};
  return Error{ErrorCode::usage, "a part of a file needs the position of each of its planes", in.source};
}

Result<Done> check_numbers(const Sections& in) {
  if (Result<Done> ok = check_part(in); !ok) return ok;
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

Result<Done> check_size(const Sections& in) {
  if (Result<Done> ok = check_part(in); !ok) return ok;
  for (std::uint32_t i = 0; i < in.planes.size(); ++i)
    for (const Vec3& v : in.planes[i].vertices)
      if (largest(v) > kLargestCoordinate && is_finite(v))
        return error_at(ErrorCode::too_large, "a coordinate is beyond 1e100", in, i);
  return Done{};
}

void drop_flat(WallSection& s, double diagonal) {
  const std::vector<std::uint32_t> flat = flat_contours(s, diagonal);
  if (flat.empty()) return;
  std::erase_if(s.walls,
                [&](const WallEdge& w) { return std::binary_search(flat.begin(), flat.end(), w.contour); });
  drop_isolated(s);
}

WallExtent wall_extent(const Sections& in) {
  std::vector<WallSection> sections;
  for (std::uint32_t i = 0; i < in.planes.size(); ++i) {
    sections.push_back(collect_walls(in.planes[i], i));
    cancel_pairs(sections.back().walls);
    drop_isolated(sections.back());
  }
  WallExtent out;
  const Bounds all = extent_of(sections);
  const double diagonal = all.diagonal();
  for (std::uint32_t i = 0; i < in.planes.size(); ++i) {
    const WallSection given = collect_walls(in.planes[i], i);  // pairs are not for single contours to cancel
    out.flat.push_back(flat_contours(given, diagonal));
    drop_flat(sections[i], diagonal);
    out.closed.join(extent_without(open_contours(given), sections[i]));
  }
  out.wide = extent_of(sections);
  if (out.wide.empty()) out.wide = all;
  return out;
}

double least_triangle(const WallSection& s) {
  struct Spread {
    std::uint32_t first = kNone, far = kNone;
    double length2 = -1, triangle = 0;
  };
  const std::vector<std::uint32_t> contours = contours_of(s.walls);
  std::vector<Spread> spreads(contours.size());
  const auto spread_of = [&](const WallEdge& w) -> Spread& {
    return spreads[static_cast<std::size_t>(std::lower_bound(contours.begin(), contours.end(), w.contour) -
                                            contours.begin())];
  };
  for (const WallEdge& w : s.walls) {
    Spread& c = spread_of(w);
    if (c.first == kNone) c.first = w.a;
    const Vec3 along = s.vertices[w.b] - s.vertices[c.first];
    if (const double l = dot(along, along); l > c.length2) c.length2 = l, c.far = w.b;
  }
  for (const WallEdge& w : s.walls) {
    Spread& c = spread_of(w);
    c.triangle = std::max(c.triangle, triangle_of(s, {c.first, c.far, w.b}));
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Spread& c : spreads) least = std::min(least, c.triangle);
  return least;
}

bool may_be_flat(double triangle, double diagonal) {
  return !(triangle > 100 * kNoWidth * diagonal * diagonal);
}

const PlaneSection* plane_at(const Sections& sections, std::uint32_t position) {
  for (std::uint32_t i = 0; sections.part_of && i < sections.planes.size(); ++i)
    if (sections.part_of->positions[i] == position) return &sections.planes[i];
  return sections.part_of || position >= sections.planes.size() ? nullptr : &sections.planes[position];
}

Result<std::vector<WallSection>> walls_of(const Sections& in) {
  if (Result<Done> ok = check_numbers(in); !ok) return ok.error();
  std::vector<std::vector<std::uint32_t>> contours(in.planes.size());
  return collect_all(in, contours, {});
}

void cancel_pairs(std::vector<WallEdge>& walls) {
  const auto key = [](const WallEdge& w) { return std::tie(w.a, w.b, w.plane, w.contour, w.line); };
  const auto before = [&](const auto& x, const auto& y) { return key(x) < key(y); };
  if (!std::is_sorted(walls.begin(), walls.end(), before)) std::sort(walls.begin(), walls.end(), before);
  auto kept = walls.begin();  // the end of those that stay
  for (std::size_t i = 0, next = 0; i < walls.size(); i = next) {
    const WallEdge first = walls[i];
    while (next < walls.size() && walls[next].a == first.a && walls[next].b == first.b) ++next;
    if ((next - i) % 2 == 1 && first.a != first.b) *kept++ = first;
  }
  walls.erase(kept, walls.end());
}

std::vector<std::uint32_t> contours_of(const std::vector<WallEdge>& walls) {
  std::vector<std::uint32_t> contours;
  for (const WallEdge& w : walls)
    if (contours.empty() || contours.back() != w.contour) contours.push_back(w.contour);
  std::sort(contours.begin(), contours.end());
  contours.erase(std::unique(contours.begin(), contours.end()), contours.end());
  return contours;
}

Result<NormalisedSections> normalise(const Sections& in, double plane_tolerance, const Context& context) {
  if (in.planes.empty()) return Error{ErrorCode::no_plane, "there is no cutting plane", in.source};
  if (Result<Done> ok = check_numbers(in); !ok) return ok.error();
  NormalisedSections out;
  if (!in.part_of) note_materials(in, out.notes);  // the rest may have others
  std::vector<std::vector<std::uint32_t>> contours(in.planes.size());
  auto collected = collect_all(in, contours, context);
  if (!collected) return collected.error();
  out.sections = std::move(collected).value();
  if (auto good = measure(in, &PartOf::extent, out); !good) return good.error();
  std::vector<std::vector<std::string>> warnings(in.planes.size());
  const auto checked = for_all(in.planes.size(), context, "sections", [&](std::size_t i) -> Result<Done> {
    WallSection& s = out.sections[i];
    const auto plane = static_cast<std::uint32_t>(i);
    if (Result<Done> ok = check_distances(in, plane, s, plane_tolerance * out.diagonal); !ok)
      return ok.error();
    drop_flat(s, out.diagonal);
    warn_of_dropped(contours[i], s, warnings[i]);
    return Done{};
  });
  if (!checked) return checked.error();
  for (const auto& list : warnings) out.warnings.insert(out.warnings.end(), list.begin(), list.end());
  // Without what has been dropped.
  if (auto good = measure(in, &PartOf::wide, out); !good) return good.error();
  return out;
}

}  // namespace crossloft
