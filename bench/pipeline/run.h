#pragma once
/// The pipeline on one file; compiled once with the library and once with its copy.

#include <ctime>
#include <string>

#include "../../io/read_sections.h"
#include "../../reconstruct/reconstruct.h"
#include "../../tests/reconstruct/result_hash.h"
#include "way.h"

namespace crossloft::bench {

/// On one thread, with the options of the program; again and again until that has taken `least_seconds`, for
/// clocks tick slowly. The time is the mean.
inline pipeline_bench::Outcome run(const std::string& path, double least_seconds = 0) {
  pipeline_bench::Outcome outcome;
  const auto sections = read_sections(path);
  if (!sections) {
    outcome.fail(sections.error().message);
    return outcome;
  }
  const std::clock_t start = std::clock();
  const auto taken = [&] { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; };
  int runs = 1;
  const auto result = reconstruct(*sections);
  for (; result.ok() && taken() < least_seconds; ++runs) (void)reconstruct(*sections);
  outcome.seconds = taken() / runs;
  if (!result) {
    outcome.fail(result.error().message);
    return outcome;
  }
  outcome.hash = test::hash(*result);
  outcome.tets = result->solid.tets.size();
  outcome.triangles = result->surface.triangles.size();
  return outcome;
}

}  // namespace crossloft::bench
