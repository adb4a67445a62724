#pragma once
/// Reads C++ sources just well enough to measure them: comments and literals blanked, functions found by
/// braces.

#include <cstddef>
#include <string>
#include <vector>

namespace house {

struct Function {
  std::string name;            ///< the text before its first parenthesis, last word
  std::size_t first_line = 0;  ///< 1-based, where its declaration starts
  std::size_t lines = 0;       ///< from there to the closing brace, both counted
  bool excused = false;        ///< a comment "long: reason" stands inside it or right before it
};

/// The text with comments, literals and preprocessor lines replaced by blanks; line breaks stay.
std::string blank_comments_and_literals(const std::string& text);

/// Functions with a body at namespace or class scope. Lambdas and local classes count as part of their
/// function.
std::vector<Function> functions_of(const std::string& text);

bool contains_word(const std::string& text, const std::string& word);

}  // namespace house
