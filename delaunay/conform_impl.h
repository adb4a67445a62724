#pragma once
/// Implementation of conform.h; include that.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "conform.h"

namespace crossloft::detail {

/// One run of conform(). Works in rounds: all pieces that may be missing, in lexicographic order of their
/// ends. A split puts into the next round its two halves and the pieces whose edges it destroyed.
template <class P, class Split>
class Conformer {
 public:
  using Segment = std::array<std::uint32_t, 2>;

  Conformer(Delaunay2<P>& tri, Split& split, std::uint32_t limit) : tri_(tri), split_(split), limit_(limit) {}

  ConformResult run(std::vector<Segment>& segments) {
    start(segments);
    while (!candidates_.empty() && !result_.limit_reached) round();
    report(segments);
    return std::move(result_);
  }

 private:
  struct Piece {
    std::uint32_t a, b;  ///< in the direction of the segment
    std::uint32_t source;
    std::uint32_t next;  ///< piece that follows it on the segment
    bool given_up;
  };

  void start(const std::vector<Segment>& segments);
  void prepare_splits();
  void find_sharp_corners(const std::vector<Segment>& segments);
  bool is_sharp(const Segment* begin, const Segment* end) const;
  void round();
  bool is_missing(const Piece& p) const { return !p.given_up && !tri_.has_edge(p.a, p.b); }
  bool comes_before(std::uint32_t k, std::uint32_t l) const;
  void split_piece(std::uint32_t k);
  SplitRequest request(const Piece& p) const;
  bool makes_progress(const Piece& p, std::uint32_t v) const;
  void replace_piece(std::uint32_t k, std::uint32_t v);
  void remember(std::uint32_t k);
  void report(std::vector<Segment>& segments);

  /// The same for both directions.
  static std::uint64_t ends_key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
  bool sharp(std::uint32_t v) const { return v < sharp_.size() && sharp_[v]; }
  std::pair<std::uint32_t, std::uint32_t> in_order(const Piece& p) const {
    return tri_.predicates().compare_lex(p.a, p.b) < 0 ? std::pair(p.a, p.b) : std::pair(p.b, p.a);
  }

  Delaunay2<P>& tri_;
  Split& split_;
  const std::uint32_t limit_;
  ConformResult result_;
  std::vector<Piece> pieces_;  ///< first one per segment, then those split off
  std::size_t segment_count_ = 0;
  std::vector<bool> sharp_;  ///< vertices where two segments meet at an acute angle
  std::vector<std::uint32_t> candidates_;
  /// Pieces by their ends, looked up only. Stale entries are harmless: a candidate is tested again.
  std::unordered_multimap<std::uint64_t, std::uint32_t> by_ends_;
};

template <class P, class Split>
void Conformer<P, Split>::start(const std::vector<Segment>& segments) {
  segment_count_ = segments.size();
  pieces_.reserve(segment_count_);
  for (std::uint32_t k = 0; k < segment_count_; ++k) {
    const auto [a, b] = segments[k];
    pieces_.push_back({a, b, k, kNone, a == b});
    if (is_missing(pieces_[k])) candidates_.push_back(k);
  }
}

/// What only splits need. REQUIRES: nothing is split yet.
template <class P, class Split>
void Conformer<P, Split>::prepare_splits() {
  std::vector<Segment> segments;
  segments.reserve(segment_count_);
  by_ends_.reserve(segment_count_ + segment_count_ / 4);
  for (std::uint32_t k = 0; k < segment_count_; ++k) {
    segments.push_back({pieces_[k].a, pieces_[k].b});
    remember(k);
  }
  find_sharp_corners(segments);
}

template <class P, class Split>
void Conformer<P, Split>::remember(std::uint32_t k) {
  by_ends_.emplace(ends_key(pieces_[k].a, pieces_[k].b), k);
}

// ---- corners

template <class P, class Split>
void Conformer<P, Split>::find_sharp_corners(const std::vector<Segment>& segments) {
  std::vector<Segment> spokes;
  for (const auto& [a, b] : segments) {
    spokes.push_back({a, b});
    spokes.push_back({b, a});
  }
  std::sort(spokes.begin(), spokes.end());
  for (std::size_t i = 0, end = 0; i < spokes.size(); i = end) {
    while (end < spokes.size() && spokes[end][0] == spokes[i][0]) ++end;
    const std::uint32_t corner = spokes[i][0];
    if (corner >= sharp_.size()) sharp_.resize(std::size_t{corner} + 1);
    sharp_[corner] = is_sharp(spokes.data() + i, spokes.data() + end);
  }
}

/// True iff two of the spokes of a corner enclose less than 90 degrees; of five, two always do.
template <class P, class Split>
bool Conformer<P, Split>::is_sharp(const Segment* begin, const Segment* end) const {
  if (end - begin > 4) return true;
  const P& p = tri_.predicates();
  for (const Segment* s = begin; s != end; ++s)
    for (const Segment* t = begin; t != s; ++t) {
      const double legs = p.squared_distance((*s)[0], (*s)[1]) + p.squared_distance((*t)[0], (*t)[1]);
      if (p.squared_distance((*s)[1], (*t)[1]) < legs) return true;
    }
  return false;
}

// ---- rounds

template <class P, class Split>
void Conformer<P, Split>::round() {
  std::vector<std::uint32_t> missing;
  missing.swap(candidates_);
  std::sort(missing.begin(), missing.end());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  std::erase_if(missing, [&](std::uint32_t k) { return !is_missing(pieces_[k]); });
  std::sort(missing.begin(), missing.end(), [&](auto k, auto l) { return comes_before(k, l); });
  for (const std::uint32_t k : missing) {
    if (!is_missing(pieces_[k])) continue;  // a split of this round brought it back
    result_.limit_reached = result_.splits >= limit_;
    if (result_.limit_reached) return;
    split_piece(k);
  }
}

template <class P, class Split>
bool Conformer<P, Split>::comes_before(std::uint32_t k, std::uint32_t l) const {
  const auto [k0, k1] = in_order(pieces_[k]);
  const auto [l0, l1] = in_order(pieces_[l]);
  if (const int sign = tri_.predicates().compare_lex(k0, l0)) return sign < 0;
  if (const int sign = tri_.predicates().compare_lex(k1, l1)) return sign < 0;
  return k < l;
}

template <class P, class Split>
void Conformer<P, Split>::split_piece(std::uint32_t k) {
  if (by_ends_.empty()) prepare_splits();
  const std::uint32_t made = split_(request(pieces_[k]));
  if (made == kNone) {
    pieces_[k].given_up = true;
    return;
  }
  const std::uint32_t v = tri_.insert(made, pieces_[k].a);
  for (const auto& [a, b] : tri_.removed_edges()) {
    const auto [begin, end] = by_ends_.equal_range(ends_key(a, b));
    for (auto it = begin; it != end; ++it) candidates_.push_back(it->second);
  }
  if (!makes_progress(pieces_[k], v)) {
    pieces_[k].given_up = true;
    return;
  }
  ++result_.splits;
  replace_piece(k, v);
}

/// Around an acute corner on a shell, otherwise in the middle. If both ends are acute the middle comes first,
/// and each half has its own shells.
template <class P, class Split>
SplitRequest Conformer<P, Split>::request(const Piece& p) const {
  SplitRequest request;
  std::tie(request.from, request.to) = in_order(p);
  if (sharp(p.a) != sharp(p.b)) {
    request.from = sharp(p.a) ? p.a : p.b;
    request.to = sharp(p.a) ? p.b : p.a;
    request.shell = true;
    request.t = shell_fraction(std::sqrt(tri_.predicates().squared_distance(p.a, p.b)));
  }
  request.segment = p.source;
  request.reversed = request.from != p.a;
  return request;
}

template <class P, class Split>
bool Conformer<P, Split>::makes_progress(const Piece& p, std::uint32_t v) const {
  if (v == p.a || v == p.b) return false;
  const P& points = tri_.predicates();
  const double length = points.squared_distance(p.a, p.b);
  return points.squared_distance(p.a, v) < length && points.squared_distance(v, p.b) < length;
}

template <class P, class Split>
void Conformer<P, Split>::replace_piece(std::uint32_t k, std::uint32_t v) {
  const auto added = static_cast<std::uint32_t>(pieces_.size());
  pieces_.push_back({v, pieces_[k].b, pieces_[k].source, pieces_[k].next, false});
  pieces_[k].b = v;
  pieces_[k].next = added;
  for (const std::uint32_t piece : {k, added}) {
    remember(piece);
    candidates_.push_back(piece);
  }
}

template <class P, class Split>
void Conformer<P, Split>::report(std::vector<Segment>& segments) {
  segments.clear();
  segments.reserve(pieces_.size());
  result_.source.reserve(pieces_.size());
  const bool untouched =
      by_ends_.empty() && !result_.limit_reached;  // all were edges at the start, but for those given up
  for (std::uint32_t s = 0; s < segment_count_; ++s)
    for (std::uint32_t k = s; k != kNone; k = pieces_[k].next) {
      const Piece& p = pieces_[k];
      if ((!untouched || p.given_up) && !tri_.has_edge(p.a, p.b))
        result_.failed.push_back(static_cast<std::uint32_t>(segments.size()));
      segments.push_back({p.a, p.b});
      result_.source.push_back(s);
    }
}

}  // namespace crossloft::detail

namespace crossloft {

template <MetricPredicates2 P, class Split>
ConformResult conform(Delaunay2<P>& tri, std::vector<std::array<std::uint32_t, 2>>& segments, Split&& split,
                      std::uint32_t limit) {
  return detail::Conformer<P, std::remove_reference_t<Split>>(tri, split, limit).run(segments);
}

}  // namespace crossloft
