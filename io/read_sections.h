#pragma once
/// Reads cross-sections from `.contour` and `.csl` files; the grammars are in docs/formats.md.
///
/// Errors name the file, the line, the plane and the contour. What is legal but worth knowing (a flipped sign
/// of D, several materials, a label that says "outside") goes to the context. Reading is linear in the size
/// of the text.

#include <string>
#include <string_view>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "../geom/result.h"

namespace crossloft {

/// Reads a file by its extension, `.contour` or `.csl` in any case; another extension is ErrorCode::usage.
/// Errors: file_not_readable, syntax, truncated, bad_count, index_out_of_range, not_finite, zero_normal,
/// no_plane, too_large, cancelled. Whether contours close, cross or lie on their planes is judged by later
/// stages.
Result<Sections> read_sections(const std::string& path, const Context& context = {});

/// Parses the text of a `.contour` file; `name` is the file name used in messages.
/// Edges are numbered into contours by connected component, in order of first appearance. Ends of open chains
/// with equal coordinates are joined, so that a contour that repeats its first vertex at the end is closed.
Result<Sections> parse_contour(std::string_view text, std::string name, const Context& context = {});

/// Parses the text of a `.csl` file. A component is a contour; its edges have the component's label on one
/// side and 0 on the other, those of a hole the label of the parent component.
Result<Sections> parse_csl(std::string_view text, std::string name, const Context& context = {});

}  // namespace crossloft
