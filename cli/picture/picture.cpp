#include "picture.h"

#include "../../geom/bounds.h"
#include "lighting.h"

namespace crossloft::cli {
namespace {

constexpr Rgb kClay{0.62f, 0.56f, 0.50f};
constexpr float kShadow = 0.8f;     // how much of the light a shadow takes
constexpr double kShadowReach = 2;  // radii of the scene over which it fades out
constexpr double kLine = 0.85;      // half the width of a contour, in pixels

/// Colours of equal brightness around the colour circle, neighbours far apart.
Rgb hue(std::size_t k) {
  const double h =
      6 * (0.08 + 0.618034 * static_cast<double>(k) - std::floor(0.08 + 0.618034 * static_cast<double>(k)));
  const auto channel = [h](double at) {
    const double away = std::abs(std::remainder(h - at, 6.0));
    return static_cast<float>(0.04 + 0.72 * std::clamp(2 - away, 0.0, 1.0));
  };
  const Rgb raw{channel(0), channel(2), channel(4)};
  const float brightness = 0.30f * raw.r + 0.55f * raw.g + 0.15f * raw.b;
  return (0.34f / brightness) * raw;
}

struct Scene {
  const Sections& sections;
  const Surface& surface;
  Vec3 center;
  double radius = 0;
  double ground = 0;  ///< its z
};

Bounds box_of(const Sections& sections, const Surface& surface) {
  Bounds box = bounds_of(surface.points);
  for (const PlaneSection& plane : sections.planes) box.join(bounds_of(plane.vertices));
  return box;
}

Scene scene_of(const Sections& sections, const Surface& surface) {
  Bounds box = box_of(sections, surface);
  if (box.empty()) box.add(Vec3{});
  return {sections, surface, box.center(), std::max(0.5 * box.diagonal(), 1e-300), box.low.z};
}

/// Makes all of the scene fill one half of the canvas but for a margin, around the height of the middle.
void fit(View& view, const Scene& scene, const Canvas& canvas) {
  Bounds seen;
  const auto add = [&](const Vec3& p) {
    seen.add({dot(p, view.right), dot(p, view.up), dot(p, view.toward)});
  };
  for (const Vec3& p : scene.surface.points) add(p);
  for (const PlaneSection& plane : scene.sections.planes) {
    for (const Vec3& p : plane.vertices) add(p);
  }
  if (seen.empty()) add(scene.center);
  const Vec3 middle = seen.center(), size = seen.high - seen.low;
  view.center = middle.x * view.right + middle.y * view.up + middle.z * view.toward;
  view.scale = 0.9 * std::min(canvas.height() / std::max(size.y, 1e-3 * scene.radius),
                              canvas.width() / 2 / std::max(size.x, 1e-3 * scene.radius));
  view.y = 0.5 * canvas.height();
}

/// Makes the ball of options.reach around options.middle fill one half of the canvas.
void fit_part(View& view, const PictureOptions& options, const Canvas& canvas) {
  view.center = options.middle;
  view.scale = 0.5 / options.reach * std::min(canvas.height(), canvas.width() / 2);
  view.y = 0.5 * canvas.height();
}

void paint_background(Canvas& canvas) {
  for (int y = 0; y < canvas.height(); ++y) {
    const float low = static_cast<float>(y) / static_cast<float>(canvas.height());
    const Rgb colour = (1 - low) * Rgb{1, 1, 1} + low * Rgb{0.86f, 0.88f, 0.90f};
    for (int x = 0; x < canvas.width(); ++x) canvas.background(x, y, colour);
  }
}

int share_of(int x, int y) { return x % kSamples + kSamples * (y % kSamples); }

void paint_surface(Canvas& canvas, const View& view, const Scene& scene, const Lighting& lighting) {
  const auto normals = corner_normals(scene.surface);
  for (std::size_t t = 0; t < scene.surface.triangles.size(); ++t) {
    const auto& corner = scene.surface.triangles[t];
    const Vec3 &p = scene.surface.points[corner[0]], &q = scene.surface.points[corner[1]],
               &r = scene.surface.points[corner[2]];
    const Spot a = view(p), b = view(q), c = view(r);
    if (dot(cross(q - p, r - p), view.toward) <= 0) continue;
    scan_triangle(a, b, c, canvas.width(), canvas.height(),
                  [&](int x, int y, double wa, double wb, double wc) {
                    const double depth = wa * a.depth + wb * b.depth + wc * c.depth;
                    if (!canvas.in_front(x, y, depth)) return;
                    Vec3 normal = wa * normals[t][0] + wb * normals[t][1] + wc * normals[t][2];
                    normal = (1 / norm(normal)) * normal;
                    const Vec3 point = wa * p + wb * q + wc * r;
                    canvas.opaque(x, y, depth, kClay * lighting.at(point, normal, share_of(x, y)));
                  });
  }
}

/// Where the line of sight through a sample meets the ground.
Vec3 ground_point(const View& view, const Scene& scene, int x, int y) {
  const Vec3 seen = view.center + ((x + 0.5 - view.x) / view.scale) * view.right -
                    ((y + 0.5 - view.y) / view.scale) * view.up;
  return seen + ((scene.ground - seen.z) / view.toward.z) * view.toward;
}

/// The shadow on the ground, in the samples from `first_x` on that show the background. Only from above is
/// the ground behind what stands on it.
void paint_shadow(Canvas& canvas, const View& view, const Scene& scene, const Lighting& lighting,
                  int first_x) {
  if (!(view.toward.z > 0)) return;
  const Vec3 up{0, 0, 1}, far_away = scene.center + (1e3 * scene.radius) * Vec3{1, 1, 1};
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = first_x; x < canvas.width(); ++x) {
      if (!canvas.empty(x, y)) continue;
      const Rgb open = lighting.at(far_away, up, share_of(x, y));
      const Vec3 ground = ground_point(view, scene, x, y);
      const Rgb lit = lighting.at(ground, up, share_of(x, y));
      const double away = norm(ground - scene.center) / (kShadowReach * scene.radius);
      const float taken = kShadow * static_cast<float>(std::max(0.0, 1 - away * away));
      canvas.shade(x, y, 1 - taken * (1 - lit.g / open.g));
    }
  }
}

/// Thick segment with its depth, drawn nearer by `lift` samples so that a surface it lies on does not hide
/// it.
void paint_segment(Canvas& canvas, const Spot& a, const Spot& b, double lift, Rgb colour, float alpha) {
  const double half = kLine * kSamples;
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const int width = canvas.width(), height = canvas.height();
  const int x0 = std::max(0, sample(std::floor(std::min(a.x, b.x) - half), width));
  const int x1 = std::min(width - 1, sample(std::ceil(std::max(a.x, b.x) + half), width));
  const int y0 = std::max(0, sample(std::floor(std::min(a.y, b.y) - half), height));
  const int y1 = std::min(height - 1, sample(std::ceil(std::max(a.y, b.y) + half), height));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
      const double t = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0;
      if (std::hypot(px - t * dx, py - t * dy) > half) continue;
      canvas.translucent(x, y, a.depth + t * (b.depth - a.depth) + lift, colour, alpha);
    }
  }
}

bool is_wall(const ContourEdge& edge) { return (edge.material_a == 0) != (edge.material_b == 0); }

void paint_contours(Canvas& canvas, const View& view, const Sections& sections, double lift) {
  for (std::size_t k = 0; k < sections.planes.size(); ++k) {
    const PlaneSection& plane = sections.planes[k];
    for (const ContourEdge& edge : plane.edges) {
      if (!is_wall(edge)) continue;
      paint_segment(canvas, view(plane.vertices[edge.a]), view(plane.vertices[edge.b]), lift, 0.55f * hue(k),
                    1);
    }
  }
}

/// A section as a sheet of coloured glass: parallel projection keeps even-odd, so spans between walls are
/// filled.
void paint_section(Canvas& canvas, const View& view, const PlaneSection& plane, Rgb colour) {
  const Vec3 normal = (1 / norm(plane.normal)) * plane.normal;
  const double facing = dot(normal, view.toward);
  if (std::abs(facing) < 1e-3) return;
  const float shade = static_cast<float>(0.75 + 0.45 * std::abs(dot(normal, Lighting::key())));
  std::vector<std::array<Spot, 2>> walls;
  for (const ContourEdge& edge : plane.edges) {
    if (is_wall(edge)) walls.push_back({view(plane.vertices[edge.a]), view(plane.vertices[edge.b])});
  }
  for (int y = 0; y < canvas.height(); ++y) {
    std::vector<std::array<double, 2>> hits;  // x, depth
    for (const auto& [a, b] : walls) {
      if ((a.y <= y + 0.5) == (b.y <= y + 0.5)) continue;
      const double t = (y + 0.5 - a.y) / (b.y - a.y);
      hits.push_back({a.x + t * (b.x - a.x), a.depth + t * (b.depth - a.depth)});
    }
    std::sort(hits.begin(), hits.end());
    for (std::size_t i = 0; i + 1 < hits.size(); i += 2) {
      const auto [x0, depth0] = hits[i];
      const auto [x1, depth1] = hits[i + 1];
      const int width = canvas.width(), last = std::min(width - 1, sample(std::ceil(x1 - 0.5), width) - 1);
      for (int x = std::max(0, sample(std::ceil(x0 - 0.5), width)); x <= last; ++x) {
        const double depth = depth0 + (x + 0.5 - x0) / (x1 - x0) * (depth1 - depth0);
        canvas.translucent(x, y, depth, shade * colour, 0.38f);
      }
    }
  }
}

}  // namespace

bool is_beside(const Sections& sections, const Surface& surface, const PictureOptions& options) {
  if (!(options.reach > 0)) return false;
  const Bounds box = box_of(sections, surface);
  if (box.empty()) return true;
  const Vec3 m = options.middle,
             nearest{std::clamp(m.x, box.low.x, box.high.x), std::clamp(m.y, box.low.y, box.high.y),
                     std::clamp(m.z, box.low.z, box.high.z)};
  return norm(nearest - m) > options.reach;
}

Image draw_picture(const Sections& sections, const Surface& surface, const PictureOptions& options) {
  const Scene scene = scene_of(sections, surface);
  const Lighting lighting(surface, scene.center, 1.02 * scene.radius);
  Canvas canvas(options.width, options.height);
  paint_background(canvas);
  View view = view_from(options.from);
  if (options.reach > 0) {
    fit_part(view, options, canvas);
  } else {
    fit(view, scene, canvas);
  }
  view.x = 0.25 * canvas.width();
  canvas.clip(0, canvas.width() / 2);
  for (std::size_t k = 0; k < sections.planes.size(); ++k)
    paint_section(canvas, view, sections.planes[k], hue(k));
  paint_contours(canvas, view, sections, 0.5);
  view.x = 0.75 * canvas.width();
  canvas.clip(canvas.width() / 2, canvas.width());
  paint_surface(canvas, view, scene, lighting);
  paint_shadow(canvas, view, scene, lighting, canvas.width() / 2);
  paint_contours(canvas, view, sections, 0.004 * scene.radius * view.scale);
  return canvas.develop();
}

}  // namespace crossloft::cli
