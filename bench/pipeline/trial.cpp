#include "trial.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <csignal>

namespace pipeline_bench {
namespace {

constexpr double kMostWaiting = 20;  // for a child on a busy machine, times its processor time
static_assert(sizeof(Outcome) <= PIPE_BUF);

[[noreturn]] void be_child(const std::function<Outcome()>& run, const Limits& limits, int out) {
  const rlimit memory{rlim_t{limits.megabytes} << 20, rlim_t{limits.megabytes} << 20}, none{0, 0};
  setrlimit(RLIMIT_AS, &memory);
  setrlimit(RLIMIT_CORE, &none);
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds));
  const rlimit time{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  if (std::freopen("/dev/null", "w", stderr) == nullptr) _exit(1);  // the runtime's words when memory is out
  const Outcome outcome = run();
  _exit(write(out, &outcome, sizeof outcome) == static_cast<ssize_t>(sizeof outcome) ? 0 : 1);
}

bool comes_in_time(int in, double seconds) {
  pollfd ready{in, POLLIN, 0};
  return poll(&ready, 1, static_cast<int>(1000 * std::min(seconds, 1e6))) ==
         1;  // also when the other end is closed
}

std::string cause_of_death(int status) {
  if (!WIFSIGNALED(status)) return "ended early";
  if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL) return "did not finish";
  if (WTERMSIG(status) == SIGABRT) return "aborted, or out of memory";
  return "crashed, signal " + std::to_string(WTERMSIG(status));
}

}  // namespace

Outcome try_in_child(const std::function<Outcome()>& run, const Limits& limits) {
  Outcome outcome;
  int ends[2];
  std::fflush(nullptr);
  if (pipe(ends) != 0) return outcome.fail("no pipe"), outcome;
  const pid_t child = fork();
  if (child == 0) be_child(run, limits, ends[1]);
  close(ends[1]);
  if (child < 0) return close(ends[0]), outcome.fail("no process"), outcome;
  const bool in_time = comes_in_time(ends[0], kMostWaiting * limits.seconds);
  if (!in_time) kill(child, SIGKILL);
  // An outcome is shorter than PIPE_BUF: it comes whole.
  const bool came =
      in_time && read(ends[0], &outcome, sizeof outcome) == static_cast<ssize_t>(sizeof outcome);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!came) outcome.fail(cause_of_death(status));
  return outcome;
}

}  // namespace pipeline_bench
