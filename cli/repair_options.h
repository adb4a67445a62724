#pragma once
/// The options of a repair on the command line.

#include "../repair/repair.h"
#include "arguments.h"

namespace crossloft::cli {

/// The largest displacement, under a name of the command's choice.
CLI::Option* add_repair_limit(CLI::App& command, const char* name, RepairOptions& options);

/// Everything else: tolerances and switches of the steps.
void add_repair_details(CLI::App& command, RepairOptions& options);

}  // namespace crossloft::cli
