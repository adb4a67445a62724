#include "assembly.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace crossloft {
namespace {

/// An old index with what decides its new one; the keys of one kind of element are all different.
template <std::size_t N>
struct Ranked {
  std::array<std::uint32_t, N> key;
  std::uint32_t old;
  friend bool operator<(const Ranked& a, const Ranked& b) { return a.key < b.key; }
};

template <std::size_t N>
std::vector<std::uint32_t> ranks(const std::vector<Ranked<N>>& sorted) {
  std::vector<std::uint32_t> rank(sorted.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) rank[sorted[i].old] = i;
  return rank;
}

/// The N lowest of the values pushed, ascending.
template <std::size_t N>
struct Lowest {
  std::array<std::uint32_t, N> value;
  Lowest() { value.fill(kNone); }
  void push(std::uint32_t x) {
    for (std::uint32_t& slot : value)
      if (x < slot) std::swap(x, slot);
  }
};

/// Lists keys by item from lists of items by key; ascending, since the keys are visited in order.
template <class Key, class Item>
Incidence<Item, Key> inverted(const Incidence<Key, Item>& lists, std::size_t item_count) {
  Incidence<Item, Key> out;
  out.begin.assign(item_count + 1, 0);
  for (const Item item : lists.items) ++out.begin[item.value + 1];
  std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
  out.items.resize(lists.items.size());
  std::vector<std::uint32_t> fill(out.begin.begin(), out.begin.end() - 1);
  for (std::uint32_t key = 0; key + 1 < lists.begin.size(); ++key)
    for (const Item item : lists.of(Key(key))) out.items[fill[item.value]++] = Key(key);
  return out;
}

template <class Key, class Item>
void close_list(Incidence<Key, Item>& lists) {
  lists.begin.push_back(static_cast<std::uint32_t>(lists.items.size()));
}

/// Appends the distinct ones of `items` as the next list.
template <class Key, class Item>
void append_distinct(Incidence<Key, Item>& lists, std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  lists.items.insert(lists.items.end(), items.begin(), std::unique(items.begin(), items.end()));
  close_list(lists);
}

}  // namespace

Arrangement ArrangementAssembly::run(std::span<const LatticePlane> given_and_box, const LatticeBox& box) {
  out_.plane_count_ = static_cast<std::uint32_t>(given_and_box.size()) - 6;
  out_.words_ = grown_.words();
  out_.box_ = box;
  out_.planes_.assign(given_and_box.begin(), given_and_box.end());
  number_vertices();
  number_edges();
  number_faces();
  lay_out_faces();
  number_cells();
  lay_out_cells();
  invert_lists();
  fill_rows();
  choose_edge_planes();
  hash_rows();
  return std::move(out_);
}

void ArrangementAssembly::number_vertices() {
  const auto& points = grown_.points();
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return compare_lex(points[a], points[b]) < 0; });
  vertex_ids_.resize(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    vertex_ids_[order[i]] = i;
    out_.points_.push_back(points[order[i]]);
    out_.vertex_box_.push_back(grown_.boxes()[order[i]]);
  }
}

void ArrangementAssembly::number_edges() {
  std::vector<Ranked<2>> order;
  order.reserve(grown_.edges().size());
  for (const auto& edge : grown_.edges()) {
    const std::uint32_t a = vertex_ids_[edge.ends[0]], b = vertex_ids_[edge.ends[1]];
    order.push_back({{std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(order.size())});
  }
  std::sort(order.begin(), order.end());
  edge_ids_ = ranks(order);
  for (const auto& [key, old] : order) out_.ends_.push_back({ArrVertexId(key[0]), ArrVertexId(key[1])});
}

void ArrangementAssembly::number_faces() {
  std::vector<Ranked<3>> order;
  order.reserve(grown_.faces().size());
  for (const auto& face : grown_.faces()) {
    Lowest<3> lowest;
    std::uint32_t use = face.first_use;
    do {
      lowest.push(vertex_ids_[grown_.uses()[use].vertex]);
      use = grown_.uses()[use].next;
    } while (use != face.first_use);
    order.push_back({lowest.value, static_cast<std::uint32_t>(order.size())});
  }
  std::sort(order.begin(), order.end());
  face_ids_ = ranks(order);
  for (const auto& ranked : order) old_faces_.push_back(ranked.old);
}

void ArrangementAssembly::lay_out_faces() {
  const auto& uses = grown_.uses();
  auto& vertices = out_.face_vertices_;
  vertices.begin.push_back(0);
  out_.face_edges_.begin.push_back(0);
  for (const std::uint32_t old : old_faces_) {
    const auto& face = grown_.faces()[old];
    std::uint32_t first = face.first_use;
    for (std::uint32_t use = uses[first].next; use != face.first_use; use = uses[use].next)
      if (vertex_ids_[uses[use].vertex] < vertex_ids_[uses[first].vertex]) first = use;
    std::uint32_t use = first;
    do {
      vertices.items.emplace_back(vertex_ids_[uses[use].vertex]);
      out_.face_edges_.items.emplace_back(edge_ids_[uses[use].edge]);
      use = uses[use].next;
    } while (use != first);
    close_list(vertices);
    close_list(out_.face_edges_);
    out_.face_planes_.emplace_back(face.plane);
  }
}

void ArrangementAssembly::number_cells() {
  std::vector<Ranked<2>> order;
  order.reserve(grown_.cells().size());
  for (const std::uint32_t first_side : grown_.cells()) {
    Lowest<2> lowest;
    for (std::uint32_t s = first_side; s != kNone; s = grown_.faces()[s / 2].next_of_cell[s % 2])
      lowest.push(face_ids_[s / 2]);
    order.push_back({lowest.value, static_cast<std::uint32_t>(order.size())});
  }
  std::sort(order.begin(), order.end());
  const std::vector<std::uint32_t> ids = ranks(order);
  for (const std::uint32_t old : old_faces_) {
    const auto [negative, positive] = grown_.faces()[old].cells;
    out_.face_cells_.push_back({negative == kNone ? CellId{} : CellId(ids[negative]),
                                positive == kNone ? CellId{} : CellId(ids[positive])});
  }
  out_.cell_faces_.begin.push_back(0);
  std::vector<FaceId> list;
  for (const auto& ranked : order) {
    list.clear();
    for (std::uint32_t s = grown_.cells()[ranked.old]; s != kNone;
         s = grown_.faces()[s / 2].next_of_cell[s % 2])
      list.emplace_back(face_ids_[s / 2]);
    append_distinct(out_.cell_faces_, list);
  }
}

void ArrangementAssembly::lay_out_cells() {
  out_.cell_edges_.begin.push_back(0);
  out_.cell_vertices_.begin.push_back(0);
  std::vector<ArrEdgeId> edges;
  std::vector<ArrVertexId> vertices;
  for (std::uint32_t c = 0; c < out_.cell_count(); ++c) {
    edges.clear();
    vertices.clear();
    for (const FaceId f : out_.faces_of(CellId(c))) {
      const auto face_edges = out_.edges_of(f);
      const auto face_vertices = out_.vertices_of(f);
      edges.insert(edges.end(), face_edges.begin(), face_edges.end());
      vertices.insert(vertices.end(), face_vertices.begin(), face_vertices.end());
    }
    append_distinct(out_.cell_edges_, edges);
    append_distinct(out_.cell_vertices_, vertices);
  }
}

void ArrangementAssembly::invert_lists() {
  const std::size_t vertices = out_.vertex_count(), edges = out_.edge_count();
  Incidence<ArrEdgeId, ArrVertexId> edge_vertices;
  edge_vertices.begin.push_back(0);
  for (const auto& [a, b] : out_.ends_) {
    edge_vertices.items.insert(edge_vertices.items.end(), {a, b});
    close_list(edge_vertices);
  }
  out_.vertex_edges_ = inverted(edge_vertices, vertices);
  out_.vertex_faces_ = inverted(out_.face_vertices_, vertices);
  out_.vertex_cells_ = inverted(out_.cell_vertices_, vertices);
  out_.edge_faces_ = inverted(out_.face_edges_, edges);
  out_.edge_cells_ = inverted(out_.cell_edges_, edges);
}

/// An open convex element has, against each plane, the sign that its vertices have or share.
void ArrangementAssembly::fill_rows() {
  const std::size_t words = out_.words_;
  const std::size_t rows = std::size_t{out_.first_cell_row()} + out_.cell_count();
  out_.pos_.assign(rows * words, 0);
  out_.zero_.assign(rows * words, ~SignWord{0});
  for (std::size_t old = 0; old < vertex_ids_.size(); ++old) {
    const std::size_t from = old * words, to = vertex_ids_[old] * words;
    std::copy_n(grown_.pos().begin() + static_cast<std::ptrdiff_t>(from), words,
                out_.pos_.begin() + static_cast<std::ptrdiff_t>(to));
    std::copy_n(grown_.zero().begin() + static_cast<std::ptrdiff_t>(from), words,
                out_.zero_.begin() + static_cast<std::ptrdiff_t>(to));
  }
  const auto merge = [&](std::size_t row, std::span<const ArrVertexId> vertices) {
    for (const ArrVertexId v : vertices)
      for (std::size_t w = 0; w < words; ++w) {
        out_.pos_[row * words + w] |= out_.pos_[v.value * words + w];
        out_.zero_[row * words + w] &= out_.zero_[v.value * words + w];
      }
  };
  std::size_t row = out_.first_edge_row();
  for (const auto& ends : out_.ends_) merge(row++, ends);
  for (std::uint32_t f = 0; f < out_.face_count(); ++f) merge(row++, out_.vertices_of(FaceId(f)));
  for (std::uint32_t c = 0; c < out_.cell_count(); ++c) merge(row++, out_.vertices_of(CellId(c)));
}

namespace {

/// True iff the plane is one of { x_axis = constant }.
bool is_level(const LatticePlane& plane, std::size_t axis) {
  return plane.normal[(axis + 1) % 3] == 0 && plane.normal[(axis + 2) % 3] == 0;
}

}  // namespace

/// The two lowest planes through the edge that differ as point sets: a given plane may coincide with one of
/// the box.
void ArrangementAssembly::choose_edge_planes() {
  for (std::uint32_t e = 0; e < out_.edge_count(); ++e) {
    std::array<PlaneId, 2> pair;
    std::size_t count = 0;
    const SignView signs = out_.signs(ArrEdgeId(e));
    for (std::uint32_t w = 0; w < out_.words_; ++w)
      for (SignWord rest = signs.zero[w]; rest != 0 && count < 2; rest &= rest - 1)
        pair[count++] = PlaneId(64 * w + static_cast<std::uint32_t>(std::countr_zero(rest)));
    const auto [a, b] = out_.ends_[e];
    const unsigned mask = out_.box_mask(a) & out_.box_mask(b);
    for (std::uint32_t j = 0; j < 6 && count < 2; ++j) {
      if ((mask >> j & 1) == 0) continue;
      if (count == 1 && is_level(out_.plane(pair[0]), j / 2)) continue;
      pair[count++] = PlaneId(out_.plane_count_ + j);
    }
    out_.edge_planes_.push_back(pair);
  }
}

/// Rows of the elements that are not on the box, by their signs.
void ArrangementAssembly::hash_rows() {
  const auto rows = out_.first_cell_row() + out_.cell_count();
  out_.by_signs_.assign(std::bit_ceil(std::size_t{rows} * 2), kNone);
  const auto enter = [&](std::uint32_t row) {
    std::size_t slot = first_slot(out_.row(row), out_.by_signs_.size());
    while (out_.by_signs_[slot] != kNone) slot = (slot + 1) & (out_.by_signs_.size() - 1);
    out_.by_signs_[slot] = row;
  };
  for (std::uint32_t v = 0; v < out_.vertex_count(); ++v)
    if (!out_.on_box(ArrVertexId(v))) enter(v);
  for (std::uint32_t e = 0; e < out_.edge_count(); ++e)
    if (!out_.on_box(ArrEdgeId(e))) enter(out_.first_edge_row() + e);
  for (std::uint32_t f = 0; f < out_.face_count(); ++f)
    if (!out_.on_box(FaceId(f))) enter(out_.first_face_row() + f);
  for (std::uint32_t c = 0; c < out_.cell_count(); ++c) enter(out_.first_cell_row() + c);
}

}  // namespace crossloft
