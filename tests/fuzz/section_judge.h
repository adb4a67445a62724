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
class SectionJudge : public Observer {
 public:
  void on_sections(const FramedSections& framed, const Arrangement&, const SectionGraph& graph) override;
  void on_face(const FaceTriangulation& face, const Numbering& numbering) override;
  void on_solid(std::span<const std::array<std::uint32_t, 4>> solid, const Numbering& numbering) override;

  const std::string& complaint() const { return complaint_; }
  /// By plane, in input units squared: of all section triangles, and of those that no tetrahedron stands on.
  std::vector<double> section_area, flat_area;

 private:
  using Triangle = std::array<std::uint32_t, 3>;
  using Edge = std::array<std::uint32_t, 2>;
  struct Section {
    std::map<Triangle, bool> covered;  ///< by section triangle, its vertices ascending
    std::set<Edge> edges;              ///< of these triangles
  };

  void judge(const std::array<std::uint32_t, 4>& tet, std::size_t plane);
  double area(const Triangle& t) const;

  WorldGrid grid_;
  std::vector<LatticePlane> planes_;
  std::vector<Section> sections_;         ///< by plane
  std::vector<std::vector<bool>> on_;     ///< [plane][vertex]
  std::span<const LatticePoint> points_;  ///< alive during on_solid
  std::string complaint_;
};

}  // namespace crossloft::test
