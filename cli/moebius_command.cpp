#include <string>
#include <vector>

#include "../io/atomic_file.h"
#include "../io/read_sites.h"
#include "../io/write_diagram_svg.h"
#include "../moebius/cells.h"
#include "arguments.h"
#include "commands.h"
#include "diagram_json.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string sites, output, json;
  std::vector<double> box;
  DiagramDrawing drawing;
  bool no_sites = false;
};

/// What the summary says beyond the sizes of the lists.
struct Counts {
  std::size_t hidden = 0, disconnected = 0, with_holes = 0, whole_circles = 0;
};

Counts count(const MoebiusDiagram& diagram, const MoebiusCells& cells) {
  Counts counts;
  for (std::uint32_t s = 0; s < diagram.sites.size(); ++s) {
    const auto pieces = cells.components_of(s);
    counts.hidden += pieces.empty() ? 1 : 0;
    counts.disconnected += pieces.size() > 1 ? 1 : 0;
    bool has_hole = false;
    for (const CellComponent& piece : pieces) has_hole = has_hole || piece.hole_count() > 0;
    counts.with_holes += has_hole ? 1 : 0;
  }
  for (const MoebiusArc& arc : diagram.arcs)
    counts.whole_circles += !arc.curve.is_line && arc.from == kNone ? 1 : 0;
  return counts;
}

void print_counts(Terminal& terminal, const MoebiusDiagram& diagram, const Counts& counts) {
  terminal.print("sites    %zu, %zu without a cell\n", diagram.sites.size(), counts.hidden);
  terminal.print("cells    %zu, %zu disconnected, %zu with holes\n", diagram.sites.size() - counts.hidden,
                 counts.disconnected, counts.with_holes);
  terminal.print("arcs     %zu, %zu of them whole circles\n", diagram.arcs.size(), counts.whole_circles);
  terminal.print("vertices %zu\n", diagram.vertices.size());
}

DiagramDrawing drawing_of(const Arguments& a) {
  DiagramDrawing drawing = a.drawing;
  drawing.sites = !a.no_sites;
  if (!a.box.empty()) drawing.box = ViewBox{{a.box[0], a.box[1]}, {a.box[2], a.box[3]}};
  return drawing;
}

Result<Done> write(const Arguments& arguments, const MoebiusDiagram& diagram, const MoebiusCells& cells) {
  DiagramDrawing drawing = drawing_of(arguments);
  drawing.cells = &cells;
  const auto drawn = write_diagram_svg(arguments.output, diagram, drawing);
  if (!drawn || arguments.json.empty()) return drawn;
  return write_file(arguments.json, diagram_json(diagram, cells, arguments.sites));
}

ExitCode run(const Arguments& arguments) {
  release_interrupts();
  Terminal terminal;
  if (auto outputs = check_outputs({arguments.sites}, {arguments.output, arguments.json}); !outputs)
    return terminal.fail(outputs.error());
  const auto sites = read_sites(arguments.sites);
  if (!sites) return terminal.fail(sites.error());
  const auto diagram = moebius_diagram(*sites);
  if (!diagram) return terminal.fail(diagram.error());
  const MoebiusCells cells = moebius_cells(*diagram);
  if (const auto written = write(arguments, *diagram, cells); !written) return terminal.fail(written.error());
  print_counts(terminal, *diagram, count(*diagram, cells));
  return kGood;
}

}  // namespace

void add_moebius(CLI::App& program, ExitCode& outcome) {
  auto [command, a] =
      add_command<Arguments>(program, "moebius",
                             "Draws a Moebius diagram: which of the sites x y [lambda [mu]] has the least "
                             "lambda |p - (x, y)|^2 - mu.",
                             "crossloft moebius sites.txt -o diagram.svg --json diagram.json",
                             [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("SITES", a.sites, "x y [lambda [mu]] a line; lambda is 1 and mu 0 if not given")
      ->required();
  command->add_option("-o,--output", a.output, "the drawing")->required()->check(extension_in({".svg"}));
  command->add_option("--json", a.json, "also the diagram as numbers (docs/formats.md)")
      ->check(extension_in({".json"}));
  command->add_option("--box", a.box, "what is drawn, instead of the sites and what is near them")
      ->expected(4)
      ->delimiter(',')
      ->type_name("X0,Y0,X1,Y1");
  command->add_option("--width", a.drawing.width, "of the drawing in pixels")
      ->capture_default_str()
      ->check(number_in(1.0, 100000.0));
  command->add_flag("--no-sites", a.no_sites, "leave out the dots of the sites");
  command->add_flag("--labels", a.drawing.labels, "the number of each site, counted from 0");
}

}  // namespace crossloft::cli
