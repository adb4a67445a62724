#include "stream.h"

#include "../io/atomic_file.h"
#include "../io/section_file.h"
#include "../io/surface_stream.h"
#include "report_json.h"
#include "summary.h"

namespace crossloft::cli {

ExitCode stream(const StreamArguments& arguments, Terminal& terminal, const Context& context) {
  auto sections = SectionFile::open(arguments.input, context);
  if (!sections) return terminal.fail(sections.error());
  auto surface = SurfaceStream::create(arguments.surface);
  if (!surface) return terminal.fail(surface.error());
  const auto report =
      reconstruct_stack(*sections, *surface, {arguments.options, arguments.window_vertices}, context);
  if (!report) return terminal.fail(report.error());
  if (context.cancelled()) return terminal.fail(make_error(ErrorCode::cancelled, "interrupted"));
  pass_over_interrupts();  // from here on the files appear, all of them
  if (auto written = surface->finish(); !written) return terminal.fail(written.error());
  if (!arguments.report.empty()) {
    const auto written =
        write_file(arguments.report, report_json(*report, {arguments.input, arguments.options}));
    if (!written) return terminal.fail(written.error());
  }
  print_summary(terminal, *report);
  return kGood;
}

}  // namespace crossloft::cli
