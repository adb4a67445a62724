#include "branching.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "../geom/lattice_rounding.h"
#include "../moebius/arc_sampling.h"
#include "../moebius/cutting.h"
#include "open_face.h"
#include "section_map.h"

namespace crossloft {
namespace {

/// Distance between samples, in mean contour edges at the two sites. In the scenes of one circle under
/// several, 1 to 3 gave the same volume within 2 %; at 4 pieces of sections stayed bare.
constexpr double kSpacing = 2;
/// Distance of samples from the section's border, in the same edges: nearer ones would break up contour
/// edges.
constexpr double kClearance = 0.5;
/// Least distance between samples, in diagonals of the section's box: between sections that are tiny against
/// the one that branches, the edges alone would ask for any number of samples.
constexpr double kLeastSpacing = 1.0 / 256;

/// A point that may become a sample.
struct Candidate {
  Vec2 at;
  std::uint32_t triangle = kNone;         ///< of its face
  double spacing = 0;                     ///< wanted distance from other samples
  std::array<std::uint32_t, 3> labels{};  ///< section components: its own and those of the two sites
  bool always = false;                    ///< of use wherever it is
};

/// Puts first the candidates where three or more components meet: there the section comes apart three ways,
/// and a sample beside the place would serve two of them. Arcs that meet end at the same bits.
void junctions_first(std::vector<Candidate>& candidates) {
  std::vector<std::pair<Vec2, std::uint32_t>> met;  // place, component that comes there
  for (const Candidate& c : candidates)
    for (const std::uint32_t label : {c.labels[1], c.labels[2]}) met.emplace_back(c.at, label);
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  std::stable_partition(candidates.begin(), candidates.end(), [&](const Candidate& c) {
    const auto at = std::lower_bound(met.begin(), met.end(), std::pair{c.at, std::uint32_t{0}});
    return met.end() - at > 2 && (at + 2)->first == c.at;
  });
}

/// A face while its samples are chosen.
struct FaceState {
  std::size_t face;  ///< of the cell
  OpenFace open;
  std::vector<Vec2> taken;  ///< plane coordinates of the samples
  FaceBranching& out;
};

SectionMap section_map(const CellFace& face, const FaceFrame& frame, std::span<const LatticePoint> points) {
  std::vector<Vec2> at;
  for (const std::uint32_t number : face.numbers) at.push_back(frame.to_plane(points[number]));
  return SectionMap(*face.triangulation, std::move(at), face.side == 0);
}

}  // namespace

/// What sampling the faces of one cell has in common.
class BranchingCell::Sampler {
 public:
  Sampler(const BranchingCell& cell, const CellTriangulation& triangulation, bool draw_all);
  CellBranching run();

 private:
  /// Bits of the faces (of one word) whose arcs between a and b may carry samples.
  std::uint64_t wanted(std::uint32_t a, std::uint32_t b) const;
  bool is_over_hole(std::uint32_t a, std::uint32_t b) const;
  std::vector<FaceArc> cutting(std::size_t face, std::span<const FaceArc> all,
                               const CellDiagrams& diagrams) const;
  void add_candidates(std::size_t face, std::span<const FaceArc> arcs, const CellDiagrams& diagrams,
                      bool cutting);
  void collect_arcs();
  void find_lacking();
  bool is_of_use(const Candidate& c) const;
  void take(std::size_t face, FaceBranching& out) const;
  std::vector<Vec2> feet(const FaceBranching& face) const;
  bool stopped(std::size_t face, Vec2 a, double radius) const;
  bool keep(const Candidate& c, FaceState& state) const;

  const BranchingCell& cell_;
  const CellVertices& vertices_;
  TetMesh mesh_;
  std::vector<FaceFrame> frames_;
  std::vector<SectionMap> maps_;
  std::vector<Box2> regions_;
  std::vector<double> spacing_;  ///< by vertex
  std::vector<std::array<std::uint32_t, 2>>
      neighbours_;                           ///< pairs of vertices joined by a section's border, sorted
  std::vector<std::uint64_t> with_section_;  ///< bits of faces, by word
  std::vector<std::uint64_t>
      lacking_faces_;  ///< those of faces with a component that is bare or flat somewhere
  std::vector<std::vector<FaceArc>> arcs_;     ///< by face
  std::vector<std::vector<Candidate>> found_;  ///< by face
  std::vector<std::uint8_t> lacking_;  ///< by component: it is flat somewhere on its branching diagram
  std::uint32_t word_ = 0;
};

BranchingCell::BranchingCell(const SectionGraph& graph, const Arrangement& arrangement,
                             const PlaneLocators& locators, std::span<const FaceId> ids,
                             std::span<const CellFace> faces, std::span<const LatticePoint> points,
                             const BranchingOptions& options)
    : graph_(graph),
      arrangement_(arrangement),
      locators_(locators),
      ids_(ids),
      faces_(faces),
      points_(points),
      options_(options) {
  label_vertices();
}

/// A section component of a cell: internal triangles of its faces that hang together at vertices.
void BranchingCell::label_vertices() {
  for (const CellFace& face : faces_)
    numbers_.insert(numbers_.end(), face.numbers.begin(), face.numbers.end());
  std::sort(numbers_.begin(), numbers_.end());
  numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
  std::vector<std::uint32_t> parent(numbers_.size(), kNone);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const CellFace& face : faces_) {
    auto& local = local_.emplace_back();
    for (const std::uint32_t number : face.numbers)
      local.push_back(static_cast<std::uint32_t>(std::lower_bound(numbers_.begin(), numbers_.end(), number) -
                                                 numbers_.begin()));
    for (std::size_t t = 0; t < face.triangulation->triangles.size(); ++t) {
      if (face.triangulation->internal[t] == 0) continue;
      const auto& v = face.triangulation->triangles[t];
      for (const std::uint32_t corner : v)
        if (parent[local[corner]] == kNone) parent[local[corner]] = local[corner];
      for (const std::uint32_t other : {v[1], v[2]}) {
        const std::uint32_t a = root(local[v[0]]), b = root(local[other]);
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  labels_.assign(numbers_.size(), kNone);
  for (std::uint32_t v = 0; v < parent.size(); ++v)
    if (parent[v] != kNone) {
      labels_[v] = root(v);
      components_ += labels_[v] == v;
    }
}

void BranchingCell::find_bare() {
  bare_.assign(labels_.size(), 1);
  flat_.assign(labels_.size(), 0);
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (std::size_t t = 0; t < faces_[f].triangulation->triangles.size(); ++t) {
      if (faces_[f].triangulation->internal[t] == 0) continue;
      const std::uint32_t label = label_of(f, t);
      if (faces_[f].covers(t))
        bare_[label] = 0;
      else if (!faces_[f].covered_behind(t))
        flat_[label] = 1;
    }
}

bool BranchingCell::lacks_on(std::size_t face) const {
  const FaceTriangulation& triangulation = *faces_[face].triangulation;
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    if (triangulation.internal[t] == 0) continue;
    const std::uint32_t label = label_of(face, t);
    if (bare_[label] != 0 || flat_[label] != 0) return true;
  }
  return false;
}

bool BranchingCell::may_branch() const { return components_ > options_.most_without_samples(); }

void BranchingCell::find_holes() {
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (const auto& [v, w] : edges_in_holes(*faces_[f].triangulation)) {
      const auto [a, b] = std::minmax(local_[f][v], local_[f][w]);
      hole_edges_.push_back({a, b});
    }
  std::sort(hole_edges_.begin(), hole_edges_.end());
}

bool BranchingCell::lacks_something() const {
  if (!options_.only_where_lacking() || !hole_edges_.empty()) return true;
  for (std::size_t v = 0; v < labels_.size(); ++v)
    if (labels_[v] == v && (bare_[v] != 0 || flat_[v] != 0)) return true;
  return false;
}

void merge_samples(const FaceBranching& side, std::vector<LatticePoint>& all) {
  const auto others = static_cast<std::ptrdiff_t>(all.size());
  for (std::size_t k = 0; k < side.samples.size(); ++k) {
    const Vec3 at = real(side.samples[k]);
    const bool is_near = std::any_of(all.begin(), all.begin() + others, [&](const LatticePoint& other) {
      return norm(real(other) - at) < side.apart[k];
    });
    if (!is_near) all.push_back(side.samples[k]);
  }
}

BranchingCell::Sampler::Sampler(const BranchingCell& cell, const CellTriangulation& triangulation,
                                bool draw_all)
    : cell_(cell), vertices_(triangulation.vertices()), mesh_(triangulation.mesh()) {
  const std::size_t face_count = cell.faces_.size();
  with_section_.assign(vertices_.words, 0);
  lacking_faces_.assign(vertices_.words, 0);
  for (std::size_t f = 0; f < face_count; ++f) {
    const FaceId id = cell.ids_[f];
    frames_.emplace_back(cell.graph_.planes[cell.arrangement_.plane_of(id).value],
                         cell.faces_[f].side == 1 ? 1 : -1);
    maps_.push_back(section_map(cell.faces_[f], frames_[f], cell.points_));
    regions_.push_back(maps_[f].box());
    const std::uint64_t bit = std::uint64_t{1} << (f % 64);
    if (!maps_[f].empty()) with_section_[f / 64] |= bit;
    if (draw_all || cell.lacks_on(f)) lacking_faces_[f / 64] |= bit;
  }
  std::vector<double> length(vertices_.size(), 0);
  std::vector<std::uint32_t> count(vertices_.size(), 0);
  for (std::size_t f = 0; f < face_count; ++f)
    maps_[f].for_each_border_edge([&](std::uint32_t p, std::uint32_t q, double edge) {
      const std::uint32_t a = cell.local_[f][p], b = cell.local_[f][q];
      neighbours_.push_back({std::min(a, b), std::max(a, b)});
      for (const std::uint32_t v : {a, b}) length[v] += edge, ++count[v];
    });
  std::sort(neighbours_.begin(), neighbours_.end());
  for (std::size_t v = 0; v < length.size(); ++v)
    spacing_.push_back(count[v] == 0 ? 0 : kSpacing * length[v] / count[v]);
}

/// Automatic: only where two section components meet and something may be lacking; that the section between
/// them is a third one is seen at the samples.
std::uint64_t BranchingCell::Sampler::wanted(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t la = cell_.labels_[a], lb = cell_.labels_[b];
  if (la == kNone || lb == kNone) return 0;
  if (cell_.options_.mode == Branching::automatic) {
    if (is_over_hole(a, b)) return with_section_[word_];
    if (la == lb) return 0;
    return cell_.bare_[la] != 0 || cell_.bare_[lb] != 0 ? with_section_[word_]
                                                        : with_section_[word_] & lacking_faces_[word_];
  }
  int shared = 0;  // all: neither both on one line of planes nor neighbours
  for (std::uint32_t w = 0; w < vertices_.words; ++w)
    shared += std::popcount(vertices_.mask(a, w) & vertices_.mask(b, w));
  if (shared > 1 || std::binary_search(neighbours_.begin(), neighbours_.end(), std::array{a, b})) return 0;
  return with_section_[word_];
}

bool BranchingCell::Sampler::is_over_hole(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(cell_.hole_edges_.begin(), cell_.hole_edges_.end(),
                            std::array{std::min(a, b), std::max(a, b)});
}

/// The sphere tangent at a meets the interior of another section before it meets the sites: a does not branch
/// there.
bool BranchingCell::Sampler::stopped(std::size_t face, Vec2 a, double radius) const {
  const Vec3 at = frames_[face].to_space(a), up = frames_[face].up();
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    if (f == face || maps_[f].empty()) continue;
    const Vec3 n = frames_[f].up();
    const double toward = 1 - dot(up, n),
                 distance = dot(n, at - frames_[f].to_space(frames_[f].to_plane(at)));
    if (!(distance < radius * toward)) continue;
    const double r = distance / toward;
    if (maps_[f].triangle_at(frames_[f].to_plane(at + r * up)) != kNone) return true;
  }
  return false;
}

/// Takes the lattice point next to the candidate if it is strictly inside and not near what is there.
bool BranchingCell::Sampler::keep(const Candidate& c, FaceState& state) const {
  const double clear = kClearance / kSpacing * c.spacing;
  const FaceFrame& frame = frames_[state.face];
  for (const Vec2 other : state.taken)
    if (dot(other - c.at, other - c.at) < c.spacing * c.spacing) return false;
  if (maps_[state.face].squared_distance_to_border(c.at, clear * clear) < clear * clear) return false;
  const auto [u, v] = nearest_coordinates(frame.plane(), frame.to_space(c.at));
  const LatticePoint p = plane_point(frame.plane(), u, v);
  if (!state.open.contains(p)) return false;
  const SectionLocator& locator = cell_.locators_.of(cell_.arrangement_.plane_of(state.out.face).value);
  if (locator.locate(p) != SectionLocator::Place::inside) return false;
  state.out.samples.push_back(p);
  state.out.apart.push_back(clear);
  state.taken.push_back(c.at);
  return true;
}

/// The arcs of the cutting diagram among all arcs of a face.
std::vector<FaceArc> BranchingCell::Sampler::cutting(std::size_t face, std::span<const FaceArc> all,
                                                     const CellDiagrams& diagrams) const {
  if (all.empty()) return {};
  std::vector<NumberedSite> sites;
  for (std::uint32_t v = 0; v < vertices_.size(); ++v)
    if (!vertices_.on_face(v, face))
      sites.push_back({v, diagrams.site(v, static_cast<std::uint32_t>(face % 64))});
  std::vector<DirectedWall> walls;
  maps_[face].for_each_border_edge([&](std::uint32_t a, std::uint32_t b, double) {
    walls.push_back({maps_[face].point(a), maps_[face].point(b)});
  });
  std::vector<FaceArc> arcs;
  for (const std::uint32_t k : cutting_arcs(sites, all, walls, neighbours_)) arcs.push_back(all[k]);
  return arcs;
}

/// Points along the arcs inside the section, where the tangent sphere reaches the sites. In mode automatic,
/// branching is between two other components than the point's own.
void BranchingCell::Sampler::add_candidates(std::size_t face, std::span<const FaceArc> arcs,
                                            const CellDiagrams& diagrams, bool cutting) {
  const auto in_word = static_cast<std::uint32_t>(face % 64);
  const bool is_automatic = cell_.options_.mode == Branching::automatic && !cutting;
  const Vec2 diagonal = maps_[face].box().high - maps_[face].box().low;
  const double least = kLeastSpacing * std::sqrt(dot(diagonal, diagonal));
  std::vector<Vec2> points;
  for (const FaceArc& arc : arcs) {
    const auto& [i, j] = arc.sites;
    if (!(std::max(spacing_[i], spacing_[j]) > 0)) continue;
    const double spacing = std::max({spacing_[i], spacing_[j], least});
    const bool automatic = is_automatic && !is_over_hole(i, j);
    points.clear();
    sample_arc(arc, spacing / 2, maps_[face].box(), points);
    for (const Vec2 a : points) {
      const std::uint32_t triangle = maps_[face].triangle_at(a);
      if (triangle == kNone) continue;
      const std::uint32_t own = cell_.label_of(face, triangle);
      const Candidate c{a, triangle, spacing, {own, cell_.labels_[i], cell_.labels_[j]}, !automatic};
      if (automatic && (own == c.labels[1] || own == c.labels[2])) continue;
      if (!stopped(face, a, tangent_radius(diagrams.site(i, in_word), a))) found_[face].push_back(c);
    }
  }
}

/// A component lacks samples if a point that could be one is over a flat triangle.
void BranchingCell::Sampler::find_lacking() {
  lacking_.assign(cell_.labels_.size(), 0);
  for (std::size_t f = 0; f < found_.size(); ++f)
    for (const Candidate& c : found_[f])
      if (!cell_.faces_[f].covers(c.triangle) && !cell_.faces_[f].covered_behind(c.triangle))
        lacking_[c.labels[0]] = 1;
}

/// Whether a sample may mend what the vertices alone leave undone: one of the components is bare, or its own
/// is flat somewhere along the diagram.
bool BranchingCell::Sampler::is_of_use(const Candidate& c) const {
  return c.always || lacking_[c.labels[0]] != 0 ||
         std::any_of(c.labels.begin(), c.labels.end(), [&](std::uint32_t l) { return cell_.bare_[l] != 0; });
}

void BranchingCell::Sampler::take(std::size_t face, FaceBranching& out) const {
  FaceState state{face, OpenFace(cell_.graph_, cell_.arrangement_, out.face), {}, out};
  std::vector<Candidate> candidates = found_[face];
  junctions_first(candidates);
  for (const Candidate& c : candidates)
    if (is_of_use(c)) keep(c, state);
}

/// The arcs that samples are looked for on, by face.
void BranchingCell::Sampler::collect_arcs() {
  arcs_.resize(frames_.size());
  found_.resize(frames_.size());
  for (word_ = 0; word_ < vertices_.words; ++word_) {
    const CellSites sites{vertices_.points, &mesh_, frames_, vertices_.face_masks, vertices_.words, regions_};
    CellDiagrams diagrams(sites, word_);
    const std::size_t first = 64 * std::size_t{word_},
                      count = std::min<std::size_t>(64, frames_.size() - first);
    const auto arcs_of = [&](auto&& wanted_faces, std::vector<std::vector<FaceArc>>& arcs) {
      diagrams.arcs(wanted_faces, std::span(arcs).subspan(first, count));
    };
    if (cell_.options_.mode != Branching::off)
      arcs_of([&](const TetEdge& edge) { return wanted(edge.i, edge.j); }, arcs_);
    for (std::size_t f = first; f < first + count; ++f) add_candidates(f, arcs_[f], diagrams, false);
    if (!cell_.options_.cutting) continue;
    std::vector<std::vector<FaceArc>> all(frames_.size());
    arcs_of([&](const TetEdge&) { return with_section_[word_]; }, all);
    for (std::size_t f = first; f < first + count; ++f) {
      const std::vector<FaceArc> cut = cutting(f, all[f], diagrams);
      add_candidates(f, cut, diagrams, true);
      arcs_[f].insert(arcs_[f].end(), cut.begin(), cut.end());
    }
  }
}

std::vector<Vec2> BranchingCell::Sampler::feet(const FaceBranching& face) const {
  std::vector<std::uint32_t> sites;
  for (const FaceArc& arc : face.arcs) sites.insert(sites.end(), arc.sites.begin(), arc.sites.end());
  std::sort(sites.begin(), sites.end());
  sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
  std::vector<Vec2> feet;
  for (const std::uint32_t v : sites) feet.push_back(face.frame.to_plane(vertices_.points[v]));
  return feet;
}

CellBranching BranchingCell::Sampler::run() {
  collect_arcs();
  find_lacking();
  CellBranching result;
  for (std::size_t f = 0; f < frames_.size(); ++f) {
    if (arcs_[f].empty()) continue;
    FaceBranching& face = result.faces.emplace_back();
    face.face = cell_.ids_[f];
    face.side = cell_.faces_[f].side;
    face.frame = frames_[f];
    face.arcs = std::move(arcs_[f]);
    face.sites = feet(face);
    take(f, face);
  }
  return result;
}

CellBranching BranchingCell::run(const CellTriangulation& triangulation, bool draw_all) const {
  const auto begin = std::chrono::steady_clock::now();
  CellBranching result = Sampler(*this, triangulation, draw_all).run();
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace crossloft
