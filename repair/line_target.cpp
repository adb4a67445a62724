#include "line_target.h"

#include <algorithm>
#include <cmath>

namespace crossloft {
namespace {

void sort_unique(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// How the blend is led to that of a contested point.
struct Lead {
  double at = 0, rise = 0, reach = 0;
  double operator()(double t) const { return rise * std::max(0.0, 1 - std::fabs(t - at) / reach); }
};

class Blend {
 public:
  Blend(const LineSetting& setting, const CommonLine& line, std::span<const Trace> traces)
      : setting_(setting), line_(line), traces_(traces) {}

  /// Mean of the distances, without what leads to contested points.
  double mean(double t) const {
    double sum = 0;
    for (std::size_t k = 0; k < traces_.size(); ++k)
      sum += distance_at(setting_, line_.planes[k], traces_[k], line_.at(t), t);
    return sum / static_cast<double>(traces_.size());
  }

  std::vector<Lead> leads(std::span<const ContestedPoint* const> contested) const {
    std::vector<std::pair<double, double>> points;
    for (const ContestedPoint* c : contested) points.push_back({line_.parameter(c->point.point), c->blend});
    std::sort(points.begin(), points.end());
    std::vector<Lead> found;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto [t, wanted] = points[k];
      const double rise = wanted - mean(t);
      double reach = std::fabs(rise);
      if (k > 0) reach = std::min(reach, (t - points[k - 1].first) / 2);
      if (k + 1 < points.size()) reach = std::min(reach, (points[k + 1].first - t) / 2);
      if ((wanted < 0) != (wanted - rise < 0) && reach > 0) found.push_back({t, rise, reach});
    }
    return found;
  }

 private:
  const LineSetting& setting_;
  const CommonLine& line_;
  std::span<const Trace> traces_;
};

std::vector<double> nodes_of(const LineSetting& setting, const CommonLine& line,
                             std::span<const Trace> traces, const std::vector<Lead>& leads,
                             std::span<const ContestedPoint* const> contested) {
  std::vector<double> nodes;
  const double steps = std::ceil(2 * line.reach / setting.spacing);
  for (double k = 0; k <= steps; ++k) nodes.push_back(line.reach * (2 * k / steps - 1));
  for (const Trace& trace : traces) nodes.insert(nodes.end(), trace.cuts.begin(), trace.cuts.end());
  for (const ContestedPoint* c : contested) nodes.push_back(line.parameter(c->point.point));
  for (const Lead& l : leads) nodes.insert(nodes.end(), {l.at - l.reach, l.at + l.reach});
  sort_unique(nodes);
  return nodes;
}

void add_span(std::vector<TargetSpan>& spans, double begin, double end, Inside state) {
  if (!spans.empty() && spans.back().state == state)
    spans.back().end = end;
  else
    spans.push_back({begin, end, state});
}

/// Cut where the blend is 0.
std::vector<TargetSpan> spans_of(const std::vector<double>& nodes, const std::vector<double>& blend) {
  std::vector<TargetSpan> spans;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const double t0 = nodes[k], t1 = nodes[k + 1], g0 = blend[k], g1 = blend[k + 1];
    if (g0 == 0 && g1 == 0) {
      add_span(spans, t0, t1, Inside::either);
    } else if ((g0 < 0 && g1 > 0) || (g0 > 0 && g1 < 0)) {
      const double cut = std::clamp(t0 + (t1 - t0) * (g0 / (g0 - g1)), t0, t1);
      add_span(spans, t0, cut, g0 < 0 ? Inside::yes : Inside::no);
      add_span(spans, cut, t1, g1 < 0 ? Inside::yes : Inside::no);
    } else {
      add_span(spans, t0, t1, g0 < 0 || g1 < 0 ? Inside::yes : Inside::no);
    }
  }
  return spans;
}

/// Spans shorter than `least` that some section contradicts are left out: contours would touch there.
void drop_short_spans(std::vector<TargetSpan>& spans, std::span<const Trace> traces, double least) {
  std::vector<TargetSpan> kept;
  for (std::size_t k = 0; k < spans.size(); ++k) {
    const TargetSpan& s = spans[k];
    const bool contradicted = std::any_of(
        traces.begin(), traces.end(), [&](const Trace& t) { return t.between(s.begin, s.end) != s.state; });
    const bool drop = k > 0 && k + 1 < spans.size() && s.end - s.begin < least && contradicted;
    add_span(kept, s.begin, s.end, drop ? kept.back().state : s.state);
  }
  spans = std::move(kept);
}

}  // namespace

double LineTarget::blend_at(double t) const {
  const auto next = static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), t) - nodes.begin());
  if (next == 0) return blend.front();
  if (next == nodes.size()) return blend.back();
  const double s = (t - nodes[next - 1]) / (nodes[next] - nodes[next - 1]);
  return blend[next - 1] + s * (blend[next] - blend[next - 1]);
}

double distance_at(const LineSetting& setting, std::uint32_t plane, const Trace& trace, Vec3 p, double t) {
  const double distance = std::min(setting.sections[plane].distance(p), setting.far);
  const Inside state = trace.between(t, t);
  if (distance <= setting.on || state == Inside::either) return 0;
  return state == Inside::yes ? -distance : distance;
}

bool contradict(std::span<const Trace> traces, double least) {
  std::vector<double> cuts;
  for (const Trace& t : traces) cuts.insert(cuts.end(), t.cuts.begin(), t.cuts.end());
  sort_unique(cuts);
  const auto comes_and_goes = [&](double begin, double end) {
    return std::any_of(traces.begin(), traces.end(), [&](const Trace& t) {
      return std::binary_search(t.cuts.begin(), t.cuts.end(), begin) &&
             std::binary_search(t.cuts.begin(), t.cuts.end(), end);
    });
  };
  std::size_t begin = 0;  // of the stretch that ends at the next cut
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    bool in = false, out = false;
    for (const Trace& t : traces) {
      const Inside state = t.between(cuts[k], cuts[k + 1]);
      in |= state == Inside::yes, out |= state == Inside::no;
    }
    if (!(in && out))
      begin = k + 1;
    else if (cuts[k + 1] - cuts[begin] >= least || comes_and_goes(cuts[begin], cuts[k + 1]))
      return true;
  }
  return false;
}

LineTarget line_target(const LineSetting& setting, const CommonLine& line, std::span<const Trace> traces,
                       std::span<const ContestedPoint* const> contested) {
  const Blend blend(setting, line, traces);
  const std::vector<Lead> leads = blend.leads(contested);
  LineTarget target;
  target.nodes = nodes_of(setting, line, traces, leads, contested);
  for (const double t : target.nodes) {
    double g = blend.mean(t);
    for (const Lead& lead : leads) g += lead(t);
    target.blend.push_back(g);
  }
  target.spans = spans_of(target.nodes, target.blend);
  drop_short_spans(target.spans, traces, setting.least);
  return target;
}

std::vector<Misfit> misfits(const LineSetting& setting, const CommonLine& line, std::uint32_t plane,
                            const Trace& trace, const LineTarget& target, const TargetSpan& span) {
  std::vector<Misfit> found;
  if (span.state == Inside::either) return found;
  const auto contradicts = [&](double t0, double t1) {
    const Inside state = trace.between(t0, t1);
    return state != Inside::either && state != span.state;
  };
  const auto depth = [&](double t) { return std::fabs(distance_at(setting, plane, trace, line.at(t), t)); };
  double from = span.begin;
  const auto close_piece = [&](double to) {
    if (to > from && contradicts(from, to)) {
      if (found.empty() || found.back().end < from) found.push_back({from, to, 0});
      found.back().end = to;
      found.back().depth = std::max({found.back().depth, depth(from), depth(to)});
    }
    from = to;
  };
  for (const double t : target.nodes)
    if (t > span.begin && t < span.end) close_piece(t);
  close_piece(span.end);
  return found;
}

}  // namespace crossloft
