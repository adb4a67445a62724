#include <algorithm>
#include <cmath>
#include <vector>

#include "circle.h"
#include "solids.h"

namespace crossloft {
namespace {

// Fields: negative inside, about the distance near the surface.

double ball(const Vec3& p, const Vec3& center, double radius) { return norm(p - center) - radius; }

/// Scaled to the length of the gradient at the surface; good near it.
double ellipsoid(const Vec3& p, const Vec3& center, const Vec3& radii) {
  const Vec3 q = p - center, s{q.x / radii.x, q.y / radii.y, q.z / radii.z};
  const Vec3 g{s.x / radii.x, s.y / radii.y, s.z / radii.z};
  const double k = norm(s), slope = norm(g);
  return slope > 0 ? k * (k - 1) / slope : -std::min({radii.x, radii.y, radii.z});
}

/// Round cone: a tube from a to b whose radius goes from ra to rb.
double tube(const Vec3& p, const Vec3& a, const Vec3& b, double ra, double rb) {
  const Vec3 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return norm(p - (a + t * d)) - (ra + t * (rb - ra));
}

double ring(const Vec3& p, const Vec3& center, double R, double r) {
  const Vec3 q = p - center;
  const double out = norm({q.x, q.y, 0}) - R;
  return norm({out, q.z, 0}) - r;
}

/// Union with a fillet of about the size k (quadratic polynomial).
double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k / 4;
}

Bounds cube_box(double half) {
  Bounds box;
  box.add(Vec3{-half, -half, -half});
  box.add(Vec3{half, half, half});
  return box;
}

double mirrored_limbs(const Vec3& p) {
  const Vec3 q{std::abs(p.x), p.y, p.z};
  const Vec3 shoulder{0.26, 0, 0.27}, elbow{0.74, 0.02, 0.12}, hand{0.36, 0, -0.33};
  const double arm = blend(tube(q, shoulder, elbow, 0.13, 0.12), tube(q, elbow, hand, 0.12, 0.12), 0.04);
  const Vec3 hip{0.2, 0, -0.5}, foot{0.34, 0, -0.83};
  const double leg =
      blend(tube(q, hip, foot, 0.19, 0.165), tube(q, foot, foot + Vec3{0.02, -0.2, -0.02}, 0.16, 0.13), 0.08);
  return std::min(arm, leg);
}

double bear(const Vec3& p) {
  const Vec3 q{std::abs(p.x), p.y, p.z};
  const double body = ellipsoid(p, {0, 0, -0.2}, {0.4, 0.35, 0.52});
  const double head = blend(ellipsoid(p, {0, -0.02, 0.56}, {0.36, 0.33, 0.33}),
                            ellipsoid(p, {0, -0.31, 0.48}, {0.16, 0.14, 0.13}), 0.06);
  const double ears = ball(q, {0.29, 0.02, 0.84}, 0.135);
  return blend(blend(body, mirrored_limbs(p), 0.09), blend(head, ears, 0.05), 0.1);
}

/// The branches of a tree of tubes: children leave the end of their parent, thinner and shorter.
struct Branch {
  Vec3 from, to;
  double thick = 0, thin = 0;
};

void grow(const Vec3& from, const Vec3& way, const Vec3& side, double thick, int depth,
          std::vector<Branch>& tree) {
  const Vec3 to = from + way;
  const double thin = 0.8 * thick;
  tree.push_back({from, to, thick, thin});
  if (depth == 0) return;
  const Vec3 other = (norm(way) / norm(cross(way, side))) * cross(way, side);
  for (const double sign : {-1.0, 1.0})
    grow(to, 0.74 * (0.78 * way + sign * 0.62 * (norm(way) / norm(side)) * side), other, 0.9 * thin,
         depth - 1, tree);
}

}  // namespace

Surface genus2_solid(std::uint32_t cells) {
  return implicit_solid(
      [](const Vec3& p) {
        return blend(ring(p, {-0.42, 0, 0}, 0.36, 0.15), ring(p, {0.42, 0, 0}, 0.36, 0.15), 0.1);
      },
      cube_box(1), cells);
}

Surface genus3_solid(std::uint32_t cells) {
  const auto field = [](const Vec3& p) {
    double f = 1;
    for (int k = 0; k < 3; ++k) {
      const SineCosine a = circle(k / 3.0 + 0.25);
      f = blend(f, ring(p, {0.45 * a.cosine, 0.45 * a.sine, 0}, 0.33, 0.14), 0.1);
    }
    return f;
  };
  return implicit_solid(field, cube_box(1), cells);
}

Surface trefoil_solid(std::uint32_t cells) {
  constexpr int kPieces = 180;
  std::vector<Vec3> curve;
  for (int k = 0; k <= kPieces; ++k) {
    const double t = static_cast<double>(k) / kPieces;
    const SineCosine one = circle(t), two = circle(2 * t), three = circle(3 * t);
    curve.push_back(0.27 * Vec3{one.sine + 2 * two.sine, one.cosine - 2 * two.cosine, -1.4 * three.sine});
  }
  const auto field = [curve](const Vec3& p) {
    double f = 1;
    for (int k = 0; k < kPieces; ++k) f = std::min(f, tube(p, curve[k], curve[k + 1], 0.12, 0.12));
    return f;
  };
  return implicit_solid(field, cube_box(1), cells);
}

Surface vessel_solid(std::uint32_t cells) {
  std::vector<Branch> tree;
  grow({0, 0, -0.8}, {0, 0, 0.6}, {1, 0, 0}, 0.24, 2, tree);
  const auto field = [tree](const Vec3& p) {
    double f = 1;
    for (const Branch& b : tree) f = blend(f, tube(p, b.from, b.to, b.thick, b.thin), 0.04);
    return f;
  };
  return implicit_solid(field, cube_box(1.1), cells);
}

Surface gyroid_solid(std::uint32_t cells) {
  const auto field = [](const Vec3& p) {
    const SineCosine x = circle(0.66 * p.x), y = circle(0.66 * p.y), z = circle(0.66 * p.z);
    const double g = x.sine * y.cosine + y.sine * z.cosine + z.sine * x.cosine;
    return -blend(-g / 5, -ball(p, {0, 0, 0}, 0.93), 0.06);  // rounded intersection
  };
  return implicit_solid(field, cube_box(1), cells);
}

Surface nested_shells(std::uint32_t cells) {
  const auto field = [](const Vec3& p) {
    const double shell = std::max(ball(p, {0, 0, 0}, 0.9), -ball(p, {0.05, 0, 0}, 0.65));
    return std::min(shell, ball(p, {0.1, 0, 0.05}, 0.4));
  };
  return implicit_solid(field, cube_box(1), cells);
}

Surface demo_solid(std::uint32_t cells) { return implicit_solid(bear, cube_box(1.05), cells); }

}  // namespace crossloft
