#pragma once
/// A way to run the pipeline on a file: under one strategy, or as the product is. Plain types alone:
/// strategies run in a copy of the library under another namespace, see CMakeLists.txt.

#include <array>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace pipeline_bench {

/// The predicates that a reconstruction asks.
inline constexpr std::array<const char*, 5> kPredicates{"orient3d", "insphere", "orient2d", "incircle",
                                                        "side_of_plane"};

/// What a run gave; without pointers, so that a child process can write it to its parent.
struct Outcome {
  static constexpr std::size_t kMostStages = 8;

  char error[160] = "";  ///< empty if there is a result
  double seconds = 0;    ///< of processor time, of reconstruct() alone
  std::uint64_t hash = 0;
  std::uint64_t tets = 0, triangles = 0;
  std::uint64_t asked[kPredicates.size()] = {};        ///< questions by predicate; 0 unless counted
  std::uint64_t decided[kMostStages] = {}, wrong = 0;  ///< by stage, the last for unknown; 0 unless counted

  bool ok() const { return error[0] == 0; }
  void fail(const std::string& message) { std::snprintf(error, sizeof error, "%s", message.c_str()); }
};
static_assert(std::is_trivially_copyable_v<Outcome>);

/// What a timed run takes at least.
inline constexpr double kLeastSeconds = 0.25;

struct Way {
  std::string name;
  bool exact = false;
  std::vector<std::string> stages;  ///< of a cascade; else the strategy itself
  std::function<Outcome()> run;
  /// Answers come from exact integers, the strategy is asked beside them: `asked`, `decided` and `wrong`.
  /// Empty for the product.
  std::function<Outcome()> count;
};

/// As the product is, without any hook.
Way product(const std::string& path);

/// Under every strategy of geom/strategies/list.h but the product's own. The file is run through once, for
/// the extent of what is asked: static filters get theirs for each predicate. A file that gives an error
/// gives no ways.
std::vector<Way> under_strategies(const std::string& path);

}  // namespace pipeline_bench
