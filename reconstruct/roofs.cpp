#include "roofs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "../geom/box_tree.h"
#include "../geom/ids.h"
#include "../geom/lattice_rounding.h"
#include "../geom/tetrahedron_meeting.h"

namespace crossloft {
namespace {

using Tet = std::array<std::uint32_t, 4>;
using Edge = std::array<std::uint32_t, 2>;

/// What fills an edge or a vertex gives up before the triangles around it do.
constexpr int kEdgeRounds = 16, kVertexRounds = 12;

/// Lattice units: further down rounding decides where a point comes to lie.
constexpr double kLowest = 2;
/// Feet that are tried there, places towards each corner of solid that leans over the triangle, and rounds
/// that may fail over them.
constexpr std::size_t kFeet = 256, kLeaning = 16;
constexpr int kFeetRounds = 8;

/// A point to be raised over a triangle's middle, an edge's middle or a vertex.
struct Raised {
  Vec3 foot, up;
  double height = 0;
  LatticePoint point;
  bool changed = true;             ///< since its tetrahedra were tested last
  std::uint32_t triangle = kNone;  ///< over whose middle, if it is one
  std::size_t tries = 0;           ///< of other places
  std::uint32_t corner = kNone;    ///< of the solid, if it is in its place
};

/// A corner of the solid over a triangle.
struct HighCorner {
  double height = 0;
  std::uint32_t number = 0;
  friend auto operator<=>(const HighCorner&, const HighCorner&) = default;
};

/// A triangle, an edge between two flat triangles of one face, or a vertex that they surround.
struct Part {
  std::uint32_t raised = 0;
  int patience = kRoofRounds + kFeetRounds;  ///< rounds that its pieces may fail before it is dropped
  int failed = 0;
  bool fails = false;  ///< in this round
  bool built = true;
};

struct EdgeName {
  std::uint32_t face = 0;
  Edge ends{};
  friend auto operator<=>(const EdgeName&, const EdgeName&) = default;
};
using VertexName = std::array<std::uint32_t, 2>;  ///< face, vertex

/// One tetrahedron of a plate, and whose it is: dropped together with the others of its owner.
struct Piece {
  Tet tet{};
  Part* owner = nullptr;
};

class RoofBuilder {
 public:
  explicit RoofBuilder(const RoofSite& site) : site_(site), triangles_(site.triangles.size()) {
    find_obstacles();
    name_parts();
    for (std::size_t t = 0; t < triangles_.size(); ++t) raise_middle(t);
    for (auto& [name, edge] : edges_) raise_edge(name, edge);
    for (auto& [name, vertex] : vertices_) {
      vertex.raised = raise(corner(name[1]), up_[name[0]]);
      vertex.patience = kVertexRounds;
    }
    start_ = raised_;
  }

  CellRoofs run() {
    bool good = false;
    while (!good) {
      drop_unsupported();
      make_pieces();
      good = settle();
    }
    return result();
  }

 private:
  Vec3 corner(std::uint32_t number) const { return real(site_.points[number]); }

  static EdgeName edge_name(const FlatTriangle& t, std::size_t i) {
    const auto [a, b] = std::minmax(t.v[i], t.v[(i + 1) % 3]);
    return {t.face, {a, b}};
  }

  /// Edges with two triangles; vertices with as many of these edges as triangles. Each face's direction
  /// upwards.
  void name_parts() {
    std::map<EdgeName, int> sides;
    std::map<VertexName, int> balance;
    for (const FlatTriangle& t : site_.triangles) {
      const Vec3 a = corner(t.v[0]);
      const Vec3 n = cross(corner(t.v[1]) - a, corner(t.v[2]) - a);
      up_[t.face] = up_[t.face] + n;
      for (std::size_t i = 0; i < 3; ++i) ++sides[edge_name(t, i)], ++balance[{t.face, t.v[i]}];
    }
    for (auto& [face, up] : up_) up = 1 / norm(up) * up;
    for (const auto& [name, count] : sides)
      if (count == 2) {
        edges_[name] = {};
        for (const std::uint32_t v : name.ends) --balance[{name.face, v}];
      }
    for (const auto& [name, left] : balance)
      if (left == 0) vertices_[name] = {};
  }

  std::uint32_t raise(const Vec3& foot, const Vec3& up, std::uint32_t triangle = kNone) {
    Raised r;
    r.foot = foot, r.up = up, r.height = site_.height, r.triangle = triangle;
    place(r);
    for (int i = 0; i < kRoofRounds && !is_inside(r.point); ++i) lower(r);
    raised_.push_back(r);
    return static_cast<std::uint32_t>(raised_.size() - 1);
  }
  void raise_middle(std::size_t t) {
    const FlatTriangle& f = site_.triangles[t];
    const Vec3 middle = 1.0 / 3 * (corner(f.v[0]) + corner(f.v[1]) + corner(f.v[2]));
    triangles_[t].raised = raise(middle, up_[f.face], static_cast<std::uint32_t>(t));
  }
  void raise_edge(const EdgeName& name, Part& edge) {
    edge.raised = raise(0.5 * (corner(name.ends[0]) + corner(name.ends[1])), up_[name.face]);
    edge.patience = kEdgeRounds;
  }

  static LatticeVector rounded(const Vec3& p) {
    const auto whole = [](double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); };
    return {whole(p.x), whole(p.y), whole(p.z)};
  }
  static void place(Raised& r) {
    r.point = make_point(rounded(r.foot + r.height * r.up));
    r.changed = true;
  }
  void lower(Raised& r) {
    const bool searches = r.triangle != kNone && (r.tries > 0 || r.height <= kLowest);
    if (searches && find_room(r)) return;
    r.height *= 0.5;
    place(r);
  }
  /// Over a needle, or under solid that leans over it, the room is a few units wide: feet all over the
  /// triangle, until one's point rounds into it. Solid may lean by so little that no grid point over the
  /// triangle is under it: the room ends at a corner of that solid, and a plate up to there fills it. If the
  /// corner is too high, or on another plane, the room may have a grid point on the way there.
  bool find_room(Raised& r) {
    while (r.tries < kFeet) {
      stand(r, r.tries++);
      if (has_room(r)) return true;
    }
    take_all_obstacles();
    const std::vector<HighCorner> corners = corners_over(site_.triangles[r.triangle]);
    while (r.tries < kFeet + corners.size() * (1 + kLeaning)) {
      const std::size_t k = r.tries++ - kFeet;
      const bool leans = k >= corners.size();
      if (leans ? lean(r, corners[k % corners.size()], k / corners.size()) : take_corner(r, corners[k]))
        if (has_room(r)) return true;
    }
    r.corner = kNone;
    r.height = std::min(r.height, kLowest);
    return false;
  }
  /// The sequence of Roberts.
  Vec3 foot(const FlatTriangle& f, std::size_t k) const {
    const Vec3 o = corner(f.v[0]), a = corner(f.v[1]) - o, b = corner(f.v[2]) - o;
    const auto i = static_cast<double>(k + 1);
    double u = std::fmod(0.7548776662466927 * i, 1), v = std::fmod(0.5698402909980532 * i, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return o + u * a + v * b;
  }
  void stand(Raised& r, std::size_t k) const {
    r.foot = foot(site_.triangles[r.triangle], k);
    r.height = std::min(site_.height, kLowest / static_cast<double>(1 << (k + 1) % 4));
    place(r);
  }
  bool take_corner(Raised& r, const HighCorner& c) const {
    if (c.height > site_.height) return false;
    r.corner = c.number, r.height = c.height, r.point = site_.points[c.number], r.changed = true;
    return true;
  }
  /// Over a foot to the grid, and along that layer of the grid until over the line from foot to corner.
  bool lean(Raised& r, const HighCorner& c, std::size_t k) const {
    stand(r, k);
    r.corner = kNone;
    const Base base = base_of(site_.triangles[r.triangle]);
    const double height = base.height(real(r.point));
    if (height <= 0 || height >= c.height) return false;
    LatticePlane layer = base.plane;
    layer.origin = to_vector(r.point);
    const auto [u, v] = nearest_coordinates(layer, r.foot + height / c.height * (corner(c.number) - r.foot));
    r.point = plane_point(layer, u, v);
    return true;
  }
  /// The plane below: a needle's own normal is not precise enough to tell how high a corner far beside it is.
  struct Base {
    LatticePlane plane;
    Vec3 up;
    double height(const Vec3& p) const {
      const auto [u, v] = nearest_coordinates(plane, p);
      return dot(p - real(plane_point(plane, u, v)), up);
    }
  };
  Base base_of(const FlatTriangle& f) const {
    const auto side = std::find_if(site_.sides.begin(), site_.sides.end(), [&](const CellSide& s) {
      return std::all_of(f.v.begin(), f.v.end(),
                         [&](std::uint32_t v) { return side_of_plane(s.plane, site_.points[v]) == 0; });
    });
    const Vec3 normal = real(side->plane.normal);
    return {side->plane, side->side / norm(normal) * normal};
  }
  /// Of tetrahedra with a vertex of the triangle; the lowest first.
  std::vector<HighCorner> corners_over(const FlatTriangle& f) const {
    std::vector<HighCorner> corners;
    const Base base = base_of(f);
    const auto is_of_triangle = [&](std::uint32_t v) {
      return std::find(f.v.begin(), f.v.end(), v) != f.v.end();
    };
    Bounds box;
    for (const std::uint32_t v : f.v) box.add(corner(v));
    around_.for_overlaps(box, [&](std::uint32_t o) {
      const Tet& t = obstacles_[o];
      if (std::none_of(t.begin(), t.end(), is_of_triangle)) return;
      for (const std::uint32_t v : t) {
        const double height = base.height(corner(v));
        if (height > 0 && !is_of_triangle(v)) corners.push_back({height, v});
      }
    });
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
  }
  bool has_room(const Raised& r) const {
    const auto& v = site_.triangles[r.triangle].v;
    const LatticeTet tet{site_.points[v[0]], site_.points[v[1]], site_.points[v[2]], r.point};
    return is_inside(r.point) && orient3d(tet[0], tet[1], tet[2], tet[3]) > 0 &&
           !hits_obstacle(tet, box_of(tet));
  }
  bool is_inside(const LatticePoint& p) const {
    return std::all_of(site_.sides.begin(), site_.sides.end(),
                       [&](const CellSide& s) { return side_of_plane(s.plane, p) == s.side; });
  }

  const LatticePoint& point(std::uint32_t number) const {
    return number < kFirstRaisedPoint ? site_.points[number] : raised_[number - kFirstRaisedPoint].point;
  }
  LatticeTet corners(const Tet& t) const { return {point(t[0]), point(t[1]), point(t[2]), point(t[3])}; }
  /// Positively oriented, and what is raised of it inside the cell: rounding may spoil both.
  bool is_sound(const Tet& t) const {
    return orient3d(point(t[0]), point(t[1]), point(t[2]), point(t[3])) > 0 &&
           std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return v < kFirstRaisedPoint || is_inside(point(v)); });
  }
  /// Rounded coordinates are within half a unit.
  static Bounds box_of(const LatticeTet& tet) {
    Bounds box;
    for (const LatticePoint& corner : tet) {
      const Vec3 p = real(corner);
      box.add(p - Vec3{1, 1, 1});
      box.add(p + Vec3{1, 1, 1});
    }
    return box;
  }

  Bounds box_of_triangle(const FlatTriangle& t) const {
    Bounds box;
    for (const std::uint32_t v : t.v) {
      const Vec3 p = corner(v), h{site_.height + 2, site_.height + 2, site_.height + 2};
      box.add(p - h), box.add(p + h);
    }
    return box;
  }

  void take_all_obstacles() {
    if (obstacles_.size() == site_.obstacles.size()) return;
    obstacles_ = site_.obstacles;
    std::vector<Bounds> boxes;
    for (const Tet& o : obstacles_) boxes.push_back(box_of(corners(o)));
    around_ = BoxTree(boxes);
  }
  /// The obstacles that some roof may reach.
  void find_obstacles() {
    std::vector<Bounds> boxes, obstacle_boxes;
    for (const FlatTriangle& t : site_.triangles) boxes.push_back(box_of_triangle(t));
    const BoxTree tree(boxes);
    for (const Tet& o : site_.obstacles) {
      bool near = false;
      const Bounds box = box_of(corners(o));
      tree.for_overlaps(box, [&](std::uint32_t) { near = true; });
      if (near) obstacles_.push_back(o), obstacle_boxes.push_back(box);
    }
    around_ = BoxTree(obstacle_boxes);
  }
  bool hits_obstacle(const LatticeTet& tet, const Bounds& box) const {
    bool hit = false;
    around_.for_overlaps(box, [&](std::uint32_t o) { hit = hit || overlap(tet, corners(obstacles_[o])); });
    return hit;
  }

  /// An edge needs both triangles, a vertex all edges around it.
  void drop_unsupported() {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t i = 0; i < 3 && !triangles_[t].built; ++i) {
        const auto edge = edges_.find(edge_name(site_.triangles[t], i));
        if (edge != edges_.end()) edge->second.built = false;
        drop_vertex(site_.triangles[t].face, site_.triangles[t].v[i]);
      }
    for (const auto& [name, edge] : edges_)
      for (const std::uint32_t v : name.ends)
        if (!edge.built) drop_vertex(name.face, v);
  }
  void drop_vertex(std::uint32_t face, std::uint32_t v) {
    const auto vertex = vertices_.find({face, v});
    if (vertex != vertices_.end()) vertex->second.built = false;
  }

  static std::uint32_t number(const Part& part) { return kFirstRaisedPoint + part.raised; }

  void make_pieces() {
    pieces_.clear();
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!triangles_[t].built) continue;
      const FlatTriangle& f = site_.triangles[t];
      const std::uint32_t top = number(triangles_[t]);
      pieces_.push_back({{f.v[0], f.v[1], f.v[2], top}, &triangles_[t]});
      for (std::size_t i = 0; i < 3; ++i) {
        const auto edge = edges_.find(edge_name(f, i));
        if (edge == edges_.end() || !edge->second.built) continue;
        const std::uint32_t a = f.v[i], b = f.v[(i + 1) % 3], ridge = number(edge->second);
        pieces_.push_back({{a, b, top, ridge}, &edge->second});
        add_at_vertex(f.face, a, {top, ridge}, false);
        add_at_vertex(f.face, b, {top, ridge}, true);
      }
    }
  }
  void add_at_vertex(std::uint32_t face, std::uint32_t v, std::array<std::uint32_t, 2> rim, bool swapped) {
    const auto vertex = vertices_.find({face, v});
    if (vertex == vertices_.end() || !vertex->second.built) return;
    if (!swapped) std::swap(rim[0], rim[1]);
    pieces_.push_back({{v, number(vertex->second), rim[0], rim[1]}, &vertex->second});
  }

  bool has_changed(const Tet& t) const {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) {
      return v >= kFirstRaisedPoint && raised_[v - kFirstRaisedPoint].changed;
    });
  }

  /// From the start, lowers points until all pieces fit; false if some part had to be dropped instead.
  bool settle() {
    raised_ = start_;
    for (Piece& p : pieces_) p.owner->failed = 0;
    for (;;) {
      const std::vector<std::uint8_t> bad = misfits();
      if (std::find(bad.begin(), bad.end(), 1) == bad.end()) return true;
      if (drop_hopeless(bad)) return false;
      lower_misfits(bad);
    }
  }

  /// By piece: 1 if it is not sound or overlaps something. Those whose points have not moved were good
  /// before, and are asked by the others only.
  std::vector<std::uint8_t> misfits() const {
    std::vector<std::uint8_t> bad(pieces_.size(), 0);
    std::vector<Bounds> boxes;
    for (const Piece& p : pieces_) boxes.push_back(box_of(corners(p.tet)));
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < pieces_.size(); ++i) bad[i] = is_sound(pieces_[i].tet) ? 0 : 1;
    const std::vector<std::uint8_t> unsound = bad;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (unsound[i] != 0 || !has_changed(pieces_[i].tet)) continue;
      const LatticeTet mine = corners(pieces_[i].tet);
      if (bad[i] == 0 && hits_obstacle(mine, boxes[i])) bad[i] = 1;
      tree.for_overlaps(boxes[i], [&](std::uint32_t j) {
        const Tet& other = pieces_[j].tet;
        if (j == i || unsound[j] != 0 || (j < i && has_changed(other))) return;
        if (overlap(mine, corners(other))) bad[i] = bad[j] = 1;
      });
    }
    return bad;
  }

  /// True if a part's pieces have failed in too many rounds.
  bool drop_hopeless(const std::vector<std::uint8_t>& bad) {
    bool some = false;
    for (Piece& p : pieces_) p.owner->fails = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      Part& part = *pieces_[i].owner;
      if (bad[i] == 0 || part.fails) continue;
      part.fails = true;
      if (++part.failed > part.patience) part.built = false, some = true;
    }
    return some;
  }

  void lower_misfits(const std::vector<std::uint8_t>& bad) {
    std::vector<std::uint8_t> low(raised_.size(), 0);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      for (const std::uint32_t v : pieces_[i].tet)
        if (bad[i] != 0 && v >= kFirstRaisedPoint) low[v - kFirstRaisedPoint] = 1;
    for (std::size_t r = 0; r < raised_.size(); ++r) {
      raised_[r].changed = false;
      if (low[r] != 0) lower(raised_[r]);
    }
  }

  CellRoofs result() const {
    CellRoofs roofs;
    for (const Raised& r : raised_) roofs.points.push_back(r.point);
    for (const Piece& p : pieces_) {
      Tet& tet = roofs.tets.emplace_back(p.tet);
      for (std::uint32_t& v : tet) {
        if (v < kFirstRaisedPoint) continue;
        const Raised& r = raised_[v - kFirstRaisedPoint];
        roofs.height = std::max(roofs.height, r.height);
        if (r.corner != kNone) v = r.corner;
      }
    }
    for (const Part& t : triangles_) roofs.built.push_back(t.built ? 1 : 0);
    return roofs;
  }

  const RoofSite& site_;
  std::map<std::uint32_t, Vec3> up_;  ///< by face, of length 1
  std::vector<Part> triangles_;
  std::map<EdgeName, Part> edges_;
  std::map<VertexName, Part> vertices_;
  std::vector<Raised> raised_, start_;
  std::vector<Piece> pieces_;
  std::vector<Tet> obstacles_;
  BoxTree around_{std::span<const Bounds>()};  ///< their boxes
};

}  // namespace

CellRoofs build_roofs(const RoofSite& site) { return RoofBuilder(site).run(); }

}  // namespace crossloft
