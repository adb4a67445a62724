#include "terminal.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdarg>
#include <cstdio>

namespace crossloft::cli {
namespace {

/// A signal handler can reach nothing but a global.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void raise_interrupted(int) { interrupted.store(true, std::memory_order_relaxed); }

extern "C" void pass_over(int) {}

/// The next signal of the kind calls `handler`, the one after that kills.
void handle_once(int number, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | flags;
  sigaction(number, &action, nullptr);
}

constexpr int kBarWidth = 30;

/// "about 12 s left", nothing while it is too early to tell.
std::string time_left(double elapsed, double done_since, double rest) {
  if (elapsed < 2 || done_since < 0.02 || rest <= 0) return {};
  const double left = elapsed * rest / done_since;
  const bool minutes = left >= 90;
  return ", about " + std::to_string(static_cast<long>(minutes ? left / 60 + 0.5 : left + 1)) +
         (minutes ? " min left" : " s left");
}

}  // namespace

void catch_interrupts() {
  for (const int number : {SIGINT, SIGTERM}) handle_once(number, raise_interrupted, 0);
  std::signal(SIGXFSZ,
              SIG_IGN);  // a file beyond the limit is a failed write, with a message, as on a full disk
}

void release_interrupts() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

void pass_over_interrupts() {
  // A write that waits goes on after the first; only a second one ends it if nobody reads.
  for (const int number : {SIGINT, SIGTERM}) handle_once(number, pass_over, SA_RESTART);
}

Terminal::Terminal(bool quiet) : quiet_(quiet), bar_(!quiet && isatty(STDERR_FILENO) == 1) {}
Terminal::~Terminal() { clear_progress(); }

Context Terminal::context(unsigned threads) {
  Context context;
  context.log = [this](LogLevel level, std::string_view text) { say(level, text); };
  if (bar_) context.progress = [this](std::string_view stage, double done) { show_progress(stage, done); };
  context.cancel = &interrupted;
  context.threads = threads;
  return context;
}

void Terminal::print(const char* format, ...) {
  if (quiet_) return;
  clear_progress();
  va_list arguments;
  va_start(arguments, format);
  std::vprintf(format, arguments);
  va_end(arguments);
}

void Terminal::say(LogLevel level, std::string_view text) {
  if (quiet_ && level == LogLevel::note) return;
  if (!said_.emplace(text).second) return;
  clear_progress();
  const char* kind = level == LogLevel::warning ? "warning" : "note";
  std::fprintf(stderr, "crossloft: %s: %.*s\n", kind, static_cast<int>(text.size()), text.data());
}

ExitCode Terminal::fail(const Error& error) {
  clear_progress();
  if (error.code == ErrorCode::cancelled) {
    std::fputs("crossloft: interrupted, nothing was written\n", stderr);
  } else {
    std::fprintf(stderr, "crossloft: %s\n", to_string(error).c_str());
  }
  return exit_code(error.code);
}

void Terminal::show_progress(std::string_view stage, double fraction) {
  const double done = std::clamp(fraction, 0.0, 1.0);
  const auto now = std::chrono::steady_clock::now();
  if (stage != stage_ || done < stage_done_)
    stage_ = stage, stage_start_ = now, stage_first_ = done;  // some stages come again
  stage_done_ = done;
  std::string bar(kBarWidth, '.');
  std::fill_n(bar.begin(), static_cast<int>(done * kBarWidth), '#');
  const std::string percent = std::to_string(static_cast<int>(100 * done));
  std::string line =
      "[" + bar + "] " + std::string(4 - std::min<std::size_t>(4, percent.size()), ' ') + percent + " % ";
  line += stage;
  line += time_left(std::chrono::duration<double>(now - stage_start_).count(), done - stage_first_, 1 - done);
  if (line == shown_) return;
  std::fprintf(stderr, "\r%s\033[K", line.c_str());
  shown_ = std::move(line);
}

void Terminal::clear_progress() {
  if (!shown_.empty()) std::fputs("\r\033[K", stderr);
  shown_.clear();
}

}  // namespace crossloft::cli
