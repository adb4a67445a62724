#include <algorithm>
#include <cmath>

#include "../geom/unit_plane.h"
#include "check.h"
#include "planar_layers.h"
#include "triangle_distance.h"
#include "unit_scale.h"

namespace crossloft {
namespace {

// Layers: the two one-sided slices of the solid, and the section.
constexpr unsigned kUpperSlice = 0, kLowerSlice = 1, kSection = 2;
constexpr LayerMask kSolidMask = 1u << kUpperSlice | 1u << kLowerSlice, kSectionMask = 1u << kSection;

// Fractions of the extent of what lies in the plane.
constexpr double kPieceLength = 1.0 / 512;  // boundaries are judged in pieces
constexpr double kShortest = 1e-8;          // shorter ones are rounding
constexpr double kBeside = 1e-9;            // how far beside a piece one looks for what covers its sides
constexpr double kNoCrossing = 1e-14;

/// Orthonormal coordinates of a plane, z the height over it.
struct PlaneFrame {
  PlaneFrame(const UnitPlane& plane, const Vec3& near) {
    w = plane.normal;
    const double x = std::abs(w.x), y = std::abs(w.y), z = std::abs(w.z);
    const Vec3 other = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    u = cross(w, other);
    u = (1 / norm(u)) * u;
    v = cross(w, u);
    origin = near - plane.height(near) * w;
  }
  Vec3 project(const Vec3& p) const { return {dot(u, p - origin), dot(v, p - origin), dot(w, p - origin)}; }

  Vec3 u, v, w, origin;
};

Vec3 flat(const Vec3& p) { return {p.x, p.y, 0}; }

/// The judgement of one plane, all at size 1; see check_sections.
class PlaneJudge {
 public:
  PlaneJudge(const Surface& surface, const PlaneSection& section, const UnitPlane& plane, const Vec3& center,
             double on_plane)
      : surface_(surface), section_(section), on_plane_(on_plane), frame_(plane, center) {}

  PlaneCheck run() {
    add_slices();
    add_section();
    Bounds box;
    for (const LayerSegment& s : segments_) box.add(s.a), box.add(s.b);
    extent_ = box.diagonal();
    measure_areas();
    measure_distance();
    return check_;
  }

 private:
  void add_slices() {
    projected_.reserve(surface_.points.size());
    for (const Vec3& p : surface_.points) {
      Vec3 q = frame_.project(p);
      if (std::abs(q.z) <= on_plane_) {
        check_.off_plane = std::max(check_.off_plane, std::abs(q.z));
        q.z = 0;
      }
      projected_.push_back(q);
    }
    for (const auto& t : surface_.triangles) {
      if (*std::max_element(t.begin(), t.end()) >= projected_.size()) continue;
      const auto [low, high] = std::minmax({projected_[t[0]].z, projected_[t[1]].z, projected_[t[2]].z});
      if (low <= 0 && high > 0) add_chord(t, kUpperSlice);
      if (low < 0 && high >= 0) add_chord(t, kLowerSlice);
    }
  }

  /// Limit of the triangle's cut from the slice's side of the plane: what lies on the plane is on its other
  /// side.
  void add_chord(const std::array<std::uint32_t, 3>& t, unsigned layer) {
    const auto beyond = [layer](double z) { return layer == kUpperSlice ? z > 0 : z < 0; };
    std::array<Vec3, 2> ends;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[k == 2 ? 0 : k + 1];
      if (beyond(projected_[a].z) != beyond(projected_[b].z))
        ends[count++] = cut_point(std::min(a, b), std::max(a, b));
    }
    if (count == 2) add_segment(ends[0], ends[1], layer);
  }

  /// Both triangles of an edge compute it from the lower vertex, so chains close exactly.
  Vec3 cut_point(std::uint32_t low, std::uint32_t high) const {
    const Vec3 &p = projected_[low], &q = projected_[high];
    if (p.z == 0) return flat(p);
    if (q.z == 0) return flat(q);
    return flat(p + p.z / (p.z - q.z) * (q - p));
  }

  void add_segment(const Vec3& a, const Vec3& b, unsigned layer) {
    if (a != b) segments_.push_back({a, b, layer});
  }

  void add_section() {
    for (const ContourEdge& e : section_.edges) {
      const bool wall = (e.material_a == 0) != (e.material_b == 0);
      if (!wall || std::max(e.a, e.b) >= section_.vertices.size()) continue;
      add_segment(flat(frame_.project(section_.vertices[e.a])), flat(frame_.project(section_.vertices[e.b])),
                  kSection);
    }
  }

  void measure_areas() {
    const auto areas = layer_areas(segments_, kNoCrossing * extent_);
    for (LayerMask m = 1; m < areas.size(); ++m) {
      const bool solid = (m & kSolidMask) != 0, section = (m & kSectionMask) != 0;
      if (solid) check_.surface_area += areas[m];
      if (section) check_.section_area += areas[m];
      if (solid && !section) check_.extra_area += areas[m];
      if (section && !solid) check_.missing_area += areas[m];
    }
  }

  void measure_distance() {
    const LayerCover cover(segments_);
    const std::vector<LayerSegment> solid = boundary(kSolidMask, cover),
                                    section = boundary(kSectionMask, cover);
    if (solid.empty() && section.empty()) return;
    check_.distance = std::max(directed_distance(solid, section), directed_distance(section, solid));
  }

  /// The pieces of the segments that separate what the layers of `mask` cover from what they don't: a segment
  /// of one slice may run within the other.
  std::vector<LayerSegment> boundary(LayerMask mask, const LayerCover& cover) const {
    std::vector<LayerSegment> pieces;
    for (const LayerSegment& s : segments_) {
      if ((mask & 1u << s.layer) == 0) continue;
      const Vec3 way = s.b - s.a;
      const double length = norm(way);
      if (length < kShortest * extent_) continue;
      const Vec3 beside = (kBeside * extent_ / length) * Vec3{-way.y, way.x, 0};
      const double count = std::ceil(length / (kPieceLength * extent_));
      for (double k = 0; k < count; ++k) {
        const Vec3 a = s.a + k / count * way, b = k + 1 < count ? s.a + (k + 1) / count * way : s.b;
        const Vec3 middle = 0.5 * (a + b);
        const bool left = (cover.at(middle + beside) & mask) != 0,
                   right = (cover.at(middle - beside) & mask) != 0;
        if (left != right) pieces.push_back({a, b, s.layer});
      }
    }
    return pieces;
  }

  static double directed_distance(const std::vector<LayerSegment>& from,
                                  const std::vector<LayerSegment>& to) {
    std::vector<Bounds> boxes;
    for (const LayerSegment& s : to) boxes.push_back(bounds_of(std::array<Vec3, 2>{s.a, s.b}));
    const BoxTree tree(boxes);
    double largest = 0;
    for (const LayerSegment& s : from)
      for (const Vec3& p : {s.a, 0.5 * (s.a + s.b), s.b})
        largest = std::max(
            largest, tree.nearest(p, [&](std::uint32_t i) { return squared_distance(p, to[i].a, to[i].b); }));
    return std::sqrt(largest);
  }

  const Surface& surface_;
  const PlaneSection& section_;
  double on_plane_;
  PlaneFrame frame_;
  std::vector<Vec3> projected_;  // surface points in the frame
  std::vector<LayerSegment> segments_;
  double extent_ = 0;  // diagonal of all segments
  PlaneCheck check_;
};

/// Of the surface's triangles and the sections' vertices.
Bounds common_box(const Surface& surface, const Sections& sections) {
  Bounds box = bounds_of_triangles(surface);
  for (const PlaneSection& s : sections.planes) box.join(bounds_of(s.vertices));
  return box;
}

/// REQUIRES: surface and sections of size 1, but for the planes, whose size `scale` knows.
SectionCheck check_at_unit(const Surface& surface, const Sections& sections, const UnitScale& scale,
                           const SectionCheckOptions& options) {
  SectionCheck check;
  const Bounds box = common_box(surface, sections);
  check.diagonal = box.diagonal();
  const Vec3 center = box.empty() ? Vec3{} : box.center();
  for (const PlaneSection& s : sections.planes) {
    PlaneCheck plane;
    if (s.normal != Vec3{} && is_finite(s.normal) && std::isfinite(s.offset)) {
      const UnitPlane at_unit = scale.to_unit(s.normal, s.offset);
      plane = PlaneJudge(surface, s, at_unit, center, options.on_plane * check.diagonal).run();
    }
    plane.plane = position_of(sections, static_cast<std::uint32_t>(check.planes.size()));
    check.planes.push_back(plane);
    check.section_area += plane.section_area;
    check.missing_area += plane.missing_area;
    check.extra_area += plane.extra_area;
    check.distance = std::max(check.distance, plane.distance);
  }
  return check;
}

double share(double part, double whole) { return part > 0 ? part / whole : 0; }

void scale_back(PlaneCheck& plane, const UnitScale& scale) {
  for (double* area : {&plane.section_area, &plane.surface_area, &plane.missing_area, &plane.extra_area})
    *area = scale.area(*area);
  for (double* length : {&plane.distance, &plane.off_plane}) *length = scale.length(*length);
}

}  // namespace

SectionCheck check_sections(const Surface& surface, const Sections& sections,
                            const SectionCheckOptions& options) {
  const UnitScale scale(common_box(surface, sections));
  Sections at_unit = sections;
  for (PlaneSection& s : at_unit.planes)
    for (Vec3& v : s.vertices) v = scale.to_unit(v);
  SectionCheck check = check_at_unit(scale.to_unit(surface), at_unit, scale, options);
  check.missing_share = share(check.missing_area, check.section_area);
  check.extra_share = share(check.extra_area, check.section_area);
  for (double* area : {&check.section_area, &check.missing_area, &check.extra_area})
    *area = scale.area(*area);
  for (double* length : {&check.distance, &check.diagonal}) *length = scale.length(*length);
  for (PlaneCheck& plane : check.planes) scale_back(plane, scale);
  return check;
}

}  // namespace crossloft
