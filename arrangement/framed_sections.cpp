#include "framed_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../geom/frame.h"
#include "../geom/parallel.h"
#include "coplanar_sections.h"
#include "directions.h"
#include "normalise.h"
#include "plane_frames.h"

namespace crossloft {
namespace {

/// Planes that agree, or share a line or a point, up to this fraction of the diagonal do so exactly.
constexpr double kCoincidence = 1e-9;
constexpr double kCubeHalf = 562949953421312.0;  // 2^49

std::string count_of(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// A section on its way: what the file wants, in lattice units.
struct Candidate {
  const WallSection* section = nullptr;
  LatticeVector direction;
  WantedPlane plane;
  std::vector<LatticeVector> points;
};

Vec3 unit_vector(const LatticeVector& d) {
  const Vec3 v{static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2])};
  const double length = norm(v);
  return {v.x / length, v.y / length, v.z / length};
}

/// Signed distance of the wanted plane from the origin of the lattice: half way between the extreme vertices,
/// which makes the largest distance to a vertex least; what the file says where there are none.
double offset_of(const Candidate& c, const WorldGrid& grid) {
  const Vec3 n = c.plane.normal;
  if (c.section->vertices.empty()) {
    const Vec3 m = c.section->normal;
    return dot(n, grid.scaled((-c.section->offset / dot(m, m)) * m));
  }
  double low = dot(n, grid.scaled(c.section->vertices[0])), high = low;
  for (const Vec3& v : c.section->vertices) {
    const double s = dot(n, grid.scaled(v));
    low = std::min(low, s), high = std::max(high, s);
  }
  return low / 2 + high / 2;
}

/// True iff a plane without section meets the cube in which the arrangement is built.
bool comes_near(const Candidate& c) {
  const Vec3 n = c.plane.normal;
  return std::fabs(c.plane.offset) <= kCubeHalf * (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z));
}

/// By section.
std::vector<LatticeVector> directions_of(const NormalisedSections& in, const std::optional<PartOf>& part_of) {
  std::vector<LatticeVector> directions;
  for (const WallSection& s : in.sections) directions.push_back(quantise_direction(s.normal));
  unify_directions(directions);
  if (part_of && part_of->direction) std::fill(directions.begin(), directions.end(), *part_of->direction);
  return directions;
}

/// The candidates in an order that the file's does not enter, as far as they differ.
std::vector<Candidate> collect_candidates(const NormalisedSections& in,
                                          const std::vector<LatticeVector>& directions, FramedSections& out,
                                          const Context& context) {
  std::vector<Candidate> all(in.sections.size()), candidates;
  parallel_for(all.size(), context, "sections", [&](std::size_t i) {
    const WallSection& s = in.sections[i];
    Candidate& c = all[i] = {&s, directions[i], {}, {}};
    c.plane.normal = unit_vector(c.direction);
    c.plane.offset = offset_of(c, out.grid);
    c.points.reserve(s.vertices.size());
    for (const Vec3& v : s.vertices) c.points.push_back(out.grid.to_lattice(v));
  });
  if (context.cancelled()) return candidates;
  for (Candidate& c : all)
    if (!c.section->vertices.empty() || comes_near(c))
      candidates.push_back(std::move(c));
    else
      out.notes.push_back("plane " + std::to_string(c.section->source) +
                          ": left out, it has no contour and stays away from the others");
  const auto content = [](const Candidate& c) {
    return std::tie(c.direction, c.plane.offset, c.section->vertices);
  };
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Candidate& a, const Candidate& b) { return content(a) < content(b); });
  return candidates;
}

using Group = std::vector<const Candidate*>;

/// The one that stands for a group: the first with points, if any has some.
const Candidate& first_of(const Group& group) {
  const auto with_points =
      std::find_if(group.begin(), group.end(), [](const auto* c) { return !c->points.empty(); });
  return with_points == group.end() ? *group.front() : **with_points;
}

/// Of the box of all points; without any the foot of the origin.
LatticeVector centre_of(const Group& group) {
  const Candidate& first = first_of(group);
  if (first.points.empty()) {
    const Vec3 foot = first.plane.offset * first.plane.normal;
    return {static_cast<std::int64_t>(foot.x), static_cast<std::int64_t>(foot.y),
            static_cast<std::int64_t>(foot.z)};
  }
  LatticeVector low = first.points[0], high = low, centre{};
  for (const Candidate* c : group)
    for (const LatticeVector& p : c->points)
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  for (std::size_t k = 0; k < 3; ++k) centre[k] = low[k] + (high[k] - low[k]) / 2;
  return centre;
}

/// What to frame: one wish for the equal planes of a group.
PlaneWish wish_of(const Group& group) {
  const Candidate& first = first_of(group);
  PlaneWish wish{first.direction, first.plane, {}, centre_of(group)};
  for (const Candidate* c : group) wish.points.insert(wish.points.end(), c->points.begin(), c->points.end());
  return wish;
}

/// The section with its vertices on the lattice plane; notes how far they went.
LatticeSection snap(const Candidate& c, const WorldGrid& grid, FramedPlane& plane,
                    std::vector<std::string>& warnings) {
  LatticeSection s;
  s.input = c.section->vertices;
  s.walls = c.section->walls;
  s.vertices.reserve(c.points.size());
  for (std::size_t v = 0; v < c.points.size(); ++v) {
    s.vertices.push_back(make_point(snap_to_plane(plane.plane, c.points[v])));
    const LatticePoint& p = s.vertices.back();
    const Vec3 way = Vec3{p.x, p.y, p.z} - grid.scaled(s.input[v]);
    plane.displacement = std::max(plane.displacement, grid.unit() * norm(way));
  }
  plane.off_plane = std::max(plane.off_plane, c.section->off_plane);
  plane.sources.push_back(c.section->source);
  const auto before = contours_of(s.walls);
  tidy(s);
  const auto after = contours_of(s.walls);
  for (const std::uint32_t contour : before)
    if (!std::binary_search(after.begin(), after.end(), contour))
      warnings.push_back("plane " + std::to_string(c.section->source) + ", contour " +
                         std::to_string(contour) + ": dropped, it vanishes on the lattice");
  return s;
}

bool content_less(const LatticeSection& a, const LatticeSection& b) {
  const auto by_points = [](const LatticePoint& p, const LatticePoint& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  const auto by_ends = [](const WallEdge& x, const WallEdge& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  };
  if (std::lexicographical_compare(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                                   by_points))
    return true;
  if (std::lexicographical_compare(b.vertices.begin(), b.vertices.end(), a.vertices.begin(), a.vertices.end(),
                                   by_points))
    return false;
  return std::lexicographical_compare(a.walls.begin(), a.walls.end(), b.walls.begin(), b.walls.end(),
                                      by_ends);
}

void append(LatticeSection& to, const LatticeSection& from) {
  const auto shift = static_cast<std::uint32_t>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
  to.input.insert(to.input.end(), from.input.begin(), from.input.end());
  for (WallEdge w : from.walls) {
    w.a += shift, w.b += shift;
    to.walls.push_back(w);
  }
}

/// One section of several on one plane: equal ones count once, the others must be apart.
Result<LatticeSection> combine(const LatticePlane& plane, std::vector<LatticeSection> sections,
                               double tolerance, const Sections& in) {
  std::erase_if(sections, [](const LatticeSection& s) { return s.walls.empty(); });
  std::stable_sort(sections.begin(), sections.end(), content_less);
  std::vector<LatticeSection> kept;
  for (LatticeSection& s : sections) {
    bool known = false;
    for (const LatticeSection& k : kept) {
      const SectionRelation r = relation(plane, k, s, tolerance);
      if (r == SectionRelation::overlapping) {
        const auto [first, second] = std::minmax(k.walls[0].plane, s.walls[0].plane);
        return Error{ErrorCode::contradicting_planes,
                     "the section overlaps that of plane " + std::to_string(first) + " in the same plane",
                     in.source, plane_at(in, second)->line, second};
      }
      known = known || r == SectionRelation::same;
    }
    if (!known) kept.push_back(std::move(s));
  }
  if (kept.size() == 1) return std::move(kept[0]);  // it is tidy
  LatticeSection all;
  for (const LatticeSection& s : kept) append(all, s);
  tidy(all);
  return all;
}

/// How near two vertices of equal planes are one: the coincidence itself and the mesh of the plane's lattice.
double same_vertex_tolerance(const LatticePlane& p, double coincidence) {
  const Vec3 e{static_cast<double>(p.e2[0]), static_cast<double>(p.e2[1]), static_cast<double>(p.e2[2])};
  return coincidence + 2 * norm(e);
}

bool plane_less(const LatticePlane& a, const LatticePlane& b) {
  return a.normal != b.normal ? a.normal < b.normal : compare_offsets(a, b) < 0;
}

using Groups = std::vector<Group>;

/// Candidates by the planes that agree up to the tolerance.
Groups group_equal(const std::vector<Candidate>& candidates, double radius, double tolerance) {
  std::vector<WantedPlane> wanted;
  for (const Candidate& c : candidates) wanted.push_back(c.plane);
  const std::vector<std::uint32_t> first = find_equal_planes(wanted, radius, tolerance);
  Groups groups;
  std::vector<std::size_t> group_of(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (first[i] == i) group_of[i] = groups.size(), groups.emplace_back();
    groups[group_of[first[i]]].push_back(&candidates[i]);
  }
  return groups;
}

struct Framing {
  LatticePlane plane;
  Group members;
};

/// In canonical order; planes that became one on the lattice joined.
std::vector<Framing> sort_and_join(std::vector<LatticePlane> planes, Groups groups) {
  std::vector<Framing> framings;
  for (std::size_t i = 0; i < groups.size(); ++i) framings.push_back({planes[i], std::move(groups[i])});
  std::stable_sort(framings.begin(), framings.end(),
                   [](const Framing& a, const Framing& b) { return plane_less(a.plane, b.plane); });
  std::vector<Framing> joined;
  for (Framing& f : framings)
    if (!joined.empty() && same_plane(joined.back().plane, f.plane))
      joined.back().members.insert(joined.back().members.end(), f.members.begin(), f.members.end());
    else
      joined.push_back(std::move(f));
  // The origin of a joined plane must not depend on which came first.
  for (Framing& f : joined) f.plane = plane_through(f.plane.normal, f.plane.origin, centre_of(f.members));
  return joined;
}

/// A plane and what is to be told of it.
struct FinishedPlane {
  FramedPlane plane;
  std::vector<std::string> notes, warnings;
};

Result<Done> finish_plane(const Framing& framing, double tolerance, const Sections& in, const WorldGrid& grid,
                          FinishedPlane& out) {
  FramedPlane& plane = out.plane;
  plane.plane = framing.plane;
  std::vector<LatticeSection> sections;
  for (const Candidate* c : framing.members) sections.push_back(snap(*c, grid, plane, out.warnings));
  std::sort(plane.sources.begin(), plane.sources.end());
  if (plane.sources.size() > 1)
    out.notes.push_back("planes " + std::to_string(plane.sources[0]) + " and " +
                        std::to_string(plane.sources[1]) + (plane.sources.size() > 2 ? " and others" : "") +
                        " are one plane");
  Result<LatticeSection> section =
      combine(plane.plane, std::move(sections), same_vertex_tolerance(plane.plane, tolerance), in);
  if (!section) return section.error();
  plane.vertices = std::move(section->vertices);
  plane.input = std::move(section->input);
  plane.walls = std::move(section->walls);
  return Done{};
}

/// Snaps the sections, plane by plane.
Result<Done> finish_planes(const std::vector<Framing>& framings, double tolerance, const Sections& in,
                           FramedSections& out, const Context& context) {
  std::vector<FinishedPlane> finished(framings.size());
  const auto done = for_all(framings.size(), context, "sections", [&](std::size_t i) {
    return finish_plane(framings[i], tolerance, in, out.grid, finished[i]);
  });
  if (!done) {
    Error error = done.error();
    if (error.file.empty()) error.file = in.source;
    return error;
  }
  for (FinishedPlane& p : finished) {
    out.planes.push_back(std::move(p.plane));
    out.notes.insert(out.notes.end(), p.notes.begin(), p.notes.end());
    out.warnings.insert(out.warnings.end(), p.warnings.begin(), p.warnings.end());
  }
  return Done{};
}

void tell_of_coincidences(const PlaneFrames& frames, FramedSections& out) {
  out.pencils = frames.pencils;
  out.common_points = frames.points;
  if (frames.pencils)
    out.notes.push_back(count_of(frames.pencils, "line") + " of three or more planes kept exactly");
  if (frames.points)
    out.notes.push_back(count_of(frames.points, "point") + " of four or more planes kept exactly");
  if (frames.lost_pencils)
    out.notes.push_back(count_of(frames.lost_pencils, "line") +
                        " of three or more planes not kept: sliver cells may appear there");
  if (frames.lost_points)
    out.notes.push_back(count_of(frames.lost_points, "point") +
                        " of four or more planes not kept: sliver cells may appear there");
}

}  // namespace

PlaneSection plane_in_input(const LatticePlane& plane, const WorldGrid& grid) {
  PlaneSection section;
  section.normal = unit_vector(plane.normal);
  section.offset = -dot(section.normal, grid.from_lattice(make_point(plane.origin)));
  return section;
}

Result<Done> check_plane_tolerance(double tolerance) {
  if (tolerance >= 0 && tolerance <= 0.1) return Done{};
  return make_error(ErrorCode::usage, "the plane tolerance must be between 0 and 0.1");
}

Result<FramedSections> frame_sections(const Sections& in, double plane_tolerance, const Context& context) {
  if (auto good = check_plane_tolerance(plane_tolerance); !good) return good.error();
  Result<NormalisedSections> normalised = normalise(in, plane_tolerance, context);
  if (!normalised) return normalised.error();

  FramedSections out;
  out.notes = std::move(normalised->notes);
  out.warnings = std::move(normalised->warnings);
  out.diagonal = normalised->diagonal;
  out.whole = normalised->extent;
  if (out.diagonal == 0) {
    out.warnings.push_back(kNoContour);
    return out;
  }
  out.grid = WorldGrid(normalised->extent.low, normalised->extent.high);
  if (out.grid.unit() == 0)
    return Error{ErrorCode::too_large, "all contours together are smaller than some 1e-309", in.source};
  if (!out.grid.exact())
    out.notes.push_back(
        "the data are far from the origin for their size: coordinates are rounded when written");
  const double radius = std::ceil(out.diagonal / out.grid.unit() / 2), tolerance = 2 * radius * kCoincidence;

  const std::vector<Candidate> candidates =
      collect_candidates(*normalised, directions_of(*normalised, in.part_of), out, context);
  Groups groups = group_equal(candidates, radius, tolerance);
  std::vector<PlaneWish> wishes(groups.size());
  parallel_for(groups.size(), context, "sections", [&](std::size_t g) { wishes[g] = wish_of(groups[g]); });
  if (context.cancelled()) return Error{ErrorCode::cancelled, "cancelled", in.source};
  PlaneFrames frames = frame_planes(wishes, static_cast<std::int64_t>(radius), tolerance, context);
  if (context.cancelled()) return Error{ErrorCode::cancelled, "cancelled", in.source};
  tell_of_coincidences(frames, out);

  const auto done =
      finish_planes(sort_and_join(std::move(frames.planes), std::move(groups)), tolerance, in, out, context);
  if (!done) return done.error();
  if (std::all_of(out.planes.begin(), out.planes.end(),
                  [](const FramedPlane& p) { return p.walls.empty(); })) {
    out.planes.clear();  // there is no box around no vertex
    if (!in.part_of) out.warnings.push_back(kNoWideContour);
  }
  return out;
}

}  // namespace crossloft
