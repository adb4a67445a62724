#pragma once
/// Whether the solid meets every plane in its section, decided exactly on the lattice from what an observer
/// sees.

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "../../geom/grid.h"
#include "../../reconstruct/observer.h"

namespace crossloft::test {

/// What of the solid lies in a plane must be triangles and edges of the plane's section; section triangles
/// that no tetrahedron stands on are the flat area.
///
/// With plates the solid has all sections, also what one of them has on another plane outside of its section:
/// sections that disagree on a line leave no other way. So a plate may have an edge there: a side of the flat
/// triangle that it stands on, of which the plane's own section has no part.
class SectionJudge : public Observer {
 public:
  SectionJudge() = default;
  /// Of a run with plates; `bare` has judged the same without.
  explicit SectionJudge(const SectionJudge& bare) : bare_(&bare) {}

  void on_sections(const FramedSections& framed, const Arrangement&, const SectionGraph& graph) override;
  void on_face(const FaceTriangulation& face, const Numbering& numbering) override;
  void on_solid(std::span<const std::array<std::uint32_t, 4>> solid, const Numbering& numbering) override;

  const std::string& complaint() const { return complaint_; }
  /// By plane, in input units squared: of all section triangles, and of those that no tetrahedron stands on.
  std::vector<double> section_area, flat_area;
  double widest_flat = 0;  ///< triangle that no tetrahedron stands on: its least height, units of the grid
  /// Edges of plates that are outside of a section, as often as a tetrahedron has one.
  std::size_t plate_edges_outside = 0;

 private:
  using Tet = std::array<std::uint32_t, 4>;
  using Triangle = std::array<std::uint32_t, 3>;
  using Edge = std::array<std::uint32_t, 2>;
  struct Section {
    std::map<Triangle, bool> covered;  ///< by section triangle, its vertices ascending
    std::set<Edge> edges;              ///< of these triangles
  };

  /// The first complaint stays.
  void complain(const std::string& text) {
    if (complaint_.empty()) complaint_ = text;
  }
  void judge_plates();
  void judge(const Tet& tet, std::size_t plane);
  bool is_side_of_plate(const Tet& tet, const Edge& edge, std::size_t plane) const;
  bool has_part_of(const Edge& edge, std::size_t plane, std::size_t other) const;
  double area(const Triangle& t) const;
  double width(const Triangle& t) const;

  WorldGrid grid_;
  std::vector<LatticePlane> planes_;
  std::vector<Section> sections_;         ///< by plane
  std::vector<std::vector<bool>> on_;     ///< [plane][vertex]
  std::span<const LatticePoint> points_;  ///< alive during on_solid
  std::set<Tet> tets_;                    ///< their vertices ascending
  const SectionJudge* bare_ = nullptr;
  std::string complaint_;
};

}  // namespace crossloft::test
