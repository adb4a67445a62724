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

/// How many changes of which kind, the largest displacement, and what is left, to stdout.
void print_repair(Terminal& terminal, const Repair& repair);

}  // namespace crossloft::cli
