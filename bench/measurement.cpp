#include "measurement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "../io/svg.h"
#include "output.h"

namespace crossloft::bench {
namespace {

double seconds_of(const Contestant& contestant, std::size_t calls) {
  const auto start = std::chrono::steady_clock::now();
  contestant.run(calls);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t calls_for(const Contestant& contestant, double seconds, std::size_t calls) {
  if (seconds <= 0) return calls;
  double taken = seconds_of(contestant, calls);
  while (taken < seconds / 2) calls *= 2, taken = seconds_of(contestant, calls);
  return calls;
}

/// Different values in the order of their first appearance.
template <class Get>
std::vector<std::string> distinct(const std::vector<Measurement>& all, const Get& get) {
  std::vector<std::string> names;
  for (const Measurement& m : all)
    if (std::find(names.begin(), names.end(), get(m)) == names.end()) names.push_back(get(m));
  return names;
}

/// The strategies for which a measurement passes the test.
template <class Test>
std::vector<std::string> named(const std::vector<Measurement>& all, const Test& test) {
  std::vector<Measurement> passing;
  std::copy_if(all.begin(), all.end(), std::back_inserter(passing), test);
  return distinct(passing, [](const Measurement& m) { return m.strategy; });
}

std::vector<std::string> strategies_of(const std::vector<Measurement>& all) {
  return distinct(all, [](const Measurement& m) { return m.strategy; });
}

std::vector<std::vector<Measurement>> by_predicate(const std::vector<Measurement>& all) {
  std::vector<std::vector<Measurement>> groups;
  for (const std::string& name : distinct(all, [](const Measurement& m) { return m.predicate; })) {
    groups.emplace_back();
    for (const Measurement& m : all)
      if (m.predicate == name) groups.back().push_back(m);
  }
  return groups;
}

std::vector<std::string> distributions_of(const std::vector<Measurement>& group) {
  return distinct(group, [](const Measurement& m) { return m.distribution; });
}

/// cell(measurement) for every measurement of a row, under a line of column numbers.
template <class Cell>
void print_rows(const std::vector<Measurement>& group, const std::vector<std::string>& rows,
                const Cell& cell) {
  if (rows.empty()) return;
  std::printf("%-50s", "");
  for (std::size_t k = 0; k < distributions_of(group).size(); ++k)
    std::printf("%17s", ("(" + std::to_string(k + 1) + ")").c_str());
  std::printf("\n");
  for (const std::string& row : rows) {
    std::printf("%-50s", row.c_str());
    for (const Measurement& m : group)
      if (m.strategy == row) std::printf("%17s", cell(m).c_str());
    std::printf("\n");
  }
}

std::string time_cell(const Measurement& m) {
  char text[64];
  std::snprintf(text, sizeof text, m.nanoseconds < 1000 ? "%.1f (%.1fx)" : "%.0f (%.0fx)", m.nanoseconds,
                m.multiple);
  return text;
}

std::string percents(const std::vector<double>& shares) {
  std::string text;
  for (const double s : shares) {
    char number[16];
    std::snprintf(number, sizeof number, "%.0f", 100 * s);
    text += (text.empty() ? "" : "/") + std::string(number);
  }
  return text;
}

constexpr std::array<const char*, 8> kColours{"#1f77b4", "#ff7f0e", "#2ca02c", "#d62728",
                                              "#9467bd", "#8c564b", "#e377c2", "#17becf"};

/// Places in the drawing, y up, one unit a pixel.
struct Panel {
  static constexpr double kNames = 300, kPlot = 360, kRow = 14, kMargin = 20;
  static constexpr double kWidth = kNames + kPlot + 2 * kMargin;
  static constexpr double kDecades = 6;  // 1 ns to 1 ms
  Vec2 corner;                           // upper left

  double height(std::size_t rows, std::size_t legend) const {
    return (static_cast<double>(rows + legend) + 4) * kRow;
  }
  double x(double nanoseconds) const {
    return corner.x + kNames + kPlot * std::clamp(std::log10(nanoseconds) / kDecades, 0.0, 1.0);
  }
  double y(double row) const { return corner.y - row * kRow; }
};

void draw_axis(SvgWriter& svg, const Panel& panel, std::size_t rows) {
  const std::array<const char*, 7> labels{"1 ns", "10", "100", "1 us", "10", "100", "1 ms"};
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const double x = panel.x(std::pow(10.0, static_cast<double>(k)));
    SvgPath line(svg.map());
    line.move({x, panel.y(1.5)}).line({x, panel.y(static_cast<double>(rows) + 2)});
    svg.path(line, "stroke=\"#ccc\" fill=\"none\"");
    svg.text({x, panel.y(static_cast<double>(rows) + 3)}, {-8, 0}, labels[k],
             "font-size=\"9\" fill=\"#666\"");
  }
}

void draw_panel(SvgWriter& svg, const Panel& panel, const std::vector<Measurement>& group) {
  const auto names = strategies_of(group), sets = distributions_of(group);
  svg.text({panel.corner.x, panel.y(1)}, {0, 0}, group.front().predicate,
           "font-size=\"13\" font-weight=\"bold\"");
  draw_axis(svg, panel, names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    svg.text({panel.corner.x, panel.y(static_cast<double>(i) + 2.2)}, {0, 0}, names[i], "font-size=\"10\"");
  for (const Measurement& m : group) {
    const auto at = [](const auto& list, const std::string& name) {
      return static_cast<std::size_t>(std::find(list.begin(), list.end(), name) - list.begin());
    };
    const std::size_t colour = at(sets, m.distribution) % kColours.size();
    svg.dot({panel.x(m.nanoseconds), panel.y(static_cast<double>(at(names, m.strategy)) + 2)}, 3.5,
            "fill=\"" + std::string(kColours[colour]) + "\" fill-opacity=\"0.75\"",
            m.strategy + ", " + m.distribution + ": " + time_cell(m));
  }
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const double x = panel.corner.x + (i % 2 == 0 ? 0.0 : 0.5 * Panel::kWidth);
    const double y = panel.y(static_cast<double>(names.size() + i / 2) + 4);
    svg.dot({x + 4, y + 3}, 3.5, "fill=\"" + std::string(kColours[i % kColours.size()]) + "\"");
    svg.text({x + 12, y}, {0, 0}, sets[i], "font-size=\"10\"");
  }
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> take_turns(std::vector<Contestant> contestants, int repetitions, double turn_seconds,
                               std::size_t least_calls) {
  std::vector<std::size_t> calls;
  for (const Contestant& c : contestants) calls.push_back(calls_for(c, turn_seconds, least_calls));
  for (int round = 0; round < repetitions; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i)
      contestants[i].samples.push_back(1e9 * seconds_of(contestants[i], calls[i]) /
                                       static_cast<double>(calls[i]));
  std::vector<double> medians;
  for (Contestant& c : contestants) medians.push_back(median(std::move(c.samples)));
  return medians;
}

void print_tables(const std::vector<Measurement>& measurements) {
  for (const auto& group : by_predicate(measurements)) {
    std::printf("\n%s: nanoseconds a call (multiple of naive)\n", group.front().predicate.c_str());
    const auto sets = distributions_of(group);
    for (std::size_t k = 0; k < sets.size(); ++k) std::printf("  (%zu) %s", k + 1, sets[k].c_str());
    std::printf("\n");
    print_rows(group, strategies_of(group), time_cell);
    const auto staged =
        named(group, [](const Measurement& m) { return m.stages.size() > 1 || m.decided.back() > 0; });
    const auto naive = named(group, [](const Measurement& m) { return m.multiple == 1; });
    if (!staged.empty()) std::printf("decided by stage, and unknown, in %%\n");
    print_rows(group, staged, [](const Measurement& m) { return percents(m.decided); });
    std::printf("wrong, in %%\n");
    print_rows(group, naive, [](const Measurement& m) { return percents({m.wrong}); });
  }
}

std::string to_json(const std::vector<Measurement>& measurements) {
  std::string text = "[\n";
  for (const Measurement& m : measurements) {
    char numbers[128];
    std::snprintf(numbers, sizeof numbers, "\"nanoseconds\": %.6g, \"multiple\": %.6g, \"wrong\": %.6g",
                  m.nanoseconds, m.multiple, m.wrong);
    text += (text.size() > 2 ? ",\n" : "") + std::string("{\"predicate\": \"") + m.predicate +
            "\", \"distribution\": \"" + m.distribution + "\", \"strategy\": \"" + m.strategy + "\", " +
            numbers + ", \"stages\": " + json_strings(m.stages) +
            ", \"decided\": " + json_numbers(m.decided) + "}";
  }
  return text + "\n]\n";
}

std::string to_svg(const std::vector<Measurement>& measurements) {
  const auto groups = by_predicate(measurements);
  double tallest = 0;
  for (const auto& g : groups)
    tallest =
        std::max(tallest, Panel{}.height(strategies_of(g).size(), (distributions_of(g).size() + 1) / 2));
  const std::size_t lines = (groups.size() + 1) / 2;
  const Vec2 page{2 * Panel::kWidth + Panel::kMargin,
                  static_cast<double>(lines) * (tallest + Panel::kMargin) + Panel::kMargin};
  SvgWriter svg(PageMap({{0, 0}, page}, page.x), "Time of predicate strategies");
  svg.open_group("font-family=\"sans-serif\"");
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const double left = Panel::kMargin + static_cast<double>(i % 2) * Panel::kWidth;
    const double down = Panel::kMargin + static_cast<double>(i / 2) * (tallest + Panel::kMargin);
    draw_panel(svg, Panel{{left, page.y - down}}, groups[i]);
  }
  svg.close_group();
  return std::move(svg).finish();
}

}  // namespace crossloft::bench
