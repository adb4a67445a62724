#include "summary.h"

namespace crossloft::cli {
namespace {

void print_topology(Terminal& terminal, const TopologyReport& t) {
  if (t.handles_before != 0 || t.handles != 0)
    terminal.print("handles      %u within cells, %u left%s\n", t.handles_before, t.handles,
                   t.handles_asked != 0 ? ", which the sections ask for" : "");
  if (t.joins != 0)
    terminal.print("joins        %u of sections within cells, the weakest with confidence %.2f\n", t.joins,
                   t.weakest_join);
  if (t.bodies_joined != 0 || t.walls_opened != 0)
    terminal.print("second look  %u small bodies joined, %u walls of cavities opened\n", t.bodies_joined,
                   t.walls_opened);
  if (t.spikes_dropped != 0)
    terminal.print("spikes       %u dropped, where a body ends beside others\n", t.spikes_dropped);
  if (t.bridges != 0 || t.open_edges != 0)
    terminal.print("bridges      at %u edges within sections, with %u handles; %u left pinched\n", t.bridges,
                   t.bridge_handles, t.open_edges);
  if (t.refused_joins != 0) terminal.print("not joined   %u, for lack of confidence\n", t.refused_joins);
}

}  // namespace

void print_summary(Terminal& terminal, const Report& report) {
  terminal.print("planes       %zu, %u cells between them\n", report.planes.size(), report.arrangement_cells);
  terminal.print("solid        %u tetrahedra, volume %.6g\n", report.solid_tets, report.volume);
  terminal.print("surface      %u triangles, %u vertices\n", report.surface_triangles,
                 report.surface_vertices);
  terminal.print("crossings    %u on common lines of two planes, %zu unmatched\n", report.crossings,
                 report.unmatched.size());
  if (report.simplified_vertices != 0)
    terminal.print("simplified   %u contour vertices left out, contours moved by up to %.3g\n",
                   report.simplified_vertices, report.simplify_deviation);
  terminal.print("branching    %u samples on %u faces\n", report.branching_samples, report.branching_faces);
  print_topology(terminal, report.topology);
  terminal.print("flat         %u regions, area %.6g of %.6g\n", report.flat_regions, report.flat_area,
                 report.section_area);
  if (report.thickened_regions != 0)
    terminal.print("thickened    %u flat regions, by up to %.3g\n", report.thickened_regions,
                   report.thickness);
  terminal.print("pinched      %u vertices, %u edges; %u copies moved apart, %u left touching\n",
                 report.pinched_vertices, report.pinched_edges, report.separated_copies,
                 report.touching_copies);
  if (report.crossing_pairs != 0)
    terminal.print(
        "mended       %llu pairs of triangles that crossed after rounding; %u vertices moved by up to "
        "%.3g, %u of them merged with others\n",
        static_cast<unsigned long long>(report.crossing_pairs), report.mended_vertices, report.mending,
        report.merged_vertices);
  terminal.print("seconds      %.3g\n", report.seconds.total);
}

void print_summary(Terminal& terminal, const StackReport& report) {
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  terminal.print("planes       %zu, in %u windows\n", report.planes.size(), report.windows);
  terminal.print("solid        %llu tetrahedra, volume %.6g\n", number(report.solid_tets), report.volume);
  terminal.print("surface      %llu triangles, %llu vertices; %llu bodies, %llu cavities, genus %llu\n",
                 number(report.surface_triangles), number(report.surface_vertices), number(report.bodies),
                 number(report.cavities), number(report.genus));
  print_topology(terminal, report.topology);
  terminal.print("flat         %u regions, area %.6g of %.6g\n", report.flat_regions, report.flat_area,
                 report.section_area);
  if (report.thickened_regions != 0)
    terminal.print("thickened    %u flat regions\n", report.thickened_regions);
  terminal.print("seconds      %.3g\n", report.seconds);
}

}  // namespace crossloft::cli
