#pragma once
/// Reads the sites of a Moebius diagram from a text file; the grammar is in docs/formats.md.

#include <string>
#include <string_view>
#include <vector>

#include "../geom/result.h"
#include "../moebius/diagram.h"

namespace crossloft {

/// Reads a file of sites, one a line, in the order of the lines. Linear in the size of the text.
/// Errors, with the line: file_not_readable, syntax (no number, or not two to four of them), not_finite,
/// truncated (no site in the file).
Result<std::vector<MoebiusSite>> read_sites(const std::string& path);

/// Parses "x y [lambda [mu]]" lines; `name` is the file name used in messages. Missing numbers are lambda = 1
/// and mu = 0; '#' starts a comment.
Result<std::vector<MoebiusSite>> parse_sites(std::string_view text, std::string name);

}  // namespace crossloft
