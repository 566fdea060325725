#include "puadem/flow/pressure_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/base/random.hpp"

using namespace puadem;

namespace {

using Method = PressureSolverOptions::Method;

struct Problem {
  int unknowns = 0;
  std::vector<std::array<int, 2>> links;
  std::vector<double> conductance, diagonal, right;
};

/// A cubic grid of n^3 pores with conductances over `decades`, some links doubled; one side is held.
Problem grid(int n, double decades, std::uint64_t seed) {
  Random random(seed);
  Problem p;
  p.unknowns = n * n * n;
  const auto add = [&](int i, int j) {
    p.links.push_back(random.uniform() < 0.5 ? std::array{i, j} : std::array{j, i});
    p.conductance.push_back(1e-15 * std::pow(10.0, random.uniform(0.0, decades)));
    if (random.uniform() < 0.1) {
      p.links.push_back({i, j});
      p.conductance.push_back(1e-15);
    }
  };
  for (int i = 0; i < p.unknowns; ++i) {
    if (i % n + 1 < n) add(i, i + 1);
    if (i / n % n + 1 < n) add(i, i + n);
    if (i / (n * n) + 1 < n) add(i, i + n * n);
    p.diagonal.push_back(i % n == 0 ? 1e-14 : 0.0);
    p.right.push_back(random.uniform(-1.0, 1.0) * 1e-12);
  }
  return p;
}

/// Gauss elimination on the full matrix, from the definition of the system.
std::vector<double> dense_solution(const Problem& p) {
  const auto n = to_size(p.unknowns);
  std::vector<std::vector<double>> a(n, std::vector<double>(n, 0.0));
  std::vector<double> x = p.right;
  for (std::size_t i = 0; i < n; ++i) a[i][i] = p.diagonal[i];
  for (std::size_t k = 0; k < p.links.size(); ++k) {
    const auto i = to_size(p.links[k][0]), j = to_size(p.links[k][1]);
    a[i][i] += p.conductance[k];
    a[j][j] += p.conductance[k];
    a[i][j] -= p.conductance[k];
    a[j][i] -= p.conductance[k];
  }
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t r = c + 1; r < n; ++r) {
      const double f = a[r][c] / a[c][c];
      if (f == 0.0) continue;
      for (std::size_t k = c; k < n; ++k) a[r][k] -= f * a[c][k];
      x[r] -= f * x[c];
    }
  for (std::size_t r = n; r-- > 0;) {
    for (std::size_t k = r + 1; k < n; ++k) x[r] -= a[r][k] * x[k];
    x[r] /= a[r][r];
  }
  return x;
}

PressureSystem system_of(const Problem& p, Method method) {
  PressureSolverOptions options;
  options.method = method;
  PressureSystem system(p.unknowns, p.links, options);
  system.set(p.conductance, p.diagonal);
  return system;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return worst / size;
}

class EveryMethod : public ::testing::TestWithParam<Method> {};

}  // namespace

TEST_P(EveryMethod, ThroatsInSeries) {
  // A chain held at 0 before its first pore; what enters the last pore flows through all links.
  const std::vector<double> g{1e-12, 4e-12, 2e-12, 8e-12};
  PressureSystem system(4, std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}}, {.method = GetParam()});
  system.set(std::vector{g[1], g[2], g[3]}, std::vector{g[0], 0.0, 0.0, 0.0});
  std::vector<double> p(4, 0.0);
  const double q = 3e-10;
  system.solve(std::vector{0.0, 0.0, 0.0, q}, p);
  double expected = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    expected += q / g[k];
    EXPECT_NEAR(p[k], expected, 1e-11 * expected);
  }
}

TEST_P(EveryMethod, EqualsTheDenseSolution) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Problem p = grid(6, 4.0, seed);
    std::vector<double> x(to_size(p.unknowns), 0.0);
    const auto report = system_of(p, GetParam()).solve(p.right, x);
    EXPECT_LT(report.residual, GetParam() == Method::incomplete ? 1e-10 : 1e-12);
    EXPECT_LT(largest_difference(x, dense_solution(p)), 1e-9);
  }
}

TEST_P(EveryMethod, KeepsItsPatternWhenTheNumbersChange) {
  Problem p = grid(6, 3.0, 5);
  PressureSystem system = system_of(p, GetParam());
  std::vector<double> x(to_size(p.unknowns), 0.0);
  system.solve(p.right, x);
  for (double& g : p.conductance) g = 1e-27 / g;
  for (double& b : p.right) b *= -2.0;
  system.set(p.conductance, p.diagonal);
  system.solve(p.right, x);
  EXPECT_LT(largest_difference(x, dense_solution(p)), 1e-9);
}

TEST_P(EveryMethod, SameBitsOnAnyNumberOfThreads) {
  const Problem p = grid(14, 5.0, 7);
  const auto solved = [&](int count) {
    set_threads(count);
    std::vector<double> x(to_size(p.unknowns), 0.0);
    system_of(p, GetParam()).solve(p.right, x);
    set_threads(0);
    return x;
  };
  EXPECT_EQ(solved(1), solved(2));
}

TEST_P(EveryMethod, NothingInNothingOut) {
  const Problem p = grid(3, 1.0, 1);
  std::vector<double> x(to_size(p.unknowns), 5.0);
  system_of(p, GetParam()).solve(std::vector<double>(x.size(), 0.0), x);
  for (const double v : x) EXPECT_EQ(v, 0.0);
}

std::string name_of(const ::testing::TestParamInfo<Method>& test) {
  return test.param == Method::cholesky ? "cholesky" : test.param == Method::multigrid ? "multigrid" : "incomplete";
}
INSTANTIATE_TEST_SUITE_P(Pressure, EveryMethod, ::testing::Values(Method::cholesky, Method::multigrid, Method::incomplete),
                         name_of);

TEST(PressureSystem, IterationsOfAnIncompleteFactorAreFew) {
  const Problem p = grid(20, 1.0, 8);
  std::vector<double> x(to_size(p.unknowns));
  PressureSystem system = system_of(p, Method::incomplete);
  const int fine = system.solve(p.right, x).iterations;
  EXPECT_GT(fine, 5);
  EXPECT_LT(fine, 60);
  std::ranges::fill(x, 0.0);
  EXPECT_LT(system.solve(p.right, x, 1e-4).iterations, 0.7 * fine);
}

TEST(PressureSystem, TakesTheFullFactorWhereTheIncompleteOneIsSlow) {
  const Problem p = grid(20, 9.0, 9);
  std::vector<double> x(to_size(p.unknowns)), expected(x.size());
  PressureSystem system = system_of(p, Method::incomplete);
  EXPECT_EQ(system.solve(p.right, x).iterations, 200);
  system_of(p, Method::cholesky).solve(p.right, expected);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-6 * std::abs(expected[i]));
}

TEST(PressureSystem, AFullFactorServesForOtherNumbersUntilItIsForgotten) {
  Problem p = grid(20, 9.0, 9);
  std::vector<double> x(to_size(p.unknowns)), expected(x.size());
  PressureSystem system = system_of(p, Method::incomplete);
  ASSERT_EQ(system.solve(p.right, x).iterations, 200);
  for (std::size_t k = 0; k < p.conductance.size(); k += 7) p.conductance[k] *= 1.3;
  system.set(p.conductance, p.diagonal);
  std::ranges::fill(x, 0.0);
  const int iterations = system.solve(p.right, x, 1e-14).iterations;
  EXPECT_GT(iterations, 1);
  EXPECT_LT(iterations, 20);
  system_of(p, Method::cholesky).solve(p.right, expected);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], expected[i], 1e-6 * std::abs(expected[i]));

  system.forget();
  system.set(p.conductance, p.diagonal);
  std::ranges::fill(x, 0.0);
  std::ranges::fill(expected, 0.0);
  EXPECT_EQ(system.solve(p.right, x).iterations, 200);
  system_of(p, Method::incomplete).solve(p.right, expected);
  EXPECT_EQ(x, expected);
}

TEST(PressureSystem, StartsFromTheLastSolution) {
  const Problem p = grid(12, 4.0, 2);
  PressureSystem system = system_of(p, Method::multigrid);
  std::vector<double> x(to_size(p.unknowns), 0.0);
  const int first = system.solve(p.right, x).iterations;
  EXPECT_GT(first, 5);
  EXPECT_EQ(system.solve(p.right, x).iterations, 0);
  std::vector<double> near = p.right;
  for (std::size_t i = 0; i < near.size(); ++i) near[i] *= 1.0 + 1e-6 * std::sin(static_cast<double>(i));
  EXPECT_LT(system.solve(near, x).iterations, first);
}

TEST(PressureSystem, ChoosesByTheNumberOfUnknowns) {
  PressureSolverOptions options;
  options.cholesky_limit = 3;
  EXPECT_TRUE(PressureSystem(3, std::vector<std::array<int, 2>>{{0, 1}}, options).is_factorised());
  EXPECT_FALSE(PressureSystem(4, std::vector<std::array<int, 2>>{{0, 1}}, options).is_factorised());
}

TEST(PressureSystem, SaysWhatIsLeftWhereItFails) {
  const Problem p = grid(12, 6.0, 3);
  PressureSolverOptions options;
  options.method = Method::multigrid;
  options.iteration_limit = 2;
  PressureSystem system(p.unknowns, p.links, options);
  system.set(p.conductance, p.diagonal);
  std::vector<double> x(to_size(p.unknowns), 0.0);
  try {
    system.solve(p.right, x);
    FAIL();
  } catch (const NumericalError& e) {
    EXPECT_NE(std::string(e.what()).find("of the right-hand side after 2 iterations"), std::string::npos) << e.what();
  }
}

TEST(PressureSystem, RefusesAMatrixThatIsNotPositiveDefinite) {
  PressureSystem system(2, std::vector<std::array<int, 2>>{{0, 1}}, {.method = Method::cholesky});
  EXPECT_THROW(system.set(std::vector{1.0}, std::vector{-3.0, 0.0}), NumericalError);
}
