#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../inspect/check.h"
#include "../io/atomic_file.h"
#include "../io/read_mesh.h"
#include "../io/read_sections.h"
#include "arguments.h"
#include "commands.h"
#include "inspect_json.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string surface, sections, report;
  double max_distance = INFINITY, max_missing = 0.1, max_extra = 0.05;
  SectionCheckOptions options;
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
  if (r.unknown_depths > 0)
    terminal.print(
        "not known    whether %u components are cavities or inside out: others touch them all over\n",
        r.unknown_depths);
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
  for (const PlaneCheck& p : check.planes) {
    terminal.print("%5u  %-13.6g %-13.3g %-13.3g %-.3g\n", p.plane, p.section_area, p.missing_area,
                   p.extra_area, p.distance);
  }
  terminal.print("  all  %-13.6g %-13.3g %-13.3g %.3g (%.3g of the diagonal)\n", check.section_area,
                 check.missing_area, check.extra_area, check.distance,
                 check.diagonal > 0 ? check.distance / check.diagonal : 0);
  terminal.print(
      "off plane    vertices up to %.3g off their planes in the file; brought on to fitted ones by up to "
      "%.3g\n",
      check.section_off_plane, check.section_displacement);
}

/// A promise that does not hold, in words that follow "NOT good: ".
using Broken = std::vector<std::string>;

void add(Broken& broken, bool is_broken, std::string what) {
  if (is_broken) broken.push_back(std::move(what));
}

Broken broken_promises(const CheckReport& r) {
  Broken broken;
  add(broken, r.triangles == 0, "the surface has no triangles");
  add(broken, r.bad_coordinates > 0, "coordinates are no numbers");
  add(broken, !r.closed(), "not closed");
  add(broken, !r.oriented(), "not oriented");
  add(broken, r.nonmanifold_vertices > 0, "not manifold");
  add(broken, r.crossings > 0, "triangles cross");
  add(broken, r.overlaps > 0, "triangles overlap in a plane");
  add(broken, r.inverted > 0, "components are inside out");
  add(broken, r.unknown_depths > 0 && r.overlaps == 0, "components may be inside out");
  return broken;
}

std::string in_words(double share) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), " (%.3g of their area)", share);
  return text.data();
}

/// A flat region of a section may be bare, but not most of it; solid where no section is is never right.
void add_sections(Broken& broken, const SectionCheck& check, const Arguments& limits) {
  add(broken, check.missing_share > limits.max_missing,
      "sections are missing" + in_words(check.missing_share));
  add(broken, check.extra_share > limits.max_extra,
      "solid outside of the sections" + in_words(check.extra_share));
  add(broken, check.distance > limits.max_distance * check.diagonal, "section boundaries are too far off");
}

void print_verdict(Terminal& terminal, const Broken& broken) {
  if (broken.empty()) return terminal.print("good\n");
  std::string list;
  for (const std::string& what : broken) list += (list.empty() ? "" : ", ") + what;
  terminal.print("NOT good: %s\n", list.c_str());
}

Result<Done> write_report(const Arguments& a, const CheckReport& surface, const SectionCheck* sections,
                          const Broken& broken) {
  if (a.report.empty()) return Done{};
  const CheckOrigin origin{a.surface, a.sections, a.options, a.max_distance, a.max_missing, a.max_extra};
  return write_file(a.report, check_json(surface, sections, origin, broken));
}

ExitCode run(const Arguments& arguments) {
  release_interrupts();
  Terminal terminal(arguments.quiet);
  const Context context = terminal.context();
  if (auto outputs = check_outputs({arguments.surface, arguments.sections}, {arguments.report}); !outputs)
    return terminal.fail(outputs.error());
  const auto surface = read_surface(arguments.surface, context);
  if (!surface) return terminal.fail(surface.error());
  const CheckReport topology = check_surface(*surface);
  print_topology(terminal, topology);
  print_components(terminal, topology);
  Broken broken = broken_promises(topology);
  std::optional<SectionCheck> met;
  if (!arguments.sections.empty()) {
    const auto sections = read_sections(arguments.sections, context);
    if (!sections) return terminal.fail(sections.error());
    const auto check = check_framed_sections(*surface, *sections, arguments.options, context);
    if (!check) return terminal.fail(check.error());
    print_sections(terminal, *check);
    add_sections(broken, *check, arguments);
    met = *check;
  }
  if (auto written = write_report(arguments, topology, met ? &*met : nullptr, broken); !written)
    return terminal.fail(written.error());
  print_verdict(terminal, broken);
  return broken.empty() ? kGood : kPromiseBroken;
}

/// What still is no broken promise.
void add_limits(CLI::App& command, Arguments& a) {
  const auto add_limit = [&](const char* name, double& value, const char* help) {
    return command.add_option(name, value, help)->check(number_in(0, std::numeric_limits<double>::infinity()));
  };
  add_limit(
      "--max-distance", a.max_distance,
      "a section boundary further off breaks a promise; a fraction of the diagonal (default: none, since "
      "flat sections are bare by design)");
  add_limit("--max-missing", a.max_missing,
            "more section without solid breaks a promise; a fraction of the sections' area. Flat regions are "
            "bare by design, so it is not 0")
      ->capture_default_str();
  add_limit("--max-extra", a.max_extra,
            "more solid outside of the sections breaks a promise; a fraction of their area. Sections that "
            "disagree are brought together within the match tolerance, so it is not 0")
      ->capture_default_str();
  command
      .add_option(
          "--on-plane", a.options.on_plane,
          "a surface vertex this near a plane lies on it; a fraction of the diagonal. What --separate moved "
          "needs as much as that was given")
      ->capture_default_str()
      ->check(number_in(0, 0.1));
  add_plane_tolerance(command, a.options.plane_tolerance);
}

}  // namespace

void add_check(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "check",
      "Is a surface closed, oriented, manifold (by index) and the right side out? Do no triangles cross or "
      "overlap (exactly)?\n"
      "Does it meet the planes in the sections, as reconstruct takes these? Exit code 1 if not.",
      "crossloft check bear.ply bear.contour",
      [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("SURFACE", a.surface, "the surface")->required()->check(is_surface_file());
  command
      ->add_option("FILE", a.sections,
                   "cross-sections to compare with, plane by plane; where they needed a repair, those that "
                   "repair wrote")
      ->check(is_sections_file());
  add_limits(*command, a);
  command->add_option("--report", a.report, "also a report (docs/report.md)")->check(extension_in({".json"}));
  command->add_flag("--quiet", a.quiet, "only the exit code");
}

}  // namespace crossloft::cli
