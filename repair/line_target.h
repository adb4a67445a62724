#pragma once
/// What a common line should be: inside or outside for all its planes alike, as near as can be to what each
/// of their sections says.

#include <cstdint>
#include <span>
#include <vector>

#include "common_lines.h"
#include "section_trace.h"

namespace crossloft {

/// A stretch of a line on which all planes are to say the same.
struct TargetSpan {
  double begin = 0, end = 0;
  Inside state = Inside::either;  ///< either: contours run along it
};

/// The blended distance along a line, linear between nodes: below 0 inside.
struct LineTarget {
  std::vector<double> nodes, blend;
  std::vector<TargetSpan> spans;  ///< in a row from the first node to the last; no two neighbours are alike

  double blend_at(double t) const;
};

/// A common point that some of its sections hold and others do not; `blend` is the mean of their distances.
struct ContestedPoint {
  SharedPoint point;
  double blend = 0;
};

/// Where a section is not what its line should be.
struct Misfit {
  double begin = 0, end = 0;
  double depth = 0;  ///< how far the contour has to move at least: the largest distance of a point of it
};

/// What lines and their targets are judged by.
struct LineSetting {
  std::span<const SectionBoundary> sections;  ///< by plane
  double on = 0;                              ///< nearer to a contour a point is on it
  double spacing = 1;                         ///< of nodes
  double least = 0;                           ///< shorter contradictions and spans do not count
  double far = 1;                             ///< what counts as the distance from the contour at most
};

/// Distance of the line's point from the contour of a plane that contains it, below 0 inside, 0 on it.
double distance_at(const LineSetting& setting, std::uint32_t plane, const Trace& trace, Vec3 p, double t);

/// Two of the planes contradict each other on a stretch of this length, or on a shorter one that one section
/// alone comes to and goes from: it has two crossings there and no other section has any.
bool contradict(std::span<const Trace> traces, double least);

/// The target. Where all sections agree it is what they say, but next to a contested point; else inside iff
/// the mean of their signed distances is below 0. Next to a contested point the blend is led to that point's
/// by slope 1, at most half way to the next one. Spans shorter than setting.least only stay where all agree.
/// `traces` are those of line.planes.
LineTarget line_target(const LineSetting& setting, const CommonLine& line, std::span<const Trace> traces,
                       std::span<const ContestedPoint* const> contested);

/// Where the trace of a plane contradicts the span.
std::vector<Misfit> misfits(const LineSetting& setting, const CommonLine& line, std::uint32_t plane,
                            const Trace& trace, const LineTarget& target, const TargetSpan& span);

}  // namespace crossloft
