// The whole reconstruction under every strategy: milliseconds of processor time, multiples of the product's
// time, whether the result is the product's to the last bit, and which stage of a cascade decided how often.
//
//   bench_pipeline_strategies [--json FILE] [--repetitions N] [--limit SECONDS] [FILE.contour | FILE.csl ...]
//
// Without files, some of examples/. Every run is a child process with limits: strategies that are no exact
// ones may give something else, an error, or nothing. Runs take turns, a time is the median; who has used up
// the limit by repeating runs no more.
//
// Exit codes: 0; 1 if an exact strategy gave another result than the product, or an error; 2 usage; 3 files.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "measurement.h"
#include "output.h"
#include "pipeline/trial.h"

namespace {

using namespace crossloft::bench;
using namespace pipeline_bench;

constexpr std::array<const char*, 5> kExamples{"demo", "figures/fig14p", "figures/fig17",
                                               "figures/fig17_cross", "figures/fig19"};

struct Options {
  std::vector<std::string> files;
  std::string json;
  int repetitions = 5;
  Limits limits;
};

/// A strategy on one input.
struct Row {
  Way way;
  Outcome outcome{}, counts{};  ///< of the first run; of the questions
  std::vector<double> seconds{};

  double time() const { return median(seconds); }
  bool same_as(const Outcome& product) const { return outcome.ok() && outcome.hash == product.hash; }
  std::string result(const Outcome& product) const {
    return !outcome.ok() ? outcome.error : same_as(product) ? "same" : "other result";
  }
};

struct Table {
  std::string input;
  std::vector<Row> rows;  ///< the product last
  const Row& product() const { return rows.back(); }
};

void repeat(Row& row, const Limits& limits) {
  double used = 0;
  for (const double s : row.seconds) used += s;
  if (!row.outcome.ok() || used + row.seconds.front() > limits.seconds) return;
  if (const Outcome outcome = try_in_child(row.way.run, limits); outcome.ok())
    row.seconds.push_back(outcome.seconds);
}

/// What a strategy would have said is of interest where that is not simply the truth.
bool worth_counting(const Way& way) { return way.count && (!way.exact || way.stages.size() > 1); }

/// False, with a word on stderr, if the product itself has no result.
bool measure(const std::string& file, const Options& options, Table& table) {
  table.input = file;
  for (Way& way : under_strategies(file)) table.rows.push_back({std::move(way)});
  table.rows.push_back({product(file)});
  for (Row& row : table.rows) {
    row.outcome = try_in_child(row.way.run, options.limits);
    if (row.outcome.ok()) row.seconds.push_back(row.outcome.seconds);
    if (worth_counting(row.way)) row.counts = try_in_child(row.way.count, options.limits);
    std::fprintf(stderr, "%s: %s\n", row.way.name.c_str(), row.outcome.ok() ? "done" : row.outcome.error);
  }
  if (!table.product().outcome.ok()) {
    std::fprintf(stderr, "%s: %s\n", file.c_str(), table.product().outcome.error);
    return false;
  }
  for (int round = 1; round < options.repetitions; ++round)
    for (Row& row : table.rows) repeat(row, options.limits);
  return true;
}

/// Shares by stage, the last of unknown answers.
std::vector<double> decided(const Row& row) {
  double sum = 0;
  for (const auto n : row.counts.decided) sum += static_cast<double>(n);
  std::vector<double> shares;
  for (std::size_t i = 0; sum > 0 && i <= row.way.stages.size(); ++i)
    shares.push_back(static_cast<double>(row.counts.decided[i]) / sum);
  return shares;
}

std::string percents(const std::vector<double>& shares) {
  std::string text;
  for (const double share : shares) {
    char number[32];
    std::snprintf(number, sizeof number, "%s%.4g", text.empty() ? "" : " / ", 100 * share);
    text += number;
  }
  return text;
}

void print_row(const Row& row, const Row& own) {
  if (row.outcome.ok())
    std::printf("%-50s %10.1f %8.2fx", row.way.name.c_str(), 1e3 * row.time(), row.time() / own.time());
  else
    std::printf("%-50s %10s %9s", row.way.name.c_str(), "-", "-");
  std::printf("  %-16s %s", row.result(own.outcome).c_str(), percents(decided(row)).c_str());
  if (row.counts.wrong > 0) std::printf(", %llu wrong", static_cast<unsigned long long>(row.counts.wrong));
  std::printf("\n");
}

void print(const Table& table) {
  const Row& own = table.product();
  std::printf("\n%s: %llu tetrahedra, %llu triangles\nasked:", table.input.c_str(),
              static_cast<unsigned long long>(own.outcome.tets),
              static_cast<unsigned long long>(own.outcome.triangles));
  for (std::size_t k = 0; k < kPredicates.size(); ++k)
    std::printf(" %s %llu%s", kPredicates[k],
                static_cast<unsigned long long>(table.rows.front().counts.asked[k]),
                k + 1 < kPredicates.size() ? "," : "\n");
  std::printf("%-50s %10s %9s  %-16s %s\n", "", "ms", "multiple", "result",
              "decided by stage, and unknown, in %");
  for (const Row& row : table.rows) print_row(row, own);
}

std::string to_json(const Table& table, const Row& row) {
  const bool ok = row.outcome.ok();
  char numbers[256];
  std::snprintf(numbers, sizeof numbers,
                "\"milliseconds\": %.6g, \"multiple\": %.6g, \"hash\": \"%016llx\", \"wrong\": %llu",
                ok ? 1e3 * row.time() : 0, ok ? row.time() / table.product().time() : 0,
                static_cast<unsigned long long>(row.outcome.hash),
                static_cast<unsigned long long>(row.counts.wrong));
  std::string asked;
  for (std::size_t k = 0; k < kPredicates.size(); ++k)
    asked +=
        (k > 0 ? ", \"" : "\"") + std::string(kPredicates[k]) + "\": " + std::to_string(row.counts.asked[k]);
  return "{\"input\": " + json_string(table.input) + ", \"strategy\": " + json_string(row.way.name) +
         ", \"result\": " + json_string(row.result(table.product().outcome)) + ", " + numbers +
         ", \"asked\": {" + asked + "}, \"stages\": " + json_strings(row.way.stages) +
         ", \"decided\": " + json_numbers(decided(row)) + "}";
}

std::string to_json(const std::vector<Table>& tables) {
  std::string text;
  for (const Table& table : tables)
    for (const Row& row : table.rows) text += (text.empty() ? "" : ",\n") + to_json(table, row);
  return "[\n" + text + "\n]\n";
}

/// A run that the limits ended is no answer, and so not a wrong one.
bool contradicts(const Row& row, const Row& own) {
  if (!row.way.exact || row.same_as(own.outcome)) return false;
  return row.outcome.ok() || std::string(row.outcome.error) != "did not finish";
}

bool parse(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name.rfind("--", 0) != 0) {
      options.files.push_back(name);
      continue;
    }
    if (++i == argc) return false;
    if (name == "--json")
      options.json = argv[i];
    else if (name == "--repetitions")
      options.repetitions = std::max(1, std::atoi(argv[i]));
    else if (name == "--limit")
      options.limits.seconds = std::max(0.1, std::atof(argv[i]));
    else
      return false;
  }
  if (options.files.empty())
    for (const char* example : kExamples)
      options.files.push_back(std::string(CROSSLOFT_SOURCE_DIR "/examples/") + example + ".contour");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (!parse(argc, argv, options)) {
    std::fprintf(
        stderr,
        "usage: bench_pipeline_strategies [--json FILE] [--repetitions N] [--limit SECONDS] [FILE ...]\n");
    return 2;
  }
  std::vector<Table> tables;
  bool agree = true;
  for (const std::string& file : options.files) {
    Table table;
    if (!measure(file, options, table)) return 3;
    print(table);
    for (const Row& row : table.rows) agree = agree && !contradicts(row, table.product());
    tables.push_back(std::move(table));
  }
  if (!agree) std::printf("\nAn exact strategy contradicts the product.\n");
  return !write_file(options.json, to_json(tables)) ? 3 : agree ? 0 : 1;
}
