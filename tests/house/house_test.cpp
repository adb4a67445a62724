// The rules of the house (CONTRIBUTING.md), read off the sources themselves.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "source_scan.h"

namespace {

namespace fs = std::filesystem;

const std::array<std::string, 10> kRooms = {"geom",  "delaunay",    "arrangement", "repair", "moebius",
                                            "prune", "reconstruct", "inspect",     "io",     "cli"};

struct Source {
  fs::path path;  ///< relative to the root, as in "geom/vec3.h"
  std::string text;

  std::string room() const { return path.begin()->string(); }
  bool is_header() const { return path.extension() == ".h"; }
};

std::size_t rank_of(const std::string& room) {
  return static_cast<std::size_t>(std::find(kRooms.begin(), kRooms.end(), room) - kRooms.begin());
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Headers and sources under a folder of the root, in the order of their names.
std::vector<Source> sources_under(const std::string& folder) {
  const fs::path root = CROSSLOFT_SOURCE_DIR;
  std::vector<Source> sources;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".h" && path.extension() != ".cpp") continue;
    sources.push_back({fs::relative(path, root), text_of(path)});
  }
  std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return sources;
}

std::vector<Source> sources_of_rooms() {
  std::vector<Source> sources;
  for (const std::string& room : kRooms) {
    for (Source& source : sources_under(room)) sources.push_back(std::move(source));
  }
  return sources;
}

/// What stands between the delimiters of the #include lines, quoted and angled ones apart.
struct Includes {
  std::vector<std::string> quoted, angled;
};

Includes includes_of(const std::string& text) {
  Includes includes;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("#include", 0) != 0) continue;
    const std::size_t open = line.find_first_of("\"<");
    const std::size_t close = line.find_first_of("\">", open + 1);
    (line[open] == '"' ? includes.quoted : includes.angled)
        .push_back(line.substr(open + 1, close - open - 1));
  }
  return includes;
}

bool starts_with_any(const std::string& name, const std::vector<std::string>& prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(), [&](const auto& p) { return name.rfind(p, 0) == 0; });
}

std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// The name of the type that a line at namespace scope defines, empty if it does not.
std::string defined_type(const std::string& line) {
  if (line.find(';') != std::string::npos && line.find('{') == std::string::npos) return {};
  for (const std::string key : {"struct ", "class ", "enum class "}) {
    if (line.rfind(key, 0) != 0) continue;
    const std::size_t end = line.find_first_of(" <:{", key.size());
    // A specialisation, or a class within another.
    const bool special = end != std::string::npos && (line[end] == '<' || line.compare(end, 2, "::") == 0);
    return special ? std::string() : line.substr(key.size(), end - key.size());
  }
  return {};
}

/// Types by full name that others can see, of one source. Namespaces open and close at the start of a line.
std::vector<std::string> types_of(const std::string& text) {
  std::vector<std::string> spaces, types;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("namespace ", 0) == 0) spaces.push_back(line.substr(10));
    if (line.rfind("}  // namespace", 0) == 0 && !spaces.empty()) spaces.pop_back();
    const bool hidden = std::find(spaces.begin(), spaces.end(), "{") != spaces.end();
    if (const std::string name = defined_type(line); !name.empty() && !hidden)
      types.push_back(std::accumulate(spaces.begin(), spaces.end(), std::string()) + " " + name);
  }
  return types;
}

}  // namespace

TEST_CASE("folders include one way only, and io is used by the edge alone") {
  for (const Source& source : sources_of_rooms()) {
    for (const std::string& name : includes_of(source.text).quoted) {
      CAPTURE(source.path.string());
      CAPTURE(name);
      const fs::path target = (source.path.parent_path() / name).lexically_normal();
      CHECK_MESSAGE(fs::exists(fs::path(CROSSLOFT_SOURCE_DIR) / target),
                    "includes are relative to their file");
      const std::string room = target.begin()->string();
      CHECK(rank_of(room) <= rank_of(source.room()));
      if (room == "io") CHECK((source.room() == "io" || source.room() == "cli"));
    }
  }
}

TEST_CASE("foreign headers stay in their place") {
  for (const Source& source : sources_of_rooms()) {
    CAPTURE(source.path.string());
    // The strategies are there to compare number types; only tests and benchmarks include them.
    const bool strategy = source.path.string().rfind("geom/strategies/", 0) == 0;
    for (const std::string& name : includes_of(source.text).angled) {
      CAPTURE(name);
      if (strategy && starts_with_any(name, {"boost/", "gmp"})) continue;
      if (starts_with_any(name, {"boost/", "Eigen/"})) {
        CHECK((!source.is_header() || source.path == fs::path("geom/homogeneous.h")));
      }
      if (starts_with_any(name, {"CLI/", "nlohmann/", "png.h"})) CHECK(source.room() == "cli");
      CHECK_FALSE(starts_with_any(name, {"CGAL/", "gmp", "doctest/"}));
      if (source.room() != "cli") CHECK_FALSE(starts_with_any(name, {"iostream"}));
    }
  }
}

TEST_CASE("nothing but tests and benchmarks includes the strategies") {
  for (const Source& source : sources_of_rooms()) {
    if (source.path.string().rfind("geom/strategies/", 0) == 0) continue;
    CAPTURE(source.path.string());
    for (const std::string& name : includes_of(source.text).quoted)
      CHECK(name.find("strategies/") == std::string::npos);
  }
}

TEST_CASE("the library neither throws nor asks for types at run time") {
  for (const Source& source : sources_of_rooms()) {
    // One header turns failed allocations into errors, in builds that have exceptions.
    if (source.room() == "cli" || source.path == fs::path("geom/failing.h")) continue;
    CAPTURE(source.path.string());
    const std::string code = house::blank_comments_and_literals(source.text);
    for (const char* word : {"throw", "try", "catch", "dynamic_cast", "typeid", "cout", "cerr"}) {
      CAPTURE(word);
      CHECK_FALSE(house::contains_word(code, word));
    }
  }
}

TEST_CASE(
    "no two files define types of one name: the linker would take the functions of one for the other's") {
  std::map<std::string, fs::path> file_of;
  for (const Source& source : sources_of_rooms())
    for (const std::string& type : types_of(source.text)) {
      CAPTURE(type);
      const auto [place, is_new] = file_of.emplace(type, source.path);
      CHECK_MESSAGE((is_new || place->second == source.path), source.path.string()
                                                                  << " and " << place->second.string());
    }
  CHECK(file_of.size() > 200);
}

TEST_CASE("rooms stay small: headers under 300 lines, files under 800") {
  std::vector<Source> sources = sources_of_rooms();
  for (const char* folder : {"tests", "bench", "examples"}) {
    for (Source& source : sources_under(folder)) sources.push_back(std::move(source));
  }
  for (const Source& source : sources) {
    CAPTURE(source.path.string());
    CHECK(line_count(source.text) < (source.is_header() ? 300u : 800u));
  }
}

TEST_CASE("functions fit in one look: none over 60 lines without a reason, nine of ten within 30") {
  std::vector<std::size_t> lengths;
  for (const Source& source : sources_of_rooms()) {
    CAPTURE(source.path.string());
    for (const house::Function& f : house::functions_of(source.text)) {
      CAPTURE(f.name);
      CAPTURE(f.first_line);
      CHECK_MESSAGE((f.lines <= 60 || f.excused), f.lines << " lines and no comment \"// long: reason\"");
      lengths.push_back(f.lines);
    }
  }
  std::sort(lengths.begin(), lengths.end());
  REQUIRE_FALSE(lengths.empty());
  MESSAGE(lengths.size() << " functions, median " << lengths[lengths.size() / 2]
                         << " lines, nine of ten within " << lengths[lengths.size() * 9 / 10]);
  CHECK(lengths[lengths.size() / 2] <= 8);
  CHECK(lengths[lengths.size() * 9 / 10] <= 30);
}

TEST_CASE("every header has its include guard and a first comment that says what it is") {
  for (const Source& source : sources_of_rooms()) {
    if (!source.is_header()) continue;
    CAPTURE(source.path.string());
    CHECK(source.text.rfind("#pragma once\n///", 0) == 0);
  }
}

TEST_CASE("every folder has its page, and the README's example is the one that is compiled") {
  const fs::path root = CROSSLOFT_SOURCE_DIR;
  for (const std::string& room : kRooms) {
    CAPTURE(room);
    CHECK(fs::exists(root / room / "README.md"));
  }
  const std::string readme = text_of(root / "README.md"), fence = "```cpp\n";
  const std::size_t begin = readme.find(fence) + fence.size(), end = readme.find("```", begin);
  REQUIRE(end != std::string::npos);
  CHECK(text_of(root / "examples/minimal.cpp").find(readme.substr(begin, end - begin)) != std::string::npos);
}

TEST_CASE("the scanner finds functions and their lengths") {
  const std::string text = R"x(
namespace a {
struct S {
  S() : x_{1}, y_(2) {
  }
  int one() const { return x_; }  // with a { in a comment
  std::array<int, 2> v{1, 2};
};
template <class T>
T two(const T& t = {}) {
  auto f = [&](int i) {
    return i + '{' + 1'000;
  };
  return f(3);
}
// long: because.
void three() {

}
constexpr int table[] = {
  1, 2
};
}
)x";
  const std::vector<house::Function> found = house::functions_of(text);
  REQUIRE(found.size() == 4);
  CHECK(found[0].name == "S");
  CHECK(found[0].lines == 2);
  CHECK(found[1].name == "one");
  CHECK(found[1].lines == 1);
  CHECK(found[2].name == "two");
  CHECK(found[2].first_line == 9);
  CHECK(found[2].lines == 7);
  CHECK(found[3].excused);
  CHECK_FALSE(found[2].excused);
}
