#include "plane_records.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "../geom/disjoint_sets.h"
#include "section_edit.h"
#include "snap_rounding.h"

namespace crossloft {
namespace {

/// Of a wall. Two pieces have all points, ends or nothing in common.
struct Piece {
  PlanarPoint a, b;  ///< a < b
  std::uint32_t section = 0, contour = 0;
};

using Pieces = std::vector<std::vector<Piece>>;  // by section, ordered by their ends

Pieces pieces_of(std::span<const PlaneSection* const> sections, const PlaneChart& chart,
                 const Context& context) {
  std::vector<PlanarSegment> segments;
  std::vector<Piece> origins;
  for (std::uint32_t s = 0; s < sections.size(); ++s)
    for (const ContourEdge& e : sections[s]->edges) {
      if (!is_wall(e)) continue;
      segments.push_back(
          {chart.to_grid(sections[s]->vertices[e.a]), chart.to_grid(sections[s]->vertices[e.b])});
      origins.push_back({{}, {}, s, e.contour});
    }
  Pieces pieces(sections.size());
  for (const SegmentPiece& p : snap_round(segments, context)) {
    Piece piece = origins[p.segment];
    std::tie(piece.a, piece.b) = std::minmax(p.a, p.b);
    pieces[piece.section].push_back(piece);
  }
  for (auto& list : pieces)
    std::sort(list.begin(), list.end(),
              [](const Piece& p, const Piece& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
  return pieces;
}

bool is_among(const std::vector<Piece>& pieces, const Piece& piece) {
  return std::binary_search(pieces.begin(), pieces.end(), piece, [](const Piece& p, const Piece& q) {
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  });
}

/// True iff the section of the pieces holds the middle of a piece that is none of them.
bool is_inside(const std::vector<Piece>& pieces, const Piece& piece) {
  const PlanarPoint middle{piece.a.x + piece.b.x, piece.a.y + piece.b.y};
  bool odd = false;
  for (const Piece& p : pieces) odd ^= is_above(p.a, p.b, middle);
  return odd;
}

/// How a contour lies to another section.
struct Place {
  bool inside = false, outside = false, along = false;  ///< some of its pieces are

  bool meets() const { return along || (inside && outside); }
  bool is_covered() const { return inside && !outside; }
};

/// By contour. A section is along itself.
std::map<std::uint32_t, Place> places_of(const std::vector<Piece>& contours,
                                         const std::vector<Piece>& section) {
  std::map<std::uint32_t, Place> places;
  for (const Piece& piece : contours) {
    Place& place = places[piece.contour];
    if (is_among(section, piece))
      place.along = true;
    else
      (is_inside(section, piece) ? place.inside : place.outside) = true;
  }
  return places;
}

CoveredContour covered_contour(const PlaneSection& section, std::uint32_t s, std::uint32_t contour,
                               std::uint32_t by) {
  CoveredContour covered{s, contour, by};
  for (const ContourEdge& e : section.edges)
    if (is_wall(e) && e.contour == contour) {
      covered.vertex = std::min({covered.vertex, e.a, e.b});
      ++covered.edges;
    }
  return covered;
}

}  // namespace

PlaneRecords compare_records(std::span<const PlaneSection* const> sections, const PlaneChart& chart,
                             const Context& context) {
  const Pieces pieces = pieces_of(sections, chart, context);
  const auto count = static_cast<std::uint32_t>(sections.size());
  DisjointSets groups(count);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>
      covers;  // by section, contour
  for (std::uint32_t s = 0; s < count; ++s)
    for (std::uint32_t by = 0; by < count && !context.cancelled(); ++by)
      for (const auto& [contour, place] : places_of(pieces[s], pieces[by])) {
        if (place.meets()) groups.join(s, by);
        if (place.is_covered()) covers[{s, contour}].push_back(by);
      }
  PlaneRecords records;
  for (std::uint32_t s = 0; s < count; ++s) records.group.push_back(groups.find(s));
  for (const auto& [at, by] : covers) {
    const auto cover = std::find_if(by.begin(), by.end(), [&, s = at.first](std::uint32_t c) {
      return records.group[c] == records.group[s];
    });
    if (cover != by.end())
      records.covered.push_back(covered_contour(*sections[at.first], at.first, at.second, *cover));
  }
  return records;
}

}  // namespace crossloft
