#pragma once
/// Section graphs with all that they refer to, for the tests.

#include <doctest/doctest.h>

#include <memory>

#include "../../arrangement/data_box.h"
#include "../../arrangement/section_graph.h"

namespace crossloft::test {

struct Built {
  FramedSections framed;
  LatticePointStore store;
  std::unique_ptr<Arrangement> arrangement;
  Result<SectionGraph> graph = make_error(ErrorCode::internal, "not built");
};

/// Builds the graph; tolerances are fractions of the diagonal.
inline Built build(const Sections& sections, double match = 2e-3, double on = 1e-9, double simplify = 0) {
  Built built;
  auto framed = frame_sections(sections, 1e-3);
  REQUIRE(framed.ok());
  built.framed = std::move(framed).value();
  std::vector<LatticePlane> planes;
  for (const FramedPlane& p : built.framed.planes) planes.push_back(p.plane);
  auto arrangement = build_arrangement(planes, data_box(built.framed), built.store);
  REQUIRE(arrangement.ok());
  built.arrangement = std::make_unique<Arrangement>(std::move(arrangement).value());
  const double unit = built.framed.diagonal / built.framed.grid.unit();
  built.graph = build_section_graph(built.framed, *built.arrangement, built.store,
                                    {on * unit, match * unit, simplify * unit}, {});
  if (built.graph) CHECK(verify(*built.graph, *built.arrangement) == "");
  return built;
}

}  // namespace crossloft::test
