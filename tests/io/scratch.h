#pragma once
/// A directory of its own for a test, and a context that remembers what it was told.

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "../../geom/context.h"

/// Removed with everything in it at the end of the test.
class Scratch {
 public:
  Scratch() {
    static std::atomic<int> next{0};
    const std::string name = "crossloft-" + std::to_string(::getpid()) + "-" + std::to_string(next++);
    directory_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(directory_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path(const std::string& name = "") const { return (directory_ / name).string(); }
  std::string add(const std::string& name, std::string_view bytes) const {
    std::ofstream(path(name), std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path(name);
  }
  std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t files() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(directory_)) count += entry.exists() ? 1 : 0;
    return count;
  }

 private:
  std::filesystem::path directory_;
};

struct Heard {
  std::vector<std::string> notes, warnings;

  crossloft::Context context() {
    crossloft::Context context;
    context.log = [this](crossloft::LogLevel level, std::string_view text) {
      (level == crossloft::LogLevel::note ? notes : warnings).emplace_back(text);
    };
    return context;
  }
};
