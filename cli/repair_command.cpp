#include <string>

#include "../io/atomic_file.h"
#include "../io/read_sections.h"
#include "../io/write_sections.h"
#include "../repair/repair.h"
#include "arguments.h"
#include "commands.h"
#include "repair_json.h"
#include "repair_options.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string input, output, report;
  RepairOptions options;
  bool quiet = false;
};

ExitCode run(const Arguments& arguments) {
  Terminal terminal(arguments.quiet);
  const Context context = terminal.context();
  if (auto outputs = check_outputs({arguments.input}, {arguments.output, arguments.report}); !outputs)
    return terminal.fail(outputs.error());
  const auto sections = read_sections(arguments.input, context);
  if (!sections) return terminal.fail(sections.error());
  const auto repair = repair_sections(*sections, arguments.options, context);
  if (!repair) return terminal.fail(repair.error());
  if (context.cancelled()) return terminal.fail(make_error(ErrorCode::cancelled, "interrupted"));
  pass_over_interrupts();
  Result<Done> written = write_sections(arguments.output, repair->sections, context);
  if (written && !arguments.report.empty())
    written = write_file(arguments.report, repair_json(*repair, arguments.options, arguments.input));
  if (!written) return terminal.fail(written.error());
  print_repair(terminal, *repair);
  return exit_code(*repair);
}

}  // namespace

CLI::Option* add_repair_limit(CLI::App& command, const char* name, RepairOptions& options) {
  return command
      .add_option(
          name, options.limit,
          "nothing that stays moves further, it caps all tolerances; what would have to is left and listed; "
          "a fraction of the diagonal")
      ->capture_default_str()
      ->check(number_in(0.0, 1.0));
}

void add_repair_details(CLI::App& command, RepairOptions& o) {
  const auto add_tolerance = [&](const char* name, double& value, const char* help) {
    command.add_option(name, value, help)->capture_default_str()->check(number_in(0.0, 1.0));
  };
  add_tolerance("--plane-tolerance", o.plane_tolerance,
                "vertices further from their plane are moved onto it");
  add_tolerance("--same-plane", o.same_plane, "planes nearer than this over the data become one");
  add_tolerance("--close-gap", o.close_gap, "ends of open contours nearer than this are joined");
  add_tolerance("--repeated", o.repeated, "neighbours on a contour nearer than this become one vertex");
  add_tolerance("--spike", o.spike, "a vertex where the contour turns back within this width goes");
  add_tolerance("--tiny-loop", o.tiny_loop, "loops in a box of this size go");
  add_tolerance("--collinear", o.collinear, "a vertex that bends a straight run by no more goes");
  add_tolerance("--agree", o.agree, "sections may differ by this on a common line");
  command.add_flag("!--no-planes", o.planes, "leave planes, and vertices beside them");
  command.add_flag("!--no-chains", o.chains, "leave open contours, repeated vertices and spikes");
  command.add_flag("!--no-crossings", o.crossings, "leave contours that cross or overlap");
  command.add_flag("!--no-loops", o.loops,
                   "leave contours without area, tiny loops and nearly straight runs");
  command.add_flag("!--no-agreement", o.agreement, "leave sections that disagree on common lines");
}

void add_repair(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "repair",
      "Dirty sections in, sections fit for reconstruction out; every change is listed in the report.\n"
      "Lengths are fractions of the diagonal of all contours that enclose an area.\n"
      "Exit code 1: something was left as it was, or a contour left out that encloses an area or is open.",
      "crossloft repair scan.contour -o clean.contour --limit 0.05 --report changes.json",
      [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("FILE", a.input, "cross-sections")->required()->check(is_sections_file());
  command->add_option("-o,--output", a.output, "the repaired sections")
      ->required()
      ->check(is_sections_file());
  add_repair_limit(*command, "--limit", a.options);
  add_repair_details(*command, a.options);
  command->add_option("--report", a.report, "also a list of all changes (docs/report.md)")
      ->check(extension_in({".json"}));
  command->add_flag("--quiet", a.quiet, "no summary, no notes");
}

}  // namespace crossloft::cli
