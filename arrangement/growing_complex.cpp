#include "growing_complex.h"

#include <algorithm>
#include <bit>

namespace crossloft {
namespace {

/// An insertion at most doubles the uses, the most numerous elements, and adds less than as many new ones.
constexpr std::size_t kMostUses = std::size_t{1} << 30;

/// The edge of the seed box between two corners (bit axis set = upper bound): 4 axis + the bits of the two
/// following axes.
std::uint32_t seed_edge(std::uint32_t u, std::uint32_t w) {
  const auto axis = static_cast<std::uint32_t>(std::countr_zero(u ^ w));
  return 4 * axis + (u >> (axis + 1) % 3 & 1) + 2 * (u >> (axis + 2) % 3 & 1);
}

}  // namespace

GrowingComplex::GrowingComplex(std::span<const LatticePlane> planes, const LatticeBox& box,
                               LatticePointStore& store)
    : planes_(planes), store_(store), words_(sign_words(planes.size() - 6)) {
  seed_edges(box);
  seed_faces();
}

void GrowingComplex::seed_edges(const LatticeBox& box) {
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    LatticeVector c{};
    unsigned mask = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      c[axis] = upper ? box.upper[axis] : box.lower[axis];
      mask |= 1u << (2 * axis + (upper ? 1 : 0));
    }
    add_vertex(make_point(c), static_cast<std::uint8_t>(mask));
  }
  const auto first_box = static_cast<std::uint32_t>(planes_.size()) - 6;
  for (std::uint32_t axis = 0; axis < 3; ++axis)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t b = (axis + 1) % 3, c = (axis + 2) % 3;
      const std::uint32_t from = (i & 1) << b | (i >> 1) << c;
      add_edge(from, from | 1u << axis, {first_box + 2 * b + (i & 1), first_box + 2 * c + (i >> 1)});
    }
}

void GrowingComplex::seed_faces() {
  const auto first_box = static_cast<std::uint32_t>(planes_.size()) - 6;
  const std::uint32_t cell = add_cell();
  for (std::uint32_t f = 0; f < 6; ++f) {
    const std::uint32_t axis = f / 2, upper = f % 2;
    const std::uint32_t b = 1u << (axis + 1) % 3, c = 1u << (axis + 2) % 3, o = upper << axis;
    const std::array<std::uint32_t, 4> loop{o, o | b, o | b | c, o | c};  // ccw seen from +axis
    add_face(first_box + f);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t use = add_use(loop[i], seed_edge(loop[i], loop[(i + 1) % 4]), f);
      uses_[use].next = i == 3 ? use - 3 : use + 1;
    }
    add_side(cell, f, upper == 1 ? 0 : 1);
  }
}

std::uint32_t GrowingComplex::add_vertex(const LatticePoint& point, std::uint8_t box) {
  points_.push_back(point);
  boxes_.push_back(box);
  signs_.push_back(0);
  polygon_.emplace_back();
  pos_.resize(pos_.size() + words_);
  zero_.resize(zero_.size() + words_);
  return static_cast<std::uint32_t>(points_.size()) - 1;
}

std::uint32_t GrowingComplex::add_edge(std::uint32_t a, std::uint32_t b,
                                       std::array<std::uint32_t, 2> planes) {
  edges_.push_back({{a, b}, planes, kNone});
  return static_cast<std::uint32_t>(edges_.size()) - 1;
}

std::uint32_t GrowingComplex::add_face(std::uint32_t plane) {
  faces_.push_back({plane, kNone, {kNone, kNone}, {kNone, kNone}});
  face_stamps_.push_back(kNone);
  return static_cast<std::uint32_t>(faces_.size()) - 1;
}

std::uint32_t GrowingComplex::add_cell() {
  cells_.push_back(kNone);
  cell_stamps_.push_back(kNone);
  return static_cast<std::uint32_t>(cells_.size()) - 1;
}

/// A use in the list of its edge; its place in the ring is up to the caller.
std::uint32_t GrowingComplex::add_use(std::uint32_t vertex, std::uint32_t edge, std::uint32_t face) {
  const auto use = static_cast<std::uint32_t>(uses_.size());
  uses_.push_back({vertex, edge, face, kNone, edges_[edge].first_use});
  edges_[edge].first_use = use;
  faces_[face].first_use = use;
  return use;
}

void GrowingComplex::add_side(std::uint32_t cell, std::uint32_t face, std::uint32_t side) {
  faces_[face].cells[side] = cell;
  faces_[face].next_of_cell[side] = cells_[cell];
  cells_[cell] = 2 * face + side;
}

bool GrowingComplex::insert(std::uint32_t p) {
  plane_ = p;
  touched_faces_.clear();
  touched_cells_.clear();
  if (uses_.size() > kMostUses) return false;
  sign_vertices();
  if (!split_edges()) return false;
  split_faces();
  split_cells();
  return true;
}

void GrowingComplex::sign_vertices() {
  const LatticePlane& plane = planes_[plane_];
  const std::size_t word = plane_ / 64;
  const SignWord bit = SignWord{1} << (plane_ % 64);
  // The first eight vertices are the corners of the box: a plane that misses it has them on one side.
  int sum = 0;
  for (std::size_t v = 0; v < 8; ++v) sum += side_of_plane(plane, points_[v]);
  const bool misses = sum == 8 || sum == -8;
  for (std::size_t v = 0; v < points_.size(); ++v) {
    const int sign = misses ? sum / 8 : side_of_plane(plane, points_[v]);
    signs_[v] = static_cast<std::int8_t>(sign);
    if (sign > 0) pos_[v * words_ + word] |= bit;
    if (sign == 0) zero_[v * words_ + word] |= bit;
  }
}

/// Splits the edges that cross the plane and collects all faces that meet it.
bool GrowingComplex::split_edges() {
  const auto old_count = static_cast<std::uint32_t>(edges_.size());
  for (std::uint32_t e = 0; e < old_count; ++e) {
    const int product = signs_[edges_[e].ends[0]] * signs_[edges_[e].ends[1]];
    if (product > 0) continue;
    if (product < 0 && !split_edge(e)) return false;
    touch_faces_of(e);
  }
  return true;
}

/// Edge (a, b) becomes (a, m), a new edge (m, b).
bool GrowingComplex::split_edge(std::uint32_t e) {
  const auto [a, b] = edges_[e].ends;
  const auto planes = edges_[e].planes;
  LatticePoint point;
  if (!store_.meet(planes_[planes[0]], planes_[planes[1]], planes_[plane_], point)) return false;
  const std::uint32_t m = add_vertex(point, boxes_[a] & boxes_[b]);
  // The signs of an open edge are those that its ends have or share.
  for (std::size_t w = 0; w < words_; ++w) {
    zero_[m * words_ + w] = zero_[a * words_ + w] & zero_[b * words_ + w];
    pos_[m * words_ + w] = pos_[a * words_ + w] | pos_[b * words_ + w];
  }
  const std::size_t word = m * words_ + plane_ / 64;
  const SignWord bit = SignWord{1} << (plane_ % 64);
  pos_[word] &= ~bit;
  zero_[word] |= bit;

  edges_[e].ends[1] = m;
  split_uses(e, add_edge(m, b, planes), m);
  return true;
}

/// Every use of edge `e` is followed by one of `tail`, or of `e` itself where it ran from the tail's far end.
void GrowingComplex::split_uses(std::uint32_t e, std::uint32_t tail, std::uint32_t middle) {
  const std::uint32_t start = edges_[e].ends[0];
  std::uint32_t use = edges_[e].first_use;
  edges_[e].first_use = kNone;
  while (use != kNone) {
    const std::uint32_t following = uses_[use].next_of_edge;
    const bool forward = uses_[use].vertex == start;
    const std::uint32_t second = add_use(middle, forward ? tail : e, uses_[use].face);
    uses_[second].next = uses_[use].next;
    uses_[use].next = second;
    set_edge(use, forward ? e : tail);
    use = following;
  }
}

void GrowingComplex::set_edge(std::uint32_t use, std::uint32_t edge) {
  uses_[use].edge = edge;
  uses_[use].next_of_edge = edges_[edge].first_use;
  edges_[edge].first_use = use;
}

void GrowingComplex::touch_faces_of(std::uint32_t e) {
  for (std::uint32_t use = edges_[e].first_use; use != kNone; use = uses_[use].next_of_edge) {
    const std::uint32_t f = uses_[use].face;
    if (face_stamps_[f] == plane_) continue;
    face_stamps_[f] = plane_;
    touched_faces_.push_back(f);
  }
}

/// All crossed edges are split: a face crosses the plane iff its ring goes from - to + and back, each time
/// through one vertex on the plane.
void GrowingComplex::split_faces() {
  for (const std::uint32_t f : touched_faces_) {
    touch_cells_of(f);
    std::uint32_t leaving = kNone, entering = kNone;  // uses from a - to a 0, and from a + to a 0 vertex
    const std::uint32_t first = faces_[f].first_use;
    std::uint32_t use = first;
    do {
      const std::uint32_t next = uses_[use].next;
      if (signs_[uses_[next].vertex] == 0) {
        if (signs_[uses_[use].vertex] < 0) leaving = use;
        if (signs_[uses_[use].vertex] > 0) entering = use;
      }
      use = next;
    } while (use != first);
    if (leaving != kNone && entering != kNone) split_face(f, leaving, entering);
  }
}

/// The part on the positive side becomes a new face. `leaving` is the last use of the negative part,
/// `entering` the last of the positive one.
void GrowingComplex::split_face(std::uint32_t f, std::uint32_t leaving, std::uint32_t entering) {
  const std::uint32_t to_positive = uses_[leaving].next, to_negative = uses_[entering].next;
  const std::uint32_t a = uses_[to_positive].vertex, b = uses_[to_negative].vertex;
  const std::uint32_t edge = add_edge(a, b, {faces_[f].plane, plane_});
  const std::uint32_t part = add_face(faces_[f].plane);
  face_stamps_[part] = plane_;

  const std::uint32_t closes_negative = add_use(a, edge, f);
  uses_[leaving].next = closes_negative;
  uses_[closes_negative].next = to_negative;
  const std::uint32_t closes_positive = add_use(b, edge, part);
  uses_[entering].next = closes_positive;
  uses_[closes_positive].next = to_positive;
  for (std::uint32_t use = to_positive; use != closes_positive; use = uses_[use].next) uses_[use].face = part;

  for (std::uint32_t side = 0; side < 2; ++side)
    if (faces_[f].cells[side] != kNone) add_side(faces_[f].cells[side], part, side);
}

void GrowingComplex::touch_cells_of(std::uint32_t f) {
  for (const std::uint32_t c : faces_[f].cells) {
    if (c == kNone || cell_stamps_[c] == plane_) continue;
    cell_stamps_[c] = plane_;
    touched_cells_.push_back(c);
  }
}

/// The side of a face that no longer crosses the plane.
int GrowingComplex::face_sign(std::uint32_t f) const {
  const std::uint32_t first = faces_[f].first_use;
  std::uint32_t use = first;
  do {
    if (const int sign = signs_[uses_[use].vertex]) return sign;
    use = uses_[use].next;
  } while (use != first);
  return 0;
}

/// All crossed faces are split: a cell crosses the plane iff it has faces on both sides.
void GrowingComplex::split_cells() {
  for (const std::uint32_t c : touched_cells_) {
    bool negative = false, positive = false;
    for (std::uint32_t s = cells_[c]; s != kNone; s = next_side(s)) {
      const int sign = face_sign(s / 2);
      negative = negative || sign < 0;
      positive = positive || sign > 0;
    }
    if (negative && positive) split_cell(c);
  }
}

/// The part on the positive side becomes a new cell, with a new face between the two.
void GrowingComplex::split_cell(std::uint32_t c) {
  const std::uint32_t part = add_cell();
  cell_stamps_[part] = plane_;
  std::uint32_t side = cells_[c], start = kNone;
  cells_[c] = kNone;
  while (side != kNone) {
    const std::uint32_t following = next_side(side);
    const bool positive = face_sign(side / 2) > 0;
    add_side(positive ? part : c, side / 2, side % 2);
    if (positive) link_polygon(side, start);
    side = following;
  }
  add_polygon(start, c, part);
}

/// Notes the way along the plane's polygon at the face of `side`, if it has an edge there. A cell is left of
/// its boundary seen from outside, which is the face's ring for the cell on its negative side. The new face
/// borders the positive part from below, so it runs along the edge as the outward ring of its neighbour does
/// backwards, and seen from above as that one does.
void GrowingComplex::link_polygon(std::uint32_t side, std::uint32_t& start) {
  const std::uint32_t first = faces_[side / 2].first_use;
  std::uint32_t use = first;
  do {
    const std::uint32_t next = uses_[use].next;
    std::uint32_t from = uses_[use].vertex, to = uses_[next].vertex;
    if (signs_[from] == 0 && signs_[to] == 0) {
      if (side % 2 == 1) std::swap(from, to);
      polygon_[from] = {to, uses_[use].edge};
      start = from;
      return;
    }
    use = next;
  } while (use != first);
}

/// The face between the two parts of a cell, from the steps of link_polygon.
void GrowingComplex::add_polygon(std::uint32_t start, std::uint32_t negative, std::uint32_t positive) {
  const std::uint32_t f = add_face(plane_);
  face_stamps_[f] = plane_;
  std::uint32_t first = kNone, previous = kNone, v = start;
  do {
    const std::uint32_t use = add_use(v, polygon_[v].edge, f);
    if (previous == kNone)
      first = use;
    else
      uses_[previous].next = use;
    previous = use;
    v = polygon_[v].vertex;
  } while (v != start);
  uses_[previous].next = first;
  add_side(negative, f, 0);
  add_side(positive, f, 1);
}

}  // namespace crossloft
