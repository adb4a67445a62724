/// Small bodies and cavities of the whole solid: the cells around them are asked, and the right one is
/// changed.

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "../geom/disjoint_sets.h"
#include "../prune/confidence.h"
#include "pipeline.h"

namespace crossloft {
namespace {

/// A bump or a dent is met by one plane, by two at their line or by three at their point: so many cells.
constexpr std::size_t kMostCellsOfBody = 8;

/// A triangle of the surface and the component that it is in.
struct PieceTriangle {
  Triangle vertices{};
  std::uint32_t piece = 0;
  friend auto operator<=>(const PieceTriangle&, const PieceTriangle&) = default;
};

/// The components of a glued surface but the largest one.
class SurfacePieces {
 public:
  SurfacePieces(const GluedSurface& surface, const std::vector<LatticePoint>& points)
      : surface_(surface), points_(points), sets_(surface.vertices.size()) {
    for (const auto& t : surface.triangles) {
      sets_.join(t[0], t[1]);
      sets_.join(t[0], t[2]);
    }
    measure();
  }

  std::vector<Piece> take() { return std::move(pieces_); }

  /// Ascending; those with midpoints are left out.
  std::vector<PieceTriangle> triangles() {
    std::vector<PieceTriangle> list;
    for (const auto& t : surface_.triangles) {
      const std::uint32_t piece = number_[sets_.find(t[0])];
      PieceTriangle triangle{{}, piece};
      bool whole = piece != kNone;
      for (std::size_t i = 0; i < 3; ++i) {
        triangle.vertices[i] = surface_.vertices[t[i]].a;
        whole = whole && !surface_.vertices[t[i]].is_midpoint();
      }
      std::sort(triangle.vertices.begin(), triangle.vertices.end());
      if (whole) list.push_back(triangle);
    }
    std::sort(list.begin(), list.end());
    return list;
  }

 private:
  Vec3 place(std::uint32_t v) const {
    const SurfaceVertex& vertex = surface_.vertices[v];
    const LatticePoint& p = points_[vertex.a];
    const LatticePoint& q = points_[vertex.is_midpoint() ? vertex.b : vertex.a];
    return 0.5 * Vec3{p.x + q.x, p.y + q.y, p.z + q.z};
  }

  /// Volumes from a point of each component: nothing small is lost against a distance from afar.
  void measure() {
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
      if (!sets_.is_root(v) || v == largest) continue;
      number_[v] = static_cast<std::uint32_t>(pieces_.size());
      pieces_.push_back({volume[v] < 0, {}, {}});
    }
  }

  const GluedSurface& surface_;
  const std::vector<LatticePoint>& points_;
  DisjointSets sets_;
  std::vector<std::uint32_t> number_;  ///< by vertex that is its component's smallest
  std::vector<Piece> pieces_;
};

/// The piece that a facet is part of, kNone if it is of none.
std::uint32_t piece_of(const std::vector<PieceTriangle>& triangles, const Triangle& facet) {
  const auto place = std::lower_bound(triangles.begin(), triangles.end(), PieceTriangle{facet, 0});
  return place != triangles.end() && place->vertices == facet ? place->piece : kNone;
}

/// Through the facets of their tetrahedra; few tetrahedra have more than two vertices at a piece.
void find_cells(std::span<const CellState> cells, const std::vector<PieceTriangle>& triangles,
                std::size_t vertices, std::vector<Piece>& pieces) {
  std::vector<std::uint8_t> at_piece(vertices, 0);
  for (const PieceTriangle& triangle : triangles)
    for (const std::uint32_t v : triangle.vertices) at_piece[v] = 1;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (TetName name : cells[c].tets) {
      if (at_piece[name[0]] + at_piece[name[1]] + at_piece[name[2]] + at_piece[name[3]] < 3) continue;
      std::sort(name.begin(), name.end());
      for (std::size_t i = 0; i < 4; ++i) {
        Triangle facet{};
        std::copy_if(name.begin(), name.end(), facet.begin(), [&](std::uint32_t v) { return v != name[i]; });
        const std::uint32_t piece = piece_of(triangles, facet);
        if (piece == kNone) continue;
        if (pieces[piece].is_cavity) pieces[piece].cavities[c].push_back(facet);
        if (!pieces[piece].is_cavity) pieces[piece].bodies[c].push_back(name);
      }
    }
}

/// A section triangle that is bare on one side: the cavity is in the cell there.
void find_bare_cells(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                     const Arrangement& arrangement, const std::vector<PieceTriangle>& triangles,
                     std::vector<Piece>& pieces) {
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (std::size_t t = 0; t < faces[f].triangles.size(); ++t) {
      if (faces[f].internal[t] == 0) continue;
      Triangle facet{};
      for (std::size_t i = 0; i < 3; ++i) facet[i] = numbering.of_face[f][faces[f].triangles[t][i]];
      std::sort(facet.begin(), facet.end());
      const std::uint32_t piece = piece_of(triangles, facet);
      if (piece == kNone || !pieces[piece].is_cavity) continue;
      for (const CellId c : arrangement.cells_of(FaceId{f})) pieces[piece].cavities[c.value].push_back(facet);
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
    for (const auto& [cell, names] : piece.bodies) cells[cell].asked.questions.bodies.push_back(names);
    for (const auto& [cell, facets] : piece.cavities) cells[cell].asked.questions.cavities.push_back(facets);
  }
  for (CellState& cell : cells) cell.due = !cell.asked.questions.empty();
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

}  // namespace

/// What of the solid so far the cells are to be asked about.
Result<std::vector<Piece>> Pipeline::find_pieces() {
  SolidInCells solid = solid_in_cells();
  if (solid.tets.empty()) return std::vector<Piece>{};
  const auto boundary = pair_boundary(solid.tets, std::move(solid.known), context_);
  if (!boundary) return boundary.error();
  solid.tets = {};
  glued_ = std::make_unique<GluedSurface>(cut_apart(*boundary));
  SurfacePieces found(*glued_, numbering_.points);
  std::vector<Piece> pieces = found.take();
  if (pieces.empty()) return pieces;
  const std::vector<PieceTriangle> triangles = found.triangles();
  find_cells(cells_, triangles, numbering_.points.size(), pieces);
  find_bare_cells(faces_, numbering_, *arrangement_, triangles, pieces);
  const bool forbids =
      std::any_of(options_.joins.begin(), options_.joins.end(), [](const auto& j) { return !j.join; });
  const bool keeps = options_.natural.cavity_confidence <= -1;
  for (Piece& piece : pieces) {
    if (piece.bodies.size() > kMostCellsOfBody || forbids) piece.bodies.clear();
    if (keeps) piece.cavities.clear();
  }
  return pieces;
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
    cell.asked.questions = {};
    cell.due = !cell.asked.joined.empty() || !cell.asked.opened.empty();
    changes |= cell.due;
  }
  if (!changes) return Done{};
  glued_.reset();
  remove_bridges();
  if (auto done = prune_due_cells(); !done) return done;
  build_bridges();
  return Done{};
}

}  // namespace crossloft
