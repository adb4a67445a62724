#pragma once
/// What the user is told of a whole and of its stream, to be compared.

#include <algorithm>
#include <string>
#include <vector>

namespace crossloft::test {

/// Sorted notes and warnings; of merged vertices, which may count twice in a stream, nothing.
inline std::vector<std::string> words_of(const std::vector<std::string>& notes, std::vector<std::string> warnings) {
  warnings.insert(warnings.end(), notes.begin(), notes.end());
  std::erase_if(warnings, [](const std::string& text) {
    return text.find("were merged with others") != std::string::npos;
  });
  std::sort(warnings.begin(), warnings.end());
  return warnings;
}

}  // namespace crossloft::test
