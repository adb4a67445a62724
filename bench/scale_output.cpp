#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <functional>

#include "scale.h"

namespace crossloft::bench {
namespace {

__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...) {
  char text[512];
  std::va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

double grown(const ScaleSeries& s, const ScalePoint& p) {
  return s.grows == "planes" ? p.planes : static_cast<double>(p.vertices);
}

constexpr double kWidth = 280, kHeight = 170, kLeft = 60, kTop = 40, kGap = 90;

/// Decades that hold all the values.
struct Axis {
  double low = 1, high = 10;
  explicit Axis(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low = std::pow(10, std::floor(std::log10(*least)));
    high = std::pow(10, std::ceil(std::log10(std::max(*most, 1.01 * low))));
  }
  double at(double v) const { return std::log10(v / low) / std::log10(high / low); }
};

std::string power(double v) {
  const int e = static_cast<int>(std::lround(std::log10(v)));
  return e >= -2 && e <= 4 ? format("%g", v) : format("10<tspan dy='-5' font-size='9'>%d</tspan>", e);
}

/// One diagram: a line for each number of threads.
class Panel {
 public:
  Panel(const ScaleSeries& series, double left, double top, const std::string& unit,
        const std::function<double(const ScalePoint&)>& value)
      : series_(series), left_(left), top_(top), unit_(unit), value_(value), x_(all(true)), y_(all(false)) {}

  std::string draw() const {
    std::string svg = frame();
    for (const unsigned threads : {1U, 2U}) svg += line(threads);
    return svg;
  }

 private:
  std::vector<double> all(bool across) const {
    std::vector<double> values;
    for (const ScalePoint& p : series_.points)
      values.push_back(std::max(across ? grown(series_, p) : value_(p), 1e-6));
    return values;
  }
  double px(double v) const { return left_ + kWidth * x_.at(v); }
  double py(double v) const { return top_ + kHeight * (1 - y_.at(v)); }

  std::string frame() const {
    std::string svg = format("<text x='%g' y='%g' font-weight='bold'>%s: %s</text>", left_, top_ - 10,
                             series_.name.c_str(), unit_.c_str());
    for (double v = x_.low; v <= x_.high * 1.001; v *= 10)
      svg += format("<path d='M%.1f %.1fv%g' stroke='#ddd'/>", px(v), top_, kHeight) +
             format("<text x='%.1f' y='%.1f' text-anchor='middle'>", px(v), top_ + kHeight + 16) + power(v) +
             "</text>";
    for (double v = y_.low; v <= y_.high * 1.001; v *= 10)
      svg += format("<path d='M%.1f %.1fh%g' stroke='#ddd'/>", left_, py(v), kWidth) +
             format("<text x='%.1f' y='%.1f' text-anchor='end'>", left_ - 6, py(v) + 4) + power(v) +
             "</text>";
    return svg + format("<text x='%.1f' y='%.1f' text-anchor='middle'>%s</text>", left_ + kWidth / 2,
                        top_ + kHeight + 34, series_.grows.c_str());
  }

  std::string line(unsigned threads) const {
    const char* colour = threads == 1 ? "#1f5fa8" : "#c2571a";
    std::string path, dots;
    for (const ScalePoint& p : series_.points) {
      if (p.threads != threads) continue;
      const double x = px(grown(series_, p)), y = py(value_(p));
      path += format("%s%.1f %.1f", path.empty() ? "M" : "L", x, y);
      dots += format("<circle cx='%.1f' cy='%.1f' r='3' fill='%s'/>", x, y, colour);
    }
    if (path.empty()) return {};
    return format("<path fill='none' stroke='%s' stroke-width='1.5' d='", colour) + path + "'/>" + dots;
  }

  const ScaleSeries& series_;
  double left_, top_;
  std::string unit_;
  std::function<double(const ScalePoint&)> value_;
  Axis x_, y_;
};

std::string row(const ScalePoint& p) {
  return format("| %u | %llu | %llu | %llu | %u | %.3g | %.3g | %.0f |\n", p.planes,
                static_cast<unsigned long long>(p.vertices), static_cast<unsigned long long>(p.cells),
                static_cast<unsigned long long>(p.tetrahedra), p.threads, p.seconds, p.processor,
                p.megabytes);
}

}  // namespace

std::string to_markdown(const std::vector<ScaleSeries>& series) {
  std::string text;
  for (const ScaleSeries& s : series) {
    text += "**" + s.name +
            "**\n\n| planes | vertices | cells | tetrahedra | threads | seconds | processor | MB |\n" +
            "|---|---|---|---|---|---|---|---|\n";
    for (const ScalePoint& p : s.points) text += row(p);
    text += "\n";
  }
  return text;
}

std::string to_svg(const std::vector<ScaleSeries>& series) {
  const double width = kLeft + 2 * (kWidth + kGap),
               height = kTop + static_cast<double>(series.size()) * (kHeight + 80);
  std::string svg = format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='%g' height='%g' font-family='sans-serif' "
      "font-size='12'>"
      "<rect width='100%%' height='100%%' fill='white'/>",
      width, height + 10);
  double top = kTop;
  for (const ScaleSeries& s : series) {
    svg += Panel(s, kLeft, top, "seconds", [](const ScalePoint& p) { return p.seconds; }).draw();
    svg += Panel(s, kLeft + kWidth + kGap, top, "MB at most", [](const ScalePoint& p) {
             return p.megabytes;
           }).draw();
    top += kHeight + 80;
  }
  return svg + format(
                   "<text x='%g' y='%g' fill='#1f5fa8'>one thread</text><text x='%g' y='%g' "
                   "fill='#c2571a'>two</text></svg>\n",
                   kLeft, height, kLeft + 80, height);
}

}  // namespace crossloft::bench
