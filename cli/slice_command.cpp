#include <limits>
#include <string>
#include <vector>

#include "../inspect/slice.h"
#include "../inspect/unit_scale.h"
#include "../io/read_mesh.h"
#include "../io/write_sections.h"
#include "arguments.h"
#include "commands.h"
#include "plane_list.h"
#include "terminal.h"

namespace crossloft::cli {
namespace {

struct Arguments {
  std::string mesh, output, planes;
  std::uint32_t parallel = 0, random = 0, rotational = 0, fan = 0;
  std::uint64_t seed = 1;
  std::vector<double> direction = {0, 0, 1};
};

Result<std::vector<CuttingPlane>> chosen_planes(const Arguments& a, const Bounds& box) {
  const Vec3 direction{a.direction[0], a.direction[1], a.direction[2]};
  if (direction == Vec3{} || !is_finite(direction)) {
    return Error{ErrorCode::usage, "--direction: the direction must be finite and not zero", ""};
  }
  if (a.parallel > 0) return parallel_planes(box, a.parallel, direction);
  if (a.random > 0) return random_planes(box, a.random, a.seed);
  if (a.rotational > 0) return rotational_planes(box, a.rotational, direction);
  if (a.fan > 0) return fan_planes(box, a.fan, a.seed);
  return read_planes(a.planes);
}

std::size_t edge_count(const Sections& sections) {
  std::size_t count = 0;
  for (const PlaneSection& plane : sections.planes) count += plane.edges.size();
  return count;
}

ExitCode run(const Arguments& arguments) {
  release_interrupts();
  Terminal terminal;
  const Context context = terminal.context();
  if (auto outputs = check_outputs({arguments.mesh, arguments.planes}, {arguments.output}); !outputs)
    return terminal.fail(outputs.error());
  const auto mesh = read_surface(arguments.mesh, context);
  if (!mesh) return terminal.fail(mesh.error());
  const auto planes = chosen_planes(arguments, bounds_of_triangles(*mesh));
  if (!planes) return terminal.fail(planes.error());
  auto sections = slice(*mesh, *planes);
  if (!sections) {
    if (sections.error().file.empty()) sections.error().file = arguments.mesh;
    return terminal.fail(sections.error());
  }
  const auto written = write_sections(arguments.output, *sections, context);
  if (!written) return terminal.fail(written.error());
  terminal.print("%zu planes, %zu contour edges\n", sections->planes.size(), edge_count(*sections));
  return kGood;
}

}  // namespace

void add_slice(CLI::App& program, ExitCode& outcome) {
  auto [command, a] = add_command<Arguments>(
      program, "slice", "Cuts a closed mesh: sections that agree on the common lines of their planes.",
      "crossloft slice bear.off -o bear.contour --random 20 --seed 7",
      [&outcome](const Arguments& arguments) { outcome = run(arguments); });
  command->add_option("MESH", a.mesh, "a closed surface")->required()->check(is_surface_file());
  command->add_option("-o,--output", a.output, "the sections")->required()->check(is_sections_file());
  CLI::Option_group* planes = command->add_option_group("planes", "one of:");
  const CLI::Validator count = whole_number_in(1, 100000);
  planes->add_option("--parallel", a.parallel, "K planes at equal distances")->transform(count);
  planes->add_option("--random", a.random, "K planes in random positions")->transform(count);
  planes->add_option("--rotational", a.rotational, "K planes around the axis --direction through the centre")
      ->transform(count);
  planes->add_option("--fan", a.fan, "K planes of a jittered sweep along x")->transform(count);
  planes->add_option("--planes", a.planes, "a file with A B C D a line for A x + B y + C z + D = 0");
  planes->require_option(1);
  command->add_option("--seed", a.seed, "of --random and --fan")
      ->capture_default_str()
      ->transform(whole_number_in(0, std::numeric_limits<std::uint64_t>::max()));
  command->add_option("--direction", a.direction, "normal of --parallel or axis of --rotational")
      ->capture_default_str()
      ->expected(3)
      ->type_name("X Y Z");
  command->parse_complete_callback([command = command] {
    if (command->count("--parallel") + command->count("--rotational") == 0)
      refuse_options(*command, {"--direction"}, "is for --parallel and --rotational alone");
    if (command->count("--random") + command->count("--fan") == 0)
      refuse_options(*command, {"--seed"}, "is for --random and --fan alone");
  });
}

}  // namespace crossloft::cli
