/// A file for every kind of mistake, with the message and the exit code that it must give.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "../../cli/exit_code.h"
#include "../../cli/plane_list.h"
#include "../../inspect/slice.h"
#include "../../io/read_mesh.h"
#include "../../io/read_points.h"
#include "../../io/read_sections.h"
#include "../../io/read_sites.h"
#include "../../reconstruct/reconstruct.h"

using namespace crossloft;

namespace {

namespace fs = std::filesystem;
using Outcome = Result<Done>;

template <class T>
Outcome outcome(const Result<T>& result) {
  return result ? Outcome(Done{}) : Outcome(result.error());
}

Outcome sections(const std::string& file) {
  const auto read = read_sections(file);
  return read ? outcome(reconstruct(*read)) : outcome(read);
}

Outcome sliced(const std::string& file) {
  const auto mesh = read_surface(file);
  const std::vector<CuttingPlane> planes{{{1, 0, 0}, -0.25}};
  auto result = mesh ? outcome(slice(*mesh, planes)) : outcome(mesh);
  if (!result && result.error().file.empty()) result.error().file = file;  // as the program does
  return result;
}

/// What a file is read by: its folder says.
const std::map<std::string, Outcome (*)(const std::string&)> kReaders = {
    {"contour", sections},
    {"csl", sections},
    {"ply", [](const std::string& f) { return outcome(read_surface(f)); }},
    {"obj", [](const std::string& f) { return outcome(read_surface(f)); }},
    {"off", [](const std::string& f) { return outcome(read_surface(f)); }},
    {"stl", [](const std::string& f) { return outcome(read_surface(f)); }},
    {"medit", [](const std::string& f) { return outcome(read_solid(f)); }},
    {"vtu", [](const std::string& f) { return outcome(read_solid(f)); }},
    {"points", [](const std::string& f) { return outcome(read_points(f)); }},
    {"weighted", [](const std::string& f) { return outcome(read_weighted_points(f)); }},
    {"sites", [](const std::string& f) { return outcome(read_sites(f)); }},
    {"planes", [](const std::string& f) { return outcome(cli::read_planes(f)); }},
    {"slice", sliced},
};

/// Lines "EXIT MESSAGE" of expected.txt; the message begins with the file, as the program prints it.
std::vector<std::pair<int, std::string>> expectations() {
  std::ifstream list("expected.txt");
  std::vector<std::pair<int, std::string>> lines;
  int code = 0;
  for (std::string message; list >> code && std::getline(list >> std::ws, message);)
    lines.emplace_back(code, message);
  return lines;
}

std::set<std::string> files() {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator("."))
    if (entry.is_regular_file() && entry.path().filename() != "expected.txt")
      files.insert(entry.path().lexically_normal().string());
  return files;
}

struct InFolder {
  explicit InFolder(const fs::path& folder) : before(fs::current_path()) { fs::current_path(folder); }
  ~InFolder() { fs::current_path(before); }
  fs::path before;
};

}  // namespace

TEST_CASE("every bad file gives its one message and its exit code") {
  const InFolder here(CROSSLOFT_SOURCE_DIR "/tests/io/bad");
  std::set<std::string> missing = files();
  std::set<ErrorCode> seen;
  for (const auto& [code, message] : expectations()) {
    const std::string file = message.substr(0, message.find(':'));
    CAPTURE(file);
    CHECK(missing.erase(file) == 1);
    const Outcome result = kReaders.at(file.substr(0, file.find('/')))(file);
    REQUIRE_FALSE(result.ok());
    CHECK(to_string(result.error()) == message);
    CHECK(cli::exit_code(result.error().code) == code);
    seen.insert(result.error().code);
  }
  CHECK(missing == std::set<std::string>{});
  for (const ErrorCode code :
       {ErrorCode::usage, ErrorCode::syntax, ErrorCode::truncated, ErrorCode::bad_count,
        ErrorCode::index_out_of_range, ErrorCode::not_finite, ErrorCode::zero_normal, ErrorCode::off_plane,
        ErrorCode::open_chain, ErrorCode::self_crossing, ErrorCode::contradicting_planes, ErrorCode::no_plane,
        ErrorCode::not_closed, ErrorCode::too_large, ErrorCode::too_thin}) {
    CAPTURE(static_cast<int>(code));
    CHECK(seen.count(code) == 1);
  }
}

TEST_CASE("a file that is not there or is a folder says so, in every format") {
  const InFolder here(CROSSLOFT_SOURCE_DIR "/tests/io/bad");
  for (const char* name : {"contour/none.contour", "csl/none.csl", "ply/none.ply", "medit/none.mesh",
                           "points/none.txt", "weighted/none.f64", "sites/none.txt", "planes/none.txt"}) {
    const std::string file = name;
    const Outcome result = kReaders.at(file.substr(0, file.find('/')))(file);
    REQUIRE_FALSE(result.ok());
    CHECK(result.error().code == ErrorCode::file_not_readable);
    CHECK(to_string(result.error()) == file + ": cannot be read: No such file or directory");
  }
}
