#pragma once
/// Runs in a process of their own: what loops, crashes or eats all memory is an outcome like others.

#include <functional>

#include "way.h"

namespace pipeline_bench {

struct Limits {
  double seconds = 60;  ///< of processor time
  std::size_t megabytes = 4096;
};

/// The outcome that `run` has in a child process; "did not finish" or how it died as its error.
/// REQUIRES: the caller has no other thread.
Outcome try_in_child(const std::function<Outcome()>& run, const Limits& limits);

}  // namespace pipeline_bench
