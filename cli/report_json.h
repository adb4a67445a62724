#pragma once
/// The report of a reconstruction as JSON; keys and their meaning are in docs/report.md.

#include <string>

#include "../reconstruct/reconstruct.h"
#include "../reconstruct/stack.h"
#include "../repair/repair.h"

namespace crossloft::cli {

/// Grows by one with every change that an old reader would stumble over.
inline constexpr int kReportVersion = 2;

struct ReportOrigin {
  std::string input;  ///< as the user named it
  Options options;
};

/// What was done to the sections first.
struct RepairOrigin {
  const Repair& repair;
  const RepairOptions& options;
};

/// Indented, with a line break at the end. Numbers that are not finite become null.
std::string report_json(const Report& report, const ReportOrigin& origin,
                        const RepairOrigin* repair = nullptr);

/// The report of a stack that was streamed: the keys that can be told piece by piece, and a part `stream`.
std::string report_json(const StackReport& report, const ReportOrigin& origin);

}  // namespace crossloft::cli
