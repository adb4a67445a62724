#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../io/atomic_file.h"
#include "../io/read_sections.h"
#include "../io/write_mesh.h"
#include "../io/write_sections.h"
#include "../reconstruct/reconstruct.h"
#include "../repair/repair.h"
#include "arguments.h"
#include "branching_drawings.h"
#include "commands.h"
#include "picture/picture.h"
#include "picture/png_file.h"
#include "repair_json.h"
#include "repair_options.h"
#include "report_json.h"
#include "stream.h"
#include "summary.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string input, surface, solid, report, sections, picture, drawings;
  std::string mode = "natural";
  Options options;
  PictureOptions view;
  unsigned threads = 0;
  bool quiet = false, repair = false, stream = false;
  std::uint64_t window_vertices = StackOptions{}.window_vertices;
  RepairOptions repair_options;
};

constexpr std::array kModes{PruneMode::natural, PruneMode::joint, PruneMode::paper, PruneMode::paper_literal};

std::vector<std::string> mode_names() {
  std::vector<std::string> names;
  for (const PruneMode mode : kModes) names.push_back(name_of(mode));
  return names;
}

/// REQUIRES: one of mode_names().
PruneMode mode_named(const std::string& name) {
  return *std::find_if(kModes.begin(), kModes.end(), [&](PruneMode mode) { return name == name_of(mode); });
}

/// The files that were asked for, one after the other; each appears whole or not at all.
Result<Done> write_results(const Arguments& arguments, const Reconstruction& result, const Repair& repair,
                           const BranchingDrawings& drawings, const Context& context) {
  Result<Done> written = write_surface(arguments.surface, result.surface, context);
  if (written && !arguments.solid.empty()) written = write_solid(arguments.solid, result.solid, context);
  if (written && !arguments.sections.empty()) {
    written = write_sections(arguments.sections, result.sections, context);
  }
  if (written && !arguments.report.empty()) {
    const RepairOrigin repaired{repair, arguments.repair_options};
    written = write_file(arguments.report, report_json(result.report, {arguments.input, arguments.options},
                                                       arguments.repair ? &repaired : nullptr));
  }
  if (written && !arguments.drawings.empty()) written = drawings.write(arguments.drawings);
  return written;
}

ExitCode run(Arguments arguments) {
  Terminal terminal(arguments.quiet);
  const Context context = terminal.context(arguments.threads);
  arguments.options.mode = mode_named(arguments.mode);
  if (auto outputs = check_outputs({arguments.input}, {arguments.surface, arguments.solid, arguments.report,
                                                       arguments.sections, arguments.picture});
      !outputs)
    return terminal.fail(outputs.error());
  if (arguments.stream)
    return stream({arguments.input, arguments.surface, arguments.report, arguments.options,
                   arguments.window_vertices},
                  terminal, context);
  const bool draw = !arguments.drawings.empty();
  if (draw)
    if (auto folder = check_folder(arguments.drawings); !folder) return terminal.fail(folder.error());
  auto sections = read_sections(arguments.input, context);
  if (!sections) return terminal.fail(sections.error());
  Repair repair;
  if (arguments.repair) {
    auto repaired = repair_sections(*sections, arguments.repair_options, context);
    if (!repaired) return terminal.fail(repaired.error());
    repair = std::move(repaired).value();
    *sections = repair.sections;
  }
  BranchingDrawings drawings;
  const auto result = reconstruct(*sections, arguments.options, context, draw ? &drawings : nullptr);
  if (!result) return terminal.fail(result.error());
  if (context.cancelled()) return terminal.fail(make_error(ErrorCode::cancelled, "interrupted"));
  pass_over_interrupts();  // from here on the files appear, all of them
  auto written = write_results(arguments, *result, repair, drawings, context);
  // The last one: whatever becomes of it, the others are there.
  if (written && !arguments.picture.empty())
    written = write_png(arguments.picture, draw_picture(result->sections, result->surface, arguments.view));
  if (!written) return terminal.fail(written.error());
  if (is_beside(result->sections, result->surface, arguments.view))
    terminal.say(LogLevel::warning, "--picture-of: the data are further from there than the length given");
  if (arguments.repair) print_repair(terminal, repair);
  print_summary(terminal, result->report);
  if (draw) terminal.print("drawings     %zu in %s\n", drawings.size(), arguments.drawings.c_str());
  return exit_code(repair);
}

/// Of Branching or InCells.
template <class Where>
void add_where(CLI::App& command, const char* name, Where& where, const char* help) {
  command
      .add_option_function<std::string>(
          name,
          [&where](const std::string& word) {
            where = word == "off" ? Where::off : word == "all" ? Where::all : Where::automatic;
          },
          help)
      ->default_str("auto")
      ->check(CLI::IsMember({"off", "auto", "all"}));
}

void add_natural_options(CLI::App& command, NaturalOptions& natural) {
  const auto add_confidence = [&](const char* name, double& value, const char* help) {
    command.add_option(name, value, help)->capture_default_str()->check(number_in(-1.0, 1.0));
  };
  add_confidence(
      "--join-confidence", natural.join_confidence,
      "natural: sections are joined where the best way between them is this sure, -1 to 1; joins in "
      "doubt: --look-around, bodies that are alone then: --alone-confidence");
  add_confidence("--dome-confidence", natural.dome_confidence,
                 "natural: a hole in a section is closed over where its dome is this sure, -1 to 1");
  add_confidence(
      "--alone-confidence", natural.alone_confidence,
      "natural: a small body that nothing is joined with is joined where the way is this sure, -1 to 1");
  add_confidence("--cavity-confidence", natural.cavity_confidence,
                 "natural: a cavity is opened where a wall of it is less sure, -1 to 1; -1: never");
  command
      .add_option("--smooth-weight", natural.smooth_weight,
                  "natural: weight of a small surface against a likely volume")
      ->capture_default_str()
      ->check(number_in(0.0, kLargestSmoothWeight));
  add_where(command, "--divide", natural.divide,
            "natural: points inside cells, where sections can't be joined or much is lost without: auto "
            "where planes meet in the cell; all not with --stream");
  add_where(command, "--look-around", natural.look_around,
            "natural: where it is in doubt whether sections are joined in a cell, ask the planes around it: "
            "auto where planes meet in the cell; all not with --stream");
}

/// What no other mode reads.
const std::vector<std::string> kNaturalOptions{
    "--join-confidence", "--dome-confidence", "--alone-confidence", "--cavity-confidence",
    "--smooth-weight",   "--divide",          "--look-around"};

/// What is done so that the solid has all of its sections and touches itself nowhere.
void add_embedding(CLI::App& command, Options& options) {
  command
      .add_option(
          "--thicken", options.thicken,
          "give section regions that nothing faces a plate of solid no thicker than this; a fraction of "
          "the diagonal, 0: they are left out")
      ->capture_default_str()
      ->check(number_in(0.0, 1.0));
  CLI::Option* separate = command.add_option(
      "--separate", options.separation,
      "where the surface touches itself, move its vertices apart by up to this, even if sections move "
      "with them; a fraction of the diagonal, 0: only where no section changes");
  separate->capture_default_str()->check(number_in(0.0, 1.0));
  command
      .add_flag("!--keep-touching", options.separate,
                "leave vertices that the surface has twice where it touches itself in one place")
      ->excludes(separate);
}

void add_view(CLI::App& command, PictureOptions& view, CLI::Option* picture) {
  command
      .add_option_function<std::vector<int>>(
          "--picture-size",
          [&view](const std::vector<int>& size) {
            view.width = size[0];
            view.height = size[1];
          },
          "of the picture in pixels (default 1200 675)")
      ->expected(2)
      ->needs(picture)
      ->type_name("WIDTH HEIGHT")
      ->transform(whole_number_in(16, 8192));
  command
      .add_option_function<std::vector<double>>(
          "--picture-from",
          [&view](const std::vector<double>& from) {
            view.from = {from[0], from[1], from[2]};
            if (!is_finite(view.from) || view.from == Vec3{})
              throw CLI::ValidationError("--picture-from", "needs a direction that is finite and not 0");
          },
          "direction towards the viewer, z is up; along z y is (default 0.42 -0.9 0.36)")
      ->expected(3)
      ->needs(picture)
      ->type_name("X Y Z");
  command
      .add_option_function<std::vector<double>>(
          "--picture-of",
          [&view](const std::vector<double>& part) {
            view.middle = {part[0], part[1], part[2]};
            view.reach = part[3];
            if (!is_finite(view.middle) || !std::isfinite(view.reach) || !(view.reach > 0))
              throw CLI::ValidationError("--picture-of", "needs a point and a length above 0");
          },
          "only what is this near to a point (default: all)")
      ->expected(4)
      ->needs(picture)
      ->type_name("X Y Z LENGTH");
}

/// What is taken for the same, left out or repaired.
void add_tolerances(CLI::App& command, Arguments& a) {
  command
      .add_option(
          "--match-tolerance", a.options.match_tolerance,
          "crossings of two sections on their common line this near are one; a fraction of the diagonal")
      ->capture_default_str()
      ->check(number_in(0.0, 1.0));
  add_plane_tolerance(command, a.options.plane_tolerance);
  command
      .add_option("--simplify", a.options.simplify,
                  "leave out contour vertices that a straight edge replaces this closely; a fraction of the "
                  "diagonal, 0: none; the solid then meets the sections of --dump-sections")
      ->capture_default_str()
      ->check(number_in(0.0, 1.0));
  CLI::Option* repair = command.add_flag(
      "--repair", a.repair,
      "repair the sections first, as crossloft repair does; exit code 1: something is left as it was, or "
      "a contour left out");
  add_repair_limit(command, "--repair-limit", a.repair_options)->needs(repair);
}

/// After all options that want the whole at once.
void add_stream(CLI::App& command, Arguments& a) {
  CLI::Option* stream = command.add_flag(
      "--stream", a.stream,
      "for a stack of parallel planes: read and reconstruct a few slices at a time, so that memory does not "
      "grow with the stack; not into .stl, and without --divide all and --look-around all");
  for (const char* whole : {"--solid", "--picture", "--dump-sections", "--dump-branching", "--repair"})
    stream->excludes(command.get_option(whole));
  command
      .add_option("--window", a.window_vertices,
                  "with --stream: contour vertices that are worked on together, but for overlaps")
      ->capture_default_str()
      ->transform(whole_number_in(1, std::uint64_t{1} << 40))
      ->needs(stream);
}

}  // namespace

void add_reconstruct(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "reconstruct", "Sections in, watertight surface and solid out.",
      "crossloft reconstruct bear.contour -o bear.ply --solid bear.vtu --report bear.json",
      [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("FILE", a.input, "cross-sections")->required()->check(is_sections_file());
  command->add_option("-o,--output", a.surface, "the surface; with --stream not .stl")
      ->required()
      ->check(is_surface_file());
  command->add_option("--solid", a.solid, "also the tetrahedra")->check(is_solid_file());
  command
      ->add_option(
          "--mode", a.mode,
          "pruning: natural looks for the likely shape without needless handles, joint keeps the "
          "largest solid subset of the tetrahedra, paper is as Boissonnat and Memari with a Step 3 that "
          "does not close the solid on itself, paper-literal with Step 3 as printed; their samples of "
          "the diagrams: --branching all --cutting")
      ->capture_default_str()
      ->check(CLI::IsMember(mode_names()));
  command->parse_complete_callback([command = command, &mode = a.mode] {
    if (mode_named(mode) != PruneMode::natural)
      refuse_options(*command, kNaturalOptions, "is for --mode natural alone");
  });
  add_natural_options(*command, a.options.natural);
  add_where(*command, "--branching", a.options.branching.mode,
            "samples where a section branches: auto where it faces several others, all of the branching "
            "diagram");
  command->add_flag("--cutting", a.options.branching.cutting, "also samples of the cutting diagram");
  add_tolerances(*command, a);
  add_embedding(*command, a.options);
  command->add_option("--report", a.report, "also a report (docs/report.md)")->check(extension_in({".json"}));
  CLI::Option* picture = command->add_option("--picture", a.picture, "also a picture of sections and surface")
                             ->check(extension_in({".png"}));
  add_view(*command, a.view, picture);
  command->add_option("--dump-sections", a.sections, "also the sections as the solid meets them")
      ->check(is_sections_file());
  command
      ->add_option("--dump-branching", a.drawings,
                   "also a drawing of each branching diagram into this folder: section, arcs, samples")
      ->check([](const std::string& folder) { return folder.empty() ? "names no folder" : std::string(); });
  add_stream(*command, a);
  command->add_option("--threads", a.threads, "worker threads, 0: one per core; the result is the same")
      ->capture_default_str()
      ->transform(whole_number_in(0, 1024));
  command->add_flag("--quiet", a.quiet, "no summary, no notes, no progress bar");
}

}  // namespace crossloft::cli
