#include "likely_joins.h"

#include <algorithm>
#include <array>

#include "../geom/bounds.h"
#include "../geom/disjoint_sets.h"
#include "confidence.h"
#include "section_field.h"
#include "section_parts.h"
#include "smooth_function.h"
#include "star.h"
#include "widest_ways.h"

namespace crossloft {
namespace {

constexpr double kSurelyApart = -0.5, kSurelyJoined = 0.05;
/// The same of bodies that kPlanesToSee planes or more meet each: what joins them, each of these had to miss.
constexpr double kSurelyJoinedIfSeen = 0.25;
constexpr std::size_t kPlanesToSee = 3;
/// How far the function looks, in radii of the cell: a little beyond it, into the planes around.
constexpr double kReach = 1.1;
/// What the function must exceed, in radii of the cell. Samples are a sixth of one apart: a gap that is
/// narrower than that does not show, and the function is a little above 0 in it. Less in tetrahedra that are
/// kept already.
constexpr double kLeastValue = 0.04, kLeastWhereKept = 0.01;
/// Between bodies that kPlanesToSee planes meet each, one more, and still more.
constexpr std::array<double, 3> kLeastIfSeen{0.05, 0.06, 0.12};

/// With more sections in a cell they are small against it, and the samples too far apart to tell them from
/// what is around; and there is a wish for each pair.
constexpr std::size_t kMostParts = 5;
/// Nor do they tell of a section whose box has a smaller diagonal than they are apart, in radii of the cell.
constexpr double kLeastExtent = kReach / SectionField::kStepsPerRadius;

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

/// By join, the confidence above which it is sure.
std::vector<std::int32_t> sure_above(std::span<const Join> joins, std::span<const SectionPart> parts) {
  SeenBodies bodies(parts);
  std::vector<std::int32_t> sure;
  for (const Join& j : joins) {
    const auto pair = bodies_of(j, parts, bodies);
    const bool seen = pair && bodies.planes_at_both((*pair)[0], (*pair)[1]) >= kPlanesToSee;
    sure.push_back(as_integer(seen ? kSurelyJoinedIfSeen : kSurelyJoined));
    if (pair) bodies.join((*pair)[0], (*pair)[1]);
  }
  return sure;
}

bool has_doubt(std::span<const Join> joins, std::span<const std::int32_t> sure) {
  return !std::equal(joins.begin(), joins.end(), sure.begin(), [](const Join& j, std::int32_t above) {
    return j.confidence < as_integer(kSurelyApart) || j.confidence > above;
  });
}

/// Whether bodies that are surely one by their confidence are so in `wanted`, or parts of them: else the
/// function does not see what it is to decide.
bool sees_sure_joins(std::span<const Join> possible, std::span<const std::int32_t> sure,
                     std::span<const SectionPart> parts, DisjointSets& wanted) {
  SeenBodies bodies(parts);
  const auto are_one = [&](std::uint32_t a, std::uint32_t b) {
    for (std::uint32_t p = 0; p < parts.size(); ++p)
      for (std::uint32_t q = 0; q < parts.size(); ++q)
        if (bodies.body_of(p) == a && bodies.body_of(q) == b &&
            wanted.find(parts[p].number) == wanted.find(parts[q].number))
          return true;
    return false;
  };
  for (std::size_t k = 0; k < possible.size(); ++k) {
    const auto pair = bodies_of(possible[k], parts, bodies);
    if (possible[k].confidence > sure[k] && !(pair && are_one((*pair)[0], (*pair)[1]))) return false;
    if (pair) bodies.join((*pair)[0], (*pair)[1]);
  }
  return true;
}

/// Joins bodies by ways on which the function is large enough for the number of planes that meet both.
class WaysBetweenSeen {
 public:
  WaysBetweenSeen(const CellComplex& complex, const Ground& ground, std::span<const SectionPart> parts)
      : complex_(complex),
        ground_(ground),
        bodies_(parts),
        pieces_(std::size_t{ground.size()} + complex.mesh.size()),
        part_(std::size_t{ground.size()} + complex.mesh.size(), kNone),
        added_(complex.mesh.size(), 0) {
    for (std::uint32_t g = 0; g < ground.size(); ++g) pieces_.join(g, ground.part(g));
    for (std::uint32_t i = 0; i < parts.size(); ++i) part_[pieces_.find(parts[i].number)] = i;
  }

  /// The next one by falling value. False if it would join bodies that it may not: it is on no way then.
  bool add(std::uint32_t t, std::int32_t value) {
    std::array<std::uint32_t, 4> bodies;
    std::size_t count = 0;
    for_pieces_at(t, [&](std::uint32_t piece) {
      if (const std::uint32_t part = part_[pieces_.find(piece)]; part != kNone)
        bodies[count++] = bodies_.body_of(part);
    });
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (bodies[i] != bodies[j] && value <= least(bodies_.planes_at_both(bodies[i], bodies[j])))
          return false;
    for (std::size_t i = 1; i < count; ++i) bodies_.join(bodies_.body_of(bodies[0]), bodies[i]);
    for_pieces_at(t, [&](std::uint32_t piece) { pieces_.join(of_tet(t), piece); });
    part_[pieces_.find(of_tet(t))] = count == 0 ? kNone : bodies[0];
    added_[t] = 1;
    return true;
  }

  std::uint32_t body_of(std::uint32_t part) { return bodies_.body_of(part); }

 private:
  std::uint32_t of_tet(std::uint32_t t) const { return ground_.size() + t; }

  template <class Visit>
  void for_pieces_at(std::uint32_t t, Visit visit) const {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = complex_.mesh.neighbours[t][i];
      if (n != kNone && added_[n] != 0) visit(of_tet(n));
      if (ground_.is_ground(t, i)) visit(ground_.at(t, i));
    }
  }

  /// With fewer planes what is above the limits of all is enough.
  static std::int32_t least(std::size_t planes) {
    return planes < kPlanesToSee
               ? 0
               : as_integer(kLeastIfSeen[std::min(planes - kPlanesToSee, kLeastIfSeen.size() - 1)]);
  }

  const CellComplex& complex_;
  const Ground& ground_;
  SeenBodies bodies_;
  DisjointSets pieces_;              ///< ground triangles, then tetrahedra
  std::vector<std::uint32_t> part_;  ///< by piece: a part of the body it is of
  std::vector<std::uint8_t> added_;
};

/// Whether these parts may become two bodies that kPlanesToSee planes meet each.
bool may_be_seen(std::span<const SectionPart> parts) {
  std::size_t planes = 0;
  for (const SectionPart& part : parts) planes += part.faces.size();
  return planes >= 2 * kPlanesToSee;
}

/// Parts by the sets they are in where the function is large enough on a way between them. What would join
/// others is taken out of what is `above`.
DisjointSets wanted_parts(const CellComplex& complex, const CellShape& shape, const Ground& ground,
                          std::span<const SectionPart> parts, const SmoothFunction& f, Reached& above) {
  if (!may_be_seen(parts)) return above.parts;
  std::vector<std::int32_t> value(complex.mesh.size(), 0);
  for (std::uint32_t t = 0; t < value.size(); ++t)
    if (above.inside[t] != 0)
      value[t] = as_integer(std::clamp(largest_value(complex, shape, f, 1, t), 0.0, 1.0));
  WaysBetweenSeen ways(complex, ground, parts);
  for (const std::uint32_t t : by_confidence(complex, above.inside, value))
    above.inside[t] = ways.add(t, value[t]);
  DisjointSets wanted(ground.size());
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    wanted.join(parts[ways.body_of(i)].number, parts[i].number);
  return wanted;
}

struct Ball {
  Vec3 centre;
  double radius = 0;
};

/// Around the mean of the cell's vertices on planes.
Ball ball_around(const CellComplex& complex, const CellShape& shape) {
  std::vector<Vec3> points;
  for (std::uint32_t v = 0; v < shape.points.size(); ++v)
    if (!complex.is_interior(v)) points.push_back(shape.points[v]);
  Ball ball;
  for (const Vec3& p : points) ball.centre = ball.centre + p;
  ball.centre = (1 / static_cast<double>(points.size())) * ball.centre;
  for (const Vec3& p : points) ball.radius = std::max(ball.radius, norm(p - ball.centre));
  return ball;
}

/// Some section is too small for the samples.
bool has_speck(std::span<const SectionPart> parts, const CellShape& shape, double radius) {
  return std::any_of(parts.begin(), parts.end(), [&](const SectionPart& part) {
    Bounds box;
    for (const std::uint32_t v : part.vertices) box.add(shape.points[v]);
    return norm(box.high - box.low) < kLeastExtent * radius;
  });
}

}  // namespace

std::optional<SmoothFunction> function_around(const CellComplex& complex, const CellShape& shape,
                                              const SectionField& field) {
  const auto [centre, radius] = ball_around(complex, shape);
  return SmoothFunction::through(field.samples(centre, kReach * radius), centre, radius);
}

double largest_value(const CellComplex& complex, const CellShape& shape, const SmoothFunction& f,
                     double enough, std::uint32_t t) {
  const auto v = sorted_vertices(complex.mesh, t);
  const auto& at = shape.points;
  const Vec3 centroid = 0.25 * ((at[v[0]] + at[v[1]]) + (at[v[2]] + at[v[3]]));
  const auto towards = [&](unsigned k) { return 0.5 * (centroid + at[v[k]]); };
  const auto larger = [&](Vec3 p, Vec3 q) {
    const auto [at_p, at_q] = f.at(p, q);
    return std::max(at_p, at_q);
  };
  double value = larger(centroid, towards(0));
  if (!(value > enough)) value = std::max(value, larger(towards(1), towards(2)));
  if (!(value > enough)) value = std::max(value, larger(towards(3), centroid));
  return value;
}

bool is_in_doubt(std::int32_t confidence) {
  return confidence >= as_integer(kSurelyApart) && confidence <= as_integer(kSurelyJoined);
}

bool are_sure(const CellComplex& complex, const Ground& ground, std::span<const Join> joins) {
  if (joins.empty() || joins.back().confidence > as_integer(kSurelyJoinedIfSeen)) return true;
  if (joins.back().confidence <= as_integer(kSurelyJoined)) return false;
  const std::uint32_t count = ground.part_count();
  if (count > kMostParts) return true;
  const std::vector<SectionPart> parts = section_parts(complex, ground);
  return count == 2 ? joins[0].confidence > sure_above(joins, parts)[0] : !may_be_seen(parts);
}

std::optional<JoinPlan> plan_joins(const CellComplex& complex, const CellShape& shape, const Ground& ground,
                                   const std::vector<std::uint8_t>& r1,
                                   std::span<const std::uint32_t> body_in_r1,
                                   const std::vector<std::uint8_t>& kept,
                                   const std::function<std::int32_t(std::uint32_t)>& measure) {
  if (ground.part_count() > kMostParts) return std::nullopt;
  const std::vector<Join> possible = find_widest_ways(complex, ground, r1, body_in_r1, measure);
  const std::vector<SectionPart> parts = section_parts(complex, ground);
  const std::vector<std::int32_t> sure = sure_above(possible, parts);
  if (!has_doubt(possible, sure)) return std::nullopt;
  if (has_speck(parts, shape, ball_around(complex, shape).radius)) return std::nullopt;
  const auto f = function_around(complex, shape, shape.field->get());
  if (!f) return std::nullopt;
  Reached above = reach(complex, ground, [&](std::uint32_t t) {
    const double least = kept[t] != 0 ? kLeastWhereKept : kLeastValue;
    return r1[t] != 0 && largest_value(complex, shape, *f, least, t) > least;
  });
  DisjointSets wanted = wanted_parts(complex, shape, ground, parts, *f, above);
  if (!sees_sure_joins(possible, sure, parts, wanted)) return std::nullopt;
  Reached found = reach(complex, ground, [&](std::uint32_t t) { return kept[t] != 0; });
  JoinPlan plan;
  bool lacks = false, differs = false;
  for (auto a = parts.begin(); a != parts.end(); ++a)
    for (auto b = a + 1; b != parts.end(); ++b) {
      const bool join = wanted.find(a->number) == wanted.find(b->number);
      const bool joined = found.parts.find(a->number) == found.parts.find(b->number);
      plan.wishes.push_back({a->vertices, b->vertices, join});
      differs |= join != joined;
      lacks |= join && !joined;
    }
  if (!differs) return std::nullopt;
  plan.likely = lacks ? std::move(above.inside) : std::vector<std::uint8_t>(r1.size(), 0);
  return plan;
}

}  // namespace crossloft
