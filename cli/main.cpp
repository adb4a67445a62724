// crossloft: the program. Parses the command line, runs one command, turns every outcome into an exit code.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <numeric>
#include <string>
#include <vector>

#include "commands.h"
#include "heap.h"
#include "terminal.h"

namespace {

using namespace crossloft::cli;

constexpr const char* kExitCodes =
    "Exit codes: 0 good, 1 a promise does not hold (after a repair: something is left as it was, or a\n"
    "contour was left out), 2 usage, 3 a file is not readable, not valid or not writable, 4 a defect of the\n"
    "program or no memory left, 130 interrupted.";

/// Help and version are printed and good; everything else is one message and usage.
ExitCode report_parse_error(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    program.exit(error);
    return kGood;
  }
  std::fprintf(stderr, "crossloft: %s (see crossloft --help)\n", error.what());
  return kUsage;
}

/// Letters put in, left out or replaced to make one word the other.
std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t corner = row[0]++;  // of the row before, one to the left
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = corner + (from[i] == to[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({replaced, corner + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// What to say if another word stands where a command has to be; CLI11 would only miss the command.
std::string unknown_command(const CLI::App& program, const std::string& word) {
  const std::vector<std::string> names = command_names(program);
  if (word.starts_with('-') || std::find(names.begin(), names.end(), word) != names.end()) return {};
  const auto nearest = std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  return "'" + word + "' is no command; did you mean " + *nearest + "?";
}

ExitCode run(int argc, char** argv) {
  CLI::App program{"Reconstructs watertight solids from planar cross-sections on planes in any position.",
                   "crossloft"};
  program.set_version_flag("--version", "crossloft " CROSSLOFT_VERSION);
  program.require_subcommand(1);
  program.footer(kExitCodes);
  ExitCode outcome = kGood;
  add_reconstruct(program, outcome);
  add_repair(program, outcome);
  add_info(program, outcome);
  add_check(program, outcome);
  add_compare(program, outcome);
  add_slice(program, outcome);
  add_moebius(program, outcome);
  add_delaunay(program, outcome);
  add_demo(program, outcome);
  if (const std::string unknown = argc > 1 ? unknown_command(program, argv[1]) : ""; !unknown.empty()) {
    std::fprintf(stderr, "crossloft: %s (see crossloft --help)\n", unknown.c_str());
    return kUsage;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_parse_error(program, error);
  }
  return outcome;
}

}  // namespace

int main(int argc, char** argv) {
  prepare_heap();
  catch_interrupts();
  try {
    const ExitCode code = run(argc, argv);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    std::fputs("crossloft: standard output cannot be written\n", stderr);
    return code == kGood ? kBadFile : code;
  } catch (const std::bad_alloc&) {
    std::fputs("crossloft: out of memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crossloft: internal error: %s\n", error.what());
  }
  return kInternal;
}
