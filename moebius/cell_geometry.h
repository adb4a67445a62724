#pragma once
/// Area and containment of the loops of Moebius cells, in doubles, with + - * / and sqrt only.

#include <span>

#include "cells.h"

namespace crossloft {

/// Positive for a counter-clockwise loop. REQUIRES: it stays away from infinity.
double signed_area(const MoebiusDiagram& diagram, std::span<const CellStep> loop);

/// How often the loop winds counter-clockwise around a point that is not on it; pieces at infinity as
/// CellLoop has them.
int winding_number(const MoebiusDiagram& diagram, std::span<const CellStep> loop, Vec2 point);

}  // namespace crossloft
