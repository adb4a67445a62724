#pragma once
/// The user's side of a command: results on stdout, everything else on stderr, Ctrl-C.

#include <chrono>
#include <set>
#include <string>
#include <string_view>

#include "../geom/context.h"
#include "../geom/result.h"
#include "exit_code.h"

namespace crossloft::cli {

/// Makes Ctrl-C and SIGTERM raise the cancel flag of every context made afterwards; a second one kills. A
/// file that grows beyond the limit of the process is a failed write from then on.
void catch_interrupts();

/// The default again: for work that does not look at the flag, and whose files appear whole or not at all.
void release_interrupts();
/// From here on Ctrl-C and SIGTERM change nothing, since several files are being written that belong
/// together; a second one kills, since a pipe without a reader would wait forever.
void pass_over_interrupts();

/// Results are printed by print(); notes, warnings, errors and the progress bar go to stderr. The bar is
/// drawn only if stderr is a terminal; it estimates what is left of the stage. Quiet leaves warnings and
/// errors alone.
class Terminal {
 public:
  explicit Terminal(bool quiet = false);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Logs and shows progress here, cancelled by Ctrl-C. Must not outlive the terminal.
  Context context(unsigned threads = 1);

  /// As printf, to stdout; nothing if quiet.
  [[gnu::format(printf, 2, 3)]] void print(const char* format, ...);
  /// A message on stderr; one that was said before is not repeated.
  void say(LogLevel level, std::string_view text);
  /// The error on stderr; the exit code that belongs to it.
  ExitCode fail(const Error& error);

 private:
  void show_progress(std::string_view stage, double fraction);
  void clear_progress();

  bool quiet_, bar_;
  std::string stage_;  ///< that the progress line shows
  std::chrono::steady_clock::time_point stage_start_;
  double stage_first_ = 0, stage_done_ = 0;  ///< its fractions, first and last told
  std::string shown_;                        ///< the progress line on the screen, empty if there is none
  std::set<std::string, std::less<>> said_;
};

}  // namespace crossloft::cli
