#include "solidity.h"

#include <algorithm>
#include <array>
#include <bit>

#include "star.h"

namespace crossloft {
namespace {

/// A corner of a tetrahedron, a node of the forest.
struct Node {
  std::uint32_t tet;
  std::uint8_t corner;
};

/// Parent of a node: a facet 0..3, or one of these.
constexpr std::uint8_t kGround = 4;     ///< the tetrahedron has an internal grounded triangle at the corner
constexpr std::uint8_t kCutOff = 5;     ///< the path is broken, another one is looked for
constexpr std::uint8_t kUnreached = 6;  ///< no path to the ground

using Corners = std::uint16_t;  ///< a bit for each

/// [facet]: its corners.
constexpr std::array<Corners, 4> corners_of_facets() {
  std::array<Corners, 4> table{};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned corner = 0; corner < kCorners; ++corner)
      table[i] |= static_cast<Corners>((kCornerFacets[corner] >> i & 1U) << corner);
  return table;
}
constexpr auto kCornersOf = corners_of_facets();

template <class Visit>
void for_each(unsigned corners, Visit visit) {
  for (; corners != 0; corners &= corners - 1) visit(static_cast<unsigned>(std::countr_zero(corners)));
}

class SolidityForest {
 public:
  SolidityForest(const CellComplex& complex, std::vector<std::uint8_t>& kept)
      : complex_(complex), mesh_(complex.mesh), kept_(kept), parent_(kept.size(), kAllUnreached) {}

  void run() {
    plant();
    drop_unreached();
    reached_ = {};
    while (!falling_.empty()) {
      const std::uint32_t t = falling_.back();
      falling_.pop_back();
      repair_after(t);
    }
  }

 private:
  static constexpr std::array<std::uint8_t, kCorners> kAllUnreached{
      {kUnreached, kUnreached, kUnreached, kUnreached, kUnreached, kUnreached, kUnreached, kUnreached,
       kUnreached, kUnreached}};

  std::uint8_t& parent(Node node) { return parent_[node.tet][node.corner]; }

  /// Calls visit(neighbour node, its facet back to `node`) for the kept neighbours in the star.
  template <class Visit>
  void for_neighbours(Node node, Visit visit) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = mesh_.neighbours[node.tet][i];
      if (n == kNone || kept_[n] == 0 || !facet_contains(i, node.corner)) continue;
      const auto corner = static_cast<std::uint8_t>(same_corner(mesh_, node.tet, node.corner, n));
      visit(Node{n, corner}, static_cast<std::uint8_t>(facet_towards(mesh_, n, node.tet)));
    }
  }

  /// First parents, nearly breadth first from the ground so that paths are short. Tetrahedra at a time: many
  /// of their corners are reached together.
  void plant() {
    std::vector<Corners> told(mesh_.size(), 0);  // reached, and their neighbours have been told
    std::vector<std::uint32_t> list;
    reached_.assign(mesh_.size(), 0);
    for (std::uint32_t t = 0; t < mesh_.size(); ++t) {
      if (kept_[t] == 0) continue;
      for (unsigned i = 0; i < 4; ++i)
        if (complex_.facets[t][i] == FacetKind::internal) reached_[t] |= kCornersOf[i];
      for_each(reached_[t], [&](unsigned corner) { parent_[t][corner] = kGround; });
      if (reached_[t] != 0) list.push_back(t);
    }
    for (std::size_t head = 0; head < list.size(); ++head) {
      const std::uint32_t t = list[head];
      const auto news = static_cast<Corners>(reached_[t] & ~told[t]);
      told[t] |= news;
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t n = mesh_.neighbours[t][i];
        if ((news & kCornersOf[i]) == 0 || n == kNone || kept_[n] == 0) continue;
        const bool is_listed = reached_[n] != told[n];
        if (tell(t, i, news, n) && !is_listed) list.push_back(n);
      }
    }
  }

  /// Tells n, across facet i of t, what has been reached there; true if that is new.
  bool tell(std::uint32_t t, unsigned i, Corners news, std::uint32_t n) {
    const auto& from = mesh_.vertices[t];
    const auto& to = mesh_.vertices[n];
    const auto back = static_cast<std::uint8_t>(facet_towards(mesh_, n, t));
    if ((kCornersOf[back] & ~reached_[n]) == 0) return false;
    std::array<unsigned, 4> slot{};
    for (const std::uint8_t k : kFacetSlots[i]) slot[k] = slot_of(to, from[k]);
    Corners there = 0;
    for_each(news & kCornersOf[i], [&](unsigned corner) {
      const auto& ends = kEdgeSlots[corner < 4 ? 0 : corner - 4];
      there |=
          static_cast<Corners>(1U << (corner < 4 ? slot[corner] : kEdgeCorner[slot[ends[0]]][slot[ends[1]]]));
    });
    there &= static_cast<Corners>(~reached_[n]);
    reached_[n] |= there;
    for_each(there, [&](unsigned corner) { parent_[n][corner] = back; });
    return there != 0;
  }

  /// Breadth-first search from queue_ over the nodes in the given state; empties the queue.
  void grow(std::uint8_t state) {
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      for_neighbours(queue_[head], [&](Node next, std::uint8_t back) {
        if (parent(next) != state) return;
        parent(next) = back;
        queue_.push_back(next);
      });
    }
    queue_.clear();
  }

  void drop_unreached() {
    for (std::uint32_t t = 0; t < mesh_.size(); ++t) {
      unsigned asked = 0b1111;
      for (unsigned e = 0; e < 6; ++e) asked |= (complex_.edges[t][e] != EdgeKind::free ? 1U : 0U) << (4 + e);
      if ((asked & ~unsigned{reached_[t]}) != 0) drop(t);
    }
  }

  void drop(std::uint32_t t) {
    if (kept_[t] == 0) return;
    kept_[t] = 0;
    falling_.push_back(t);
  }

  void repair_after(std::uint32_t t) {
    for (std::uint8_t corner = 0; corner < kCorners; ++corner) {
      if (!is_grounded(complex_, t, corner)) continue;
      cut_off_.clear();
      cut_off_children({t, corner});
      for (std::size_t head = 0; head < cut_off_.size(); ++head) cut_off_children(cut_off_[head]);
      reattach();
    }
  }

  void cut_off_children(Node node) {
    for_neighbours(node, [&](Node next, std::uint8_t back) {
      if (parent(next) != back) return;
      parent(next) = kCutOff;
      cut_off_.push_back(next);
    });
  }

  /// Finds new parents for cut_off_, a set of whole subtrees: nodes outside of it don't lead through it,
  /// except behind tetrahedra that are falling already, and those links are cut when their turn comes.
  void reattach() {
    for (const Node node : cut_off_) {
      for_neighbours(node, [&](Node next, std::uint8_t) {
        if (parent(node) != kCutOff || parent(next) > kGround) return;
        parent(node) = static_cast<std::uint8_t>(facet_towards(mesh_, node.tet, next.tet));
        queue_.push_back(node);
      });
    }
    grow(kCutOff);
    for (const Node node : cut_off_) {
      if (parent(node) != kCutOff) continue;
      parent(node) = kUnreached;
      drop(node.tet);
    }
  }

  const CellComplex& complex_;
  const TetMesh& mesh_;
  std::vector<std::uint8_t>& kept_;
  std::vector<std::array<std::uint8_t, kCorners>> parent_;
  std::vector<Corners> reached_;  ///< by tetrahedron; while the forest is planted
  std::vector<Node> queue_;
  std::vector<Node> cut_off_;
  std::vector<std::uint32_t> falling_;
};

/// Flags of the vertices with an internal triangle at them.
std::vector<std::uint8_t> vertices_on_ground(const CellComplex& complex) {
  std::vector<std::uint8_t> flags(complex.vertex_count, 0);
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    for (unsigned i = 0; i < 4; ++i)
      if (complex.facets[t][i] == FacetKind::internal)
        for (const std::uint8_t slot : kFacetSlots[i]) flags[complex.mesh.vertices[t][slot]] = 1;
  return flags;
}

bool is_on_two_faces(const CellComplex& complex, std::uint32_t v) {
  std::uint64_t seen = 0;
  for (const std::uint64_t word : complex.faces_of(v)) {
    if ((word & (word - 1)) != 0 || (word != 0 && seen != 0)) return true;
    seen |= word;
  }
  return false;
}

/// Whether an internal triangle is at the edge, of any tetrahedron around it.
bool has_ground_at_edge(const CellComplex& complex, std::uint32_t t, unsigned corner) {
  bool found = is_on_ground(complex, t, corner);
  visit_around_edge(complex.mesh, t, corner,
                    [&](std::uint32_t n, unsigned at) { found |= is_on_ground(complex, n, at); });
  return found;
}

}  // namespace

void keep_largest_solid_subset(const CellComplex& complex, std::vector<std::uint8_t>& kept) {
  SolidityForest(complex, kept).run();
}

/// A grounded edge on one face alone has an internal triangle there; it is asked where two faces meet.
bool has_ground_everywhere(const CellComplex& complex, const std::vector<std::uint8_t>& kept) {
  const std::vector<std::uint8_t> on_ground = vertices_on_ground(complex);
  std::vector<std::uint8_t> on_line(complex.vertex_count);
  for (std::uint32_t v = 0; v < complex.vertex_count; ++v) on_line[v] = is_on_two_faces(complex, v) ? 1 : 0;
  const bool has_lines = std::find(on_line.begin(), on_line.end(), 1) != on_line.end();
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (kept[t] == 0) continue;
    const auto& v = complex.mesh.vertices[t];
    if ((on_ground[v[0]] & on_ground[v[1]] & on_ground[v[2]] & on_ground[v[3]]) == 0) return false;
    for (unsigned e = 0; e < 6 && has_lines; ++e)
      if (complex.edges[t][e] != EdgeKind::free &&
          (on_line[v[kEdgeSlots[e][0]]] & on_line[v[kEdgeSlots[e][1]]]) != 0 &&
          !has_ground_at_edge(complex, t, 4 + e))
        return false;
  }
  return true;
}

}  // namespace crossloft
