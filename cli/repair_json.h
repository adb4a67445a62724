#pragma once
/// What a repair did, for a program (docs/report.md) and for a person.

#include <nlohmann/json_fwd.hpp>

#include <string>

#include "../repair/repair.h"
#include "terminal.h"

namespace crossloft::cli {

/// The part of a report that tells of a repair.
nlohmann::ordered_json repair_part(const Repair& repair, const RepairOptions& options);

/// The report of `crossloft repair`; `input` is the file as the user named it.
std::string repair_json(const Repair& repair, const RepairOptions& options, const std::string& input);

/// How many changes of which kind, how many defects are left and the largest displacement, to stdout; what is
/// left or was left out, one by one, as warnings.
void print_repair(Terminal& terminal, const Repair& repair);

/// kPromiseBroken if something was left.
ExitCode exit_code(const Repair& repair);

}  // namespace crossloft::cli
