#include "contour_tracing.h"

#include <algorithm>
#include <utility>

namespace crossloft {
namespace {

using Segment = std::array<std::uint32_t, 2>;

class Tracer {
 public:
  explicit Tracer(const std::vector<std::array<Vec3, 2>>& segments) {
    number_points(segments);
    number_segments(segments);
    cancel_pairs();
    connect();
  }

  void run(PlaneSection& section) {
    for (std::uint32_t node = 0; node < points_.size(); ++node)
      while (next_free(node) != kNone) walk(node, section);
  }

 private:
  void number_points(const std::vector<std::array<Vec3, 2>>& segments) {
    for (const auto& s : segments) points_.insert(points_.end(), s.begin(), s.end());
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  std::uint32_t number_of(const Vec3& p) const {
    return static_cast<std::uint32_t>(std::lower_bound(points_.begin(), points_.end(), p) - points_.begin());
  }

  void number_segments(const std::vector<std::array<Vec3, 2>>& segments) {
    for (const auto& [p, q] : segments) {
      const std::uint32_t a = number_of(p), b = number_of(q);
      if (a != b) segments_.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(segments_.begin(), segments_.end());
  }

  /// Two equal segments bound nothing: the material is the same on their outer sides.
  void cancel_pairs() {
    std::vector<Segment> odd;
    for (const Segment& s : segments_) {
      if (!odd.empty() && odd.back() == s)
        odd.pop_back();
      else
        odd.push_back(s);
    }
    segments_ = std::move(odd);
  }

  void connect() {
    first_.assign(points_.size() + 1, 0);
    for (const auto& [a, b] : segments_) ++first_[a], ++first_[b];
    std::uint32_t sum = 0;
    for (std::uint32_t& f : first_) sum += std::exchange(f, sum);
    at_.resize(sum);
    cursor_.assign(first_.begin(), first_.end() - 1);
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      for (const std::uint32_t end : segments_[s]) at_[cursor_[end]++] = s;
    cursor_.assign(first_.begin(), first_.end() - 1);
    used_.assign(segments_.size(), false);
    place_.assign(points_.size(), kNone);
    vertex_.assign(points_.size(), kNone);
  }

  std::uint32_t next_free(std::uint32_t node) {
    while (cursor_[node] < first_[node + 1] && used_[at_[cursor_[node]]]) ++cursor_[node];
    return cursor_[node] < first_[node + 1] ? at_[cursor_[node]] : kNone;
  }

  /// Follows free segments from `start`; whenever the path meets itself, that loop is cut off and written.
  void walk(std::uint32_t start, PlaneSection& section) {
    std::vector<std::uint32_t> path{start};
    place_[start] = 0;
    for (std::uint32_t s = next_free(start); s != kNone; s = next_free(path.back())) {
      used_[s] = true;
      const std::uint32_t to = segments_[s][0] == path.back() ? segments_[s][1] : segments_[s][0];
      if (place_[to] == kNone) {
        place_[to] = static_cast<std::uint32_t>(path.size());
        path.push_back(to);
      } else {
        cut_loop(path, place_[to], section);
      }
    }
    for (const std::uint32_t node : path) place_[node] = kNone;
  }

  void cut_loop(std::vector<std::uint32_t>& path, std::uint32_t from, PlaneSection& section) {
    for (std::size_t i = from; i < path.size(); ++i) {
      const std::uint32_t a = emit(path[i], section);
      const std::uint32_t b = emit(i + 1 < path.size() ? path[i + 1] : path[from], section);
      section.edges.push_back({a, b, 1, 0, loops_, 0});
    }
    ++loops_;
    for (std::size_t i = from + 1; i < path.size(); ++i) place_[path[i]] = kNone;
    path.resize(from + 1);
  }

  std::uint32_t emit(std::uint32_t node, PlaneSection& section) {
    if (vertex_[node] == kNone) {
      vertex_[node] = static_cast<std::uint32_t>(section.vertices.size());
      section.vertices.push_back(points_[node]);
    }
    return vertex_[node];
  }

  std::vector<Vec3> points_;               // distinct, ascending
  std::vector<Segment> segments_;          // low point first, ascending, distinct
  std::vector<std::uint32_t> first_, at_;  // segments at point p: at_[first_[p] .. first_[p + 1])
  std::vector<std::uint32_t> cursor_;      // per point, the first entry of at_ that may be free
  std::vector<std::uint32_t> place_;       // per point, position on the current path
  std::vector<std::uint32_t> vertex_;      // per point, number in the section
  std::vector<bool> used_;
  std::uint32_t loops_ = 0;
};

}  // namespace

void trace_contours(const std::vector<std::array<Vec3, 2>>& segments, PlaneSection& section) {
  Tracer(segments).run(section);
}

}  // namespace crossloft
