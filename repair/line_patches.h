#pragma once
/// The shapes by which a section is changed next to a line, so that it becomes there what the line should be.

#include <span>
#include <vector>

#include "line_target.h"
#include "section_edit.h"

namespace crossloft {

/// A plane and all common lines in it.
struct PlaneLines {
  const SectionBoundary& section;
  std::vector<const CommonLine*> lines;
};

/// The patch for the misfits of one span: a lens around the line, added where the span is inside and removed
/// where it is outside.
///
/// It touches the line in the span alone and no other line of the plane but at common points. Its height is
/// kSlope times the blend, so that the contour bends away from the line's target in an angle of 1 : kSlope,
/// falls off by slope 1 beyond the misfits, and stays where points are no further from the contour than the
/// deepest of the misfits. O(nodes of the span * (lines + n)).
Patch lens(const PlaneLines& plane, const CommonLine& line, const LineTarget& target, const TargetSpan& span,
           std::span<const Misfit> misfits);

/// Where the section does not reach the span at all: a strip from the line to the nearest point of the
/// contour. False if there is none that stays clear of other lines; the lens is an island then.
bool bridge(const PlaneLines& plane, const CommonLine& line, const LineTarget& target, const TargetSpan& span,
            Patch& patch);

}  // namespace crossloft
