#pragma once
/// What a triangulation tells about itself: to a person in a few lines, to a program as JSON
/// (docs/report.md).

#include <cstdint>
#include <string>

#include "../delaunay/triangulation.h"
#include "terminal.h"

namespace crossloft::cli {

/// Grows by one with every change that an old reader would stumble over.
inline constexpr int kDelaunayVersion = 1;

struct DelaunayReport {
  std::size_t points = 0;
  int dimension = -1;
  std::size_t simplices = 0;   ///< tetrahedra, triangles, edges, or the one point, by the dimension
  std::size_t duplicates = 0;  ///< points equal to a vertex, in weight too, that are none
  bool weighted = false;
  std::size_t hidden = 0;  ///< neither vertex nor duplicate: others are heavier
  std::uint64_t hash = 0;  ///< simplex_hash
  unsigned threads = 1;
  double seconds = 0;  ///< of the construction
  std::uint64_t peak_rss_kib = 0;
};

/// All but the last three fields.
DelaunayReport describe(const Triangulation& triangulation, bool weighted);

/// Depends on which vertices the simplices join, not on their order or that of their vertices: the sum modulo
/// 2^64 of a 64-bit mix of each simplex' ascending vertex numbers, as docs/report.md has it.
std::uint64_t simplex_hash(const Triangulation& triangulation);

/// Indented, with a line break at the end. `file` is where the points are from.
std::string delaunay_json(const DelaunayReport& report, const std::string& file);

void print_summary(Terminal& terminal, const DelaunayReport& report);

}  // namespace crossloft::cli
