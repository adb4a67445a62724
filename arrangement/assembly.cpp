#include "assembly.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <numeric>
#include <utility>

namespace crossloft {
namespace {

/// An old index with what decides its new one; the keys of one kind of element are all different.
template <std::size_t N>
struct Ranked {
  std::array<std::uint32_t, N> key;
  std::uint32_t old;
  friend bool operator<(const Ranked& a, const Ranked& b) { return a.key < b.key; }
};

/// Ascending by key. One bucket for each of the `values` of key[0], then the rest within each: linear, since
/// only a few edges and faces have the same lowest vertex and two cells at most the same lowest face.
template <std::size_t N>
std::vector<Ranked<N>> sorted(const std::vector<Ranked<N>>& items, std::size_t values) {
  std::vector<std::uint32_t> end(values + 1, 0);
  for (const Ranked<N>& item : items) ++end[item.key[0] + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Ranked<N>> out(items.size());
  for (const Ranked<N>& item : items) out[end[item.key[0]]++] = item;
  auto begin = out.begin();
  for (std::size_t v = 0; v < values; ++v) {
    const auto next = out.begin() + end[v];
    std::sort(begin, next);
    begin = next;
  }
  return out;
}

template <std::size_t N>
std::vector<std::uint32_t> ranks(const std::vector<Ranked<N>>& order) {
  std::vector<std::uint32_t> rank(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i].old] = i;
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

/// The distinct items of all faces of each cell, in the order in which they come up.
template <class Item>
Incidence<CellId, Item> gathered(const Incidence<CellId, FaceId>& faces, const Incidence<FaceId, Item>& lists,
                                 std::size_t item_count) {
  Incidence<CellId, Item> out;
  out.begin.push_back(0);
  std::vector<std::uint32_t> last(item_count, kNone);  // cell that has the item
  for (std::uint32_t c = 0; c + 1 < faces.begin.size(); ++c) {
    for (const FaceId f : faces.of(CellId(c)))
      for (const Item item : lists.of(f))
        if (std::exchange(last[item.value], c) != c) out.items.push_back(item);
    close_list(out);
  }
  return out;
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
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a].x != points[b].x) return points[a].x < points[b].x;  // as compare_lex, inline
    return compare_lex(points[a], points[b]) < 0;
  });
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
  order = sorted(order, vertex_ids_.size());
  edge_ids_ = ranks(order);
  for (const auto& [key, old] : order) out_.ends_.push_back({ArrVertexId(key[0]), ArrVertexId(key[1])});
}

void ArrangementAssembly::number_faces() {
  const auto& uses = grown_.uses();
  std::vector<Ranked<3>> order;
  order.reserve(grown_.faces().size());
  for (const auto& face : grown_.faces()) {
    Lowest<3> lowest;
    std::uint32_t use = face.first_use, start = use;
    do {
      const std::uint32_t v = vertex_ids_[uses[use].vertex];
      if (v < lowest.value[0]) start = use;
      lowest.push(v);
      use = uses[use].next;
    } while (use != face.first_use);
    order.push_back({lowest.value, start});
  }
  for (const auto& ranked : sorted(order, vertex_ids_.size())) loop_starts_.push_back(ranked.old);
}

void ArrangementAssembly::lay_out_faces() {
  const auto& uses = grown_.uses();
  auto& vertices = out_.face_vertices_;
  auto& edges = out_.face_edges_;
  vertices.begin.push_back(0);
  vertices.items.reserve(uses.size());
  edges.items.reserve(uses.size());
  for (const std::uint32_t start : loop_starts_) {
    std::uint32_t use = start;
    do {
      vertices.items.emplace_back(vertex_ids_[uses[use].vertex]);
      edges.items.emplace_back(edge_ids_[uses[use].edge]);
      use = uses[use].next;
    } while (use != start);
    close_list(vertices);
    out_.face_planes_.emplace_back(old_face(start).plane);
  }
  edges.begin = vertices.begin;
}

/// The faces come in ascending order, so the first two that name a cell are its lowest.
void ArrangementAssembly::number_cells() {
  std::vector<Lowest<2>> lowest(grown_.cells().size());
  for (std::uint32_t f = 0; f < loop_starts_.size(); ++f)
    for (const std::uint32_t c : old_face(loop_starts_[f]).cells)
      if (c != kNone) lowest[c].push(f);
  std::vector<Ranked<2>> order;
  order.reserve(lowest.size());
  for (const auto& pair : lowest) order.push_back({pair.value, static_cast<std::uint32_t>(order.size())});
  const std::vector<std::uint32_t> ids = ranks(sorted(order, loop_starts_.size()));
  for (const std::uint32_t start : loop_starts_) {
    const auto [negative, positive] = old_face(start).cells;
    out_.face_cells_.push_back({negative == kNone ? CellId{} : CellId(ids[negative]),
                                positive == kNone ? CellId{} : CellId(ids[positive])});
  }
}

/// Inverting sorts: the lists of cells from the lists around vertices and edges, which need not be in order.
void ArrangementAssembly::invert_lists() {
  const std::size_t vertices = out_.vertex_count(), edges = out_.edge_count();
  const std::size_t cells = grown_.cells().size();
  Incidence<FaceId, CellId> face_cells;
  face_cells.begin.push_back(0);
  for (const auto& sides : out_.face_cells_) {
    std::copy_if(sides.begin(), sides.end(), std::back_inserter(face_cells.items),
                 [](CellId c) { return c.valid(); });
    close_list(face_cells);
  }
  out_.cell_faces_ = inverted(face_cells, cells);
  out_.vertex_cells_ = inverted(gathered(out_.cell_faces_, out_.face_vertices_, vertices), vertices);
  out_.cell_vertices_ = inverted(out_.vertex_cells_, cells);
  out_.edge_cells_ = inverted(gathered(out_.cell_faces_, out_.face_edges_, edges), edges);
  out_.cell_edges_ = inverted(out_.edge_cells_, cells);

  Incidence<ArrEdgeId, ArrVertexId> edge_vertices;
  edge_vertices.begin.push_back(0);
  for (const auto& ends : out_.ends_) {
    edge_vertices.items.insert(edge_vertices.items.end(), ends.begin(), ends.end());
    close_list(edge_vertices);
  }
  out_.vertex_edges_ = inverted(edge_vertices, vertices);
  out_.vertex_faces_ = inverted(out_.face_vertices_, vertices);
  out_.edge_faces_ = inverted(out_.face_edges_, edges);
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
