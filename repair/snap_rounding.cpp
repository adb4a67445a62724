/// Iterated snap rounding (Halperin and Packer, 2002): ends and crossings, rounded to the grid, are the hot
/// points. A segment that passes the unit square of a hot point is led through the point, and so are its
/// pieces, until none passes another. Rounding to hot points makes no segments cross (Guibas and Marimont,
/// 1998), and no hot point comes from it, so that the rerouting ends. That no crossing is left is looked at
/// in the end; one would be rounded in another pass.

#include "snap_rounding.h"

#include <algorithm>

#include "../geom/box_tree.h"

namespace crossloft {
namespace {

Bounds box_of(PlanarPoint a, PlanarPoint b) {
  const auto [x0, x1] = std::minmax(a.x, b.x);
  const auto [y0, y1] = std::minmax(a.y, b.y);
  Bounds box;
  box.low = {static_cast<double>(x0), static_cast<double>(y0), 0};
  box.high = {static_cast<double>(x1), static_cast<double>(y1), 0};
  return box;
}

BoxTree tree_of(const std::vector<SegmentPiece>& pieces) {
  std::vector<Bounds> boxes;
  for (const SegmentPiece& p : pieces) boxes.push_back(box_of(p.a, p.b));
  return BoxTree(boxes);
}

std::vector<PlanarPoint> crossings_of(const std::vector<SegmentPiece>& pieces, const Context& context) {
  std::vector<PlanarPoint> found;
  tree_of(pieces).for_pairs([&](std::uint32_t i, std::uint32_t j) {
    if (context.cancelled()) return;
    const SegmentPiece &p = pieces[i], &q = pieces[j];
    if (cross(p.a, p.b, q.a, q.b)) found.push_back(crossing_point(p.a, p.b, q.a, q.b));
  });
  return found;
}

void sort_unique(std::vector<PlanarPoint>& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

class HotPoints {
 public:
  explicit HotPoints(std::vector<PlanarPoint> points) : points_(std::move(points)), tree_(boxes()) {}

  /// Leads the piece through the hot points it passes, and its parts again.
  void route(SegmentPiece piece, std::vector<SegmentPiece>& out) const {
    const std::vector<PlanarPoint> on = passed(piece.a, piece.b);
    if (on.empty()) return out.push_back(piece);
    PlanarPoint from = piece.a;
    for (const PlanarPoint h : on) {
      route({from, h, piece.segment}, out);
      from = h;
    }
    route({from, piece.b, piece.segment}, out);
  }

 private:
  std::vector<Bounds> boxes() const {
    std::vector<Bounds> boxes;
    for (const PlanarPoint p : points_) boxes.push_back(box_of({p.x - 1, p.y - 1}, {p.x + 1, p.y + 1}));
    return boxes;
  }

  /// In order along ab.
  std::vector<PlanarPoint> passed(PlanarPoint a, PlanarPoint b) const {
    std::vector<PlanarPoint> on;
    tree_.for_overlaps(box_of(a, b), [&](std::uint32_t k) {
      const PlanarPoint h = points_[k];
      if (h != a && h != b && passes(a, b, h) && along(a, b, h) > 0 && along(b, a, h) > 0) on.push_back(h);
    });
    std::sort(on.begin(), on.end(), [&](PlanarPoint p, PlanarPoint q) {
      const std::int64_t s = along(a, b, p), t = along(a, b, q);
      return s != t ? s < t : p < q;
    });
    return on;
  }

  static std::int64_t along(PlanarPoint a, PlanarPoint b, PlanarPoint p) {
    return (b.x - a.x) * (p.x - a.x) + (b.y - a.y) * (p.y - a.y);
  }

  std::vector<PlanarPoint> points_;
  BoxTree tree_;
};

}  // namespace

std::vector<SegmentPiece> snap_round(std::span<const PlanarSegment> segments, const Context& context) {
  std::vector<SegmentPiece> pieces;
  std::vector<PlanarPoint> hot;
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    const auto& [a, b] = segments[s];
    hot.insert(hot.end(), {a, b});
    if (a != b) pieces.push_back({a, b, s});
  }
  if (pieces.empty()) return pieces;
  std::vector<PlanarPoint> fresh = crossings_of(pieces, context);
  do {
    hot.insert(hot.end(), fresh.begin(), fresh.end());
    sort_unique(hot);
    const HotPoints points(hot);
    std::vector<SegmentPiece> routed;
    for (const SegmentPiece& piece : pieces) {
      if (context.cancelled()) return pieces;
      points.route(piece, routed);
    }
    pieces = std::move(routed);
    fresh = crossings_of(pieces, context);
  } while (!fresh.empty());
  return pieces;
}

}  // namespace crossloft
