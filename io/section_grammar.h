#pragma once
/// What a format of cross-sections consists of: a header and planes, one after the other.

#include <string>

#include "../arrangement/sections.h"
#include "token_reader.h"

namespace crossloft {

struct ParsedPlane {
  PlaneSection section;
  bool has_outside_label = false;  ///< a component with a label below 1, which was taken as 1
};

/// Both read on after an error, in vain.
struct SectionGrammar {
  /// Returns the number of planes.
  std::uint32_t (*header)(TokenReader& in);
  /// The plane at a position of the file, which the reader has entered.
  ParsedPlane (*plane)(TokenReader& in, std::uint32_t position);
};

const SectionGrammar& contour_grammar();
const SectionGrammar& csl_grammar();
/// By the extension of the path; null if there is none for it.
const SectionGrammar* grammar_of(const std::string& path);

}  // namespace crossloft
