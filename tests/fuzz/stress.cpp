/// Random small section sets through the pipeline, each judged by all promises (promises.h).
///
///   stress [--count N] [--seed S] [--first K] [--threads T] [--keep FOLDER] [--mode
///   natural|joint|paper|careful|thick|far|far_thick]
///
/// Mode careful: natural, with points inside all cells, and joins in doubt decided by what is around in all.
/// Mode thick: any of the three, with plates over what is flat, and some with all copies moved apart or as
/// careful.
/// Mode far: any of the three, moved away by 1e3 to 1e13 sizes, where rounding makes triangles cross.
/// Mode far_thick: both.
/// Input k of seed S is the same whatever the others are: --first K --count 1 repeats it. Broken promises are
/// printed, with --keep also kept as FOLDER/S-K.bytes (an input of the fuzz target, for mode far before it is
/// moved) and FOLDER/S-K.contour.
/// Exit 1 if there was one.
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "../../inspect/random.h"
#include "../../io/atomic_file.h"
#include "../../io/write_sections.h"
#include "promises.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

struct Arguments {
  std::uint64_t count = 2000, seed = 1, first = 0, threads = 1;
  std::string keep;
  std::optional<PruneMode> mode;
  bool careful = false, thick = false, far = false;
};

/// What was seen of one kind of set.
struct Tally {
  std::uint64_t inputs = 0, refused = 0, too_thin = 0, empty = 0, broken = 0, merged = 0, outside = 0,
                bare = 0, streamed = 0, unlike = 0;
  void add(const Verdict& v) {
    ++inputs;
    refused += v.error.has_value();
    too_thin += v.error == ErrorCode::too_thin;
    empty += v.empty;
    broken += !v.broken.empty();
    merged += v.merged;
    outside += v.outside != 0;
    bare += v.bare;
    streamed += v.stack;
    unlike += v.unlike;
  }
};

std::array<std::uint8_t, 160> bytes_of(std::uint64_t seed, std::uint64_t k) {
  Random random(seed * 0x9E3779B97F4A7C15u + k * 0xD1B54A32D192ED03u);
  std::array<std::uint8_t, 160> bytes;
  for (std::uint8_t& b : bytes) b = static_cast<std::uint8_t>(random.next() >> 56);
  return bytes;
}

class Stress {
 public:
  explicit Stress(const Arguments& arguments) : arguments_(arguments) {}

  bool run() {
    std::vector<std::thread> workers;
    for (std::uint64_t t = 1; t < arguments_.threads; ++t) workers.emplace_back([this] { drain(); });
    drain();
    for (std::thread& worker : workers) worker.join();
    return print();
  }

 private:
  void drain() {
    for (std::uint64_t i; (i = next_.fetch_add(1)) < arguments_.count;) one(arguments_.first + i);
  }

  void one(std::uint64_t k) {
    const auto bytes = bytes_of(arguments_.seed, k);
    ByteSource source(bytes);
    SectionSet set = draw_section_set(source);
    if (arguments_.mode) set.options.mode = *arguments_.mode;
    if (arguments_.careful) set.options.natural.divide = set.options.natural.look_around = InCells::all;
    if (arguments_.thick) draw_plates(k, set.options);
    if (arguments_.far) move_away(k, set);
    const auto begin = std::chrono::steady_clock::now();
    const Verdict verdict = judge(set);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const std::lock_guard lock(mutex_);
    tallies_[set.kind].add(verdict);
    if (took.count() > slowest_) slowest_ = took.count(), slowest_input_ = k;
    if (!verdict.broken.empty())
      report(k, set, verdict, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  /// From numbers of their own, so that the set is that of the other modes.
  void draw_plates(std::uint64_t k, Options& options) const {
    static constexpr double kHeights[] = {0.01, 0.01, 1e-3, 0.2, 1, 1e-9};
    static constexpr double kMoves[] = {0, 0, 1e-3, 0.05};
    const auto bytes = bytes_of(~arguments_.seed, k);
    ByteSource source(bytes);
    options.thicken = source.one_of(kHeights);
    options.separation = source.one_of(kMoves);
    options.natural.divide = source.one_in(4) ? InCells::all : InCells::automatic;
    options.natural.look_around = source.one_in(4) ? InCells::all : InCells::automatic;
  }

  /// Likewise. What is moved need not agree as before.
  void move_away(std::uint64_t k, SectionSet& set) const {
    const auto bytes = bytes_of(~arguments_.seed, k);
    ByteSource source(bytes);
    Bounds box;
    for (const PlaneSection& plane : set.sections.planes)
      for (const Vec3& v : plane.vertices) box.add(v);
    if (box.empty()) return;
    const double distance = box.diagonal() * std::pow(10, source.between(3, 13));
    const auto along = [&] { return distance * source.between(-8, 8) / 7; };
    const Vec3 by{along(), along(), along()};
    for (PlaneSection& plane : set.sections.planes) {
      for (Vec3& v : plane.vertices) v = v + by;
      plane.offset -= dot(plane.normal, by);
    }
    set.consistent = false;
    set.told_twice = true;
  }

  void report(std::uint64_t k, const SectionSet& set, const Verdict& verdict, std::string_view bytes) const {
    std::printf("input %llu (%s, %s): %s\n", static_cast<unsigned long long>(k), set.kind,
                name_of(set.options.mode), verdict.broken.c_str());
    std::fflush(stdout);
    if (arguments_.keep.empty()) return;
    const std::string name =
        arguments_.keep + "/" + std::to_string(arguments_.seed) + "-" + std::to_string(k);
    const bool kept =
        write_file(name + ".bytes", bytes).ok() && write_sections(name + ".contour", set.sections).ok();
    if (!kept) std::printf("  could not be kept\n");
  }

  static void print_line(const char* name, const Tally& t) {
    std::printf("%-10s", name);
    for (const std::uint64_t n : {t.inputs, t.refused, t.too_thin, t.empty, t.merged, t.outside, t.bare,
                                  t.streamed, t.unlike, t.broken})
      std::printf(" %9llu", static_cast<unsigned long long>(n));
    std::printf("\n");
  }

  bool print() const {
    Tally all;
    std::printf("%-10s %9s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n", "planes", "inputs", "refused", "too thin",
                "empty", "merged", "outside", "bare", "streamed", "unlike", "broken");
    for (const auto& [name, t] : tallies_) {
      print_line(name.c_str(), t);
      all.inputs += t.inputs, all.refused += t.refused, all.too_thin += t.too_thin, all.empty += t.empty;
      all.merged += t.merged, all.outside += t.outside, all.bare += t.bare, all.streamed += t.streamed,
          all.unlike += t.unlike, all.broken += t.broken;
    }
    print_line("all", all);
    std::printf("slowest: input %llu, %.3f s\n", static_cast<unsigned long long>(slowest_input_), slowest_);
    // Mode far is for these; a thousand sets have some.
    const bool is_idle = arguments_.far && arguments_.count >= 1000 && all.merged == 0;
    if (is_idle) std::printf("no set needed a merge\n");
    return all.broken == 0 && !is_idle;
  }

  const Arguments& arguments_;
  std::atomic<std::uint64_t> next_{0};
  std::mutex mutex_;
  std::map<std::string, Tally> tallies_;
  double slowest_ = 0;
  std::uint64_t slowest_input_ = 0;
};

bool parse_number(const char* text, std::uint64_t& number) {
  const auto [end, error] = std::from_chars(text, text + std::strlen(text), number);
  return error == std::errc() && *end == '\0';
}

bool parse_mode(const std::string& name, Arguments& a) {
  a.careful = name == "careful";
  if (a.careful) a.mode = PruneMode::natural;
  a.thick = name == "thick" || name == "far_thick";
  a.far = name == "far" || name == "far_thick";
  if (a.thick || a.far) return true;
  for (const PruneMode m : {PruneMode::natural, PruneMode::joint, PruneMode::paper})
    if (name == name_of(m)) a.mode = m;
  return a.mode.has_value();
}

bool parse(int argc, char** argv, Arguments& a) {
  if (argc % 2 == 0) return false;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    bool good = true;
    if (name == "--count")
      good = parse_number(argv[i + 1], a.count);
    else if (name == "--seed")
      good = parse_number(argv[i + 1], a.seed);
    else if (name == "--first")
      good = parse_number(argv[i + 1], a.first);
    else if (name == "--threads")
      good = parse_number(argv[i + 1], a.threads);
    else if (name == "--mode")
      good = parse_mode(argv[i + 1], a);
    else if (name == "--keep")
      a.keep = argv[i + 1];
    else
      good = false;
    if (!good) return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    std::fputs("stress [--count N] [--seed S] [--first K] [--threads T] [--keep FOLDER] [--mode M]\n",
               stderr);
    return 2;
  }
  std::printf("seed %llu\n", static_cast<unsigned long long>(arguments.seed));
  return Stress(arguments).run() ? EXIT_SUCCESS : EXIT_FAILURE;
}
