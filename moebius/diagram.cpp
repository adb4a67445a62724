#include "diagram.h"
#include "../geom/failing.h"

#include <cmath>

#include "../delaunay/regular3.h"
#include "diagram_builder.h"
#include "power_facets.h"
#include "site_predicates.h"

namespace crossloft {
namespace {

bool is_finite(const MoebiusSite& s) {
  return is_finite(s.p) && std::isfinite(s.lambda) && std::isfinite(s.mu);
}

/// l |x|^2 - 2 (x, y).x + w = 0 in the plane moved to the site whose |lambda| is larger: it is nearer to the
/// centre.
MoebiusCurve circle_of(const MoebiusSite& i, const MoebiusSite& j) {
  const double lead = std::abs(i.lambda) - std::abs(j.lambda);
  const bool i_is_base = lead != 0 ? lead > 0 : i.lambda > 0;  // then they differ in sign
  const MoebiusSite &base = i_is_base ? i : j, &other = i_is_base ? j : i;
  const Vec2 d = other.p - base.p;
  const double l = other.lambda - base.lambda;
  const double squared = rounded_circle_extent(base, other) / (l * l);
  return {false, base.p + other.lambda / l * d, std::sqrt(std::max(squared, 0.0)), {}};
}

/// 2 lambda d.x = lambda |d|^2 - (mu_j - mu_i), from p_i, d = p_j - p_i; the cell of i is where lambda d.x is
/// smaller. REQUIRES: p_i < p_j.
MoebiusCurve line_of(const MoebiusSite& i, const MoebiusSite& j) {
  const Vec2 d = j.p - i.p;
  const double squared = dot(d, d), step = 0.5 * (1 - (j.mu - i.mu) / (i.lambda * squared));
  const double length = (i.lambda > 0 ? 1 : -1) * std::sqrt(squared);
  return {true, i.p + step * d, 0, {-d.y / length, d.x / length}};
}

}  // namespace

MoebiusCurve moebius_curve(const MoebiusSite& i, const MoebiusSite& j) {
  if (i.lambda != j.lambda) return circle_of(i, j);
  if (i.p < j.p) return line_of(i, j);
  MoebiusCurve line = line_of(j, i);
  line.direction = -line.direction;
  return line;
}

Result<MoebiusDiagram> moebius_diagram(std::span<const MoebiusSite> sites) {
  return or_out_of_memory([&]() -> Result<MoebiusDiagram> {
    for (std::size_t i = 0; i < sites.size(); ++i)
      if (!is_finite(sites[i]))
        return make_error(ErrorCode::usage, "site " + std::to_string(i) + " is not finite");
    const SitePredicates predicates(sites);
    Regular3 triangulation(predicates);
    triangulation.build();
    DiagramBuilder builder(predicates);
    if (triangulation.dimension() == 3) add_facets(predicates, triangulation.tet_mesh(), builder);
    if (triangulation.dimension() == 2) add_facets(predicates, triangulation.tri_mesh(), builder);
    if (triangulation.dimension() == 1) {
      const auto& chain = triangulation.chain();
      for (std::size_t k = 1; k < chain.size(); ++k) builder.add_facet(chain[k - 1], chain[k], {});
    }
    MoebiusDiagram diagram = builder.finish();
    diagram.sites.assign(sites.begin(), sites.end());
    return diagram;
  });
}

}  // namespace crossloft
