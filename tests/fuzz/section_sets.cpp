#include "section_sets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "contours.h"

namespace crossloft::test {
namespace {

constexpr Vec3 kNiceNormals[] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0},  {0, 0, -1}, {1, 1, 0},  {1, -1, 0},
                                 {1, 0, 1}, {0, 1, 1}, {1, 1, 1},  {1, -1, 1}, {1, 2, 0},  {2, 1, -2},
                                 {0, 3, 4}, {1, 2, 3}, {5, 0, 12}, {1, 0, -1}, {-1, -1, 1}};

/// Tilted by a hair, far from any short vector, or of an odd length.
constexpr Vec3 kNastyNormals[] = {{1, 1e-9, 0},           {1e-6, 0, 1},
                                  {0, 1, 1e-12},          {0.1, 0.2, 0.3},
                                  {0.577, 0.577, 0.5781}, {1e-200, 2e-200, 0},
                                  {3e150, 1e150, 1e140},  {-0.3, 0.7, 1.1},
                                  {1, 1 + 1e-10, 1},      {0.123456789, 0.987654321, -0.5},
                                  {1, 1e-3, 0},           {7e-8, 1, 1e-8}};

Vec3 draw_normal(ByteSource& bytes, bool nice) {
  return nice ? bytes.one_of(kNiceNormals) : bytes.one_of(kNastyNormals);
}

Vec3 draw_point(ByteSource& bytes, int reach) {
  const int x = bytes.between(-reach, reach), y = bytes.between(-reach, reach);
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(bytes.between(-reach, reach))};
}

void add_plane(Sections& sections, const PlaneFrame& frame, const std::vector<Polygon>& polygons) {
  PlaneSection plane = plane_of(frame);
  for (const Polygon& polygon : polygons) add_polygon(plane, frame, polygon);
  sections.planes.push_back(std::move(plane));
}

/// A contour of its own, the one of the plane before, or none.
void add_drawn(Sections& sections, const PlaneFrame& frame, ByteSource& bytes, std::vector<Polygon>& last) {
  const std::uint32_t choice = bytes.below(8);
  if (choice < 5 || last.empty()) last = draw_polygons(bytes);
  add_plane(sections, frame, choice == 7 ? std::vector<Polygon>{} : last);
}

Sections free_planes(ByteSource& bytes) {
  Sections sections;
  std::vector<Polygon> last;
  const std::uint32_t count = 1 + bytes.below(5);
  for (std::uint32_t p = 0; p < count; ++p) {
    const Vec3 normal = draw_normal(bytes, !bytes.one_in(3));
    add_drawn(sections, frame_of(normal, draw_point(bytes, 3)), bytes, last);
  }
  return sections;
}

/// Equal distances, unequal ones, by a hair, and the same plane again.
Sections parallel_planes(ByteSource& bytes) {
  static constexpr double kSteps[] = {1, 1, 2, 0.5, 5, 1e-3, 1e-9, 0};
  Sections sections;
  std::vector<Polygon> last;
  PlaneFrame frame = frame_of(draw_normal(bytes, !bytes.one_in(4)), draw_point(bytes, 2));
  const double unit = norm(frame.u) / norm(frame.normal);
  const std::uint32_t count = 2 + bytes.below(4);
  for (std::uint32_t p = 0; p < count; ++p) {
    add_drawn(sections, frame, bytes, last);
    frame.origin = frame.origin + bytes.one_of(kSteps) * unit * frame.normal;
  }
  return sections;
}

/// Planes through one line: b = 0 is the line in each of them, so contours touch it, end on it and cross it.
Sections pencil(ByteSource& bytes) {
  static constexpr std::array<int, 2> kTurns[] = {{1, 0}, {0, 1},  {1, 1}, {1, -1},
                                                  {2, 1}, {-1, 2}, {3, 4}, {100, 1}};
  Sections sections;
  std::vector<Polygon> last;
  const PlaneFrame across = frame_of(draw_normal(bytes, !bytes.one_in(4)), draw_point(bytes, 2));
  const std::uint32_t count = 2 + bytes.below(4);
  for (std::uint32_t p = 0; p < count; ++p) {
    const auto [s, t] = bytes.one_of(kTurns);
    const Vec3 way = static_cast<double>(s) * across.u + static_cast<double>(t) * across.v;
    add_drawn(sections, {cross(across.normal, way), across.origin, across.normal, way}, bytes, last);
  }
  if (bytes.one_in(3)) add_drawn(sections, across, bytes, last);
  return sections;
}

Sections planes_through_a_point(ByteSource& bytes) {
  Sections sections;
  std::vector<Polygon> last;
  const Vec3 point = draw_point(bytes, 2);
  const bool nice = !bytes.one_in(3);
  const std::uint32_t count = 3 + bytes.below(3);
  for (std::uint32_t p = 0; p < count; ++p)
    add_drawn(sections, frame_of(draw_normal(bytes, nice), point), bytes, last);
  return sections;
}

/// Circles of one sphere: all vertices are cospherical, up to rounding.
Sections cuts_of_a_sphere(ByteSource& bytes) {
  Sections sections;
  const Vec3 centre = draw_point(bytes, 2);
  const std::uint32_t count = 2 + bytes.below(4), corners = 3 + bytes.below(10);
  const bool nice = !bytes.one_in(3);
  for (std::uint32_t p = 0; p < count; ++p) {
    const Vec3 normal = draw_normal(bytes, nice);
    const double height = bytes.between(-5, 5);
    PlaneFrame frame = frame_of((1 / norm(normal)) * normal, centre);
    frame.origin = centre + height * frame.normal;
    const double radius = height * height < 25 ? std::sqrt(25 - height * height) : 0.5;
    add_plane(sections, frame, {circle(0, 0, radius, corners)});
  }
  return sections;
}

/// Circles about one line on parallel planes: equal ones, cones, cospherical ones, and pairs.
Sections coaxial_circles(ByteSource& bytes) {
  Sections sections;
  const std::uint32_t count = 2 + bytes.below(4), corners = 3 + bytes.below(10);
  const bool twice = bytes.one_in(4);
  for (std::uint32_t p = 0; p < count; ++p) {
    const PlaneFrame frame = frame_of({0, 0, 1}, {0, 0, static_cast<double>(bytes.between(0, 6))});
    std::vector<Polygon> polygons{circle(0, 0, bytes.between(1, 4), corners)};
    if (twice) polygons.push_back(circle(10, 0, bytes.between(1, 4), corners));
    if (bytes.one_in(4)) polygons.push_back(circle(0, 0, 0.5, 3 + bytes.below(5)));
    add_plane(sections, frame, polygons);
  }
  return sections;
}

struct Box {
  std::array<double, 3> low{}, high{};
};

Box draw_box(ByteSource& bytes, int from) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = bytes.between(0, 3) + (k == 0 ? from : 0);
    box.high[k] = box.low[k] + bytes.between(1, 4);
  }
  return box;
}

/// Planes of an integer grid through one or two boxes; a plane in a side of a box has that side, or nothing.
Sections grid(ByteSource& bytes) {
  Sections sections;
  std::vector<Box> boxes{draw_box(bytes, 0)};
  if (bytes.one_in(2)) boxes.push_back(draw_box(bytes, 8));
  const std::uint32_t count = 2 + bytes.below(5);
  for (std::uint32_t p = 0; p < count; ++p) {
    const std::uint32_t axis = bytes.below(3), i = (axis + 1) % 3, j = (axis + 2) % 3;
    const double at = bytes.between(0, 8);
    const bool sides = bytes.one_in(2);
    const auto unit = [](std::uint32_t k) {
      return Vec3{k == 0 ? 1. : 0., k == 1 ? 1. : 0., k == 2 ? 1. : 0.};
    };
    std::vector<Polygon> polygons;
    for (const Box& b : boxes)
      if (sides ? b.low[axis] <= at && at <= b.high[axis] : b.low[axis] < at && at < b.high[axis])
        polygons.push_back(rectangle(b.low[i], b.low[j], b.high[i], b.high[j]));
    add_plane(sections, {unit(axis), at * unit(axis), unit(i), unit(j)}, polygons);
  }
  return sections;
}

Surface draw_mesh(ByteSource& bytes) {
  switch (bytes.below(4)) {
    case 0:
      return torus(2, 1, 6 + bytes.below(4), 4 + bytes.below(3));
    case 1:
      return torus(3, 1, 5, 3);
    case 2:
      return box_mesh({{-2, -2, -2}, {2, 3, 1}});
    default:
      return genus2_solid(6);
  }
}

/// Slices of one mesh: by random planes, or by planes that may pass through its vertices and edges.
Sections slices(ByteSource& bytes) {
  const Surface mesh = draw_mesh(bytes);
  const std::uint32_t count = 1 + bytes.below(6);
  std::vector<CuttingPlane> planes;
  if (bytes.one_in(2)) {
    planes = random_planes(bounds_of(mesh.points), count, bytes.byte());
  } else {
    for (std::uint32_t p = 0; p < count; ++p) {
      const Vec3 normal = draw_normal(bytes, true);
      planes.push_back({normal, -dot(normal, 0.5 * draw_point(bytes, 3))});
    }
  }
  auto cut = slice(mesh, planes);
  return cut ? std::move(cut).value() : Sections{};
}

/// Rounded coordinates everywhere: what was exact is only nearly so.
Vec3 rotated(const Vec3& p) {
  return {0.36 * p.x + 0.48 * p.y - 0.8 * p.z, -0.8 * p.x + 0.6 * p.y, 0.48 * p.x + 0.64 * p.y + 0.6 * p.z};
}

void rotate(Sections& sections) {
  for (PlaneSection& plane : sections.planes) {
    plane.normal = rotated(plane.normal);
    for (Vec3& v : plane.vertices) v = rotated(v);
  }
}

void place(Sections& sections, double scale, const Vec3& by) {
  for (PlaneSection& plane : sections.planes) {
    plane.offset = scale * plane.offset - dot(plane.normal, by);
    for (Vec3& v : plane.vertices) v = scale * v + by;
  }
}

/// Each coordinate and offset by up to `size`, to one of three places.
void disturb(Sections& sections, double size, ByteSource& bytes) {
  const auto hair = [&] { return size * bytes.between(-1, 1); };
  for (PlaneSection& plane : sections.planes) {
    plane.offset += hair() * norm(plane.normal);
    for (Vec3& v : plane.vertices) v.x += hair(), v.y += hair(), v.z += hair();
  }
}

/// Whether the set is still what it was: slices disturbed need not agree.
bool change(Sections& sections, ByteSource& bytes) {
  static constexpr double kHairs[] = {1e-15, 1e-12, 1e-9, 1e-6, 1e-4};
  switch (bytes.below(16)) {
    case 10:
      place(sections, 1e-5, {});
      return true;
    case 11:
      place(sections, 1e7, {3e7, 1e6, -1e7});
      return true;
    case 12:
      place(sections, 0.1, {1e4, 0, 0});
      return false;  // coordinates are rounded to 1e-12
    case 13:
      rotate(sections);
      return true;
    case 14:
    case 15:
      disturb(sections, bytes.one_of(kHairs), bytes);
      return false;
    default:
      return true;
  }
}

Options draw_options(ByteSource& bytes) {
  static constexpr PruneMode kModes[] = {PruneMode::natural, PruneMode::natural, PruneMode::joint,
                                         PruneMode::paper};
  static constexpr double kConfidences[] = {-1, 1, 0, 0.5, -0.5};
  static constexpr double kSimplify[] = {1e-3, 0.05, 0.5};
  Options options;
  options.mode = bytes.one_of(kModes);
  if (!bytes.one_in(4)) return options;
  const std::uint32_t changes = bytes.byte();
  if (changes & 1) options.branching.mode = Branching::all;
  if (changes & 2) options.branching.mode = Branching::off;
  if (changes & 4) options.branching.cutting = true;
  if (changes & 8) options.simplify = bytes.one_of(kSimplify);
  if (changes & 16) options.match_tolerance = bytes.one_in(2) ? 0 : 0.1;
  if (changes & 32) options.separate = false;
  if (changes & 64) {
    options.natural.join_confidence = bytes.one_of(kConfidences);
    options.natural.dome_confidence = bytes.one_of(kConfidences);
    options.natural.alone_confidence = bytes.one_of(kConfidences);
    options.natural.cavity_confidence = bytes.one_of(kConfidences);
  }
  if (changes & 128) options.natural.smooth_weight = bytes.one_in(2) ? 0 : 100;
  return options;
}

/// Requests name two contours that are there; the others are an error of their own.
void draw_requests(const Sections& sections, Options& options, ByteSource& bytes) {
  const auto draw = [&](std::uint32_t& plane, std::uint32_t& contour) {
    plane = bytes.below(static_cast<std::uint32_t>(sections.planes.size()));
    const auto& edges = sections.planes[plane].edges;
    if (edges.empty()) return false;
    contour = edges[bytes.byte() % edges.size()].contour;
    return true;
  };
  JoinRequest request;
  if (sections.planes.empty() || !draw(request.plane_a, request.contour_a)) return;
  if (!draw(request.plane_b, request.contour_b)) return;
  if (request.plane_a == request.plane_b && request.contour_a == request.contour_b) return;
  request.join = bytes.one_in(2);
  options.joins.push_back(request);
}

struct Kind {
  const char* name;
  Sections (*draw)(ByteSource&);
};
constexpr Kind kKinds[] = {{"free", free_planes},
                           {"parallel", parallel_planes},
                           {"pencil", pencil},
                           {"point", planes_through_a_point},
                           {"sphere", cuts_of_a_sphere},
                           {"coaxial", coaxial_circles},
                           {"grid", grid},
                           {"slices", slices}};

}  // namespace

SectionSet draw_section_set(ByteSource& bytes) {
  SectionSet set;
  set.options = draw_options(bytes);
  const std::uint32_t extras = bytes.byte();
  set.threads = (extras & 7) == 7 ? 2 : 1;
  set.told_twice = (extras & 56) == 56;
  const Kind& kind = bytes.one_of(kKinds);
  set.kind = kind.name;
  set.sections = kind.draw(bytes);
  const bool as_drawn = change(set.sections, bytes);
  set.consistent = as_drawn && kind.draw == slices && !set.sections.planes.empty();
  if ((extras & 192) == 192) draw_requests(set.sections, set.options, bytes);
  return set;
}

}  // namespace crossloft::test
