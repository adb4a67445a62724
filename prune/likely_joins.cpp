#include "likely_joins.h"

#include <algorithm>
#include <array>

#include "../geom/disjoint_sets.h"
#include "confidence.h"
#include "section_field.h"
#include "smooth_function.h"
#include "star.h"
#include "widest_ways.h"

namespace crossloft {
namespace {

constexpr double kSurelyApart = -0.5, kSurelyJoined = 0.05;
/// How far the function looks, in radii of the cell: a little beyond it, into the planes around.
constexpr double kReach = 1.1;
/// What the function must exceed, in radii of the cell. Samples are a sixth of one apart: a gap that is
/// narrower than that does not show, and the function is a little above 0 in it. Less in tetrahedra that are
/// kept already.
constexpr double kLeastValue = 0.04, kLeastWhereKept = 0.01;

/// With more sections in a cell they are small against it, and the samples too far apart to tell them from
/// what is around; and there is a wish for each pair.
constexpr std::size_t kMostParts = 5;

std::optional<SmoothFunction> function_around(const CellComplex& complex, const CellShape& shape) {
  std::vector<Vec3> points;
  for (std::uint32_t v = 0; v < shape.points.size(); ++v)
    if (!complex.is_interior(v)) points.push_back(shape.points[v]);
  Vec3 centre;
  for (const Vec3& p : points) centre = centre + p;
  centre = (1 / static_cast<double>(points.size())) * centre;
  double radius = 0;
  for (const Vec3& p : points) radius = std::max(radius, norm(p - centre));
  return SmoothFunction::through(shape.field->get().samples(centre, kReach * radius), centre, radius);
}

/// Whether the function is above `least` somewhere at the centroid of a tetrahedron or half way to its
/// vertices.
bool is_likely(const CellComplex& complex, const CellShape& shape, const SmoothFunction& f, double least,
               std::uint32_t t) {
  const auto v = sorted_vertices(complex.mesh, t);
  const auto& at = shape.points;
  const Vec3 centroid = 0.25 * ((at[v[0]] + at[v[1]]) + (at[v[2]] + at[v[3]]));
  const auto is_above = [&](Vec3 p, Vec3 q) {
    const auto [at_p, at_q] = f.at(p, q);
    return at_p > least || at_q > least;
  };
  const auto towards = [&](unsigned k) { return 0.5 * (centroid + at[v[k]]); };
  return is_above(centroid, towards(0)) || is_above(towards(1), towards(2)) || is_above(towards(3), centroid);
}

/// Tetrahedra that sections reach.
struct Reached {
  DisjointSets parts;                ///< by part(g) of the ground: those that meet
  std::vector<std::uint8_t> inside;  ///< by tetrahedron
};

/// From the ground through tetrahedra with inside(t), which is asked once of each that is next to these.
template <class Inside>
Reached reach(const CellComplex& complex, const Ground& ground, Inside inside) {
  constexpr std::uint32_t kRefused = kNone - 1;
  Reached reached{DisjointSets(ground.size()), std::vector<std::uint8_t>(complex.mesh.size(), 0)};
  std::vector<std::uint32_t> part(complex.mesh.size(), kNone), stack;
  const auto see = [&](std::uint32_t t, std::uint32_t from) {
    if (part[t] == kNone) {
      reached.inside[t] = inside(t) ? 1 : 0;
      part[t] = reached.inside[t] != 0 ? from : kRefused;
      if (reached.inside[t] != 0) stack.push_back(t);
    } else if (part[t] != kRefused) {
      reached.parts.join(part[t], from);
    }
  };
  for (std::uint32_t g = 0; g < ground.size(); ++g) see(ground.facet(g).tet, ground.part(g));
  while (!stack.empty()) {
    const std::uint32_t t = stack.back();
    stack.pop_back();
    for (const std::uint32_t n : complex.mesh.neighbours[t])
      if (n != kNone) see(n, part[t]);
  }
  return reached;
}

/// One part of the sections.
struct Part {
  std::uint32_t number = 0;
  std::vector<std::uint32_t> vertices;  ///< ascending
};

std::vector<Part> list_parts(const CellComplex& complex, const Ground& ground) {
  std::vector<Part> parts;
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    if (ground.part(g) == g) parts.push_back({g, {}});
    const auto part = std::lower_bound(parts.begin(), parts.end(), ground.part(g),
                                       [](const Part& p, std::uint32_t number) { return p.number < number; });
    const Facet& f = ground.facet(g);
    for (const std::uint8_t slot : kFacetSlots[f.facet])
      part->vertices.push_back(complex.mesh.vertices[f.tet][slot]);
  }
  for (Part& part : parts) {
    std::sort(part.vertices.begin(), part.vertices.end());
    part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
  }
  return parts;
}

/// Whether parts that are surely one body by their confidence are so in `wanted`: else the function does not
/// see what it is to decide. A join has the name of one part of each of two bodies, its smallest vertex,
/// which parts that touch may have in common.
bool sees_sure_joins(std::span<const Join> possible, std::span<const Part> parts, Reached& wanted) {
  const auto is_seen = [&](const Join& j) {
    for (const Part& p : parts)
      for (const Part& q : parts)
        if (p.number != q.number && p.vertices.front() == j.a && q.vertices.front() == j.b &&
            wanted.parts.find(p.number) == wanted.parts.find(q.number))
          return true;
    return false;
  };
  return std::all_of(possible.begin(), possible.end(),
                     [&](const Join& j) { return !is_sure(j.confidence) || is_seen(j); });
}

}  // namespace

bool is_in_doubt(std::int32_t confidence) {
  return confidence >= as_integer(kSurelyApart) && !is_sure(confidence);
}

bool is_sure(std::int32_t confidence) { return confidence > as_integer(kSurelyJoined); }

std::optional<JoinPlan> plan_joins(const CellComplex& complex, const CellShape& shape, const Ground& ground,
                                   const std::vector<std::uint8_t>& r1,
                                   std::span<const std::uint32_t> body_in_r1,
                                   const std::vector<std::uint8_t>& kept,
                                   const std::function<std::int32_t(std::uint32_t)>& measure) {
  const std::vector<Join> possible = find_widest_ways(complex, ground, r1, body_in_r1, measure);
  if (std::none_of(possible.begin(), possible.end(), [](const Join& j) { return is_in_doubt(j.confidence); }))
    return std::nullopt;
  const std::vector<Part> parts = list_parts(complex, ground);
  if (parts.size() > kMostParts) return std::nullopt;
  const auto f = function_around(complex, shape);
  if (!f) return std::nullopt;
  Reached wanted = reach(complex, ground, [&](std::uint32_t t) {
    return r1[t] != 0 && is_likely(complex, shape, *f, kept[t] != 0 ? kLeastWhereKept : kLeastValue, t);
  });
  if (!sees_sure_joins(possible, parts, wanted)) return std::nullopt;
  Reached found = reach(complex, ground, [&](std::uint32_t t) { return kept[t] != 0; });
  JoinPlan plan;
  bool lacks = false, differs = false;
  for (auto a = parts.begin(); a != parts.end(); ++a)
    for (auto b = a + 1; b != parts.end(); ++b) {
      const bool join = wanted.parts.find(a->number) == wanted.parts.find(b->number);
      const bool joined = found.parts.find(a->number) == found.parts.find(b->number);
      plan.wishes.push_back({a->vertices, b->vertices, join});
      differs |= join != joined;
      lacks |= join && !joined;
    }
  if (!differs) return std::nullopt;
  plan.likely = lacks ? std::move(wanted.inside) : std::vector<std::uint8_t>(r1.size(), 0);
  return plan;
}

}  // namespace crossloft
