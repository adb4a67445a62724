#pragma once
/// What happens when an allocation fails: the one place of the library that knows of exceptions (README.md,
/// "Memory").

#include <atomic>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

#include "result.h"

namespace crossloft {

#ifdef __cpp_exceptions

/// Fails as an allocation does: where numbers, not memory, have an end.
[[noreturn]] inline void fail_as_allocation() { throw std::bad_alloc(); }

/// work(), which returns a Result; the error out_of_memory if an allocation in it fails. Its message is short
/// enough to need no memory of its own.
template <class Work>
auto or_out_of_memory(Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return Error{ErrorCode::out_of_memory, "out of memory", {}, 0, kNone, kNone};
}

/// Keeps the first failure of several threads until all of them are over.
class SharedFailure {
 public:
  template <class Work>
  void keep_from(Work&& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_.store(true, std::memory_order_relaxed);
    }
  }
  bool failed() const { return failed_.load(std::memory_order_relaxed); }
  /// Fails here as it failed there, if it did. REQUIRES: the other threads are over.
  void pass_on() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::atomic<bool> failed_{false};
};

/// Threads for work(1), work(2), .. work(count - 1), or as many of the first of them as the system grants.
template <class Work>
std::vector<std::thread> start_threads(unsigned count, const Work& work) {
  std::vector<std::thread> threads;
  try {
    threads.reserve(count);
    for (unsigned k = 1; k < count; ++k) threads.emplace_back([&work, k] { work(k); });
  } catch (const std::exception&) {
  }
  return threads;
}

#else

[[noreturn]] inline void fail_as_allocation() {
  if (const std::new_handler handler = std::get_new_handler()) handler();
  std::terminate();
}

template <class Work>
auto or_out_of_memory(Work&& work) -> decltype(work()) {
  return work();
}

class SharedFailure {
 public:
  template <class Work>
  void keep_from(Work&& work) {
    work();
  }
  bool failed() const { return false; }
  void pass_on() const {}
};

template <class Work>
std::vector<std::thread> start_threads(unsigned count, const Work& work) {
  std::vector<std::thread> threads;
  threads.reserve(count);
  for (unsigned k = 1; k < count; ++k) threads.emplace_back([&work, k] { work(k); });
  return threads;
}

#endif

}  // namespace crossloft
