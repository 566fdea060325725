// The standing threads behind parallel_for, and the arrays they work on.
#include "puadem/base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <numeric>
#include <thread>

#include "puadem/base/large_array.hpp"

namespace puadem {
namespace {

struct Threads {
  explicit Threads(int n) { set_threads(n); }
  ~Threads() { set_threads(0); }
};

TEST(Parallel, ManyShortLoopsLoseNothing) {
  const Threads guard(4);
  std::vector<int> count(64, 0);
  for (int loop = 0; loop < 20000; ++loop)
    parallel_for(
        64, [&](int i) { ++count[to_size(i)]; }, 1);
  for (const int c : count) EXPECT_EQ(c, 20000);
}

TEST(Parallel, TheTeamFollowsTheNumberOfThreads) {
  for (const int threads : {3, 1, 5, 2, 8, 1, 4}) {
    const Threads guard(threads);
    std::vector<int> seen(1000, 0);
    parallel_for(
        1000, [&](int i) { ++seen[to_size(i)]; }, 8);
    EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), 0), 1000);
  }
}

TEST(Parallel, ALoopWithinALoopRuns) {
  const Threads guard(3);
  std::vector<int> count(40, 0);
  parallel_for(
      40,
      [&](int i) {
        parallel_for(
            100, [&](int) { ++count[to_size(i)]; }, 10);
      },
      1);
  for (const int c : count) EXPECT_EQ(c, 100);
}

TEST(Parallel, TwoCallersAtOnceAreServed) {
  const Threads guard(2);
  std::atomic<int> sum = 0;
  const auto call = [&] {
    for (int loop = 0; loop < 500; ++loop)
      parallel_for(
          16, [&](int) { ++sum; }, 1);
  };
  std::thread other(call);
  call();
  other.join();
  EXPECT_EQ(sum, 16000);
}

TEST(Parallel, WorksOnAfterAnException) {
  const Threads guard(2);
  for (int loop = 0; loop < 3; ++loop) {
    EXPECT_THROW(parallel_for(
                     16,
                     [](int i) {
                       if (i == 5) throw 1;
                     },
                     1),
                 int);
    std::vector<int> seen(16, 0);
    parallel_for(
        16, [&](int i) { seen[to_size(i)] = 1; }, 1);
    EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), 0), 16);
  }
}

TEST(LargeArray, LiesOnLargePagesOnceItSpansSome) {
  struct alignas(64) Line {
    double value = 1.0;
  };
  LargeArray<Line> small(10), large(100000);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(small.data()) % 64, 0u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(large.data()) % LargePages<Line>::page, 0u);
  large.resize(200000);
  large = small;
  EXPECT_EQ(large.size(), 10u);
  EXPECT_EQ(large[9].value, 1.0);
}

}  // namespace
}  // namespace puadem
