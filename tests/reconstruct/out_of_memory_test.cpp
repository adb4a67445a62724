/// Every allocation of a run fails once: an error, never a crash, and nothing is lost.

#include <atomic>
#include <cstdlib>
#include <new>
#include <optional>

#include <sys/wait.h>
#include <unistd.h>

#include "../../inspect/info.h"
#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "../../io/write_sections.h"
#include "../arrangement/polygon_sections.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

std::atomic<std::int64_t> allocations_left{-1};  // below 0: as many as wanted
std::atomic<std::int64_t> live{0};

/// True once the allocation that is to fail has come, and for all after it.
bool fails() {
  std::int64_t left = allocations_left.load();
  while (left > 0)
    if (allocations_left.compare_exchange_weak(left, left - 1)) return false;
  return left == 0;
}

void* granted(std::size_t bytes) {
  void* const memory = std::malloc(bytes != 0 ? bytes : 1);
  if (memory == nullptr) std::abort();
  live.fetch_add(1);
  return memory;
}

/// As the standard asks of operator new.
void* allocate(std::size_t bytes) {
  while (fails()) {
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
  return granted(bytes);
}

void release(void* memory) {
  if (memory != nullptr) live.fetch_sub(1);
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t bytes) { return allocate(bytes); }
void* operator new[](std::size_t bytes) { return allocate(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return fails() ? nullptr : granted(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return fails() ? nullptr : granted(bytes);
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }

namespace {

Sections small_stack() {
  Sections s;
  for (const double z : {0.0, 1.0}) s.planes.push_back(disk({0, 0, 1}, {0, 0, z}, 1, 3));
  return s;
}

#ifndef CROSSLOFT_NO_EXCEPTIONS

/// Planes that cross, bridges, samples, a second look.
Sections crossing_planes() {
  const Surface mesh = torus(1, 0.4, 6, 4);
  auto cut = slice(mesh, random_planes(bounds_of(mesh.points), 4, 2));
  REQUIRE(cut.ok());
  return std::move(cut).value();
}

/// What `run` gives when allocation n fails, and all after it until it has ended. Nothing may be left
/// allocated.
template <class Run>
std::optional<ErrorCode> with_failure(std::int64_t n, const Run& run) {
  const std::int64_t before = live.load();
  std::optional<ErrorCode> code;
  {
    allocations_left = n;
    const auto result = run();
    allocations_left = -1;
    if (!result) code = result.error().code;
  }
  CHECK(live.load() == before);
  return code;
}

/// Fails allocations 0, step, 2 step .. until a run needs no more; how many runs that took.
template <class Run>
std::int64_t fail_all(std::int64_t step, const Run& run) {
  for (std::int64_t n = 0;; n += step) {
    CAPTURE(n);
    const auto code = with_failure(n, run);
    if (!code) return n / step;
    REQUIRE(*code == ErrorCode::out_of_memory);
  }
}

#endif

}  // namespace

#ifndef CROSSLOFT_NO_EXCEPTIONS

TEST_CASE("a reconstruction whose n-th allocation fails is the error out_of_memory, for every n") {
  const Sections sections = small_stack();
  for (const PruneMode mode : {PruneMode::natural, PruneMode::paper}) {
    Options options;
    options.mode = mode;
    CHECK(fail_all(1, [&] { return reconstruct(sections, options); }) > 100);
  }
}

TEST_CASE("the same where planes cross, at every so many allocations, also on other threads") {
  const Sections sections = crossing_planes();
  for (const unsigned threads : {1u, 2u, 4u}) {
    CAPTURE(threads);
    Context context;
    context.threads = threads;
    Options options;
    options.branching.mode = Branching::all;
    fail_all(threads == 1 ? 61 : 499, [&] { return reconstruct(sections, options, context); });
  }
}

TEST_CASE("readers, writers and judges that return a Result do the same") {
  const Sections sections = small_stack();
  const std::string text = format_contour(sections);
  CHECK(fail_all(1, [&] { return parse_contour(text, "a file"); }) > 3);
  CHECK(fail_all(1, [&] { return format_csl(sections); }) > 3);
  CHECK(fail_all(1, [&] { return examine(sections); }) > 3);
  const Surface mesh = box_mesh({{-1, -1, -1}, {1, 1, 1}});
  const std::vector<CuttingPlane> planes{{{0, 0, 1}, 0.25}};
  CHECK(fail_all(1, [&] { return slice(mesh, planes); }) > 3);
}

#endif

TEST_CASE("a handler set with std::set_new_handler is asked first, in every build") {
  const Sections sections = small_stack();
  const pid_t child = fork();
  if (child == 0) {
    std::set_new_handler([] { _exit(7); });
    allocations_left = 50;
    const auto r = reconstruct(sections);
    _exit(r.ok() ? 0 : 1);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 7);
}
