#pragma once
/// The commands of the program, one source file each.

#include <CLI/CLI.hpp>

#include "exit_code.h"

namespace crossloft::cli {

// Each adds its command to the program; parsing a command line that names it runs it and leaves its exit
// code.
void add_reconstruct(CLI::App& program, ExitCode& outcome);
void add_repair(CLI::App& program, ExitCode& outcome);
void add_info(CLI::App& program, ExitCode& outcome);
void add_check(CLI::App& program, ExitCode& outcome);
void add_compare(CLI::App& program, ExitCode& outcome);
void add_slice(CLI::App& program, ExitCode& outcome);
void add_moebius(CLI::App& program, ExitCode& outcome);
void add_delaunay(CLI::App& program, ExitCode& outcome);
void add_demo(CLI::App& program, ExitCode& outcome);

}  // namespace crossloft::cli
