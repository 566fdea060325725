// The pressures of a packing against theory (3.12) written out pore by pore and solved by elimination.

#include <gtest/gtest.h>

#include <cmath>

#include "puadem/flow/single_phase_flow.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using Kind = FaceCondition::Kind;

namespace {

struct Dense {
  std::vector<std::vector<double>> matrix;
  std::vector<double> right;
  explicit Dense(int n) : matrix(to_size(n), std::vector<double>(to_size(n), 0.0)), right(to_size(n), 0.0) {}
};

/// Gauss elimination with the largest pivot of a column.
std::vector<double> solved(Dense d) {
  const std::size_t n = d.right.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::abs(d.matrix[r][c]) > std::abs(d.matrix[pivot][c])) pivot = r;
    std::swap(d.matrix[c], d.matrix[pivot]);
    std::swap(d.right[c], d.right[pivot]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double f = d.matrix[r][c] / d.matrix[c][c];
      if (f == 0.0) continue;
      for (std::size_t k = c; k < n; ++k) d.matrix[r][k] -= f * d.matrix[c][k];
      d.right[r] -= f * d.right[c];
    }
  }
  for (std::size_t r = n; r-- > 0;) {
    for (std::size_t k = r + 1; k < n; ++k) d.right[r] -= d.matrix[r][k] * d.right[k];
    d.right[r] /= d.matrix[r][r];
  }
  return d.right;
}

/// Balance of every pore, with the rows of pores at faces of given pressure replaced by that pressure.
std::vector<double> dense_pressures(const PoreNetwork& network, const Domain& domain, const SinglePhaseProblem& problem) {
  Dense d(network.pores());
  const Vec3 period = domain.size();
  for (int t = 0; t < network.throats(); ++t) {
    const auto i = to_size(network.throat_pores[to_size(t)][0]), j = to_size(network.throat_pores[to_size(t)][1]);
    const double g = network.throat_conductance[to_size(t)] / problem.viscosity;
    double driven = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      driven += problem.pressure_gradient[axis] * network.throat_shift[to_size(t)][to_size(axis)] * period[axis];
    d.matrix[i][i] += g;
    d.matrix[j][j] += g;
    d.matrix[i][j] -= g;
    d.matrix[j][i] -= g;
    d.right[i] += g * driven;
    d.right[j] -= g * driven;
  }
  for (std::size_t p = 0; p < d.right.size(); ++p) {
    if (!problem.volume_rate.empty()) d.right[p] -= problem.volume_rate[p];
    if (const auto& fluid = problem.compressibility) {
      const double storage = network.pore_volume[p] / (fluid->bulk_modulus * fluid->time_step);
      d.matrix[p][p] += storage;
      d.right[p] += storage * fluid->pressure_before[p];
    }
    for (std::size_t f = 0; f < 6; ++f) {
      if (problem.faces[f].kind != Kind::pressure || !(network.pore_walls[p] >> f & 1)) continue;
      d.matrix[p].assign(d.right.size(), 0.0);
      d.matrix[p][p] = 1.0;
      d.right[p] = problem.faces[f].value;
    }
  }
  return solved(std::move(d));
}

void expect_equal(const PoreNetwork& network, const Domain& domain, const SinglePhaseProblem& problem) {
  const std::vector<double> expected = dense_pressures(network, domain, problem);
  double size = 0.0;
  for (const double v : expected) size = std::max(size, std::abs(v));
  for (const auto method : {PressureSolverOptions::Method::cholesky, PressureSolverOptions::Method::multigrid}) {
    SinglePhaseMemory memory;
    memory.solver.method = method;
    const SinglePhaseFlow flow = solve_single_phase(network, domain, problem, memory);
    for (int p = 0; p < network.pores(); ++p) EXPECT_NEAR(flow.pressure[to_size(p)], expected[to_size(p)], 1e-9 * size) << p;
  }
}

}  // namespace

TEST(SinglePhaseFlow, EqualsTheBalanceOfEveryPore) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Spheres s = random_spheres(30, 2.0, {1, 1, 1.2}, {true, false, false}, seed, 0.3);
    for (const double merge_ratio : {0.9, std::numeric_limits<double>::infinity()}) {
      NetworkOptions options;
      options.merge_ratio = merge_ratio;
      const PoreNetwork network = build_pore_network(s.centre, s.radius, s.domain, options);
      std::vector<double> rate, before;
      for (int p = 0; p < network.pores(); ++p) {
        rate.push_back(network.pore_volume[to_size(p)] * std::sin(p));
        before.push_back(3.0 + std::cos(p));
      }
      SinglePhaseProblem problem;
      problem.viscosity = 2e-3;
      problem.faces[4] = {Kind::pressure, 5.0};
      problem.faces[5] = {Kind::pressure, -1.0};
      problem.pressure_gradient = {7.0, 0.0, 0.0};
      problem.volume_rate = rate;
      for (const bool is_compressible : {false, true}) {
        if (is_compressible) problem.compressibility = SlightCompressibility{1e3, 1e-2, before};
        expect_equal(network, s.domain, problem);
      }
    }
  }
}
