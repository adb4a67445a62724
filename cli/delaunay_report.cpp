#include "delaunay_report.h"

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "../io/triangulation_cells.h"

namespace crossloft::cli {
namespace {

using Json = nlohmann::ordered_json;

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection in which every bit reaches all.
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

template <std::size_t K>
std::uint64_t hash_of(std::array<std::uint32_t, K> corners) {
  std::sort(corners.begin(), corners.end());
  std::uint64_t hash = 0;
  for (const std::uint32_t v : corners) hash = mixed(hash + v + 0x9e3779b97f4a7c15u);
  return hash;
}

std::string hex(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016" PRIx64, value);
  return text;
}

}  // namespace

std::uint64_t simplex_hash(const Triangulation& triangulation) {
  return visit_cells(triangulation, [](const auto& cells) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) sum += hash_of(cells[i]);
    return sum;
  });
}

DelaunayReport describe(const Triangulation& triangulation, bool weighted) {
  DelaunayReport report;
  report.points = triangulation.kept.size();
  report.dimension = triangulation.dimension;
  report.simplices = visit_cells(triangulation, [](const auto& cells) { return cells.size(); });
  for (std::uint32_t i = 0; i < report.points; ++i) {
    const std::uint32_t vertex = triangulation.kept[i];
    report.hidden += vertex == kNone ? 1 : 0;
    report.duplicates += vertex != kNone && vertex != i ? 1 : 0;
  }
  report.weighted = weighted;
  report.hash = simplex_hash(triangulation);
  return report;
}

std::string delaunay_json(const DelaunayReport& report, const std::string& file) {
  Json json;
  json["delaunay_version"] = kDelaunayVersion;
  json["program"] = "crossloft " CROSSLOFT_VERSION;
  json["file"] = file;
  json["points"] = report.points;
  json["dimension"] = report.dimension;
  json["tets"] = report.dimension == 3 ? report.simplices : 0;
  if (report.dimension == 2) json["triangles"] = report.simplices;
  if (report.dimension == 1) json["edges"] = report.simplices;
  json["duplicates"] = report.duplicates;
  if (report.weighted) json["hidden"] = report.hidden;
  json["hash"] = hex(report.hash);
  json["threads"] = report.threads;
  json["seconds"] = report.seconds;
  json["peak_rss_kib"] = report.peak_rss_kib;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void print_summary(Terminal& terminal, const DelaunayReport& report) {
  static constexpr const char* kDimensions[] = {"-1, no points", "0, all points in one place",
                                                "1, all points on one line", "2, all points on one plane",
                                                "3"};
  static constexpr const char* kSimplices[] = {"simplices", "vertices", "edges", "triangles", "tets"};
  const auto row = static_cast<std::size_t>(report.dimension + 1);
  terminal.print("points     %zu\n", report.points);
  terminal.print("duplicates %zu\n", report.duplicates);
  if (report.weighted) terminal.print("hidden     %zu\n", report.hidden);
  terminal.print("dimension  %s\n", kDimensions[row]);
  terminal.print("%-10s %zu\n", kSimplices[row], report.simplices);
  terminal.print("hash       %s\n", hex(report.hash).c_str());
  terminal.print("seconds    %.3f with %u thread%s\n", report.seconds, report.threads,
                 report.threads == 1 ? "" : "s");
  terminal.print("memory     %" PRIu64 " KiB at most\n", report.peak_rss_kib);
}

}  // namespace crossloft::cli
