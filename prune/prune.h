#pragma once
/// Pruning of one cell: which tetrahedra of R0 are the solid (Boissonnat & Memari 2007, section 4).
///
/// A set of tetrahedra is *solid* at a section vertex or grounded edge s if each of its tetrahedra at s is
/// connected, through facets that contain s and within the set, to one that has an internal grounded triangle
/// at s (Definition 9). Unions of solid sets are solid, so every set has one largest solid subset, whatever
/// the order in which it is found (Lemma 1).

#include <cstdint>
#include <vector>

#include "cell_complex.h"
#include "cell_shape.h"
#include "ground.h"
#include "natural.h"

namespace crossloft {

enum class PruneMode : std::uint8_t {
  natural,        ///< the likely solid without needless handles (natural.h)
  joint,          ///< the largest solid subset of R1
  paper,          ///< the largest solid set of two-plane tetrahedra, then Step 3 with the corrected condition
  paper_literal,  ///< Step 3 as printed, which may close on itself along an edge; for study
};

/// As the user writes it: natural, joint, paper, paper-literal.
const char* name_of(PruneMode mode);

struct PruneResult {
  std::vector<std::uint8_t> kept;  ///< per tetrahedron of R0: 1 in the solid, 0 not
  std::uint32_t r0 = 0;            ///< tetrahedra of R0
  std::uint32_t r1 = 0;   ///< after Step 1: neither an external grounded edge nor an external triangle
  std::uint32_t r2 = 0;   ///< after Step 2: the largest solid subset (of the two-plane ones in `paper`);
                          ///< the cheapest solid in `natural`
  std::uint32_t r3 = 0;   ///< after Step 3: the solid; r2 in `joint`
  NaturalReport natural;  ///< but for the topology, filled in `natural` only
};

struct PruneOptions {
  PruneMode mode = PruneMode::natural;
  NaturalOptions natural;
};

/// Prunes. The solid depends on the tetrahedra alone: not on their numbers nor on the order of their
/// vertices, provided vertex numbers are canonical (Step 3 takes candidates in the order of their sorted
/// vertices). REQUIRES: verify(complex) (verify.h); in `natural` the shape has a point for each vertex and a
/// plane for each face. Time and memory: README.md.
PruneResult prune(const CellComplex& complex, const CellShape& shape, const PruneOptions& options,
                  const CellRequests& requests = {});
/// The same for who has the ground already. REQUIRES: it is that of the complex.
PruneResult prune(const CellComplex& complex, const Ground& ground, const CellShape& shape,
                  const PruneOptions& options, const CellRequests& requests);
/// Step 1: by tetrahedron, 1 in R1, which have neither an external grounded edge nor an external triangle.
std::vector<std::uint8_t> without_external(const CellComplex& complex);
/// The modes that measure nothing. REQUIRES: mode is not `natural`.
PruneResult prune(const CellComplex& complex, PruneMode mode);

}  // namespace crossloft
