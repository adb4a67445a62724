#pragma once
/// Moebius diagrams in the plane: which of the sites (p_i, lambda_i, mu_i) has the least lambda_i |x - p_i|^2
/// - mu_i.
///
/// Equal lambdas give power diagrams, all mu = 0 multiplicatively weighted Voronoi diagrams, both together
/// Voronoi diagrams. Cells may be disconnected and may have holes. Lifted to (x, |x|^2) the distances are
/// linear functions, so the diagram is the power diagram of the lifted sites cut by the paraboloid. Source:
/// Boissonnat, Karavelas, On the combinatorial complexity of Euclidean Voronoi cells and convex hulls of
/// d-dimensional spheres (2003); Boissonnat, Wormser, Yvinec, Curved Voronoi diagrams (2007).

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../geom/ids.h"
#include "../geom/result.h"
#include "../geom/vec2.h"

namespace crossloft {

/// The distance of x from the site is lambda |x - p|^2 - mu; lambda may be 0 or negative.
struct MoebiusSite {
  Vec2 p;
  double lambda = 1, mu = 0;
};

/// Where two sites are equally near: a circle, or a line if their lambdas are equal.
struct MoebiusCurve {
  bool is_line = false;
  Vec2 centre;        ///< of the circle; a point of the line
  double radius = 0;  ///< of the circle
  Vec2 direction;     ///< of the line, of length 1: along the arc from `from` to `to`
};

/// A piece of the curve of two sites along which no third one is nearer. Walked from `from` to `to`, the cell
/// of sites[0] is on the left; on a circle that is counter-clockwise iff lambda of sites[0] is the larger
/// one. An end is a vertex, or kNone: at infinity (only on a line), and both on a whole curve.
struct MoebiusArc {
  std::array<std::uint32_t, 2> sites{};
  std::uint32_t from = kNone, to = kNone;
  MoebiusCurve curve;
  bool over_half = false;  ///< more than half of a circle, but not the whole one
};

/// Vertices have three arcs each: where more cells meet, several vertices have (nearly) the same place.
struct MoebiusDiagram {
  std::vector<MoebiusSite> sites;
  std::vector<Vec2> vertices;
  std::vector<MoebiusArc> arcs;
};

/// The curve of sites i and j, its line directed with the cell of i on the left. REQUIRES: i and j differ in
/// (lambda p, lambda), and are equally near somewhere.
MoebiusCurve moebius_curve(const MoebiusSite& i, const MoebiusSite& j);

/// The diagram of the sites. Which cells meet, and where along them, is decided exactly for all finite
/// doubles; curves and vertices are rounded, and are lost where (lambda distance)^4 leaves the range of a
/// double. Errors: usage for a site that is not finite. Expected O(n log n) plus the tetrahedra of the
/// regular triangulation of the lifted sites, at worst O(n^2).
///
/// Where more than three cells meet, where a cell is a point or arcs only touch, it is the diagram after an
/// infinitely small change of the mus: sound, and a function of the set of sites alone. Of sites with the
/// same distance everywhere only the first one has a cell.
Result<MoebiusDiagram> moebius_diagram(std::span<const MoebiusSite> sites);

/// Empty if sound, else the first broken invariant: three arcs at a vertex, of three sites, and one border of
/// each of their cells passes through it; indices in range, two different sites at an arc; ends at infinity
/// only on lines; ends on their curves within rounding.
std::string verify(const MoebiusDiagram& diagram);

}  // namespace crossloft
