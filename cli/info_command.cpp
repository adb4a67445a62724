#include <string>

#include "../inspect/bounds.h"
#include "../io/read_sections.h"
#include "arguments.h"
#include "commands.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string input;
};

ExitCode run(const Arguments& arguments) {
  Terminal terminal;
  const Context context = terminal.context();
  const auto sections = read_sections(arguments.input, context);
  if (!sections) return terminal.fail(sections.error());
  std::size_t vertices = 0, edges = 0, empty = 0;
  Bounds box;
  for (const PlaneSection& plane : sections->planes) {
    vertices += plane.vertices.size();
    edges += plane.edges.size();
    empty += plane.edges.empty() ? 1u : 0u;
    for (const Vec3& p : plane.vertices) box.add(p);
  }
  terminal.print("planes       %zu, %zu of them empty\n", sections->planes.size(), empty);
  terminal.print("contours     %zu vertices, %zu edges\n", vertices, edges);
  if (!box.empty()) {
    terminal.print("extent       [%.9g, %.9g] x [%.9g, %.9g] x [%.9g, %.9g], diagonal %.9g\n", box.low.x, box.high.x,
                   box.low.y, box.high.y, box.low.z, box.high.z, box.diagonal());
  }
  return kGood;
}

}  // namespace

void add_info(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(program, "info", "What a file of cross-sections holds, and how consistent it is.",
                                             "crossloft info bear.contour",
                                             [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("FILE", a.input, "cross-sections")->required()->check(is_sections_file());
}

}  // namespace crossloft::cli
