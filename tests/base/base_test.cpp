#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "puadem/base/csr.hpp"
#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/base/random.hpp"
#include "puadem/base/vec3.hpp"

using namespace puadem;

namespace {

struct Threads {  // restores the default when a test leaves
  explicit Threads(int n) { set_threads(n); }
  ~Threads() { set_threads(0); }
};

}  // namespace

TEST(Vec3, CrossIsNormalToBothAndTripleIsSixVolumes) {
  const Vec3 a{1, 2, 3}, b{-2, 0.5, 4}, c{0.3, -1, 2};
  EXPECT_EQ(dot(cross(a, b), a), 0.0);
  EXPECT_EQ(dot(cross(a, b), b), 0.0);
  EXPECT_NEAR(squared_norm(cross(a, b)), squared_norm(a) * squared_norm(b) - dot(a, b) * dot(a, b), 1e-12);
  EXPECT_EQ(triple({2, 0, 0}, {0, 3, 0}, {0, 0, 4}), 24.0);
  EXPECT_NEAR(triple(a, b, c), -triple(b, a, c), 1e-14);
}

TEST(Csr, RowsListTheirEntriesInOrder) {
  const std::vector<int> row_of{2, 0, -1, 2, 0, 2};
  const Csr rows = rows_from(row_of, 4);
  ASSERT_EQ(rows.rows(), 4);
  EXPECT_EQ(std::vector<int>(rows[0].begin(), rows[0].end()), (std::vector<int>{1, 4}));
  EXPECT_TRUE(rows[1].empty());
  EXPECT_EQ(std::vector<int>(rows[2].begin(), rows[2].end()), (std::vector<int>{0, 3, 5}));
  EXPECT_TRUE(rows[3].empty());
}

TEST(Parallel, EveryIndexOnceOnAnyNumberOfThreads) {
  for (const int n : {0, 1, 511, 512, 513, 5000}) {
    for (const int threads : {1, 2, 5}) {
      const Threads guard(threads);
      std::vector<int> seen(to_size(n), 0);
      parallel_for(n, [&](int i) { ++seen[to_size(i)]; });
      EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int k) { return k == 1; }));
    }
  }
}

TEST(Parallel, SumsHaveTheSameBitsOnAnyNumberOfThreads) {
  const auto sum = [](int threads) {
    const Threads guard(threads);
    return parallel_sum<double>(100000, [](int i) { return std::sin(i) * std::exp(i % 37); });
  };
  const double one = sum(1);
  EXPECT_EQ(one, sum(2));
  EXPECT_EQ(one, sum(7));
  double plain = 0;
  for (int i = 0; i < 100000; ++i) plain += std::sin(i) * std::exp(i % 37);
  EXPECT_NEAR(one, plain, 1e-9 * std::abs(plain) + 1.0);
}

TEST(Parallel, AnExceptionReachesTheCaller) {
  for (const int threads : {1, 3}) {
    const Threads guard(threads);
    try {
      parallel_for(10000, [](int i) {
        if (i == 700 || i == 9000) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "no exception";
    } catch (const std::runtime_error& e) {
      EXPECT_STREQ(e.what(), "700");  // the first block wins, whoever throws first
    }
  }
}

TEST(DisjointSets, RootIsTheSmallestMember) {
  DisjointSets sets(10);
  EXPECT_TRUE(sets.join(7, 3));
  EXPECT_TRUE(sets.join(9, 7));
  EXPECT_FALSE(sets.join(3, 9));
  EXPECT_TRUE(sets.join(9, 1));
  for (const int i : {1, 3, 7, 9}) EXPECT_EQ(sets.find(i), 1);
  EXPECT_EQ(sets.find(4), 4);
}

TEST(DisjointSets, AgreesWithRelabelling) {
  Random random(11);
  DisjointSets sets(200);
  std::vector<int> label(200);
  std::iota(label.begin(), label.end(), 0);
  for (int k = 0; k < 150; ++k) {
    const int a = static_cast<int>(random.below(200)), b = static_cast<int>(random.below(200));
    sets.join(a, b);
    const int keep = std::min(label[to_size(a)], label[to_size(b)]), gone = std::max(label[to_size(a)], label[to_size(b)]);
    std::replace(label.begin(), label.end(), gone, keep);
    for (int i = 0; i < 200; i += 17) EXPECT_EQ(sets.find(i), label[to_size(i)]);
  }
}

TEST(Random, FollowsTheReferenceSequence) {
  // SplitMix64 from seed 0: first outputs as published with the generator.
  Random random(0);
  EXPECT_EQ(random.next(), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(random.next(), 0x6e789e6aa1b965f4ULL);
}

TEST(Random, IsUniform) {
  Random random(5);
  std::array<int, 10> bins{};
  double sum = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform();
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    ++bins[static_cast<std::size_t>(10 * x)];
    sum += x;
  }
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
  for (const int b : bins) EXPECT_NEAR(b, n / 10, 5 * std::sqrt(n / 10.0));
  for (int i = 0; i < 1000; ++i) EXPECT_LT(random.below(7), 7u);
}

TEST(Errors, CarryTheirMessage) {
  EXPECT_NO_THROW(require(true, "never"));
  try {
    require(false, "{} must lie in [0, 1], not {}", "x", 2);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "x must lie in [0, 1], not 2");
  }
  EXPECT_THROW(ensure(false, "lost"), NumericalError);
}
