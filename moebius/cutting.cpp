#include "cutting.h"

#include <algorithm>
#include <map>

#include "section_overlay.h"

namespace crossloft {
namespace {

/// The borders of the cells within the section, as directed pieces that are joined to loops.
///
/// A loop that goes around what it bounds has positive area, one around a hole negative; each piece of a cell
/// has exactly one of the former, so counting them counts the pieces.
class SectionOverlay {
 public:
  SectionOverlay(std::span<const NumberedSite> sites, std::span<const FaceArc> arcs,
                 std::span<const DirectedWall> walls)
      : sites_(sites), arcs_(arcs), walls_(walls) {}

  void build() {
    find_crossings();
    add_arc_pieces();
    add_wall_pieces();
    count_loops();
  }
  bool is_inside(std::uint32_t arc) const { return inside_[arc]; }
  /// Pieces of the site's cell within the section.
  std::uint32_t pieces_of(std::uint32_t site) const {
    const auto found = pieces_of_.find(site);
    return found == pieces_of_.end() ? 0 : found->second;
  }

 private:
  /// Part of the border of a cell, the cell on its left.
  struct Piece {
    std::uint32_t from, to;  ///< nodes
    std::uint32_t cell;
    double twice_area;
  };

  void find_crossings();
  void add_arc_pieces();
  void add_strand_piece(const Strand& strand, std::uint32_t from, std::uint32_t to);
  void add_wall_pieces();
  void label_walls();
  void follow_walls(std::uint32_t wall);
  void count_loops();
  bool in_section(Vec2 p) const;
  std::uint32_t nearest(Vec2 p) const;

  std::uint32_t node(Vec2 p) {
    const auto next = static_cast<std::uint32_t>(crossings_.size() + nodes_.size());
    return nodes_.try_emplace(p, next).first->second;
  }
  /// Of a node, in the frame of the first wall's begin, where areas are computed.
  Vec2 place(Vec2 p) const { return p - walls_[0].from; }

  std::span<const NumberedSite> sites_;
  std::span<const FaceArc> arcs_;
  std::span<const DirectedWall> walls_;
  std::vector<Strand> strands_;
  std::vector<WallCrossing> crossings_;
  std::vector<std::vector<std::uint32_t>> on_strand_, on_wall_;  ///< crossings in order
  std::map<Vec2, std::uint32_t> nodes_;                          ///< vertices of the diagram and of the walls
  std::vector<std::uint32_t> first_cell_;                        ///< of each wall: at its begin
  std::vector<std::vector<std::uint32_t>> after_;  ///< of each wall: those that begin at its end
  std::vector<Piece> pieces_;
  double least_area_ = 0;
  std::vector<char> inside_;  ///< per arc: part of it is within the section
  std::map<std::uint32_t, std::uint32_t> pieces_of_;
};

Box2 box_of(std::span<const DirectedWall> walls) {
  Box2 box{walls[0].from, walls[0].from};
  for (const DirectedWall& w : walls) {
    box.low = {std::min(box.low.x, w.from.x), std::min(box.low.y, w.from.y)};
    box.high = {std::max(box.high.x, w.from.x), std::max(box.high.y, w.from.y)};
  }
  return box;
}

void SectionOverlay::find_crossings() {
  const Box2 box = box_of(walls_);
  least_area_ = 1e-12 * dot(box.high - box.low, box.high - box.low);
  for (std::uint32_t a = 0; a < arcs_.size(); ++a) split_arc(arcs_[a], a, box, strands_);
  inside_.assign(arcs_.size(), 0);
  on_strand_.resize(strands_.size());
  on_wall_.resize(walls_.size());
  for (std::uint32_t s = 0; s < strands_.size(); ++s)
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
      std::size_t k = crossings_.size();
      cross_wall(strands_[s], walls_[w], crossings_);
      for (; k < crossings_.size(); ++k) {
        crossings_[k].strand = s;
        crossings_[k].wall = w;
        on_strand_[s].push_back(static_cast<std::uint32_t>(k));
        on_wall_[w].push_back(static_cast<std::uint32_t>(k));
      }
    }
  for (auto& list : on_strand_)
    std::sort(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) {
      return crossings_[a].along_strand < crossings_[b].along_strand;
    });
  for (auto& list : on_wall_)
    std::sort(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) {
      return crossings_[a].along_wall < crossings_[b].along_wall;
    });
}

void SectionOverlay::add_arc_pieces() {
  for (std::uint32_t s = 0; s < strands_.size(); ++s) {
    const Strand& strand = strands_[s];
    const auto& list = on_strand_[s];
    const bool starts_inside = list.empty() ? in_section(strand.from) : !crossings_[list.front()].enters;
    std::uint32_t begin = starts_inside ? node(strand.from) : kNone;
    for (const std::uint32_t c : list) {
      if (begin != kNone && !crossings_[c].enters) add_strand_piece(strand, begin, c);
      begin = crossings_[c].enters ? c : kNone;
    }
    if (begin != kNone) add_strand_piece(strand, begin, node(strand.to));
  }
}

void SectionOverlay::add_strand_piece(const Strand& strand, std::uint32_t from, std::uint32_t to) {
  const Vec2 begin = from < crossings_.size() ? crossings_[from].at : strand.from;
  const Vec2 end = to < crossings_.size() ? crossings_[to].at : strand.to;
  const double area = twice_area(strand, place(begin), place(end));
  pieces_.push_back({from, to, arcs_[strand.arc].sites[0], area});
  pieces_.push_back({to, from, arcs_[strand.arc].sites[1], -area});
  inside_[strand.arc] = 1;
}

void SectionOverlay::add_wall_pieces() {
  label_walls();
  for (std::uint32_t w = 0; w < walls_.size(); ++w) {
    std::uint32_t from = node(walls_[w].from), cell = first_cell_[w];
    Vec2 begin = walls_[w].from;
    for (const std::uint32_t c : on_wall_[w]) {
      const Vec2 end = crossings_[c].at;
      const auto& sites = arcs_[strands_[crossings_[c].strand].arc].sites;
      pieces_.push_back({from, c, cell, cross(place(begin), place(end))});
      from = c;
      begin = end;
      cell = sites[crossings_[c].enters ? 1 : 0];
    }
    pieces_.push_back({from, node(walls_[w].to), cell, cross(place(begin), place(walls_[w].to))});
  }
}

/// Crossings tell in which cell a wall begins and ends; a wall without one begins where the one before it
/// ends.
void SectionOverlay::label_walls() {
  std::map<Vec2, std::vector<std::uint32_t>> by_begin;
  for (std::uint32_t w = 0; w < walls_.size(); ++w) by_begin[walls_[w].from].push_back(w);
  after_.resize(walls_.size());
  for (std::uint32_t w = 0; w < walls_.size(); ++w) after_[w] = by_begin[walls_[w].to];
  first_cell_.assign(walls_.size(), kNone);
  for (std::uint32_t w = 0; w < walls_.size(); ++w)
    if (!on_wall_[w].empty()) {
      const WallCrossing& first = crossings_[on_wall_[w].front()];
      first_cell_[w] = arcs_[strands_[first.strand].arc].sites[first.enters ? 0 : 1];
    }
  for (std::uint32_t w = 0; w < walls_.size(); ++w)
    if (!on_wall_[w].empty()) follow_walls(w);
  for (std::uint32_t w = 0; w < walls_.size(); ++w)
    if (first_cell_[w] == kNone) {
      first_cell_[w] = nearest(walls_[w].from);
      follow_walls(w);
    }
}

/// Labels the walls without a crossing that follow a wall.
void SectionOverlay::follow_walls(std::uint32_t wall) {
  std::uint32_t cell = first_cell_[wall];
  if (!on_wall_[wall].empty()) {
    const WallCrossing& last = crossings_[on_wall_[wall].back()];
    cell = arcs_[strands_[last.strand].arc].sites[last.enters ? 1 : 0];
  }
  std::vector<std::uint32_t> stack{wall};
  while (!stack.empty()) {
    const std::uint32_t w = stack.back();
    stack.pop_back();
    for (const std::uint32_t next : after_[w]) {
      if (first_cell_[next] != kNone) continue;
      first_cell_[next] = cell;
      stack.push_back(next);
    }
  }
}

void SectionOverlay::count_loops() {
  std::multimap<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>
      begins;  // of the pieces left, by node and cell
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) begins.insert({{pieces_[p].from, pieces_[p].cell}, p});
  while (!begins.empty()) {
    const auto start = begins.begin();
    const Piece& first = pieces_[start->second];
    double area = 0;
    std::uint32_t end = first.to;
    for (auto at = start; at != begins.end(); at = begins.find({end, first.cell})) {
      area += pieces_[at->second].twice_area;
      end = pieces_[at->second].to;
      begins.erase(at);
      if (end == first.from) break;
    }
    if (end == first.from && area > least_area_) ++pieces_of_[first.cell];
  }
}

/// By the walls that a ray to the right passes.
bool SectionOverlay::in_section(Vec2 p) const {
  bool inside = false;
  for (const DirectedWall& w : walls_) {
    if ((w.from.y > p.y) == (w.to.y > p.y)) continue;
    const double turn = cross(w.to - w.from, p - w.from);
    inside ^= (turn > 0) == (w.to.y > w.from.y);
  }
  return inside;
}

std::uint32_t SectionOverlay::nearest(Vec2 p) const {
  return std::min_element(sites_.begin(), sites_.end(),
                          [&](const NumberedSite& a, const NumberedSite& b) {
                            return tangent_radius(a.site, p) < tangent_radius(b.site, p);
                          })
      ->vertex;
}

}  // namespace

std::vector<std::uint32_t> pieces_in_section(std::span<const NumberedSite> sites,
                                             std::span<const FaceArc> arcs,
                                             std::span<const DirectedWall> walls) {
  std::vector<std::uint32_t> pieces(sites.size());
  if (walls.empty() || sites.empty()) return pieces;
  SectionOverlay overlay(sites, arcs, walls);
  overlay.build();
  for (std::size_t k = 0; k < sites.size(); ++k) pieces[k] = overlay.pieces_of(sites[k].vertex);
  return pieces;
}

std::vector<std::uint32_t> cutting_arcs(std::span<const NumberedSite> sites, std::span<const FaceArc> arcs,
                                        std::span<const DirectedWall> walls,
                                        std::span<const std::array<std::uint32_t, 2>> neighbours) {
  std::vector<std::uint32_t> cutting;
  if (walls.empty() || arcs.empty() || sites.empty()) return cutting;
  SectionOverlay overlay(sites, arcs, walls);
  overlay.build();
  for (std::uint32_t a = 0; a < arcs.size(); ++a) {
    const auto [i, j] = arcs[a].sites;
    if (!overlay.is_inside(a) || (overlay.pieces_of(i) == 1) == (overlay.pieces_of(j) == 1)) continue;
    if (std::binary_search(neighbours.begin(), neighbours.end(), arcs[a].sites)) cutting.push_back(a);
  }
  return cutting;
}

}  // namespace crossloft
