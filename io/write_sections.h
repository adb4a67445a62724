#pragma once
/// Writes cross-sections as `.contour` or `.csl`, planes as n.x + D = 0, numbers as the shortest decimals
/// that read back as the same doubles.

#include <string>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "../geom/result.h"

namespace crossloft {

/// Writes a file by its extension, `.contour` or `.csl` in any case; another extension is ErrorCode::usage.
/// The target appears whole or stays as it was (ErrorCode::file_not_writable). What would not be read back is
/// not written: errors of check_numbers() (arrangement/normalise.h), and for `.csl` those of format_csl().
Result<Done> write_sections(const std::string& path, const Sections& sections, const Context& context = {});

/// The text of a `.contour` file. Reading it gives the same planes, vertices and edges in the same order;
/// only source, lines and contour numbers are new. REQUIRES for that: check_numbers() finds nothing.
std::string format_contour(const Sections& sections);

/// The text of a `.csl` file: the walls of each section as closed loops that do not cross at vertices of
/// higher degree, holes marked with their parent. The format knows one material per contour; where a loop has
/// more, the first is written and the context warned. The marks of holes are decided in double precision and
/// are advisory: inside is even-odd. Errors: those of check_numbers(), open_chain when walls do not close.
Result<std::string> format_csl(const Sections& sections, const Context& context = {});

}  // namespace crossloft
