/// Fifth step: sections that agree on the common lines of their planes.
///
/// Round by round: every line gets its target (line_target.h), and where a section is not what the target
/// says it is changed by patches (line_patches.h). All patches of a round are made from the sections before
/// it. After a round without misfit all sections of a line have the same inside on it, and the ends of the
/// target's spans, the same doubles for all planes of the line, are vertices of all their contours.

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "../geom/disjoint_sets.h"
#include "line_patches.h"
#include "line_target.h"
#include "repair_steps.h"
#include "section_edit.h"
#include "segment_distance.h"

namespace crossloft::repair_steps {
namespace {

// Fractions of the diagonal.
constexpr double kCoincidence = 1e-9;  ///< planes through one line or point, as in the reconstruction
constexpr double kOnLine = 4e-9;  ///< a contour vertex this near is on the line: more than a step of the grid
constexpr double kLift = 4 * kOnLine;   ///< a vertex at this distance is certainly not
constexpr double kSpacing = 1.0 / 256;  ///< nodes of lines that are contested
constexpr std::uint32_t kMostRounds = 8;

/// What is wrong on one span of a line with one plane.
struct Contradiction {
  std::uint32_t line = 0, span = 0, plane = 0;
  std::vector<Misfit> misfits;
  Patch patch;
  double moved = 0;  ///< by the patch alone: the longest way between the contours before and after it

  double depth() const {
    double d = 0;
    for (const Misfit& m : misfits) d = std::max(d, m.depth);
    return d;
  }
};

class Agreement {
 public:
  explicit Agreement(Work& work) : work_(work) {}
  void run();

 private:
  /// A section with patches in it.
  struct Edited {
    PlaneSection section;
    SectionEdit edit;
    std::uint32_t pieces = 0;  ///< that were left over and went
    double largest_piece = 0;
  };

  void order_planes();
  void look();
  void look_at_line(std::uint32_t line, const std::vector<std::vector<const ContestedPoint*>>& contested);
  std::vector<ContestedPoint> contested_points() const;
  std::vector<bool> beyond_limit();
  void join_touching(DisjointSets& groups) const;
  bool apply();
  PlaneLines lines_in(std::uint32_t plane, const std::vector<bool>& left_out) const;
  void add_plugs(std::uint32_t plane, const PlaneLines& in_plane, std::vector<Patch>& patches) const;
  void make_patches();
  Edited edited(std::uint32_t plane, const std::vector<bool>& beyond) const;
  bool blame(std::uint32_t plane, const PlaneSection& section, const std::vector<bool>& beyond);
  std::vector<bool> decide(std::map<std::uint32_t, Edited>& sections);
  void replace(std::uint32_t plane, Edited&& edited);
  void tell_agreed(const Contradiction& c);
  void tell_left(const Contradiction& c, bool beyond);
  void tell_all_left();
  std::uint32_t lonely_line(std::uint32_t plane, Vec3 at) const;
  bool touches(std::uint32_t plane, Vec3 before, Vec3 at, Vec3 after) const;
  bool lift(std::uint32_t plane, Vec3 before, Vec3& at, Vec3 after) const;
  bool remove_touches(std::uint32_t plane);
  bool remove_all_touches();
  void tell_touches(std::uint32_t plane);
  void renew(std::uint32_t plane);
  bool cancelled() const { return work_.context.cancelled(); }
  RepairChange change_of(const Contradiction& c) const;
  std::string others_of(const Contradiction& c) const;
  WorkPlane& plane(std::uint32_t p) { return work_.planes[order_[p]]; }
  const WorkPlane& plane(std::uint32_t p) const { return work_.planes[order_[p]]; }

  Work& work_;
  std::vector<std::uint32_t> order_;  ///< canonical number of a plane -> position in work_.planes
  std::vector<UnitPlane> planes_;
  std::vector<SectionBoundary> sections_, originals_;  ///< as they are, as they were
  std::vector<CommonLine> lines_;
  std::vector<SharedPoint> points_;
  LineSetting setting_;
  // Of this round.
  std::vector<std::vector<Trace>> traces_;  ///< by line, by plane of the line
  std::vector<LineTarget> targets_;         ///< by line; empty where nothing is contested
  std::vector<ContestedPoint> contested_;
  std::vector<Contradiction> contradictions_;
};

/// By normal and offset, and not by the file's order.
void Agreement::order_planes() {
  for (std::uint32_t p = 0; p < work_.planes.size(); ++p) order_.push_back(p);
  const auto key = [&](std::uint32_t p) { return std::tie(work_.planes[p].normal, work_.planes[p].offset); };
  std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return key(a) < key(b); });
  for (const std::uint32_t p : order_) planes_.push_back({work_.planes[p].normal, work_.planes[p].offset});
  for (std::uint32_t p = 0; p < order_.size(); ++p)
    for (auto* list : {&sections_, &originals_})
      list->emplace_back(plane(p).section, planes_[p], work_.chart(plane(p)));
  const double tolerance = kCoincidence * work_.diagonal;
  lines_ = common_lines(planes_, {work_.middle, 0.51 * work_.diagonal}, tolerance);
  points_ = common_points(planes_, lines_, tolerance);
  setting_ = {sections_, kOnLine * work_.diagonal, kSpacing * work_.diagonal,
              work_.options.agree * work_.diagonal, 2 * work_.diagonal};
}

std::vector<ContestedPoint> Agreement::contested_points() const {
  std::vector<ContestedPoint> contested;
  for (const SharedPoint& point : points_) {
    bool in = false, out = false;
    double sum = 0;
    for (const std::uint32_t p : point.planes) {
      const double d = std::min(sections_[p].distance(point.point), setting_.far);
      if (d > setting_.on) (sections_[p].inside(point.point) ? in : out) = true;
      sum += d <= setting_.on ? 0 : sections_[p].inside(point.point) ? -d : d;
    }
    if (in && out) contested.push_back({point, sum / static_cast<double>(point.planes.size())});
  }
  return contested;
}

void Agreement::look_at_line(std::uint32_t line,
                             const std::vector<std::vector<const ContestedPoint*>>& contested) {
  const CommonLine& l = lines_[line];
  std::vector<Trace>& traces = traces_[line];
  for (const std::uint32_t p : l.planes) traces.push_back(sections_[p].trace(l, setting_.on));
  const double least = setting_.least;
  if (contested[line].empty() && !contradict(traces, least)) return;
  targets_[line] = line_target(setting_, l, traces, contested[line]);
  for (std::uint32_t s = 0; s < targets_[line].spans.size(); ++s)
    for (std::size_t k = 0; k < l.planes.size(); ++k) {
      const TargetSpan& span = targets_[line].spans[s];
      auto found = misfits(setting_, l, l.planes[k], traces[k], targets_[line], span);
      std::erase_if(found, [&](const Misfit& m) {
        // One that ends with the span is a crossing that is shifted by a hair; others come and go.
        const bool shifted = m.begin <= span.begin || m.end >= span.end;
        return shifted && m.end - m.begin < least &&
               std::none_of(contested[line].begin(), contested[line].end(), [&](auto* c) {
                 const double t = l.parameter(c->point.point);
                 return m.begin - setting_.on <= t && t <= m.end + setting_.on;
               });
      });
      if (!found.empty()) contradictions_.push_back({line, s, l.planes[k], std::move(found), {}, 0});
    }
}

/// Targets of all lines and what contradicts them.
void Agreement::look() {
  contested_ = contested_points();
  std::vector<std::vector<const ContestedPoint*>> contested(lines_.size());
  for (const ContestedPoint& c : contested_)
    for (const std::uint32_t l : c.point.lines) contested[l].push_back(&c);
  traces_.assign(lines_.size(), {});
  targets_.assign(lines_.size(), {});
  contradictions_.clear();
  for (std::uint32_t l = 0; l < lines_.size() && !cancelled(); ++l) look_at_line(l, contested);
}

/// Contradictions that can only be solved together: misfits of one line that touch, and those of several
/// lines at one contested point.
void Agreement::join_touching(DisjointSets& groups) const {
  const double tolerance = setting_.on;
  const auto touch = [&](const Contradiction& a, const Contradiction& b) {
    for (const Misfit& m : a.misfits)
      for (const Misfit& n : b.misfits)
        if (m.begin <= n.end + tolerance && n.begin <= m.end + tolerance) return true;
    return false;
  };
  const auto holds = [&](const Contradiction& a, Vec3 point) {
    const double t = lines_[a.line].parameter(point);
    return std::any_of(a.misfits.begin(), a.misfits.end(),
                       [&](const Misfit& m) { return m.begin - tolerance <= t && t <= m.end + tolerance; });
  };
  for (std::uint32_t i = 0; i < contradictions_.size(); ++i)
    for (std::uint32_t j = i + 1; j < contradictions_.size(); ++j)
      if (contradictions_[i].line == contradictions_[j].line && touch(contradictions_[i], contradictions_[j]))
        groups.join(i, j);
  for (const ContestedPoint& c : contested_) {
    std::uint32_t first = kNone;
    for (std::uint32_t i = 0; i < contradictions_.size(); ++i) {
      const auto& lines = c.point.lines;
      if (!std::binary_search(lines.begin(), lines.end(), contradictions_[i].line)) continue;
      if (!holds(contradictions_[i], c.point.point)) continue;
      if (first == kNone) first = i;
      groups.join(first, i);
    }
  }
}

/// [contradiction] it, or one that is solved together with it, needs more than the limit.
std::vector<bool> Agreement::beyond_limit() {
  DisjointSets groups(contradictions_.size());
  join_touching(groups);
  std::map<std::uint32_t, double> depth;
  for (std::uint32_t i = 0; i < contradictions_.size(); ++i) {
    double& d = depth[groups.find(i)];
    d = std::max(d, contradictions_[i].moved);
  }
  std::vector<bool> beyond;
  for (std::uint32_t i = 0; i < contradictions_.size(); ++i)
    beyond.push_back(depth[groups.find(i)] > work_.options.limit * work_.diagonal);
  return beyond;
}

RepairChange Agreement::change_of(const Contradiction& c) const {
  const CommonLine& line = lines_[c.line];
  RepairChange change;
  change.plane = plane(c.plane).source;
  change.count = static_cast<std::uint32_t>(c.misfits.size());
  change.distance = c.moved;
  const Misfit& m = c.misfits[0];
  change.point = line.at(m.begin / 2 + m.end / 2);
  if (!sections_[c.plane].empty()) sections_[c.plane].nearest(change.point, change.contour);
  return change;
}

/// "plane 3", the planes that share the line.
std::string Agreement::others_of(const Contradiction& c) const {
  std::vector<std::uint32_t> sources;
  for (const std::uint32_t p : lines_[c.line].planes)
    if (p != c.plane) sources.push_back(plane(p).source);
  std::sort(sources.begin(), sources.end());
  std::string text = sources.size() == 1 ? "plane " : "planes ";
  for (std::size_t k = 0; k < sources.size(); ++k) text += (k ? ", " : "") + std::to_string(sources[k]);
  return text;
}

void Agreement::tell_agreed(const Contradiction& c) {
  RepairChange change = change_of(c);
  change.kind = RepairKind::agreed;
  const bool in = targets_[c.line].spans[c.span].state == Inside::yes;
  change.text = (in ? "the section was extended" : "the section was taken back") +
                std::string(" on the common line with ") + others_of(c);
  work_.note(std::move(change));
}

void Agreement::tell_left(const Contradiction& c, bool beyond) {
  RepairChange change = change_of(c);
  change.kind = RepairKind::left_as_it_is;
  change.text = "the section disagrees on the common line with " + others_of(c) +
                (beyond ? ": more than the limit" : ": no way was found");
  work_.note(std::move(change));
}

PlaneLines Agreement::lines_in(std::uint32_t p, const std::vector<bool>& left_out) const {
  PlaneLines in_plane{sections_[p], {}};
  const double least = setting_.least;
  for (std::uint32_t l = 0; l < lines_.size(); ++l) {
    if (!std::binary_search(lines_[l].planes.begin(), lines_[l].planes.end(), p)) continue;
    LineInPlane line{&lines_[l], targets_[l].spans.empty() ? nullptr : &targets_[l], {}};
    for (std::size_t i = 0; i < contradictions_.size(); ++i) {
      const Contradiction& c = contradictions_[i];
      if (c.plane != p || c.line != l || left_out[i]) continue;
      const bool inside = targets_[l].spans[c.span].state == Inside::yes;
      for (const Misfit& m : c.misfits)
        line.corrections.emplace_back(sections_[p], lines_[l], targets_[l], m, inside, least);
    }
    in_plane.lines.push_back(std::move(line));
  }
  return in_plane;
}

/// Contested points of the plane that one of its misfits holds.
void Agreement::add_plugs(std::uint32_t p, const PlaneLines& in_plane, std::vector<Patch>& patches) const {
  for (const ContestedPoint& c : contested_) {
    if (!std::binary_search(c.point.planes.begin(), c.point.planes.end(), p)) continue;
    std::vector<const CommonLine*> through;
    for (const std::uint32_t l : c.point.lines) through.push_back(&lines_[l]);
    const bool inside = c.blend < 0;
    const bool misfit = std::any_of(in_plane.lines.begin(), in_plane.lines.end(), [&](const LineInPlane& l) {
      if (std::find(through.begin(), through.end(), l.line) == through.end()) return false;
      const double t = l.line->parameter(c.point.point);
      return std::any_of(l.corrections.begin(), l.corrections.end(), [&](const Correction& correction) {
        return correction.holds(t) && correction.inside() == inside;
      });
    });
    if (!misfit) continue;
    const double radius = setting_.least;
    patches.push_back(plug(in_plane, c.point.point, through, inside, radius));
  }
}

/// Gives every contradiction its patch, and how far that moves the contour: a gulf or a spit that is narrower
/// than the patch is high vanishes whole, however deep it is.
void Agreement::make_patches() {
  for (std::uint32_t p = 0; p < order_.size(); ++p) {
    if (std::none_of(contradictions_.begin(), contradictions_.end(), [&](auto& c) { return c.plane == p; }))
      continue;
    const PlaneLines in_plane = lines_in(p, std::vector<bool>(contradictions_.size(), false));
    for (Contradiction& c : contradictions_) {
      if (c.plane != p || cancelled()) continue;
      const auto line = std::find_if(in_plane.lines.begin(), in_plane.lines.end(),
                                     [&](const LineInPlane& l) { return l.line == &lines_[c.line]; });
      c.patch = lens(in_plane, static_cast<std::size_t>(line - in_plane.lines.begin()),
                     targets_[c.line].spans[c.span], setting_.least);
      PlaneSection alone = plane(p).section;
      edit_section(alone, work_.chart(plane(p)), {&c.patch, 1}, {}, work_.context);
      drop_crumbs(alone, in_plane, 2 * kPush * c.depth());
      const SectionBoundary after(alone, planes_[p], work_.chart(plane(p)));
      c.moved = std::max(c.depth(), largest_distance(sections_[p], after));
    }
  }
}

/// The section with the patches of its contradictions that are not beyond the limit.
Agreement::Edited Agreement::edited(std::uint32_t p, const std::vector<bool>& beyond) const {
  Edited result{plane(p).section, {}, 0, 0};
  std::vector<Patch> patches;
  for (std::size_t i = 0; i < contradictions_.size(); ++i) {
    if (contradictions_[i].plane != p || beyond[i]) continue;
    patches.push_back(contradictions_[i].patch);
    result.largest_piece = std::max(result.largest_piece, 2 * kPush * contradictions_[i].depth());
  }
  const PlaneLines in_plane = lines_in(p, beyond);
  add_plugs(p, in_plane, patches);
  result.edit = edit_section(result.section, work_.chart(plane(p)), patches, {}, work_.context);
  result.pieces = drop_crumbs(result.section, in_plane, result.largest_piece);
  return result;
}

/// Where patches go beyond the limit together, the contradiction nearest to the place is held to be beyond
/// it.
bool Agreement::blame(std::uint32_t p, const PlaneSection& section, const std::vector<bool>& beyond) {
  const SectionBoundary now(section, planes_[p], work_.chart(plane(p)));
  Vec3 where;
  const double way = largest_distance(originals_[p], now, &where);
  if (way <= work_.options.limit * work_.diagonal) return false;
  double least = HUGE_VAL;
  Contradiction* nearest = nullptr;
  for (std::size_t i = 0; i < contradictions_.size(); ++i) {
    Contradiction& c = contradictions_[i];
    if (c.plane != p || beyond[i]) continue;
    for (const Misfit& m : c.misfits) {
      const CommonLine& l = lines_[c.line];
      const double d = distance_to_segment(l.at(m.begin), l.at(m.end), where);
      if (d < least) least = d, nearest = &c;
    }
  }
  if (nearest) nearest->moved = std::max(nearest->moved, way);
  return nearest != nullptr;
}

/// [contradiction] it can't be solved within the limit; and the sections with the others solved.
std::vector<bool> Agreement::decide(std::map<std::uint32_t, Edited>& sections) {
  for (;;) {
    const std::vector<bool> beyond = beyond_limit();
    sections.clear();
    for (std::size_t i = 0; i < contradictions_.size(); ++i)
      if (const std::uint32_t p = contradictions_[i].plane; !beyond[i] && !sections.contains(p))
        sections.emplace(p, edited(p, beyond));
    bool blamed = false;
    for (const auto& [p, e] : sections) blamed |= blame(p, e.section, beyond);
    if (!blamed) return beyond;
  }
}

void Agreement::replace(std::uint32_t p, Edited&& e) {
  WorkPlane& w = plane(p);
  w.section = std::move(e.section);
  w.edited |= e.edit.changed;
  renew(p);
  if (e.pieces != 0)
    work_.note({RepairKind::pieces_left_out, w.source, kNone, kNone, e.pieces, e.largest_piece, e.edit.point,
                count_of(e.pieces, "piece", "pieces") + " of the section that its changes left over"});
  if (e.edit.borders != 0)
    work_.note({RepairKind::borders_left_out, w.source, kNone, kNone, e.edit.borders, 0, e.edit.point,
                count_of(e.edit.borders, "edge", "edges") + " between two materials left out"});
}

/// False if there was nothing to do.
bool Agreement::apply() {
  std::map<std::uint32_t, Edited> sections;
  const std::vector<bool> beyond = decide(sections);
  for (std::size_t i = 0; i < contradictions_.size(); ++i)
    if (!beyond[i]) tell_agreed(contradictions_[i]);
  for (auto& [p, e] : sections) replace(p, std::move(e));
  return !sections.empty();
}

void Agreement::tell_all_left() {
  std::map<std::uint32_t, Edited> sections;
  const std::vector<bool> beyond = decide(sections);
  for (std::size_t i = 0; i < contradictions_.size(); ++i) tell_left(contradictions_[i], beyond[i]);
}

/// A common line that the point of the plane is on and no other section is cut at there, kNone if there is
/// none.
std::uint32_t Agreement::lonely_line(std::uint32_t p, Vec3 at) const {
  const double on = 2 * setting_.on;
  for (std::uint32_t l = 0; l < lines_.size(); ++l) {
    const CommonLine& line = lines_[l];
    const double t = line.parameter(at);
    if (!std::binary_search(line.planes.begin(), line.planes.end(), p) || norm(line.at(t) - at) > on)
      continue;
    bool shared = false;
    for (std::size_t k = 0; k < line.planes.size(); ++k)
      shared |= line.planes[k] != p && std::any_of(traces_[l][k].cuts.begin(), traces_[l][k].cuts.end(),
                                                   [&](double cut) { return std::fabs(cut - t) <= on; });
    if (!shared) return l;
  }
  return kNone;
}

/// The contour leaves such a line on the side it came from, or runs along it.
bool Agreement::touches(std::uint32_t p, Vec3 before, Vec3 at, Vec3 after) const {
  const std::uint32_t l = lonely_line(p, at);
  if (l == kNone) return false;
  const Vec3 aside = cross(planes_[p].normal, lines_[l].direction);
  const double b = dot(aside, before - at), a = dot(aside, after - at), on = 2 * setting_.on;
  return !(std::fabs(b) > on && std::fabs(a) > on && (b < 0) != (a < 0));
}

/// In lexicographic order.
std::vector<std::uint32_t> vertices_from(const PlaneSection& s, std::uint32_t first) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = first; v < s.vertices.size(); ++v) order.push_back(v);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t v, std::uint32_t w) { return s.vertices[v] < s.vertices[w]; });
  return order;
}

std::uint32_t other_end(const ContourEdge& e, std::uint32_t v) { return e.a == v ? e.b : e.a; }

/// Off its line by a few steps of the grid, to the side of a neighbour that is not on it: a contour that
/// comes over the line at one place and runs along it to another leaves it where it comes. False if both
/// neighbours are on it, or other lines are near.
bool Agreement::lift(std::uint32_t p, Vec3 before, Vec3& at, Vec3 after) const {
  const std::uint32_t l = lonely_line(p, at);
  const Vec3 aside = cross(planes_[p].normal, lines_[l].direction);
  const double b = dot(aside, before - at), a = dot(aside, after - at);
  const double off = std::fabs(a) > std::fabs(b) ? a : b, height = kLift * work_.diagonal;
  if (std::fabs(off) < 2 * height) return false;
  for (std::uint32_t k = 0; k < lines_.size(); ++k) {
    const CommonLine& line = lines_[k];
    if (k != l && std::binary_search(line.planes.begin(), line.planes.end(), p) &&
        norm(line.at(line.parameter(at)) - at) < 2 * height)
      return false;
  }
  const PlaneChart chart = work_.chart(plane(p));
  at = chart.to_space(chart.to_grid(at + (off < 0 ? -height : height) * aside));
  return true;
}

/// Next to common points lenses are no higher than a step of the grid, and new vertices may come to lie on a
/// line that the contour does not cross there; others were crossings of an earlier round. The reconstruction
/// would take them for crossings. They go if the contour hardly moves, and off the line if not.
bool Agreement::remove_touches(std::uint32_t p) {
  PlaneSection& s = plane(p).section;
  auto walls = edges_by_vertex(s);
  const double least = setting_.least;
  bool any = false;
  for (const std::uint32_t v : vertices_from(s, plane(p).given)) {
    if (walls[v].size() != 2) continue;
    ContourEdge &e = s.edges[walls[v][0]], &f = s.edges[walls[v][1]];
    const std::uint32_t u = other_end(e, v), w = other_end(f, v);
    if (u == w || !touches(p, s.vertices[u], s.vertices[v], s.vertices[w])) continue;
    if (distance_to_segment(s.vertices[u], s.vertices[w], s.vertices[v]) > least) {
      any |= lift(p, s.vertices[u], s.vertices[v], s.vertices[w]);
      continue;
    }
    std::replace(walls[w].begin(), walls[w].end(), walls[v][1], walls[v][0]);
    walls[v].clear();
    e.a = u, e.b = w;
    f.a = f.b = v;
  }
  any |= std::erase_if(s.edges, [](const ContourEdge& e) { return e.a == e.b; }) != 0;
  if (any) renew(p);
  return any;
}

bool Agreement::remove_all_touches() {
  bool any = false;
  for (std::uint32_t p = 0; p < order_.size(); ++p)
    if (plane(p).edited && remove_touches(p)) any = true;
  return any;
}

/// New vertices on a line that no other section is cut at there, where contours touch each other or the line.
void Agreement::tell_touches(std::uint32_t p) {
  const PlaneSection& s = plane(p).section;
  const auto walls = edges_by_vertex(s);
  for (const std::uint32_t v : vertices_from(s, plane(p).given)) {
    const bool pinch = walls[v].size() > 2 && lonely_line(p, s.vertices[v]) != kNone;
    const auto neighbour = [&](std::size_t k) { return s.vertices[other_end(s.edges[walls[v][k]], v)]; };
    if (!pinch && (walls[v].size() != 2 || !touches(p, neighbour(0), s.vertices[v], neighbour(1)))) continue;
    work_.note({RepairKind::left_as_it_is, plane(p).source, kNone, kNone, 1, 0, s.vertices[v],
                pinch ? "contours touch on a common line: no way was found"
                      : "the contour touches a common line: no way was found"});
  }
}

void Agreement::renew(std::uint32_t p) {
  sections_[p] = SectionBoundary(plane(p).section, planes_[p], work_.chart(plane(p)));
}

void Agreement::run() {
  order_planes();
  for (std::uint32_t round = 0; round < kMostRounds; ++round) {
    if (cancelled()) return;
    look();
    make_patches();
    ++work_.result.rounds;
    if (!apply() && !remove_all_touches()) break;
  }
  look();
  make_patches();
  tell_all_left();
  for (std::uint32_t p = 0; p < order_.size(); ++p)
    if (plane(p).edited) tell_touches(p);
}

}  // namespace

void repair_agreement(Work& work) { Agreement(work).run(); }

}  // namespace crossloft::repair_steps
