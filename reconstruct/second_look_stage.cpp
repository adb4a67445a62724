/// Small bodies and cavities of the whole solid: the cells around them are asked, and the right one is
/// changed.

#include <algorithm>
#include <cmath>
#include <map>

#include "../prune/confidence.h"
#include "../prune/disjoint_sets.h"
#include "../prune/star.h"
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
    const LatticePoint& p = points_[surface_.vertices[v].a];
    return {p.x, p.y, p.z};
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

template <class Name>
void keep_smallest(std::map<std::uint32_t, Name>& names, std::uint32_t cell, const Name& name) {
  const auto [place, is_new] = names.try_emplace(cell, name);
  if (!is_new) place->second = std::min(place->second, name);
}

/// Through the facets of their tetrahedra.
void find_cells(std::span<const CellState> cells, const std::vector<PieceTriangle>& triangles,
                std::vector<Piece>& pieces) {
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (TetName name : cells[c].tets) {
      std::sort(name.begin(), name.end());
      for (std::size_t i = 0; i < 4; ++i) {
        Triangle facet{};
        std::copy_if(name.begin(), name.end(), facet.begin(), [&](std::uint32_t v) { return v != name[i]; });
        const std::uint32_t piece = piece_of(triangles, facet);
        if (piece == kNone) continue;
        if (pieces[piece].is_cavity) keep_smallest(pieces[piece].cavities, c, facet);
        if (!pieces[piece].is_cavity) keep_smallest(pieces[piece].bodies, c, name);
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
      for (const CellId c : arrangement.cells_of(FaceId{f}))
        keep_smallest(pieces[piece].cavities, c.value, facet);
    }
}

/// The answers of all cells about one piece.
template <class Answer>
struct Told {
  std::uint32_t cell;
  Answer answer;
};

/// By the name under which each cell was asked.
template <class Answer, class Name>
std::vector<Told<Answer>> told_of(const std::map<std::uint32_t, Name>& names,
                                  std::span<const CellState> cells,
                                  std::vector<Name> SecondThoughts::*questions,
                                  std::vector<Answer> Answers::*answers) {
  std::vector<Told<Answer>> told;
  for (const auto& [cell, name] : names) {
    const auto& asked = cells[cell].asked.questions.*questions;
    const auto place = static_cast<std::size_t>(std::find(asked.begin(), asked.end(), name) - asked.begin());
    const auto& answered = cells[cell].answers.*answers;
    if (place < answered.size()) told.push_back({cell, answered[place]});
  }
  return told;
}

std::vector<Told<BodyAnswer>> told_of_body(const Piece& piece, std::span<const CellState> cells) {
  return told_of(piece.bodies, cells, &SecondThoughts::bodies, &Answers::bodies);
}

/// Of the cells that a part of the cavity is in.
std::vector<Told<CavityAnswer>> told_of_cavity(const Piece& piece, std::span<const CellState> cells) {
  auto told = told_of(piece.cavities, cells, &SecondThoughts::cavities, &Answers::cavities);
  std::erase_if(told, [](const auto& t) { return t.answer.opening == Opening::none && !t.answer.can_open; });
  return told;
}

/// The cell where a body that is alone in all of them is joined best; kNone if it is not alone or nowhere
/// sure enough.
std::uint32_t cell_to_join_in(const std::vector<Told<BodyAnswer>>& told, std::int32_t least) {
  const Told<BodyAnswer>* best = nullptr;
  for (const auto& t : told) {
    if (!t.answer.is_alone) return kNone;
    const bool able = t.answer.can_join && t.answer.confidence >= least;
    if (able && (best == nullptr || t.answer.confidence > best->answer.confidence)) best = &t;
  }
  return best == nullptr ? kNone : best->cell;
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

std::int32_t as_integer(double confidence) {
  return static_cast<std::int32_t>(std::floor(confidence * kCertain + 0.5));
}

std::vector<std::array<std::uint32_t, 4>> all_tets(std::span<const CellState> cells) {
  std::vector<std::array<std::uint32_t, 4>> tets;
  for (const CellState& cell : cells)
    for (const auto* list : {&cell.tets, &cell.bridge_tets})
      tets.insert(tets.end(), list->begin(), list->end());
  return tets;
}

void put_questions(std::span<const Piece> pieces, std::vector<CellState>& cells) {
  for (const Piece& piece : pieces) {
    for (const auto& [cell, name] : piece.bodies) cells[cell].asked.questions.bodies.push_back(name);
    for (const auto& [cell, facet] : piece.cavities) cells[cell].asked.questions.cavities.push_back(facet);
  }
  for (CellState& cell : cells) cell.due = !cell.asked.questions.empty();
}

/// False if no cell has to change.
bool put_requests(std::span<const Piece> pieces, std::span<const FaceTriangulation> faces,
                  const NaturalOptions& options, std::vector<CellState>& cells, TopologyReport& report) {
  for (const Piece& piece : pieces) {
    if (const std::uint32_t cell =
            cell_to_join_in(told_of_body(piece, cells), as_integer(options.alone_confidence));
        cell != kNone) {
      cells[cell].asked.joined.push_back(piece.bodies.at(cell));
      ++report.bodies_joined;
    }
    const auto walls =
        to_be_opened(told_of_cavity(piece, cells), faces, as_integer(options.cavity_confidence));
    for (const auto& wall : walls)
      cells[wall.cell].asked.opened.push_back({wall.answer.from, wall.answer.to});
    report.cavities_opened += walls.empty() ? 0U : 1U;
  }
  for (CellState& cell : cells) {
    cell.asked.questions = {};
    cell.due = !cell.asked.joined.empty() || !cell.asked.opened.empty();
  }
  return std::any_of(cells.begin(), cells.end(), [](const CellState& c) { return c.due; });
}

}  // namespace

/// What of the solid so far the cells are to be asked about.
Result<std::vector<Piece>> Pipeline::find_pieces() const {
  const std::vector<std::array<std::uint32_t, 4>> tets = all_tets(cells_);
  if (tets.empty()) return std::vector<Piece>{};
  const auto glued = glue(tets);
  if (!glued) return glued.error();
  SurfacePieces found(*glued, numbering_.points);
  const std::vector<PieceTriangle> triangles = found.triangles();
  std::vector<Piece> pieces = found.take();
  if (pieces.empty()) return pieces;
  find_cells(cells_, triangles, pieces);
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
  if (!put_requests(*pieces, faces_, options_.natural, cells_, result_.report.topology)) return Done{};
  remove_bridges();
  if (auto done = prune_due_cells(); !done) return done;
  build_bridges();
  return Done{};
}

}  // namespace crossloft
