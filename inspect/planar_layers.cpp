#include "planar_layers.h"

#include <algorithm>
#include <utility>

namespace crossloft {
namespace {

/// Lower end first.
LayerSegment upward(LayerSegment s) {
  if (s.b.y < s.a.y) std::swap(s.a, s.b);
  return s;
}

double x_at(const LayerSegment& s, double y) {
  if (y <= s.a.y) return s.a.x;
  if (y >= s.b.y) return s.b.x;
  return s.a.x + (y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x);
}

/// A segment's way through a strip.
struct Strand {
  double bottom = 0, top = 0;
  unsigned layer = 0;
};

class AreaSweep {
 public:
  AreaSweep(const std::vector<LayerSegment>& segments, double tolerance) : tolerance_(tolerance) {
    for (const LayerSegment& s : segments) {
      if (s.a.y == s.b.y) continue;
      segments_.push_back(upward(s));
      levels_.push_back(s.a.y);
      levels_.push_back(s.b.y);
    }
    std::sort(segments_.begin(), segments_.end(),
              [](const LayerSegment& s, const LayerSegment& t) { return s.a.y < t.a.y; });
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
  }

  std::array<double, 1u << kLayers> run() {
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
      const double low = levels_[i], high = levels_[i + 1];
      std::erase_if(active_, [low](const LayerSegment* s) { return s->b.y <= low; });
      while (next < segments_.size() && segments_[next].a.y <= low) active_.push_back(&segments_[next++]);
      strip(low, high);
    }
    return areas_;
  }

 private:
  void strip(double low, double high) {
    strands_.clear();
    for (const LayerSegment* s : active_) strands_.push_back({x_at(*s, low), x_at(*s, high), s->layer});
    std::sort(strands_.begin(), strands_.end(), [](const Strand& s, const Strand& t) {
      return s.bottom != t.bottom ? s.bottom < t.bottom : s.top < t.top;
    });
    cuts_ = {0.0, 1.0};
    find_crossings();
    std::sort(cuts_.begin(), cuts_.end());
    for (std::size_t k = 0; k + 1 < cuts_.size(); ++k)
      if (cuts_[k] < cuts_[k + 1])
        slab(0.5 * (cuts_[k] + cuts_[k + 1]), (cuts_[k + 1] - cuts_[k]) * (high - low));
  }

  /// Insertion sort by the upper end: each exchange is a crossing.
  void find_crossings() {
    for (std::size_t i = 1; i < strands_.size(); ++i)
      for (std::size_t j = i; j > 0 && strands_[j].top < strands_[j - 1].top; --j) {
        Strand &s = strands_[j - 1], &t = strands_[j];
        const double below = t.bottom - s.bottom, above = s.top - t.top;
        if (std::max(below, above) > tolerance_) cuts_.push_back(below / (below + above));
        std::swap(s, t);
      }
  }

  /// Adds a slab of the strip whose middle line is at the fraction `at` of its height.
  void slab(double at, double height) {
    middle_.clear();
    for (const Strand& s : strands_) middle_.push_back({s.bottom + at * (s.top - s.bottom), s.layer});
    std::sort(middle_.begin(), middle_.end());
    LayerMask cover = 0;
    for (std::size_t i = 0; i + 1 < middle_.size(); ++i) {
      cover ^= 1u << middle_[i].second;
      if (cover != 0) areas_[cover] += (middle_[i + 1].first - middle_[i].first) * height;
    }
  }

  double tolerance_;
  std::vector<LayerSegment> segments_;       // by lower end
  std::vector<double> levels_;               // of all ends, ascending
  std::vector<const LayerSegment*> active_;  // those that reach through the strip
  std::vector<Strand> strands_;
  std::vector<double> cuts_;  // fractions of the strip's height
  std::vector<std::pair<double, unsigned>> middle_;
  std::array<double, 1u << kLayers> areas_{};
};

std::vector<Bounds> boxes(const std::vector<LayerSegment>& segments) {
  std::vector<Bounds> out;
  for (const LayerSegment& s : segments) {
    out.emplace_back();
    out.back().add(s.a);
    out.back().add(s.b);
  }
  return out;
}

}  // namespace

std::array<double, 1u << kLayers> layer_areas(const std::vector<LayerSegment>& segments, double tolerance) {
  return AreaSweep(segments, tolerance).run();
}

LayerCover::LayerCover(const std::vector<LayerSegment>& segments)
    : segments_(segments), tree_(boxes(segments)) {}

LayerMask LayerCover::at(const Vec3& p) const {
  LayerMask cover = 0;
  const Bounds ray{p, {Bounds::kFar, p.y, p.z}};
  tree_.for_overlaps(ray, [&](std::uint32_t i) {
    const LayerSegment s = upward(segments_[i]);
    if (s.a.y <= p.y && p.y < s.b.y && x_at(s, p.y) > p.x) cover ^= 1u << s.layer;
  });
  return cover;
}

}  // namespace crossloft
