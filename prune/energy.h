#pragma once
/// What a solid costs: a small surface, and volume where the sections make it likely.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "cell_complex.h"
#include "cell_shape.h"
#include "confidence.h"

namespace crossloft {

/// Finite; smooth and volume not negative.
struct EnergyWeights {
  double smooth = 1;    ///< of the surface's area
  double volume = 8;    ///< of the volume times its confidence, over the cell's size
  double offset = 0.6;  ///< added to every confidence: in doubt there is solid
};

/// Tetrahedra that stand on the sections, and those around the edges within them: without these a section
/// falls apart where the solid is on one side of it here and on the other side there.
bool is_tied_to_sections(const CellComplex& complex, std::uint32_t t);

/// The confidences of tetrahedra, asked for where they are needed.
struct ConfidenceSource {
  std::function<ConfidenceBounds(std::uint32_t)> bounds;  ///< for less work
  std::function<std::int32_t(std::uint32_t)> measure;
};

/// The subset of R1 that has the least
///     smooth area(surface within the cell) - volume sum over tetrahedra of (confidence + offset) volume /
///     size,
/// size = the cube root of the volume of the cell's vertices' hull, among those that contain all tied ones of
/// R1; the smallest if there are several, so it is unique. A minimum cut between neighbours (min_cut.h) that
/// are not tied, with capacities rounded to integers. Tied tetrahedra are not measured, nor those that bounds
/// or their neighbours decide. Once `cancel` is raised the result comes soon, and means nothing. REQUIRES:
/// r1[t] = 0 for tetrahedra that can't be kept.
std::vector<std::uint8_t> cheapest_solid(const CellComplex& complex, const CellShape& shape,
                                         const std::vector<std::uint8_t>& r1,
                                         const ConfidenceSource& confidence, const EnergyWeights& weights,
                                         CancelFlag cancel = nullptr);
/// The same with confidences that are known but for tied tetrahedra.
std::vector<std::uint8_t> cheapest_solid(const CellComplex& complex, const CellShape& shape,
                                         const std::vector<std::uint8_t>& r1,
                                         std::span<const std::int32_t> confidence,
                                         const EnergyWeights& weights);

}  // namespace crossloft
