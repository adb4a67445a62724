#pragma once
/// Tips that lead far away from where a body ends.
///
/// What stands on a section is kept, as no cell knows what is on the section's other side. Where a body ends
/// at its last section this leaves it a tip, to vertices of other sections. It is as good as any if these are
/// near. If they are not, it is a spike along the plane.

#include <cstdint>
#include <functional>
#include <vector>

#include "cell_complex.h"
#include "ground.h"

namespace crossloft {

/// Nothing of a spike is as sure: all of it is rather outside (docs/natural.md).
inline constexpr double kSpikeConfidence = 0;

/// A body of the cell that stands on one part of the sections, within one face, and is nowhere sure.
struct Spike {
  std::int32_t confidence = 0;      ///< of its surest tetrahedron
  std::vector<std::uint32_t> tets;  ///< ascending
};

/// Those whose tetrahedra are all less sure than `limit`, by their smallest ground triangles. `confidence`:
/// of a tetrahedron. O(n log n), and a confidence for each tetrahedron of a body on one face until one is
/// sure.
std::vector<Spike> find_spikes(const CellComplex& complex, const Ground& ground,
                               const std::vector<std::uint8_t>& kept, std::int32_t limit,
                               const std::function<std::int32_t(std::uint32_t)>& confidence);

/// Takes away the bodies that these tetrahedra are part of, as far as they are kept; their sections are bare
/// then. Returns how many there were. O(n + n log k) for k tetrahedra.
std::uint32_t drop_bodies(const CellComplex& complex, const Ground& ground, std::vector<TetName> tets,
                          std::vector<std::uint8_t>& kept);

}  // namespace crossloft
