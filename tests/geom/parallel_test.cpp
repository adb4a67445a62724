#include "../../geom/parallel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "../../delaunay/in_parallel.h"
#include "../../geom/parallel_sort.h"

using namespace crossloft;

namespace {

Context with_threads(unsigned threads) {
  Context context;
  context.threads = threads;
  return context;
}

}  // namespace

TEST_CASE("every item is done once, for any number of threads") {
  for (const unsigned threads : {1u, 2u, 7u, 0u})
    for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
      std::vector<std::atomic<int>> done(count);
      CHECK(parallel_for(count, with_threads(threads), "items", [&](std::size_t i) { ++done[i]; }));
      for (const auto& times : done) CHECK(times == 1);
    }
}

TEST_CASE("progress tells of items that are done, all of them in the end") {
  for (const unsigned threads : {1u, 2u, 5u})
    for (int round = 0; round < 50; ++round) {
      constexpr std::size_t kCount = 8;
      std::atomic<std::size_t> done{0};
      double last = 0;
      Context context = with_threads(threads);
      context.progress = [&](std::string_view, double fraction) {
        CHECK(fraction * kCount <= static_cast<double>(done.load()));
        CHECK(fraction >= last);
        last = fraction;
      };
      CHECK(parallel_for(kCount, context, "items", [&](std::size_t i) {
        if (i % 2 == 1) std::this_thread::yield();
        ++done;
      }));
      CHECK(last == 1);
    }
}

TEST_CASE("cancelled: false, and the rest is not begun") {
  std::atomic<bool> cancel{false};
  Context context = with_threads(3);
  context.cancel = &cancel;
  std::atomic<std::size_t> done{0};
  const bool complete = parallel_for(100000, context, "items", [&](std::size_t) {
    if (++done == 10) cancel = true;
  });
  CHECK_FALSE(complete);
  CHECK(done < 100000);
}

TEST_CASE("the first error by number comes out, with or without a message") {
  for (const unsigned threads : {1u, 3u}) {
    const auto done = for_all(100, with_threads(threads), "items", [](std::size_t i) -> Result<Done> {
      if (i == 30) return make_error(ErrorCode::too_thin, "");
      if (i == 70) return make_error(ErrorCode::usage, "seventy");
      return Done{};
    });
    REQUIRE_FALSE(done.ok());
    CHECK(done.error().code == ErrorCode::too_thin);
  }
}

TEST_CASE("what is kept is numbered in its order, for any number of threads") {
  for (const unsigned threads : {1u, 2u, 7u})
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, kBlock, 5 * kBlock + 7}) {
      const auto is_kept = [](std::size_t i) { return i % 3 == 1 || i / kBlock == 2; };
      std::vector<std::size_t> expected, kept;
      for (std::size_t i = 0; i < count; ++i)
        if (is_kept(i)) expected.push_back(i);
      CHECK(number_kept(
          count, with_threads(threads), "items", is_kept, [&](std::size_t size) { kept.resize(size); },
          [&](std::size_t i, std::size_t number) { kept[number] = i; }));
      CHECK(kept == expected);
    }
}

TEST_CASE("long lists are sorted by any number of threads") {
  std::mt19937 random(1);
  for (const std::size_t count : {std::size_t{0}, std::size_t{10}, 20 * kBlock + 3, 50 * kBlock}) {
    std::vector<std::uint64_t> items(count);
    for (std::uint64_t i = 0; i < count; ++i) items[i] = std::uint64_t{random() % 1000} << 32 | i;
    std::vector<std::uint64_t> expected = items;
    std::sort(expected.begin(), expected.end());
    for (const unsigned threads : {1u, 2u, 3u, 16u, 0u}) {
      std::vector<std::uint64_t> sorted = items;
      sort_in_parallel(sorted, with_threads(threads), "items", std::less<>());
      CHECK(sorted == expected);
    }
  }
}

#ifndef CROSSLOFT_NO_EXCEPTIONS

TEST_CASE("an item that fails on any thread fails on the calling one, when all threads are over") {
  for (const unsigned threads : {1u, 2u, 7u})
    for (const std::size_t bad : {0u, 1u, 500u, 999u}) {
      std::atomic<int> running{0};
      CHECK_THROWS_AS(parallel_for(1000, with_threads(threads), "items",
                                   [&](std::size_t i) {
                                     ++running;
                                     if (i == bad) {
                                       --running;
                                       throw std::bad_alloc();
                                     }
                                     --running;
                                   }),
                      std::bad_alloc);
      CHECK(running == 0);
    }
}

TEST_CASE("what the caller's own callback throws comes out as it was") {
  std::atomic<bool> called{false};
  Context context = with_threads(3);
  context.progress = [&](std::string_view, double) {
    called = true;
    throw std::runtime_error("enough");
  };
  const auto caller = std::this_thread::get_id();
  const auto work = [&](std::size_t) {
    while (!called && std::this_thread::get_id() != caller) std::this_thread::yield();
  };
  CHECK_THROWS_WITH(parallel_for(1000, context, "items", work), "enough");
}

TEST_CASE("shared work that fails on one thread fails on the calling one") {
  for (const unsigned bad : {0u, 1u, 3u}) {
    std::atomic<int> done{0};
    CHECK_THROWS_AS(detail::in_parallel(4,
                                        [&](unsigned k) {
                                          if (k == bad) throw std::bad_alloc();
                                          ++done;
                                        }),
                    std::bad_alloc);
    CHECK(done == 3);
  }
}

#endif
