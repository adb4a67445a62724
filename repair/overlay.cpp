#include "overlay.h"

#include <algorithm>
#include <tuple>

#include "snap_rounding.h"

namespace crossloft {
namespace {

/// All pieces in one place.
struct Link {
  PlanarPoint a, b;                   ///< a < b
  std::uint32_t segment = 0;          ///< the first of them
  bool forward = true;                ///< that one leads from a to b
  std::vector<std::uint32_t> layers;  ///< of which an odd number of pieces is here, ascending
};

void toggle(std::vector<std::uint32_t>& layers, std::uint32_t layer) {
  const auto at = std::lower_bound(layers.begin(), layers.end(), layer);
  if (at != layers.end() && *at == layer)
    layers.erase(at);
  else
    layers.insert(at, layer);
}

std::vector<Link> links_of(std::span<const OverlaySegment> segments, const Context& context) {
  std::vector<PlanarSegment> plain;
  for (const OverlaySegment& s : segments) plain.push_back({s.a, s.b});
  std::vector<SegmentPiece> pieces = snap_round(plain, context);
  std::stable_sort(pieces.begin(), pieces.end(), [](const SegmentPiece& p, const SegmentPiece& q) {
    return std::pair(std::minmax(p.a, p.b), p.segment) < std::pair(std::minmax(q.a, q.b), q.segment);
  });
  std::vector<Link> links;
  for (const SegmentPiece& p : pieces) {
    const auto [a, b] = std::minmax(p.a, p.b);
    if (links.empty() || links.back().a != a || links.back().b != b)
      links.push_back({a, b, p.segment, p.a == a, {}});
    toggle(links.back().layers, segments[p.segment].layer);
  }
  std::erase_if(links, [](const Link& l) { return l.layers.empty(); });
  return links;
}

PlanarPoint flipped(PlanarPoint p) { return {p.y, p.x}; }

/// Which layers are odd at one side of a link.
class Sides {
 public:
  Sides(const std::vector<Link>& links, std::span<const LayerKind> layers)
      : links_(links), layers_(layers), odd_(layers.size()) {}

  /// True iff inside and outside meet at the link.
  bool is_boundary(const Link& link) {
    std::fill(odd_.begin(), odd_.end(), std::uint8_t{0});
    const bool upright = link.a.x == link.b.x;
    const auto at = [&](PlanarPoint p) { return upright ? flipped(p) : p; };
    const PlanarPoint p = at(link.a), q = at(link.b);
    const PlanarPoint middle{p.x + q.x, p.y + q.y};  // doubled
    for (const Link& other : links_)
      if (&other != &link && is_above(at(other.a), at(other.b), middle)) flip(other);
    const bool one_side = inside();
    flip(link);
    return inside() != one_side;
  }

 private:
  void flip(const Link& link) {
    for (const std::uint32_t layer : link.layers) odd_[layer] ^= 1;
  }
  bool inside() const {
    bool in = false;
    for (std::size_t l = 0; l < layers_.size(); ++l) {
      if (odd_[l] && layers_[l] == LayerKind::removed) return false;
      in = in || odd_[l];
    }
    return in;
  }

  const std::vector<Link>& links_;
  std::span<const LayerKind> layers_;
  std::vector<std::uint8_t> odd_;
};

struct Box {
  PlanarPoint low{kPlanarLimit + 1, kPlanarLimit + 1}, high{-kPlanarLimit - 1, -kPlanarLimit - 1};
  void add(PlanarPoint p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool meets(const Link& l) const {
    return std::min(l.a.x, l.b.x) <= high.x && std::max(l.a.x, l.b.x) >= low.x &&
           std::min(l.a.y, l.b.y) <= high.y && std::max(l.a.y, l.b.y) >= low.y;
  }
};

/// By layer but the first: where it may change what the first says.
std::vector<Box> boxes_of(const std::vector<Link>& links, std::size_t layers) {
  std::vector<Box> boxes(layers);
  for (const Link& l : links)
    for (const std::uint32_t layer : l.layers) boxes[layer].add(l.a), boxes[layer].add(l.b);
  if (!boxes.empty()) boxes.erase(boxes.begin());
  return boxes;
}

}  // namespace

std::vector<OverlayEdge> overlay(std::span<const OverlaySegment> segments, std::span<const LayerKind> layers,
                                 const Context& context) {
  std::vector<Link> links = links_of(segments, context);
  const std::vector<Box> boxes = boxes_of(links, layers.size());
  Sides sides(links, layers);
  std::vector<OverlayEdge> edges;
  for (const Link& l : links) {
    if (context.cancelled()) return {};
    const bool alone = l.layers == std::vector<std::uint32_t>{0} && layers[0] == LayerKind::section &&
                       std::none_of(boxes.begin(), boxes.end(), [&](const Box& b) { return b.meets(l); });
    if (alone || sides.is_boundary(l))
      edges.push_back(l.forward ? OverlayEdge{l.a, l.b, l.segment} : OverlayEdge{l.b, l.a, l.segment});
  }
  const auto along = [&](const OverlayEdge& e) {
    const OverlaySegment& s = segments[e.segment];
    return (s.b.x - s.a.x) * (e.a.x - s.a.x) + (s.b.y - s.a.y) * (e.a.y - s.a.y);
  };
  std::sort(edges.begin(), edges.end(), [&](const OverlayEdge& d, const OverlayEdge& e) {
    return std::tuple(d.segment, along(d), d.a, d.b) < std::tuple(e.segment, along(e), e.a, e.b);
  });
  return edges;
}

}  // namespace crossloft
