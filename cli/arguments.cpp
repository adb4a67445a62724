#include "arguments.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "../io/atomic_file.h"

namespace crossloft::cli {

CLI::Validator extension_in(std::vector<std::string> extensions) {
  std::string list;
  for (const std::string& extension : extensions) list += (list.empty() ? "" : " ") + extension;
  const auto check = [extensions = std::move(extensions), list](const std::string& path) -> std::string {
    const std::size_t dot = path.find_last_of("./");
    std::string extension = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool known = std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
    return known ? "" : path + ": unknown extension, expected one of " + list;
  };
  return CLI::Validator(check, list);
}

CLI::Validator number_in(double low, double high) {
  char range[80];
  std::snprintf(range, sizeof range, "%g to %g", low, high);
  const auto check = [low, high, words = std::string(range)](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
    return text + " is not a number from " + words;
  };
  return CLI::Validator(check, range);
}

void add_plane_tolerance(CLI::App& command, double& value) {
  command
      .add_option("--plane-tolerance", value,
                  "a section vertex further from its plane is an error; a fraction of the diagonal")
      ->capture_default_str()
      ->check(number_in(0, 0.1));
}

CLI::Validator whole_number_in(std::uint64_t low, std::uint64_t high) {
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  const auto rewrite = [low, high, range](std::string& text) -> std::string {
    std::uint64_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = failure == std::errc() && end == text.data() + text.size();
    if (!whole || value < low || value > high) return text + " is not a whole number from " + range;
    text = std::to_string(value);
    return {};
  };
  return CLI::Validator(rewrite, range);
}

void refuse_options(const CLI::App& command, const std::vector<std::string>& names, const std::string& why) {
  for (const std::string& name : names)
    if (command.count(name) != 0) throw CLI::ValidationError(name, why);
}

namespace {

namespace fs = std::filesystem;

Error at(ErrorCode code, const char* message, const std::string& path) {
  return {code, message, path, 0, kNone, kNone};
}

bool same_file(const std::string& a, const std::string& b) {
  const auto reached_a = link_target(a), reached_b = link_target(b);
  if (!reached_a || !reached_b) return false;
  std::error_code unknown_a, unknown_b, none;
  const fs::path path_a = fs::weakly_canonical(*reached_a, unknown_a),
                 path_b = fs::weakly_canonical(*reached_b, unknown_b);
  if (!unknown_a && !unknown_b && path_a == path_b) return true;
  return fs::equivalent(*reached_a, *reached_b, none);
}

/// A file appears beside its target, under another name at first: it is the folder that is written to. What
/// is there and no regular file is written in its place.
Result<Done> check_output(const std::string& path) {
  const auto target = link_target(path);
  if (!target) return target.error();
  std::error_code none;
  const fs::file_status status = fs::status(*target, none);
  if (fs::is_directory(status))
    return at(ErrorCode::file_not_writable, "cannot be written: it is a folder", path);
  if (fs::exists(status) && !fs::is_regular_file(status)) return Done{};
  const fs::path parent = fs::path(*target).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  if (!fs::is_directory(folder, none))
    return at(ErrorCode::file_not_writable, "cannot be written: its folder is not there", path);
  if (access(folder.c_str(), W_OK) != 0)
    return at(ErrorCode::file_not_writable, "cannot be written: no permission in its folder", path);
  return Done{};
}

}  // namespace

Result<Done> check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty()) continue;
    for (const std::string& input : inputs)
      if (!input.empty() && same_file(input, outputs[i]))
        return at(ErrorCode::usage, "is the input, and would be overwritten", outputs[i]);
    for (std::size_t j = 0; j < i; ++j)
      if (!outputs[j].empty() && same_file(outputs[j], outputs[i]))
        return at(ErrorCode::usage, "is asked for twice, with different contents", outputs[i]);
    if (auto writable = check_output(outputs[i]); !writable) return writable;
  }
  return Done{};
}

}  // namespace crossloft::cli
