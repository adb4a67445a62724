#include "face_triangulation.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "../delaunay/conform.h"
#include "../delaunay/lattice_predicates.h"
#include "../geom/disjoint_sets.h"
#include "../geom/parallel.h"
#include "face_split.h"
#include "self_check.h"

namespace crossloft {

namespace {

/// Calls use(face) for the faces whose closure has the location, those of the box left out.
template <class Use>
void for_each_face(const Arrangement& arrangement, Location at, Use&& use) {
  const auto inner = [&](FaceId f) {
    if (!arrangement.on_box(f)) use(f);
  };
  if (at.dimension == 2) inner(FaceId{at.index});
  if (at.dimension == 1) std::ranges::for_each(arrangement.faces_around(ArrEdgeId{at.index}), inner);
  if (at.dimension == 0) std::ranges::for_each(arrangement.faces_around(ArrVertexId{at.index}), inner);
}

/// The places of graph vertices in their faces.
class PlacesInFaces {
 public:
  PlacesInFaces(const SectionGraph& graph, const std::vector<FaceInput>& inputs, const Context& context)
      : graph_(graph), inputs_(inputs), place_(graph.size()) {
    parallel_for(inputs.size(), context, "faces", [&](std::size_t f) {
      const auto& vertices = inputs[f].vertices;
      for (std::uint32_t k = 0; k < vertices.size(); ++k)
        if (is_in_face(vertices[k])) place_[vertices[k]] = k;
    });
  }
  Wall local(Wall wall, std::uint32_t face) const {
    wall.a = place(wall.a, face), wall.b = place(wall.b, face);
    return wall;
  }

 private:
  bool is_in_face(std::uint32_t v) const { return graph_.locations[v].dimension == 2; }
  /// A vertex in the open face is in no other; one on a line is searched for.
  std::uint32_t place(std::uint32_t v, std::uint32_t face) const {
    if (is_in_face(v)) return place_[v];
    const auto& list = inputs_[face].vertices;
    return static_cast<std::uint32_t>(std::lower_bound(list.begin(), list.end(), v) - list.begin());
  }
  const SectionGraph& graph_;
  const std::vector<FaceInput>& inputs_;
  std::vector<std::uint32_t> place_;
};

/// The section vertices of every face. They come ascending, so the lists are too.
void collect_vertices(const SectionGraph& graph, const Arrangement& arrangement,
                      std::vector<FaceInput>& inputs) {
  std::vector<std::uint32_t> count(inputs.size(), 0);
  for (const Location at : graph.locations)
    for_each_face(arrangement, at, [&](FaceId f) { ++count[f.value]; });
  for (std::uint32_t f = 0; f < inputs.size(); ++f) inputs[f].vertices.reserve(count[f]);
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    for_each_face(arrangement, graph.locations[v], [&](FaceId f) { inputs[f.value].vertices.push_back(v); });
}

/// How many walls each face has inside.
std::vector<std::uint32_t> count_walls(const SectionGraph& graph, std::size_t faces) {
  std::vector<std::uint32_t> count(faces, 0);
  for (const auto& list : graph.wall_locations)
    for (const Location at : list)
      if (at.dimension == 2) ++count[at.index];
  return count;
}

}  // namespace

/// Walls of a plane are in faces of that plane alone.
std::vector<FaceInput> face_inputs(const SectionGraph& graph, const Arrangement& arrangement,
                                   const Context& context) {
  std::vector<FaceInput> inputs(arrangement.face_count());
  const std::vector<std::uint32_t> walls = count_walls(graph, inputs.size());
  for (std::uint32_t f = 0; f < inputs.size(); ++f) {
    inputs[f].face = FaceId{f};
    inputs[f].walls.reserve(walls[f]);
  }
  collect_vertices(graph, arrangement, inputs);
  const PlacesInFaces places(graph, inputs, context);
  parallel_for(graph.planes.size(), context, "faces", [&](std::size_t p) {
    for (std::size_t w = 0; w < graph.walls[p].size(); ++w) {
      const Wall& wall = graph.walls[p][w];
      const Location at = graph.wall_locations[p][w];
      if (at.dimension == 2) inputs[at.index].walls.push_back(places.local(wall, at.index));
      if (at.dimension == 1)
        for (const FaceId f : arrangement.faces_around(ArrEdgeId{at.index}))
          if (arrangement.plane_of(f).value == p)
            inputs[f.value].border.push_back(places.local(wall, f.value));
    }
  });
  return inputs;
}

namespace {

/// Looks up walls by their ends, in either direction.
class WallTable {
 public:
  static constexpr std::uint32_t kNoWall = kNone;

  void reserve(std::size_t walls) { walls_.reserve(walls); }
  void add(const Wall& wall) { walls_.push_back(wall.a < wall.b ? wall : reversed(wall)); }
  const Wall& operator[](std::uint32_t wall) const { return walls_[wall]; }
  /// REQUIRES: ends are below `vertices`.
  void finish(std::size_t vertices) {
    begin_.assign(vertices + 2, 0);
    for (const Wall& wall : walls_) ++begin_[wall.a + std::size_t{2}];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    at_.resize(walls_.size());
    for (std::uint32_t w = 0; w < walls_.size(); ++w) at_[begin_[walls_[w].a + std::size_t{1}]++] = w;
  }
  /// Among the walls at the smaller end: two at most as a rule.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const {
    const auto [low, high] = std::minmax(a, b);
    for (std::uint32_t k = begin_[low]; k < begin_[low + std::size_t{1}]; ++k)
      if (walls_[at_[k]].b == high) return at_[k];
    return kNoWall;
  }
  /// Whether the section is on the left of the directed edge; REQUIRES find(a, b).
  bool inside_left(std::uint32_t wall, std::uint32_t from) const {
    return walls_[wall].inside_left == (walls_[wall].a == from);
  }

 private:
  static Wall reversed(Wall wall) {
    std::swap(wall.a, wall.b);
    wall.inside_left = !wall.inside_left;
    return wall;
  }
  std::vector<Wall> walls_;
  std::vector<std::uint32_t> begin_;  ///< by smaller end: its first wall in at_
  std::vector<std::uint32_t> at_;
};

/// The work of one face; local numbers throughout.
class FaceBuilder {
 public:
  FaceBuilder(const SectionGraph& graph, const Arrangement& arrangement, const PlaneLocators& locators,
              const FaceInput& input)
      : graph_(graph), arrangement_(arrangement), locators_(locators), input_(input) {
    result_.face = input.face;
    result_.plane = arrangement.plane_of(input.face).value;
    result_.vertices = input.vertices;
    points_.reserve(input.vertices.size());
    for (const std::uint32_t v : input.vertices) points_.push_back(graph.points[v]);
    walls_ = input.walls;
  }
  void start_from(const FaceTriangulation& coarse, std::span<const LatticePoint> samples) {
    points_.insert(points_.end(), coarse.added.begin(), coarse.added.end());
    points_.insert(points_.end(), samples.begin(), samples.end());
    walls_ = coarse.walls;
    result_.samples = coarse.samples + static_cast<std::uint32_t>(samples.size());
  }
  Result<FaceTriangulation> run();

 private:
  Result<Done> conform_to_walls(Delaunay2<LatticePredicates2>& tri);
  void find_walls();
  Result<Done> label();
  bool seed(std::uint32_t triangle) const;
  void collect_border();
  void collect_edges();

  const SectionGraph& graph_;
  const Arrangement& arrangement_;
  const PlaneLocators& locators_;
  const FaceInput& input_;
  std::vector<LatticePoint> points_;
  std::span<const Wall> walls_;  ///< as they were before conforming, local ends
  FaceTriangulation result_;
  TriMesh mesh_;
  WallTable table_;
  std::vector<std::array<std::uint32_t, 3>>
      wall_at_;  ///< by triangle: wall of the table on the side opposite each vertex
};

Result<Done> FaceBuilder::conform_to_walls(Delaunay2<LatticePredicates2>& tri) {
  std::vector<std::array<std::uint32_t, 2>> segments;
  segments.reserve(walls_.size());
  for (const Wall& wall : walls_) segments.push_back({wall.a, wall.b});
  FaceSplitter splitter(graph_, arrangement_, input_.face, result_.plane, walls_, points_);
  const auto limit = static_cast<std::uint32_t>(4096 + 64 * walls_.size());
  const ConformResult conformed = conform(tri, segments, splitter, limit);
  result_.walls.reserve(segments.size());
  table_.reserve(segments.size() + input_.border.size());
  for (const Wall& wall : input_.border) table_.add(wall);
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    Wall piece = walls_[conformed.source[s]];
    piece.a = segments[s][0], piece.b = segments[s][1];
    result_.walls.push_back(piece);
    table_.add(piece);
  }
  if (!conformed.failed.empty()) {
    const Wall& wall = result_.walls[conformed.failed[0]];
    return Error{
        ErrorCode::too_thin,
        conformed.limit_reached
            ? "other contours come so close that an edge would need too many splits to become Delaunay"
            : "other contours come so close that an edge can't be split to become Delaunay",
        {},
        wall.line,
        wall.source_plane,
        wall.contour};
  }
  result_.added.assign(points_.begin() + static_cast<std::ptrdiff_t>(input_.vertices.size()), points_.end());
  return Done{};
}

/// Inside or not, for a triangle without a wall: its region has none, so its edges run through the open
/// section or outside it.
bool FaceBuilder::seed(std::uint32_t triangle) const {
  const auto& v = mesh_.vertices[triangle];
  return locators_.of(result_.plane).inside_toward(points_[v[0]], points_[v[1]]);
}

/// Each edge is looked up once, from the later of its triangles or the only one.
void FaceBuilder::find_walls() {
  table_.finish(points_.size());
  wall_at_.resize(mesh_.size());
  for (std::uint32_t t = 0; t < mesh_.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t n = mesh_.neighbours[t][i];
      if (n != kNone && n > t) continue;
      const auto& v = mesh_.vertices[t];
      const std::uint32_t wall = wall_at_[t][i] = table_.find(v[(i + 1) % 3], v[(i + 2) % 3]);
      if (n == kNone) continue;
      const auto& back = mesh_.neighbours[n];
      wall_at_[n][back[0] == t ? 0 : back[1] == t ? 1 : 2] = wall;
    }
}

/// Floods inside and outside from the walls; contradictions are a defect of the walls' orientation.
Result<Done> FaceBuilder::label() {
  constexpr std::uint8_t kUnknown = 2;
  result_.internal.assign(mesh_.size(), kUnknown);
  std::vector<std::uint32_t> stack;
  bool contradiction = false;
  const auto mark = [&](std::uint32_t t, bool inside) {
    if (result_.internal[t] == kUnknown) {
      result_.internal[t] = inside;
      stack.push_back(t);
    } else if (result_.internal[t] != static_cast<std::uint8_t>(inside)) {
      contradiction = true;
    }
  };
  const auto flood = [&] {
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (std::uint32_t i = 0; i < 3; ++i)
        if (const std::uint32_t n = mesh_.neighbours[t][i];
            n != kNone && wall_at_[t][i] == WallTable::kNoWall)
          mark(n, result_.internal[t] != 0);
    }
  };
  for (std::uint32_t t = 0; t < mesh_.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i)
      if (const std::uint32_t wall = wall_at_[t][i]; wall != WallTable::kNoWall)
        mark(t, table_.inside_left(wall, mesh_.vertices[t][(i + 1) % 3]));
  flood();
  for (std::uint32_t t = 0; t < mesh_.size(); ++t)
    if (result_.internal[t] == kUnknown) {
      mark(t, seed(t));
      flood();
    }
  if (contradiction) return make_error(ErrorCode::internal, "the contours of a face contradict each other");
  return Done{};
}

/// The table has the walls of the border first.
void FaceBuilder::collect_border() {
  for (std::uint32_t t = 0; t < mesh_.size() && !input_.border.empty(); ++t)
    for (std::uint32_t i = 0; i < 3 && result_.internal[t] != 0; ++i)
      if (wall_at_[t][i] < input_.border.size()) result_.border.push_back(table_[wall_at_[t][i]]);
}

void FaceBuilder::collect_edges() {
  result_.sides.resize(mesh_.size());
  // Euler: one less, but for points that are none of its vertices.
  result_.edges.reserve(points_.size() + mesh_.size());
  for (std::uint32_t t = 0; t < mesh_.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (const std::uint32_t n = mesh_.neighbours[t][i]; n != kNone && n < t) {
        const auto& back = mesh_.neighbours[n];
        result_.sides[t][i] = result_.sides[n][back[0] == t ? 0 : back[1] == t ? 1 : 2];
        continue;
      }
      result_.sides[t][i] = static_cast<std::uint32_t>(result_.edges.size());
      const std::uint32_t a = mesh_.vertices[t][(i + 1) % 3], b = mesh_.vertices[t][(i + 2) % 3];
      const EdgeKind kind = wall_at_[t][i] != WallTable::kNoWall ? EdgeKind::contour
                            : result_.internal[t] != 0           ? EdgeKind::internal
                                                                 : EdgeKind::external;
      result_.edges.push_back({std::min(a, b), std::max(a, b), kind});
    }
}

Result<FaceTriangulation> FaceBuilder::run() {
  LatticePredicates2 predicates(graph_.planes[result_.plane], points_);
  Delaunay2 tri(predicates);
  tri.build();
  if (auto done = conform_to_walls(tri); !done) return done.error();
  if (auto good = self_check("Delaunay of a face", [&] { return tri.verify(); }); !good) return good.error();
  if (tri.dimension() < 2) return std::move(result_);
  mesh_ = tri.tri_mesh();
  find_walls();
  if (auto done = label(); !done) return done.error();
  collect_border();
  collect_edges();
  result_.triangles = std::move(mesh_.vertices);
  for (auto& side : result_.covered) side.assign(result_.triangles.size(), 0);
  return std::move(result_);
}

}  // namespace

Result<FaceTriangulation> triangulate_face(const SectionGraph& graph, const Arrangement& arrangement,
                                           const PlaneLocators& locators, const FaceInput& input) {
  return FaceBuilder(graph, arrangement, locators, input).run();
}

Result<FaceTriangulation> refine_face(const SectionGraph& graph, const Arrangement& arrangement,
                                      const PlaneLocators& locators, const FaceInput& input,
                                      const FaceTriangulation& coarse,
                                      std::span<const LatticePoint> samples) {
  FaceBuilder builder(graph, arrangement, locators, input);
  builder.start_from(coarse, samples);
  return builder.run();
}

std::uint32_t LineEdges::shared_planes(std::uint32_t u, std::uint32_t v) const {
  const auto in_face = [&](std::uint32_t x) { return graph_->locations[x].dimension == 2; };
  if (in_face(u) || in_face(v)) return 1;
  return graph_->common_planes(u, v);
}

std::vector<std::uint8_t> LineEdges::vertices_on_lines(const FaceTriangulation& face) const {
  std::vector<std::uint8_t> flags;
  for (const std::uint32_t v : face.vertices) flags.push_back(graph_->locations[v].dimension != 2 ? 1 : 0);
  return std::count(flags.begin(), flags.end(), 1) < 2 ? std::vector<std::uint8_t>{} : flags;
}

void LineEdges::add(const FaceTriangulation& face) {
  const std::vector<std::uint8_t> on_some_line = vertices_on_lines(face);
  if (on_some_line.empty()) return;
  const auto count = static_cast<std::uint32_t>(face.vertices.size());
  for (std::size_t t = 0; t < face.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3 && face.internal[t] != 0; ++i) {
      const std::uint32_t a = face.triangles[t][i], b = face.triangles[t][(i + 1) % 3];
      if (a >= count || b >= count) continue;  // splits and samples are on no line
      if ((on_some_line[a] & on_some_line[b]) == 0) continue;
      const std::uint32_t u = face.vertices[a], v = face.vertices[b];
      if (on_line(u, v)) inside_.push_back({std::min(u, v), std::max(u, v), face.plane});
    }
}

void LineEdges::finish() {
  std::sort(inside_.begin(), inside_.end());
  inside_.erase(std::unique(inside_.begin(), inside_.end()), inside_.end());
  for (const auto& walls : graph_->walls)
    for (const Wall& wall : walls)
      if (on_line(wall.a, wall.b)) contour_.push_back({wall.a, wall.b});
  std::sort(contour_.begin(), contour_.end());
}

EdgeKind LineEdges::kind(std::uint32_t u, std::uint32_t v) const {
  if (u > v) std::swap(u, v);
  const auto begin = std::lower_bound(inside_.begin(), inside_.end(), Entry{u, v, 0});
  std::uint32_t planes = 0;
  for (auto it = begin; it != inside_.end() && it->u == u && it->v == v; ++it) ++planes;
  if (planes < shared_planes(u, v)) return EdgeKind::external;
  return std::binary_search(contour_.begin(), contour_.end(), std::array{u, v}) ? EdgeKind::contour
                                                                                : EdgeKind::internal;
}

/// Triangles outside are connected across edges between them; what is connected with the hull is no hole.
std::vector<std::array<std::uint32_t, 2>> edges_in_holes(const FaceTriangulation& face) {
  std::vector<std::array<std::uint32_t, 2>> triangles(face.edges.size(), {kNone, kNone});  // by edge
  for (std::uint32_t t = 0; t < face.triangles.size(); ++t)
    for (const std::uint32_t e : face.sides[t]) triangles[e][triangles[e][0] == kNone ? 0 : 1] = t;
  const auto count = static_cast<std::uint32_t>(face.triangles.size());
  const auto is_outside = [&](std::uint32_t t) { return t != kNone && face.internal[t] == 0; };
  DisjointSets regions(count + std::size_t{1});  // the last one is beyond the hull
  for (const auto& [s, t] : triangles)
    if (is_outside(s) && (t == kNone || is_outside(t))) regions.join(s, t == kNone ? count : t);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::size_t e = 0; e < triangles.size(); ++e) {
    const auto& [s, t] = triangles[e];
    if (is_outside(s) && is_outside(t) && regions.find(s) != regions.find(count))
      edges.push_back({face.edges[e].a, face.edges[e].b});
  }
  return edges;
}

}  // namespace crossloft
