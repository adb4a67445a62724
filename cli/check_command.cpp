#include <cmath>
#include <string>

#include "../inspect/check.h"
#include "../io/read_mesh.h"
#include "../io/read_sections.h"
#include "arguments.h"
#include "commands.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string surface, sections;
  double max_distance = INFINITY, max_extra = 0.05;
  bool quiet = false;
};

const char* yes_no(bool yes) { return yes ? "yes" : "NO"; }

void print_topology(Terminal& terminal, const CheckReport& r) {
  terminal.print("triangles    %u on %u points\n", r.triangles, r.points);
  terminal.print("closed       %s (%u open, %u crowded edges)\n", yes_no(r.closed()), r.open_edges,
                 r.crowded_edges);
  terminal.print("oriented     %s (%u edges run through twice one way)\n", yes_no(r.oriented()),
                 r.misoriented_edges);
  terminal.print("manifold     %s (%u vertices with more than one fan)\n", yes_no(r.manifold()),
                 r.nonmanifold_vertices);
  terminal.print("crossings    %llu proper, %llu coplanar overlaps\n",
                 static_cast<unsigned long long>(r.crossings), static_cast<unsigned long long>(r.overlaps));
  for (const auto& pair : r.crossing_pairs)
    terminal.print("             triangles %u and %u cross\n", pair[0], pair[1]);
  if (r.bad_indices + r.bad_coordinates + r.repeated_indices > 0) {
    terminal.print("broken       %u bad indices, %u bad coordinates, %u triangles that name a point twice\n",
                   r.bad_indices, r.bad_coordinates, r.repeated_indices);
  }
  terminal.print("degenerate   %u triangles with equal corners, %u with corners on one line\n",
                 r.repeated_points, r.flat_triangles);
}

void print_components(Terminal& terminal, const CheckReport& r) {
  terminal.print("components   %zu\ncavities     %u\n", r.components.size(), r.cavities);
  if (r.good_topology()) {
    terminal.print("genus        %lld\n", static_cast<long long>(r.genus));
  } else {
    terminal.print("genus        unknown, this is no closed manifold\n");
  }
  if (r.inverted > 0) terminal.print("inside out   %u components\n", r.inverted);
  terminal.print("volume       %.9g\narea         %.9g\n", r.volume, r.area);
  if (r.components.size() < 2) return;
  for (std::size_t i = 0; i < r.components.size(); ++i) {
    const ComponentReport& c = r.components[i];
    terminal.print("  %3zu: %u triangles, genus %lld, volume %.9g%s\n", i, c.triangles,
                   static_cast<long long>(c.genus), c.volume, c.cavity() ? ", a cavity" : "");
  }
}

void print_sections(Terminal& terminal, const SectionCheck& check) {
  terminal.print("\nplane  section area   missing       extra         distance\n");
  for (std::size_t i = 0; i < check.planes.size(); ++i) {
    const PlaneCheck& p = check.planes[i];
    terminal.print("%5zu  %-13.6g %-13.3g %-13.3g %-.3g\n", i, p.section_area, p.missing_area, p.extra_area,
                   p.distance);
  }
  terminal.print("  all  %-13.6g difference %.3g, largest distance %.3g (%.3g of the diagonal)\n",
                 check.section_area, check.difference_area, check.distance, check.distance / check.diagonal);
}

/// Solid where no section is: never right, while section without solid may be a flat.
double extra_area(const SectionCheck& check) {
  double sum = 0;
  for (const PlaneCheck& p : check.planes) sum += p.extra_area;
  return sum;
}

ExitCode run(const Arguments& arguments) {
  release_interrupts();
  Terminal terminal(arguments.quiet);
  const Context context = terminal.context();
  const auto surface = read_surface(arguments.surface, context);
  if (!surface) return terminal.fail(surface.error());
  const CheckReport topology = check_surface(*surface);
  print_topology(terminal, topology);
  print_components(terminal, topology);
  bool good = topology.good_topology() && topology.crossings == 0;
  if (!arguments.sections.empty()) {
    const auto sections = read_sections(arguments.sections, context);
    if (!sections) return terminal.fail(sections.error());
    const SectionCheck check = check_sections(*surface, *sections);
    print_sections(terminal, check);
    good = good && !(check.distance > arguments.max_distance * check.diagonal) &&
           !(extra_area(check) > arguments.max_extra * check.section_area);
  }
  terminal.print("%s\n", good ? "good" : "NOT good");
  return good ? kGood : kPromiseBroken;
}

}  // namespace

void add_check(CLI::App& program, ExitCode& outcome) {
  auto [command, a] =
      add_command<Arguments>(program, "check",
                             "Is a surface closed, oriented, manifold (by index) and free of proper "
                             "crossings (exactly)? Does it meet the\n"
                             "planes in the sections? Exit code 1 if not.",
                             "crossloft check bear.ply bear.contour",
                             [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("SURFACE", a.surface, "the surface")->required()->check(is_surface_file());
  command->add_option("FILE", a.sections, "cross-sections to compare with, plane by plane")
      ->check(is_sections_file());
  command
      ->add_option(
          "--max-distance", a.max_distance,
          "a section boundary further off breaks a promise; a fraction of the diagonal (default: none, "
          "since flat sections are bare by design)")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--max-extra", a.max_extra,
                   "more solid outside of the sections breaks a promise; a fraction of their area. Sections that disagree are "
                   "brought together within the match tolerance, so it is not 0")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--quiet", a.quiet, "only the exit code");
}

}  // namespace crossloft::cli
