#pragma once
/// What a caller lends to a long operation. Every field may be left empty; there is no global state.

#include <atomic>
#include <functional>
#include <string_view>

namespace crossloft {

/// A flag that another thread may raise.
using CancelFlag = const std::atomic<bool>*;
inline bool is_raised(CancelFlag flag) { return flag != nullptr && flag->load(std::memory_order_relaxed); }

enum class LogLevel : unsigned char { note, warning };

struct Context {
  /// Called from the calling thread only, never concurrently. Hears all that a report of the operation has as
  /// notes and warnings, each once. What a callback throws: README.md, "Memory".
  std::function<void(LogLevel, std::string_view)> log;
  /// Stage name and the fraction of it that is done, 0..1; from the calling thread only. A stage may have
  /// several passes, one after the other under its name, and come again after others: within a pass fractions
  /// never get less, and one less than the last of its stage tells that another pass has begun.
  std::function<void(std::string_view stage, double fraction)> progress;
  /// When raised, the operation ends soon with ErrorCode::cancelled and leaves nothing behind.
  CancelFlag cancel = nullptr;
  /// Worker threads, the calling one included; 0 means one per core. The result never depends on it.
  unsigned threads = 1;

  void note(std::string_view text) const { if (log) log(LogLevel::note, text); }
  void warn(std::string_view text) const { if (log) log(LogLevel::warning, text); }
  void report(std::string_view stage, double fraction) const { if (progress) progress(stage, fraction); }
  bool cancelled() const { return is_raised(cancel); }
};

}  // namespace crossloft
