#include "../inspect/info.h"

#include <string>

#include "../io/read_sections.h"
#include "arguments.h"
#include "commands.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string input;
  double plane_tolerance = 1e-3;
};

void print_contents(Terminal& terminal, const SectionsInfo& info) {
  terminal.print("planes       %zu in %u directions, %u with a section\n", info.planes.size(),
                 info.directions, info.sections);
  terminal.print("contours     %u, %u of them holes\n", info.contours, info.holes);
  terminal.print("vertices     %u on %u edges\n", info.vertices, info.edges);
  terminal.print("extents      [%.9g, %.9g] x [%.9g, %.9g] x [%.9g, %.9g]\n", info.low.x, info.high.x,
                 info.low.y, info.high.y, info.low.z, info.high.z);
  terminal.print("diagonal     %.9g\n", info.diagonal);
  terminal.print("coincidences %u lines of three or more planes, %u points of four or more\n", info.pencils,
                 info.common_points);
}

/// "1.2e-05 (3.4e-06 of the diagonal)"
std::string length_text(double length, double diagonal) {
  char text[80];
  std::snprintf(text, sizeof text, "%.3g (%.3g of the diagonal)", length,
                diagonal > 0 ? length / diagonal : 0);
  return text;
}

void print_agreement(Terminal& terminal, const SectionsInfo& info) {
  terminal.print("off plane    %s\n", length_text(info.off_plane, info.diagonal).c_str());
  terminal.print("crossing     %u pairs of contour edges\n", info.crossing_edges);
  if (info.edges == 0) {
    terminal.print("mismatch     nothing to compare, since there is no contour\n");
    return;
  }
  if (!info.lines_compared) {
    terminal.print("mismatch     not known, since contours cross\n");
    return;
  }
  terminal.print("mismatch     %s on common lines\n", length_text(info.mismatch, info.diagonal).c_str());
  terminal.print("crossings    %u on common lines, %u without a partner\n", info.crossings, info.unpaired);
}

void print_planes(Terminal& terminal, const SectionsInfo& info) {
  terminal.print("\nplane  contours  holes  vertices  off plane  normal and offset\n");
  for (const PlaneInfo& p : info.planes) {
    terminal.print("%5u  %8u  %5u  %8u  %9.3g  %.6g %.6g %.6g  %.6g%s\n", p.plane, p.contours, p.holes,
                   p.vertices, p.off_plane, p.normal.x, p.normal.y, p.normal.z, p.offset,
                   p.crossing_edges > 0 ? "  edges cross" : "");
  }
}

ExitCode run(const Arguments& arguments) {
  Terminal terminal;
  const Context context = terminal.context();
  const auto sections = read_sections(arguments.input, context);
  if (!sections) return terminal.fail(sections.error());
  const auto info = examine(*sections, arguments.plane_tolerance, context);
  if (!info) return terminal.fail(info.error());
  print_contents(terminal, *info);
  print_agreement(terminal, *info);
  print_planes(terminal, *info);
  return kGood;
}

}  // namespace

void add_info(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "info", "What a file of cross-sections holds, and how well its planes agree.",
      "crossloft info bear.contour", [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("FILE", a.input, "cross-sections")->required()->check(is_sections_file());
  add_plane_tolerance(*command, a.plane_tolerance);
}

}  // namespace crossloft::cli
