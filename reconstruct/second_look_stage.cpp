/// Small bodies and cavities of the whole solid: the cells around them are asked, and the right one is
/// changed.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "../geom/disjoint_sets.h"
#include "../prune/confidence.h"
#include "../prune/star.h"
#include "pipeline.h"
#include "pruning_input.h"

namespace crossloft {
namespace {

/// A bump or a dent is met by one plane, by two at their line or by three at their point: so many cells.
constexpr std::size_t kMostCellsOfBody = 8;
/// The largest body is mostly what was cut. If one plane alone has met it, it is as small as others: so a
/// window of a stack need not know which is the largest, where bodies that are alone have one plane each.
constexpr std::size_t kMostCellsOfLargest = 2;

std::size_t most_cells(const Piece& piece) {
  return piece.is_largest ? kMostCellsOfLargest : kMostCellsOfBody;
}

/// A facet of the solid and the component of the surface that it is in.
struct PieceFacet {
  std::uint32_t number = 0;  ///< 4 * tetrahedron of the solid + slot
  std::uint32_t piece = 0;
  Triangle vertices{};
};

/// The same by its vertices, ascending.
struct PieceTriangle {
  Triangle vertices{};
  std::uint32_t piece = 0;
  friend auto operator<=>(const PieceTriangle&, const PieceTriangle&) = default;
};

/// The different cells of a body, as far as there are few.
class FewCells {
 public:
  /// How many there are with this one, up to the most that count and one.
  std::size_t add(std::uint32_t cell) {
    const auto end = cells_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (count_ < cells_.size() && std::find(cells_.begin(), end, cell) == end) cells_[count_++] = cell;
    return count_;
  }

 private:
  std::array<std::uint32_t, kMostCellsOfBody + 1> cells_{};
  std::size_t count_ = 0;
};

/// The cell that each tetrahedron of the solid is of.
class CellOfTet {
 public:
  explicit CellOfTet(std::span<const CellState> cells) : cells_(cells) {}

  /// kNone for those of bridges, which cells don't know of.
  std::uint32_t find(std::uint32_t tet) const {
    const auto after =
        std::upper_bound(cells_.begin(), cells_.end(), tet,
                         [](std::uint32_t t, const CellState& cell) { return t < cell.first_tet; });
    const auto c = static_cast<std::uint32_t>(after - cells_.begin() - 1);
    return tet < cells_[c].first_tet + cells_[c].tet_count ? c : kNone;
  }

 private:
  std::span<const CellState> cells_;  ///< `first_tet` ascending from 0 on
};

/// The components of a glued surface.
class SurfacePieces {
 public:
  SurfacePieces(const GluedSurface& surface, const std::vector<LatticePoint>& points)
      : surface_(surface), points_(points), sets_(surface.vertices.size()) {
    for (const auto& t : surface.triangles) {
      sets_.join(t[0], t[1]);
      sets_.join(t[0], t[2]);
    }
  }

  std::uint32_t count() const { return sets_.count(); }
  /// What follows takes that.
  void measure();
  std::vector<Piece> take() { return std::move(pieces_); }

  /// The facets of a boundary that has been cut apart to this surface, by number; those with midpoints are
  /// left out, and more of bodies that are in too many cells than tells so.
  std::vector<PieceFacet> facets(const PairedBoundary& boundary, const CellOfTet& cell_of) {
    std::vector<PieceFacet> list;
    std::vector<FewCells> cells(pieces_.size());
    std::vector<std::uint8_t> is_large(pieces_.size(), 0);
    std::size_t next = 0, left = pieces_.size();
    for (std::size_t t = 0; t < surface_.triangles.size() && left != 0; ++t) {
      const std::uint32_t piece = number_[sets_.find(surface_.triangles[t][0])];
      Triangle vertices{};
      if (is_large[piece] != 0 || !is_whole(surface_.triangles[t], vertices)) continue;
      // What is whole comes in the order of the boundary, from the same vertex on.
      while (next < boundary.triangles.size() && boundary.triangles[next] != vertices) ++next;
      assert(next < boundary.triangles.size());
      if (next == boundary.triangles.size()) break;
      list.push_back({boundary.facets[next], piece, vertices});
      const std::uint32_t cell = pieces_[piece].is_cavity ? kNone : cell_of.find(boundary.facets[next] / 4);
      if (cell == kNone || cells[piece].add(cell) <= most_cells(pieces_[piece])) continue;
      is_large[piece] = 1;
      --left;
    }
    std::sort(list.begin(), list.end(), [](const auto& x, const auto& y) { return x.number < y.number; });
    return list;
  }

 private:
  /// With its vertices, unless one is a midpoint.
  bool is_whole(const Triangle& triangle, Triangle& vertices) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const SurfaceVertex& v = surface_.vertices[triangle[i]];
      if (v.is_midpoint()) return false;
      vertices[i] = v.a;
    }
    return true;
  }
  Vec3 place(std::uint32_t v) const {
    const SurfaceVertex& vertex = surface_.vertices[v];
    const LatticePoint& p = points_[vertex.a];
    const LatticePoint& q = points_[vertex.is_midpoint() ? vertex.b : vertex.a];
    return 0.5 * Vec3{p.x + q.x, p.y + q.y, p.z + q.z};
  }

  const GluedSurface& surface_;
  const std::vector<LatticePoint>& points_;
  DisjointSets sets_;
  std::vector<std::uint32_t> number_;  ///< by vertex that is its component's smallest
  std::vector<Piece> pieces_;
};

/// Volumes from a point of each component: nothing small is lost against a distance from afar.
void SurfacePieces::measure() {
  std::vector<double> volume(surface_.vertices.size(), 0);
  for (const auto& t : surface_.triangles) {
    const std::uint32_t root = sets_.find(t[0]);
    const Vec3 o = place(root);
    volume[root] += dot(place(t[0]) - o, cross(place(t[1]) - o, place(t[2]) - o));
  }
  std::uint32_t largest = 0;
  for (std::uint32_t v = 0; v < volume.size(); ++v)
    if (std::fabs(volume[v]) > std::fabs(volume[largest])) largest = v;
  number_.assign(volume.size(), kNone);
  for (std::uint32_t v = 0; v < volume.size(); ++v) {
    if (!sets_.is_root(v)) continue;
    number_[v] = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back({volume[v] < 0 && v != largest, v == largest, {}, {}});
  }
}

/// False if the only body of the solid is surely not, as mostly: a few cells, on one face in each.
bool may_be_alone(std::span<const CellState> cells) {
  std::size_t count = 0;
  for (const CellState& cell : cells) {
    const auto elsewhere = [&](const GroundTriangle& g) { return g.face != cell.ground.front().face; };
    if (std::any_of(cell.ground.begin(), cell.ground.end(), elsewhere)) return false;
    count += cell.tet_count != 0 ? 1 : 0;
  }
  return count <= kMostCellsOfLargest;
}

void sort_vertices(Triangle& facet) { std::sort(facet.begin(), facet.end()); }

/// The facets of one tetrahedron of a cell, as its pieces see them: in the order of the vertices opposite to
/// them.
void tell_pieces(std::uint32_t cell, const TetName& tet, std::span<PieceFacet> facets,
                 std::vector<Piece>& pieces) {
  std::sort(facets.begin(), facets.end(),
            [&](const PieceFacet& x, const PieceFacet& y) { return tet[x.number % 4] < tet[y.number % 4]; });
  TetName name = tet;
  std::sort(name.begin(), name.end());
  for (PieceFacet& facet : facets) {
    sort_vertices(facet.vertices);
    Piece& piece = pieces[facet.piece];
    if (piece.is_cavity) piece.cavities[cell].push_back(facet.vertices);
    if (!piece.is_cavity) piece.bodies[cell].push_back(name);
  }
}

/// `solid` has the tetrahedra of the cells, each time followed by bridges, which cells don't know of.
void find_cells(std::span<const CellState> cells, std::span<const TetName> solid,
                std::vector<PieceFacet>& facets, std::vector<Piece>& pieces) {
  std::size_t next = 0;  // facet
  const auto tet_of = [&](std::size_t facet) { return facets[facet].number / 4; };
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    while (next < facets.size() && tet_of(next) < cells[c].first_tet) ++next;  // of bridges
    const std::uint32_t end = cells[c].first_tet + cells[c].tet_count;
    while (next < facets.size() && tet_of(next) < end) {
      const std::size_t first = next;
      const std::uint32_t tet = tet_of(first);
      while (next < facets.size() && tet_of(next) == tet) ++next;
      tell_pieces(c, solid[tet], {facets.data() + first, next - first}, pieces);
    }
  }
}

/// The triangles of cavities, ascending.
std::vector<PieceTriangle> cavity_triangles(std::span<const PieceFacet> facets,
                                            std::span<const Piece> pieces) {
  std::vector<PieceTriangle> list;
  for (const PieceFacet& facet : facets) {
    if (!pieces[facet.piece].is_cavity) continue;
    list.push_back({facet.vertices, facet.piece});
    sort_vertices(list.back().vertices);
  }
  std::sort(list.begin(), list.end());
  return list;
}

/// A section triangle that is bare on one side: the cavity is in the cell there.
void find_bare_cells(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                     const Arrangement& arrangement, const std::vector<PieceTriangle>& cavities,
                     std::vector<Piece>& pieces) {
  for (std::uint32_t f = 0; f < faces.size() && !cavities.empty(); ++f)
    for (std::size_t t = 0; t < faces[f].triangles.size(); ++t) {
      if (faces[f].internal[t] == 0) continue;
      Triangle facet{};
      for (std::size_t i = 0; i < 3; ++i) facet[i] = numbering.of_face[f][faces[f].triangles[t][i]];
      sort_vertices(facet);
      const auto place = std::lower_bound(cavities.begin(), cavities.end(), PieceTriangle{facet, 0});
      if (place == cavities.end() || place->vertices != facet) continue;
      for (const CellId c : arrangement.cells_of(FaceId{f}))
        pieces[place->piece].cavities[c.value].push_back(facet);
    }
}

/// What a cell tells about one piece.
template <class Answer>
struct Told {
  std::uint32_t cell;
  Answer answer;
};

/// Whether nothing is joined with a body in any cell.
bool is_alone(const std::vector<Told<BodyAnswer>>& told) {
  return !told.empty() &&
         std::all_of(told.begin(), told.end(), [](const auto& t) { return t.answer.is_alone; });
}

bool is_seen_by_one_plane(const std::vector<Told<CavityAnswer>>& told,
                          std::span<const FaceTriangulation> faces) {
  return std::all_of(told.begin(), told.end(), [&](const auto& t) {
    return t.answer.opening == Opening::hole && told[0].answer.opening == Opening::hole &&
           faces[t.answer.face].plane == faces[told[0].answer.face].plane;
  });
}

/// Where a cavity is opened: at its least sure wall if one plane alone has seen it, else at all walls that
/// are less sure than `closed`.
std::vector<Told<CavityAnswer>> to_be_opened(std::vector<Told<CavityAnswer>> told,
                                             std::span<const FaceTriangulation> faces, std::int32_t closed) {
  const bool one_plane = is_seen_by_one_plane(told, faces);
  std::erase_if(told, [&](const auto& t) {
    return !t.answer.can_open || (!one_plane && t.answer.confidence >= closed);
  });
  std::stable_sort(told.begin(), told.end(),
                   [](const auto& x, const auto& y) { return x.answer.confidence < y.answer.confidence; });
  if (one_plane && told.size() > 1) told.resize(1);
  return told;
}

/// Answers of the cells by piece.
struct ToldOfAll {
  std::vector<std::vector<Told<BodyAnswer>>> bodies;
  std::vector<std::vector<Told<CavityAnswer>>> cavities;
};

void put_questions(std::span<const Piece> pieces, std::vector<CellState>& cells) {
  for (const Piece& piece : pieces) {
    for (const auto& [cell, names] : piece.bodies) cells[cell].questions.bodies.push_back(names);
    for (const auto& [cell, facets] : piece.cavities) cells[cell].questions.cavities.push_back(facets);
  }
  for (CellState& cell : cells) cell.due = !cell.questions.empty();
}

/// The answers come in the order of the questions, those in the order of the pieces.
ToldOfAll take_answers(std::span<const Piece> pieces, std::span<const CellState> cells) {
  ToldOfAll told{std::vector<std::vector<Told<BodyAnswer>>>(pieces.size()),
                 std::vector<std::vector<Told<CavityAnswer>>>(pieces.size())};
  std::vector<std::array<std::size_t, 2>> next(cells.size(), {0, 0});
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (const auto& [cell, names] : pieces[p].bodies) {
      const std::size_t i = next[cell][0]++;
      const auto& answers = cells[cell].answers.bodies;
      told.bodies[p].push_back({cell, i < answers.size() ? answers[i] : BodyAnswer{}});
    }
    for (const auto& [cell, facets] : pieces[p].cavities) {
      const std::size_t i = next[cell][1]++;
      if (i >= cells[cell].answers.cavities.size()) continue;
      for (const CavityAnswer& part : cells[cell].answers.cavities[i])
        told.cavities[p].push_back({cell, part});
    }
  }
  return told;
}

/// A body that may be joined in a cell.
struct Candidate {
  std::int32_t confidence = 0;
  std::uint32_t cell = 0, piece = 0;
  TetName target{};

  friend bool operator<(const Candidate& x, const Candidate& y) {
    return x.confidence != y.confidence ? x.confidence > y.confidence
                                        : std::tie(x.cell, x.piece) < std::tie(y.cell, y.piece);
  }
};

/// Bodies as sets: two requests must not close a loop through several cells.
class JoinedPieces {
 public:
  explicit JoinedPieces(std::span<const Piece> pieces)
      : main_(static_cast<std::uint32_t>(pieces.size())), sets_(pieces.size() + 1) {
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
      for (const auto& [cell, names] : pieces[p].bodies)
        for (const TetName& name : names) piece_of_[{cell, name}] = p;
  }

  /// False if the two are one already. What is not known to be a small piece counts as the main body.
  bool join(const Candidate& c) {
    const auto target = piece_of_.find({c.cell, c.target});
    const std::uint32_t a = sets_.find(c.piece),
                        b = sets_.find(target == piece_of_.end() ? main_ : target->second);
    sets_.join(a, b);
    return a != b;
  }

 private:
  std::uint32_t main_;
  DisjointSets sets_;
  std::map<std::pair<std::uint32_t, TetName>, std::uint32_t> piece_of_;
};

/// The most confident first; each body once.
void request_joins(std::span<const Piece> pieces, const ToldOfAll& told, std::int32_t least,
                   std::vector<CellState>& cells) {
  std::vector<Candidate> candidates;
  for (std::uint32_t p = 0; p < pieces.size(); ++p)
    for (const auto& [cell, answer] : told.bodies[p])
      if (is_alone(told.bodies[p]) && answer.can_join && answer.confidence >= least)
        candidates.push_back({answer.confidence, cell, p, answer.target});
  std::sort(candidates.begin(), candidates.end());
  JoinedPieces joined(pieces);
  std::vector<std::uint8_t> has_request(pieces.size(), 0);
  for (const Candidate& c : candidates) {
    if (has_request[c.piece] != 0 || !joined.join(c)) continue;
    has_request[c.piece] = 1;
    const auto& names = pieces[c.piece].bodies.find(c.cell)->second;
    cells[c.cell].asked.joined.push_back(names.front());
  }
}

void request_openings(const ToldOfAll& told, std::span<const FaceTriangulation> faces, std::int32_t closed,
                      std::vector<CellState>& cells) {
  for (const auto& parts : told.cavities)
    for (const auto& wall : to_be_opened(parts, faces, closed))
      cells[wall.cell].asked.opened.push_back({wall.answer.from, wall.answer.to});
}

/// A cell's part of the solid in its triangulation made anew, which may have another order.
std::vector<std::uint8_t> kept_in(const BuiltCell& cell, std::span<const std::array<std::uint32_t, 4>> tets) {
  std::vector<TetName> names(tets.begin(), tets.end());
  for (TetName& name : names) std::sort(name.begin(), name.end());
  std::sort(names.begin(), names.end());
  std::vector<std::uint8_t> kept(cell.complex.mesh.size(), 0);
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    TetName name = sorted_vertices(cell.complex.mesh, t);
    for (std::uint32_t& v : name) v = cell.vertices[v];  // ascending too
    kept[t] = std::binary_search(names.begin(), names.end(), name) ? 1 : 0;
  }
  return kept;
}

}  // namespace

/// What of the solid so far the cells are to be asked about.
Result<std::vector<Piece>> Pipeline::find_pieces() {
  SolidInCells solid = take_solid();
  tets_ = std::move(solid.tets);
  if (tets_.empty()) return std::vector<Piece>{};
  const auto boundary = pair_boundary(tets_, std::move(solid.known), context_);
  if (!boundary) return boundary.error();
  auto surface = cut_apart(*boundary, context_, window_ != nullptr);
  if (!surface) return surface.error();
  glued_ = std::make_unique<GluedSurface>(std::move(surface).value());
  SurfacePieces found(*glued_, numbering_.points);
  if (found.count() == 1 && !may_be_alone(cells_)) return std::vector<Piece>{};
  found.measure();
  std::vector<PieceFacet> facets = found.facets(*boundary, CellOfTet(cells_));
  std::vector<Piece> pieces = found.take();
  find_cells(cells_, tets_, facets, pieces);
  find_bare_cells(faces_, numbering_, *arrangement_, cavity_triangles(facets, pieces), pieces);
  const bool forbids =
      std::any_of(options_.joins.begin(), options_.joins.end(), [](const auto& j) { return !j.join; });
  const bool keeps = options_.natural.cavity_confidence <= -1;
  for (Piece& piece : pieces) {
    if (piece.bodies.size() > most_cells(piece) || forbids) piece.bodies.clear();
    if (keeps) piece.cavities.clear();
  }
  return pieces;
}

/// The cell stays as it is; its triangulation does too, as a request may follow.
Result<Done> Pipeline::answer(CellInHand& hand, CellState& state) const {
  Stopwatch watch;
  const auto tets = std::span(tets_).subspan(state.first_tet, state.tet_count);
  const SecondThoughts questions = by_local_numbers(state.questions, hand.built);
  state.answers = by_final_numbers(answer_questions(hand.built.complex, *hand.ground, hand.shape,
                                                    kept_in(hand.built, tets), questions, context_.cancel),
                                   hand.ids, hand.built);
  state.pruning_seconds += watch.lap();
  return Done{};
}

/// Asks, decides, and lets the cells that have to change be pruned once more.
Result<Done> Pipeline::look_again() {
  const auto pieces = find_pieces();
  if (!pieces) return pieces.error();
  if (pieces->empty()) return Done{};
  put_questions(*pieces, cells_);
  if (auto done = prune_due_cells(); !done) return done;
  const ToldOfAll told = take_answers(*pieces, cells_);
  request_joins(*pieces, told, as_integer(options_.natural.alone_confidence), cells_);
  request_openings(told, faces_, as_integer(options_.natural.cavity_confidence), cells_);
  bool changes = false;
  for (CellState& cell : cells_) {
    cell.questions = {};
    cell.due = !cell.asked.joined.empty() || !cell.asked.opened.empty();
    changes |= cell.due;
    if (!cell.due) cell.triangulation.reset();
  }
  return changes ? prune_again() : Result<Done>(Done{});
}

Result<Done> Pipeline::prune_again() {
  glued_.reset();
  give_tets_back();
  remove_bridges();
  if (auto done = prune_due_cells(); !done) return done;
  build_bridges();
  return Done{};
}

}  // namespace crossloft
