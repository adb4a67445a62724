#pragma once
/// What a reconstruction costs as its input grows: measurements and the picture of them.

#include <cstdint>
#include <string>
#include <vector>

namespace crossloft::bench {

/// One reconstruction in a process of its own.
struct ScalePoint {
  std::uint32_t planes = 0, threads = 1;
  std::uint64_t vertices = 0, tetrahedra = 0;  ///< of the contours; of the cells' triangulations
  std::uint64_t cells = 0;                     ///< of the arrangement
  double seconds = 0, processor = 0;           ///< wall clock; processor time of all threads
  double megabytes = 0;                        ///< peak of the process, input and result included
};

/// Points of one series, in the order of what grows.
struct ScaleSeries {
  std::string name, grows;  ///< `grows`: vertices or planes
  std::vector<ScalePoint> points;
};

/// A table a series, Markdown.
std::string to_markdown(const std::vector<ScaleSeries>& series);
/// A row a series: seconds and megabytes, both over what grows and all logarithmic.
std::string to_svg(const std::vector<ScaleSeries>& series);

}  // namespace crossloft::bench
