#pragma once
/// What several commands say in the same words on the command line.

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include "../geom/result.h"

namespace crossloft::cli {

/// Accepts paths that end in one of the extensions (".ply"), in any case.
CLI::Validator extension_in(std::vector<std::string> extensions);

inline const CLI::Validator& is_sections_file() {
  static const CLI::Validator validator = extension_in({".contour", ".csl"});
  return validator;
}
inline const CLI::Validator& is_surface_file() {
  static const CLI::Validator validator = extension_in({".ply", ".obj", ".off", ".stl"});
  return validator;
}
inline const CLI::Validator& is_solid_file() {
  static const CLI::Validator validator = extension_in({".vtu", ".mesh"});
  return validator;
}

/// Accepts numbers from `low` to `high`. Not a number is none, which CLI::Range would let pass.
CLI::Validator number_in(double low, double high);

/// --plane-tolerance as all but repair take it: frame_sections() refuses what is further off.
void add_plane_tolerance(CLI::App& command, double& value);

/// Accepts whole decimal numbers from `low` to `high`, for transform(): CLI11 by itself would take 010 as
/// octal, 0x10 as hexadecimal and all of them modulo 2^64.
CLI::Validator whole_number_in(std::uint64_t low, std::uint64_t high);

/// A usage error if one of the options was given. REQUIRES: the command has them.
void refuse_options(const CLI::App& command, const std::vector<std::string>& names, const std::string& why);

/// Looks at a command's outputs before its work: each needs a folder that is there and can be written to, and no output may be
/// an input or another output. Empty paths are skipped.
Result<Done> check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

/// A subcommand with its arguments' storage and an example that --help shows below the options. `run` is
/// called with the parsed arguments after parsing succeeded.
template <class Arguments, class Run>
std::pair<CLI::App*, Arguments&> add_command(CLI::App& program, const char* name, const char* what,
                                             const char* example, Run run) {
  CLI::App* command = program.add_subcommand(name, what);
  command->footer(std::string("Example:\n  ") + example);
  auto arguments = std::make_shared<Arguments>();
  command->callback([arguments, run] { run(*arguments); });
  return {command, *arguments};
}

}  // namespace crossloft::cli
