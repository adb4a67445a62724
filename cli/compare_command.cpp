#include <string>

#include "../inspect/check.h"
#include "../inspect/compare.h"
#include "../io/atomic_file.h"
#include "../io/read_mesh.h"
#include "arguments.h"
#include "commands.h"
#include "inspect_json.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string a, b, report;
};

void print_comparison(Terminal& terminal, const CompareReport& r) {
  terminal.print("                 A               B\n");
  terminal.print("volume           %-15.9g %-15.9g", r.volume_a, r.volume_b);
  if (r.volume_a != 0) terminal.print(" B / A = %.6g", r.volume_b / r.volume_a);
  terminal.print("\n");
  terminal.print("components       %-15u %-15u\n", r.components_a, r.components_b);
  terminal.print("genus            %-15lld %-15lld\n", static_cast<long long>(r.genus_a),
                 static_cast<long long>(r.genus_b));
  terminal.print("largest distance %-15.6g %-15.6g to the other\n", r.distance_ab, r.distance_ba);
  terminal.print("mean distance    %-15.6g %-15.6g to the other\n", r.mean_ab, r.mean_ba);
  terminal.print("common volume    %.9g, union %.9g, IoU %.6g\n", r.intersection, r.union_volume, r.iou);
  terminal.print("Hausdorff        %.6g (%.3g of the diagonal), symmetric mean %.6g\n", r.hausdorff(),
                 r.diagonal > 0 ? r.hausdorff() / r.diagonal : 0, r.mean());
}

/// What makes a volume meaningless: the file is then not a solid to compare with.
Result<Surface> read_closed(const std::string& path, const Context& context) {
  auto surface = read_surface(path, context);
  if (!surface) return surface;
  const CheckReport check = check_surface(*surface);
  if (check.bad_coordinates > 0) return Error{ErrorCode::not_finite, "not a finite coordinate", path};
  if (check.triangles == 0) context.warn(path + " has no triangles");
  if (!check.closed()) context.warn(path + " is not closed: its volume and overlap mean little");
  return surface;
}

ExitCode run(const Arguments& arguments) {
  release_interrupts();
  Terminal terminal;
  const Context context = terminal.context();
  if (auto outputs = check_outputs({arguments.a, arguments.b}, {arguments.report}); !outputs)
    return terminal.fail(outputs.error());
  const auto a = read_closed(arguments.a, context);
  if (!a) return terminal.fail(a.error());
  const auto b = read_closed(arguments.b, context);
  if (!b) return terminal.fail(b.error());
  const CompareReport comparison = compare(*a, *b);
  if (!arguments.report.empty()) {
    const auto written = write_file(arguments.report, compare_json(comparison, arguments.a, arguments.b));
    if (!written) return terminal.fail(written.error());
  }
  print_comparison(terminal, comparison);
  return kGood;
}

}  // namespace

void add_compare(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "compare", "How alike two closed surfaces are: volume, overlap, distance, topology.",
      "crossloft compare truth.stl bear.ply",
      [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("A", a.a, "a surface")->required()->check(is_surface_file());
  command->add_option("B", a.b, "another")->required()->check(is_surface_file());
  command->add_option("--report", a.report, "also a report (docs/report.md)")->check(extension_in({".json"}));
}

}  // namespace crossloft::cli
