#pragma once
/// What check and compare found, as JSON; keys and their meaning are in docs/report.md.

#include <string>
#include <vector>

#include "../inspect/check.h"
#include "../inspect/compare.h"

namespace crossloft::cli {

/// Each grows by one with every change that an old reader would stumble over.
inline constexpr int kCheckVersion = 1, kCompareVersion = 1;

struct CheckOrigin {
  std::string surface, sections;  ///< as the user named them; the second is empty if there are none
  SectionCheckOptions options;
  double max_distance = 0, max_missing = 0, max_extra = 0;
};

/// Indented, with a line break at the end. Numbers that are not finite become null. `sections` is null if
/// there are none, `broken` are the promises that don't hold.
std::string check_json(const CheckReport& surface, const SectionCheck* sections, const CheckOrigin& origin,
                       const std::vector<std::string>& broken);

/// `a` and `b` are the files as the user named them.
std::string compare_json(const CompareReport& report, const std::string& a, const std::string& b);

}  // namespace crossloft::cli
