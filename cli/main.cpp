// crossloft: the program. Parses the command line, runs one command, turns every outcome into an exit code.
#include <cstdio>
#include <exception>

#include "commands.h"
#include "heap.h"
#include "terminal.h"

namespace {

using namespace crossloft::cli;

constexpr const char* kExitCodes =
    "Exit codes: 0 good, 1 a promise does not hold (after a repair: something is left as it was, or a "
    "contour\n"
    "was left out), 2 usage, 3 a file is not readable, not valid or not writable, 4 a defect of the program\n"
    "or no memory left, 130 interrupted.";

/// Help and version are printed and good; everything else is one message and usage.
ExitCode report_parse_error(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    program.exit(error);
    return kGood;
  }
  std::fprintf(stderr, "crossloft: %s (see crossloft --help)\n", error.what());
  return kUsage;
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
