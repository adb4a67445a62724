#include <filesystem>
#include <string>

#include "../inspect/slice.h"
#include "../inspect/solids.h"
#include "../io/atomic_file.h"
#include "../io/read_sections.h"
#include "../io/write_mesh.h"
#include "../io/write_sections.h"
#include "../reconstruct/reconstruct.h"
#include "arguments.h"
#include "commands.h"
#include "demo_input.h"
#include "picture/picture.h"
#include "picture/png_file.h"
#include "report_json.h"
#include "summary.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

constexpr const char* kInputName = "examples/demo.contour";

struct Arguments {
  std::string folder = "demo-output";
  std::string make_input;
};

/// How examples/demo.contour came to be; roundings have changed since.
ExitCode make_input(const std::string& path) {
  Terminal terminal;
  const Surface solid = demo_solid(44);
  auto planes = demo_planes(bounds_of(solid.points));
  const auto sections = slice(solid, planes);
  if (!sections) return terminal.fail(sections.error());
  const auto written = write_sections(path, *sections, terminal.context());
  return written ? kGood : terminal.fail(written.error());
}

Result<Done> write_results(const std::string& folder, const Image& picture, const Reconstruction& result,
                           const Context& context) {
  Result<Done> written = write_surface(folder + "/surface.ply", result.surface, context);
  if (written) written = write_solid(folder + "/solid.vtu", result.solid, context);
  if (written) written = write_file(folder + "/report.json", report_json(result.report, {kInputName, {}}));
  if (written) written = write_png(folder + "/picture.png", picture);
  return written;
}

ExitCode run(const Arguments& arguments) {
  if (!arguments.make_input.empty()) return make_input(arguments.make_input);
  Terminal terminal;
  const Context context = terminal.context(0);
  const auto sections = parse_contour(demo_input(), kInputName, context);
  if (!sections) return terminal.fail(sections.error());
  const auto result = reconstruct(*sections, {}, context);
  if (!result) return terminal.fail(result.error());
  const Image picture = draw_picture(*sections, result->surface);
  if (context.cancelled()) return terminal.fail(make_error(ErrorCode::cancelled, "interrupted"));
  pass_over_interrupts();  // from here on the files appear, all of them
  std::error_code failure;
  std::filesystem::create_directories(arguments.folder, failure);
  if (failure)
    return terminal.fail({ErrorCode::file_not_writable, "cannot be made: " + failure.message(), arguments.folder, 0, kNone, kNone});
  const auto written = write_results(arguments.folder, picture, *result, context);
  if (!written) return terminal.fail(written.error());
  print_summary(terminal, result->report);
  const std::string folder = std::filesystem::absolute(arguments.folder).lexically_normal().string();
  terminal.print("result       %s/surface.ply (solid.vtu, report.json)\npicture      %s/picture.png\n",
                 folder.c_str(), folder.c_str());
  return kGood;
}

}  // namespace

void add_demo(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "demo",
      "Reconstructs the sections that come with the program: surface, solid, report and a picture.",
      "crossloft demo -o demo-output", [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("-o,--output", a.folder, "folder for the results, made if missing")
      ->capture_default_str();
  command
      ->add_option("--make-input", a.make_input,
                   "only write sections like the demo's, up to rounding: cut from the demo's solid anew")
      ->check(is_sections_file());
}

}  // namespace crossloft::cli
