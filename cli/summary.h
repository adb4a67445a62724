#pragma once
/// What a person wants to know about a reconstruction, in a few lines.

#include "../reconstruct/report.h"
#include "../reconstruct/stack.h"
#include "terminal.h"

namespace crossloft::cli {

/// Notes and warnings of the report to stderr, its main numbers to stdout.
void print_summary(Terminal& terminal, const Report& report);
void print_summary(Terminal& terminal, const StackReport& report);

}  // namespace crossloft::cli
