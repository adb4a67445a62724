/// Arrangement::verify.

#include <algorithm>
#include <utility>

#include "../geom/plane_predicates.h"
#include "complex.h"

namespace crossloft {
namespace {

/// One pass over all that Arrangement promises; every check returns the first violation it finds.
class Verifier {
 public:
  explicit Verifier(const Arrangement& complex) : a_(complex) {}

  std::string run() const {
    using Check = std::string (Verifier::*)() const;
    for (const Check check : {&Verifier::vertices, &Verifier::edges, &Verifier::faces, &Verifier::face_sides,
                              &Verifier::cells, &Verifier::euler, &Verifier::lists, &Verifier::locations})
      if (std::string problem = (this->*check)(); !problem.empty()) return problem;
    return {};
  }

 private:
  static std::string name(const char* kind, std::uint32_t index, const char* what) {
    return std::string(kind) + ' ' + std::to_string(index) + ": " + what;
  }

  std::string vertices() const;
  std::string vertex_signs(ArrVertexId v) const;
  std::string vertex_planes(ArrVertexId v) const;
  std::string edges() const;
  std::string faces() const;
  std::string face_loop(FaceId f) const;
  std::string face_sides() const;
  std::string cells() const;
  std::string cell_surface(CellId c) const;
  std::string euler() const;
  std::string lists() const;
  std::string locations() const;

  /// The signs of an open element are those its vertices have or share; each vertex lies in its closure.
  bool spans(SignView element, std::span<const ArrVertexId> vertices) const;
  bool on_plane(ArrVertexId v, PlaneId p) const {
    return a_.is_box(p) ? (a_.box_mask(v) >> (p.value - a_.plane_count()) & 1) != 0
                        : has_bit(a_.signs(v).zero, p);
  }

  template <class Key, class Item, class Forward, class Backward>
  bool mutual(std::uint32_t keys, std::uint32_t items, Forward forward, Backward backward) const;

  const Arrangement& a_;
};

bool Verifier::spans(SignView element, std::span<const ArrVertexId> vertices) const {
  for (std::size_t w = 0; w < a_.words(); ++w) {
    SignWord pos = 0, zero = ~SignWord{0};
    for (const ArrVertexId v : vertices) pos |= a_.signs(v).pos[w], zero &= a_.signs(v).zero[w];
    if (element.pos[w] != pos || element.zero[w] != zero) return false;
  }
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](ArrVertexId v) { return in_closure(a_.signs(v), element); });
}

std::string Verifier::vertices() const {
  for (std::uint32_t v = 0; v < a_.vertex_count(); ++v) {
    if (v > 0 && compare_lex(a_.point(ArrVertexId(v - 1)), a_.point(ArrVertexId(v))) >= 0)
      return name("vertex", v, "not above the one before");
    if (std::string problem = vertex_signs(ArrVertexId(v)); !problem.empty()) return problem;
    if (std::string problem = vertex_planes(ArrVertexId(v)); !problem.empty()) return problem;
  }
  return {};
}

std::string Verifier::vertex_signs(ArrVertexId v) const {
  for (std::uint32_t p = 0; p < a_.plane_count(); ++p)
    if (side_of_plane(a_.plane(PlaneId(p)), a_.point(v)) != sign_at(a_.signs(v), PlaneId(p)))
      return name("vertex", v.value, "wrong sign");
  for (std::uint32_t j = 0; j < 6; ++j) {
    const int inner = j % 2 == 0 ? 1 : -1;
    const int side = inner * side_of_plane(a_.plane(PlaneId(a_.plane_count() + j)), a_.point(v));
    if (side < 0) return name("vertex", v.value, "outside the box");
    if ((side == 0) != ((a_.box_mask(v) >> j & 1) != 0)) return name("vertex", v.value, "wrong box mask");
  }
  return {};
}

/// The vertex once more by its planes alone: three of its tag that meet in a point, against all the others.
std::string Verifier::vertex_planes(ArrVertexId v) const {
  std::vector<LatticePlane> tag;
  for (std::uint32_t p = 0; p < a_.plane_count() + 6; ++p)
    if (on_plane(v, PlaneId(p))) tag.push_back(a_.plane(PlaneId(p)));
  for (std::size_t i = 1; i < tag.size(); ++i)
    for (std::size_t j = i + 1; j < tag.size(); ++j) {
      if (orient_normals(tag[0], tag[i], tag[j]) == 0) continue;
      for (std::uint32_t p = 0; p < a_.plane_count(); ++p)
        if (side_of_meet(tag[0], tag[i], tag[j], a_.plane(PlaneId(p))) != sign_at(a_.signs(v), PlaneId(p)))
          return name("vertex", v.value, "its planes meet elsewhere");
      return {};
    }
  return name("vertex", v.value, "its planes do not meet in a point");
}

std::string Verifier::edges() const {
  for (std::uint32_t i = 0; i < a_.edge_count(); ++i) {
    const ArrEdgeId e(i);
    const auto ends = a_.ends(e);
    const auto planes = a_.planes_of(e);
    if (ends[0] >= ends[1]) return name("edge", i, "ends not in order");
    if (i > 0 && a_.ends(ArrEdgeId(i - 1)) >= ends) return name("edge", i, "not above the one before");
    if (!spans(a_.signs(e), ends)) return name("edge", i, "wrong signs");
    if (planes[0] >= planes[1]) return name("edge", i, "planes not in order");
    for (const PlaneId p : planes)
      if (!on_plane(ends[0], p) || !on_plane(ends[1], p)) return name("edge", i, "not on its planes");
  }
  return {};
}

std::string Verifier::faces() const {
  for (std::uint32_t i = 0; i < a_.face_count(); ++i) {
    const FaceId f(i);
    if (a_.vertices_of(f).size() < 3) return name("face", i, "fewer than three vertices");
    if (!spans(a_.signs(f), a_.vertices_of(f))) return name("face", i, "wrong signs");
    if (std::string problem = face_loop(f); !problem.empty()) return problem;
  }
  return {};
}

/// A closed loop that turns left everywhere and has one lexicographic minimum is a convex polygon.
std::string Verifier::face_loop(FaceId f) const {
  const auto loop = a_.vertices_of(f);
  const auto edges = a_.edges_of(f);
  const LatticePlane& plane = a_.plane(a_.plane_of(f));
  const std::size_t n = loop.size();
  if (edges.size() != n) return name("face", f.value, "edges not in step with vertices");
  std::size_t minima = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const ArrVertexId before = loop[(i + n - 1) % n], v = loop[i], after = loop[(i + 1) % n];
    if (!on_plane(v, a_.plane_of(f))) return name("face", f.value, "vertex off its plane");
    if (a_.ends(edges[i]) != std::array{std::min(v, after), std::max(v, after)})
      return name("face", f.value, "edge does not join its vertices");
    if (orient2d(plane, a_.point(before), a_.point(v), a_.point(after)) <= 0)
      return name("face", f.value, "not strictly convex");
    if (v < before && v < after) ++minima;
  }
  if (minima != 1 || *std::min_element(loop.begin(), loop.end()) != loop[0])
    return name("face", f.value, "winds more than once or starts at the wrong vertex");
  return {};
}

std::string Verifier::face_sides() const {
  for (std::uint32_t i = 0; i < a_.face_count(); ++i) {
    const FaceId f(i);
    const auto cells = a_.cells_of(f);
    const PlaneId p = a_.plane_of(f);
    if (a_.on_box(f)) {
      const bool upper = (p.value - a_.plane_count()) % 2 == 1;
      if (!cells[upper ? 0 : 1].valid() || cells[upper ? 1 : 0].valid())
        return name("face", i, "of the box without one cell inside");
      continue;
    }
    if (!cells[0].valid() || !cells[1].valid()) return name("face", i, "without two cells");
    if (sign_at(a_.signs(cells[0]), p) != -1 || sign_at(a_.signs(cells[1]), p) != 1)
      return name("face", i, "cells on the wrong sides");
  }
  return {};
}

std::string Verifier::cells() const {
  std::array<FaceId, 2> before{};
  for (std::uint32_t i = 0; i < a_.cell_count(); ++i) {
    const CellId c(i);
    const auto faces = a_.faces_of(c);
    if (faces.size() < 4) return name("cell", i, "fewer than four faces");
    const std::array<FaceId, 2> lowest{faces[0], faces[1]};
    if (i > 0 && before >= lowest) return name("cell", i, "not above the one before");
    before = lowest;
    // With all vertices in the closure of its signs the cell lies on one side of each of its faces' planes.
    if (!spans(a_.signs(c), a_.vertices_of(c))) return name("cell", i, "wrong signs");
    if (std::string problem = cell_surface(c); !problem.empty()) return problem;
  }
  return {};
}

/// The faces close up: every edge is run along once in each direction, and the surface is a sphere.
std::string Verifier::cell_surface(CellId c) const {
  std::vector<std::pair<ArrVertexId, ArrVertexId>> directed;
  for (const FaceId f : a_.faces_of(c)) {
    const auto cells = a_.cells_of(f);
    if (cells[0] != c && cells[1] != c) return name("cell", c.value, "not a cell of its face");
    const auto loop = a_.vertices_of(f);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const ArrVertexId from = loop[i], to = loop[(i + 1) % loop.size()];
      directed.push_back(cells[0] == c ? std::pair(from, to) : std::pair(to, from));
    }
  }
  std::sort(directed.begin(), directed.end());
  if (std::adjacent_find(directed.begin(), directed.end()) != directed.end())
    return name("cell", c.value, "edge run along twice in one direction");
  for (const auto& [from, to] : directed)
    if (!std::binary_search(directed.begin(), directed.end(), std::pair(to, from)))
      return name("cell", c.value, "surface is open");
  const std::size_t v = a_.vertices_of(c).size(), e = a_.edges_of(c).size(), f = a_.faces_of(c).size();
  if (directed.size() != 2 * e) return name("cell", c.value, "wrong list of edges");
  if (v + f != e + 2) return name("cell", c.value, "surface is not a sphere");
  return {};
}

/// The box is a ball: V - E + F - C = 1.
std::string Verifier::euler() const {
  const std::uint64_t even = std::uint64_t{a_.vertex_count()} + a_.face_count();
  const std::uint64_t odd = std::uint64_t{a_.edge_count()} + a_.cell_count();
  return even == odd + 1 ? std::string() : "the complex is not a ball";
}

/// True iff b is in forward(a) exactly where a is in backward(b), all lists strictly ascending but the
/// forward ones, which may be loops.
template <class Key, class Item, class Forward, class Backward>
bool Verifier::mutual(std::uint32_t keys, std::uint32_t items, Forward forward, Backward backward) const {
  std::size_t there = 0, back = 0;
  for (std::uint32_t k = 0; k < keys; ++k)
    for (const Item item : forward(Key(k))) {
      const auto list = backward(item);
      if (!std::binary_search(list.begin(), list.end(), Key(k))) return false;
      ++there;
    }
  for (std::uint32_t i = 0; i < items; ++i) {
    const auto list = backward(Item(i));
    if (std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) != list.end()) return false;
    back += list.size();
  }
  return there == back;
}

std::string Verifier::lists() const {
  const std::uint32_t v = a_.vertex_count(), e = a_.edge_count(), f = a_.face_count(), c = a_.cell_count();
  const auto around = [&](auto key) { return a_.faces_around(key); };
  const auto cells_around = [&](auto key) { return a_.cells_around(key); };
  if (!mutual<ArrEdgeId, ArrVertexId>(
          e, v, [&](ArrEdgeId k) { return a_.ends(k); }, [&](ArrVertexId k) { return a_.edges_around(k); }))
    return "edges around vertices do not match";
  if (!mutual<FaceId, ArrVertexId>(
          f, v, [&](FaceId k) { return a_.vertices_of(k); }, around))
    return "faces around vertices do not match";
  if (!mutual<FaceId, ArrEdgeId>(
          f, e, [&](FaceId k) { return a_.edges_of(k); }, around))
    return "faces around edges do not match";
  if (!mutual<CellId, ArrVertexId>(
          c, v, [&](CellId k) { return a_.vertices_of(k); }, cells_around))
    return "cells around vertices do not match";
  if (!mutual<CellId, ArrEdgeId>(
          c, e, [&](CellId k) { return a_.edges_of(k); }, cells_around))
    return "cells around edges do not match";
  std::size_t sides = 0, listed = 0;
  for (std::uint32_t i = 0; i < f; ++i) sides += a_.on_box(FaceId(i)) ? 1 : 2;
  for (std::uint32_t i = 0; i < c; ++i) listed += a_.faces_of(CellId(i)).size();
  return sides == listed ? std::string() : "faces of cells do not match";
}

std::string Verifier::locations() const {
  const auto found = [&](auto id, std::uint8_t dimension) {
    return a_.locate(a_.signs(id)) == Location{dimension, id.value};
  };
  for (std::uint32_t i = 0; i < a_.vertex_count(); ++i)
    if (const ArrVertexId v(i); !a_.on_box(v) && !found(v, 0)) return name("vertex", i, "not found");
  for (std::uint32_t i = 0; i < a_.edge_count(); ++i)
    if (const ArrEdgeId e(i); !a_.on_box(e) && !found(e, 1)) return name("edge", i, "not found");
  for (std::uint32_t i = 0; i < a_.face_count(); ++i)
    if (const FaceId f(i); !a_.on_box(f) && !found(f, 2)) return name("face", i, "not found");
  for (std::uint32_t i = 0; i < a_.cell_count(); ++i)
    if (!found(CellId(i), 3)) return name("cell", i, "not found");
  return {};
}

}  // namespace

std::string Arrangement::verify() const { return Verifier(*this).run(); }

}  // namespace crossloft
