#pragma once
/// Joins in doubt, decided by the smoothest function through the sections around the cell.
///
/// A confidence looks at one cell. Whether a tube that ends in two sections goes on between them or bends
/// away shows in the planes beyond, and the function goes on as the sections around do. Sections are one body
/// where it is clearly positive on a way between them, and more so where several planes meet both: of what
/// would join them these planes have met nothing.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "cell_complex.h"
#include "cell_shape.h"
#include "ground.h"
#include "section_field.h"
#include "simple_growth.h"
#include "smooth_function.h"

namespace crossloft {

/// Whether a join with this confidence is in doubt, whatever the planes. Of the joins that docs/natural.md
/// counts, those with others need no second opinion: they are sure, or surely refused.
bool is_in_doubt(std::int32_t confidence);
/// Whether all of these joins, the most confident first, are sure, and so all others that make the same body:
/// plan_joins() has nothing to say of it. Between two bodies that three or more planes meet each, more
/// confident joins are in doubt, too: of what would join them none of these planes has met anything. With
/// more than two sections, where that depends on the order of joins, only if no two such bodies can be made
/// of them; nor with more sections than plan_joins() looks at. O(1) if the planes do not matter, else O(n log
/// n).
bool are_sure(const CellComplex& complex, const Ground& ground, std::span<const Join> joins);

/// The function that decides them: through samples in a ball a little larger than the cell. Nothing where
/// they do not determine it. O(s^3) for s samples, and what these take.
std::optional<SmoothFunction> function_around(const CellComplex& complex, const CellShape& shape,
                                              const SectionField& field);
/// Its largest value at the centroid of a tetrahedron and half way to its vertices, in radii of the cell, or
/// one that is above `enough`.
double largest_value(const CellComplex& complex, const CellShape& shape, const SmoothFunction& f,
                     double enough, std::uint32_t t);

/// What growth is to do otherwise.
struct JoinPlan {
  std::vector<JoinWish> wishes;      ///< one for each pair of parts of the sections
  std::vector<std::uint8_t> likely;  ///< tetrahedra on ways between sections to be joined that are not yet
};

/// Nothing where no join is in doubt by its confidence and planes, there are too many sections, the function
/// is not determined or parts what is surely joined, or `kept` joins just the sections that it would.
/// `measure` and `body_in_r1`: as in find_widest_ways(). REQUIRES: the shape has a field. Where joins are in
/// doubt O(s^3 + n s) for s samples, and what these take; else O(n log n).
std::optional<JoinPlan> plan_joins(const CellComplex& complex, const CellShape& shape, const Ground& ground,
                                   const std::vector<std::uint8_t>& r1,
                                   std::span<const std::uint32_t> body_in_r1,
                                   const std::vector<std::uint8_t>& kept,
                                   const std::function<std::int32_t(std::uint32_t)>& measure);

}  // namespace crossloft
