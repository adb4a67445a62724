#pragma once
/// JSON and files, as far as the benchmarks write them.

#include <string>
#include <vector>

namespace crossloft::bench {

/// "a", with what JSON wants escaped but control characters, which become spaces.
std::string json_string(const std::string& value);
/// ["a", "b"]
std::string json_strings(const std::vector<std::string>& values);
/// [1, 0.5] with six digits.
std::string json_numbers(const std::vector<double>& values);

/// Nothing to do without a path; false, and a word on stderr, if the file cannot be written.
bool write_file(const std::string& path, const std::string& text);

}  // namespace crossloft::bench
