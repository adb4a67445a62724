#pragma once
/// The shapes by which a section is changed next to a line, so that it becomes there what the line should be.

#include <span>
#include <vector>

#include "correction.h"
#include "section_edit.h"

namespace crossloft {

/// A common line in a plane, and how the plane's section has to be corrected there.
struct LineInPlane {
  const CommonLine* line = nullptr;
  const LineTarget* target = nullptr;  ///< null where nothing is contested
  std::vector<Correction> corrections;
};

/// A plane and all common lines in it.
struct PlaneLines {
  const SectionBoundary& section;
  std::vector<LineInPlane> lines;
};

/// The patch for the misfits of one span of a line: a lens around the line, added where the span is inside
/// and removed where it is outside.
///
/// It is where the signed distance from the contour and the correction together are on the side of the span,
/// seen from the line: the contour moves by no more than the correction and joins the old one at a flat
/// angle. Next to other lines the correction goes down to theirs. The lens touches its line in the span
/// alone, and other lines of the plane at common points alone. Within misfits its height is `least` at least,
/// where other lines leave room. O(samples * n), some 50 samples for each misfit.
Patch lens(const PlaneLines& plane, std::size_t line, const TargetSpan& span, double least);

/// A small patch around a common point that the section is on the wrong side of: lenses have no height there.
/// `radius` at most, and within the spans of all lines of the plane through the point.
Patch plug(const PlaneLines& plane, Vec3 point, const std::vector<const CommonLine*>& through, bool inside,
           double radius);

/// Loops with new edges (contour kNone) that meet no line and are no larger than `size` go: pieces that
/// lenses left over. Returns how many. O(n * lines).
std::uint32_t drop_crumbs(PlaneSection& section, const PlaneLines& plane, double size);

}  // namespace crossloft
