/// Seeds and kept finds of the fuzz targets, judged as the fuzzer judges them.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "../../io/atomic_file.h"
#include "targets.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const char* folder, const char* target) {
  const fs::path path = fs::path(CROSSLOFT_SOURCE_DIR) / "tests/fuzz" / folder / target;
  std::vector<fs::path> files;
  if (!fs::is_directory(path)) return files;
  for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void judge_files(const char* folder, bool needed) {
  for (const FuzzTarget& target : fuzz_targets()) {
    CAPTURE(target.name);
    const auto files = files_of(folder, target.name);
    if (needed) CHECK_FALSE(files.empty());
    for (const fs::path& file : files) {
      CAPTURE(file.string());
      const auto bytes = read_file(file.string());
      REQUIRE(bytes.ok());
      CHECK(target.judge(*bytes) == "");
    }
  }
}

}  // namespace

TEST_CASE("every target has seeds, and they keep all promises") { judge_files("seeds", true); }

TEST_CASE("what fuzzing has found once stays good") { judge_files("finds", false); }
