/// Flat section regions get plates of solid.

#include <algorithm>
#include <utility>

#include "flats.h"
#include "pipeline.h"

namespace crossloft {
namespace {

using Tet = std::array<std::uint32_t, 4>;

/// A flat triangle and where it comes from.
struct Found {
  std::uint32_t cell = 0, face = 0, triangle = 0;
  friend auto operator<=>(const Found&, const Found&) = default;
};

/// Flat triangles by the cell on one side of their face, ascending.
std::vector<Found> find_flats(std::span<const FaceTriangulation> faces, const Arrangement& arrangement,
                              std::uint32_t side) {
  std::vector<Found> found;
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    for (std::uint32_t t = 0; t < faces[f].triangles.size(); ++t)
      if (faces[f].is_flat(t)) found.push_back({arrangement.cells_of(FaceId{f})[side].value, f, t});
  std::sort(found.begin(), found.end());
  return found;
}

/// Faces' triangles turn counter-clockwise seen from the positive side.
FlatTriangle flat_triangle(const Found& found, const FaceTriangulation& face, const Numbering& numbering,
                           std::uint32_t side) {
  FlatTriangle flat;
  flat.face = found.face;
  for (std::size_t i = 0; i < 3; ++i)
    flat.v[i] = numbering.of_face[found.face][face.triangles[found.triangle][i]];
  if (side == 0) std::swap(flat.v[1], flat.v[2]);
  return flat;
}

std::vector<CellSide> sides_of(const Arrangement& arrangement, CellId cell) {
  std::vector<CellSide> sides;
  for (const FaceId f : arrangement.faces_of(cell))
    sides.push_back(
        {arrangement.plane(arrangement.plane_of(f)), arrangement.cells_of(f)[0] == cell ? -1 : 1});
  return sides;
}

std::span<const Found> of_cell(const std::vector<Found>& found, std::uint32_t cell) {
  const auto first = std::lower_bound(found.begin(), found.end(), Found{cell, 0, 0});
  const auto last = std::lower_bound(first, found.end(), Found{cell + 1, 0, 0});
  return {first, last};
}

}  // namespace

/// Roofs over what is flat, in the cells on one side of all planes.
Result<std::vector<CellRoofs>> Pipeline::roofs_on(std::uint32_t side) {
  const std::vector<Found> found = find_flats(faces_, *arrangement_, side);
  std::vector<CellRoofs> roofs(cells_.size());
  const auto good = for_all(cells_.size(), "thickening", [&](std::size_t c) -> Result<Done> {
    const auto here = of_cell(found, static_cast<std::uint32_t>(c));
    if (here.empty()) return Done{};
    std::vector<FlatTriangle> triangles;
    for (const Found& f : here) triangles.push_back(flat_triangle(f, faces_[f.face], numbering_, side));
    RoofSite site;
    site.triangles = triangles;
    site.points = numbering_.points;
    site.sides = sides_of(*arrangement_, CellId{static_cast<std::uint32_t>(c)});
    for (const auto* list : {&cells_[c].tets, &cells_[c].bridge_tets, &cells_[c].roof_tets})
      site.obstacles.insert(site.obstacles.end(), list->begin(), list->end());
    site.height = options_.thicken * framed_.diagonal / framed_.grid.unit();
    roofs[c] = build_roofs(site);
    return Done{};
  });
  if (!good) return good.error();
  // Only now: while cells are asked the faces are shared.
  for (std::size_t c = 0; c < roofs.size(); ++c) {
    const auto here = of_cell(found, static_cast<std::uint32_t>(c));
    for (std::size_t i = 0; i < here.size(); ++i)
      faces_[here[i].face].covered[side][here[i].triangle] = roofs[c].built[i];
  }
  return roofs;
}

/// Raised points get numbers after all others, in lexicographic order.
void Pipeline::take_roofs(std::vector<CellRoofs> roofs) {
  struct Name {
    std::uint32_t cell, point;
  };
  std::vector<Name> order;
  std::vector<std::vector<std::uint32_t>> number(roofs.size());
  for (std::uint32_t c = 0; c < roofs.size(); ++c) {
    number[c].assign(roofs[c].points.size(), kNone);
    for (const Tet& tet : roofs[c].tets)
      for (const std::uint32_t v : tet)
        if (v >= kFirstRaisedPoint) number[c][v - kFirstRaisedPoint] = 0;
    for (std::uint32_t p = 0; p < number[c].size(); ++p)
      if (number[c][p] != kNone) order.push_back({c, p});
  }
  std::sort(order.begin(), order.end(), [&](const Name& x, const Name& y) {
    return compare_lex(roofs[x.cell].points[x.point], roofs[y.cell].points[y.point]) < 0;
  });
  for (const Name& n : order) {
    number[n.cell][n.point] = static_cast<std::uint32_t>(numbering_.points.size());
    numbering_.points.push_back(roofs[n.cell].points[n.point]);
    numbering_.graph_vertex.push_back(kNone);
  }
  for (std::size_t c = 0; c < roofs.size(); ++c) {
    for (Tet tet : roofs[c].tets) {
      for (std::uint32_t& v : tet)
        if (v >= kFirstRaisedPoint) v = number[c][v - kFirstRaisedPoint];
      cells_[c].roof_tets.push_back(tet);
    }
    result_.report.thickness = std::max(result_.report.thickness, roofs[c].height * framed_.grid.unit());
  }
}

/// On the positive side of each plane, and what does not fit there on the other.
Result<Done> Pipeline::thicken() {
  give_tets_back();
  std::vector<std::vector<std::uint8_t>> was_flat(faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (std::size_t t = 0; t < faces_[f].triangles.size(); ++t)
      was_flat[f].push_back(faces_[f].is_flat(t) ? 1 : 0);
  for (const std::uint32_t side : {1u, 0u}) {
    auto roofs = roofs_on(side);
    if (!roofs) return roofs.error();
    take_roofs(std::move(roofs).value());
  }
  const auto has_plate = [&](std::size_t f, std::size_t t) {
    return was_flat[f][t] != 0 && !faces_[f].is_flat(t);
  };
  thickened_ = count_regions(faces_, numbering_, graph_.planes.size(), has_plate, context_);
  for (const CellState& cell : cells_)
    roof_tets_.insert(roof_tets_.end(), cell.roof_tets.begin(), cell.roof_tets.end());
  if (!roof_tets_.empty()) glued_.reset();
  return Done{};
}

}  // namespace crossloft
