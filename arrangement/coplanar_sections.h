#pragma once
/// Sections that share one plane: are they the same, apart, or do they contradict?

#include <cstdint>
#include <vector>

#include "framed_sections.h"

namespace crossloft {

/// Walls between lattice points of one plane.
struct LatticeSection {
  std::vector<LatticePoint> vertices;  ///< explicit, distinct, in lexicographic order
  std::vector<Vec3> input;             ///< [vertex] in input coordinates
  std::vector<WallEdge> walls;         ///< ordered by (a, b), every vertex of even degree
};

enum class SectionRelation : std::uint8_t { same, apart, overlapping };

/// How two sections of the plane lie to each other. They are the same if their vertices agree within
/// `tolerance` (lattice units) and so do their walls, or if their boundaries are one point set; apart if
/// their interiors have no common point; else they overlap. Exact but for the tolerance. O(n^2) with small
/// constants.
SectionRelation relation(const LatticePlane& plane, const LatticeSection& a, const LatticeSection& b,
                         double tolerance);

/// Sorts and merges vertices with equal coordinates (the smallest input stays), cancels equal walls in pairs,
/// drops vertices without wall.
void tidy(LatticeSection& section);

}  // namespace crossloft
