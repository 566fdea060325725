#include "puadem/flow/permeability.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/parallel.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/lattice_facts.hpp"
#include "support/rotated_packing.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

NetworkOptions unmerged() {
  NetworkOptions options;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  return options;
}

PoreNetwork network_of(const Spheres& s, const NetworkOptions& options = unmerged()) {
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

Permeability permeability_of(const Spheres& s) { return measure_permeability(network_of(s), s.domain); }

void expect_isotropic(const Permeability& k, double value, double tolerance) {
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(k.tensor[to_size(a)][b], a == b ? value : 0.0, tolerance * value) << a << b;
}

/// Axes exchanged: x to y, y to z, z to x.
Spheres turned(Spheres s) {
  const auto turn = [](const Vec3& v) { return Vec3{v.z, v.x, v.y}; };
  for (Vec3& c : s.centre) c = turn(c);
  s.domain.upper = turn(s.domain.upper);
  s.domain.periodic = {s.domain.periodic[2], s.domain.periodic[0], s.domain.periodic[1]};
  return s;
}

}  // namespace

TEST(Permeability, OfLatticesOfTouchingSpheres) {
  for (const LatticeFacts& lattice : lattice_facts())
    for (int cells = 1; cells <= 2; ++cells) {
      SCOPED_TRACE(lattice.name);
      const Permeability k = permeability_of(lattice.make(cells));
      expect_isotropic(k, lattice.permeability(), 1e-9);
      EXPECT_LT(k.imbalance, 1e-12);
    }
}

// Four grains around a square window lie in one plane but for the shaking: a flat cell in each window. What it is cut into
// must not matter.
TEST(Permeability, HardlyChangesWhereALatticeIsShaken) {
  for (const LatticeFacts& lattice : lattice_facts())
    for (const double amplitude : {1e-5, 1e-7, 3e-9, 1e-9, 1e-10, 1e-11, 1e-13}) {
      Spheres s = lattice.make(2);
      Random random(5);
      for (Vec3& c : s.centre)
        for (int axis = 0; axis < 3; ++axis) c[axis] += random.uniform(-amplitude, amplitude);
      const Permeability k = permeability_of(s);
      for (int a = 0; a < 3; ++a)
        EXPECT_NEAR(k.tensor[to_size(a)][a] / lattice.permeability(), 1.0, 0.01) << lattice.name << ", " << amplitude;
    }
}

// Stokes flow in the same lattices: what the scheme is off by, 2 % low, 2 % high and 8 % low.
TEST(Permeability, LiesNearExactStokesFlowInLattices) {
  constexpr std::array<std::array<double, 2>, 3> bounds{{{0.97, 0.99}, {1.01, 1.03}, {0.91, 0.93}}};
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    const LatticeFacts lattice = lattice_facts()[k];
    const double ratio = permeability_of(lattice.make(1)).mean() / lattice.stokes_permeability();
    EXPECT_GT(ratio, bounds[k][0]) << lattice.name;
    EXPECT_LT(ratio, bounds[k][1]) << lattice.name;
  }
}

TEST(Permeability, WallsWithSlipAreMirrorPlanes) {
  // The walls of this box lie where the lattice is its own mirror image, so that they change nothing.
  const double lattice_value = permeability_of(simple_cubic(1.0, 2)).tensor[2].z;
  for (const std::array<bool, 3>& periodic : {std::array{false, false, false}, {true, true, false}, {false, false, true}})
    expect_isotropic(permeability_of(simple_cubic(1.0, 3, periodic)), lattice_value, 1e-9);
}

TEST(Permeability, WallsWithoutSlipTakeTheirShare) {
  const Spheres s = simple_cubic(1.0, 3, {false, false, false});
  NetworkOptions held = unmerged();
  held.no_slip = {true, true, false, false, false, false};  // left and right
  const Permeability slip = permeability_of(s), k = measure_permeability(network_of(s, held), s.domain);
  EXPECT_NEAR(k.tensor[0].x, slip.tensor[0].x, 1e-9 * slip.tensor[0].x);
  EXPECT_LT(k.tensor[1].y, 0.9 * slip.tensor[1].y);
  EXPECT_NEAR(k.tensor[2].z, k.tensor[1].y, 1e-9 * slip.tensor[0].x);
}

TEST(Permeability, PeriodicTensorIsSymmetric) {
  const Permeability k = permeability_of(random_spheres(150, 3.0, {1.0, 1.3, 0.9}, {true, true, true}, 12, 0.35));
  for (int a = 0; a < 3; ++a) {
    EXPECT_GT(k.tensor[to_size(a)][a], 0.0);
    for (int b = 0; b < a; ++b) EXPECT_NEAR(k.tensor[to_size(a)][b], k.tensor[to_size(b)][a], 1e-11 * k.mean());
  }
}

TEST(Permeability, TurnsWithThePacking) {
  const Spheres s = random_spheres(150, 2.0, {1.0, 1.2, 0.8}, {true, false, true}, 3, 0.35);
  const Permeability k = permeability_of(s), t = permeability_of(turned(s));
  const auto to = [](int axis) { return (axis + 1) % 3; };
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(t.tensor[to_size(to(a))][to(b)], k.tensor[to_size(a)][b], 1e-8 * k.mean());
}

TEST(Permeability, TurnsWithThePackingByAnyAngle) {
  for (const bool walls : {false, true}) {
    const Spheres s = random_spheres(40, 2.0, {1.0, 1.0, 1.3}, {true, true, !walls}, 31, 0.35);
    const Permeability k = permeability_of(s), t = permeability_of(rotated_packing(s));
    // k' = Q k Q^T, a column at a time: k maps a gradient to a flux.
    const auto flux = [](const Permeability& of, const Vec3& gradient) {
      return Vec3{dot(of.tensor[0], gradient), dot(of.tensor[1], gradient), dot(of.tensor[2], gradient)};
    };
    for (const Vec3& gradient : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      const Vec3 got = flux(t, rotated(gradient)), expected = rotated(flux(k, gradient));
      EXPECT_LT(norm(got - expected), 1e-9 * k.mean()) << gradient.x << gradient.y << gradient.z;
    }
  }
}

TEST(Permeability, ScalesWithTheSquareOfLengths) {
  const Spheres s = random_spheres(100, 2.0, {1, 1, 1}, {true, true, false}, 5, 0.3);
  Spheres small = s;
  const double scale = 2e-4;
  for (Vec3& c : small.centre) c *= scale;
  for (double& r : small.radius) r *= scale;
  small.domain.upper *= scale;
  const Permeability k = permeability_of(s), m = permeability_of(small);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(m.tensor[to_size(a)][a] / (scale * scale), k.tensor[to_size(a)][a], 1e-8 * k.mean());
}

TEST(Permeability, RandomPackingsAreIsotropicWithinTheirNoise) {
  // Each packing alone is anisotropic by a few percent. Over many, the means of k_aa / k - 1 and k_ab / k must not lie
  // farther from zero than chance puts them.
  constexpr int packings = 24;
  std::array<double, 9> sum{}, squares{};
  for (int n = 0; n < packings; ++n) {
    const Permeability k =
        permeability_of(random_spheres(150, 1.5, {1, 1, 1}, {true, true, true}, static_cast<std::uint64_t>(n + 1), 0.35));
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        const double x = k.tensor[to_size(a)][b] / k.mean() - (a == b ? 1.0 : 0.0);
        sum[to_size(3 * a + b)] += x;
        squares[to_size(3 * a + b)] += x * x;
      }
  }
  for (std::size_t c = 0; c < sum.size(); ++c) {
    const double mean = sum[c] / packings, spread = std::sqrt(squares[c] / packings - mean * mean);
    EXPECT_GT(spread, 0.005) << c;
    EXPECT_LT(spread, 0.1) << c;
    EXPECT_LT(std::abs(mean), 3.5 * spread / std::sqrt(double(packings))) << c;
  }
}

TEST(Permeability, IsNearKozenyAndCarman) {
  const Spheres s = random_spheres(1000, 1.5, {1, 1, 1}, {true, true, true}, 21, 0.35);
  double r2 = 0.0, r3 = 0.0;
  for (const double r : s.radius) {
    r2 += r * r;
    r3 += r * r * r;
  }
  const double ratio = permeability_of(s).mean() / kozeny_carman(0.65, r3 / r2);
  EXPECT_GT(ratio, 0.5);  // which is meant for dense beds
  EXPECT_LT(ratio, 3.0);
}

TEST(Permeability, TheSameFluidPassesEverySection) {
  const Spheres s = random_spheres(400, 2.0, {1, 1, 2}, {true, true, false}, 14, 0.35);
  const PoreNetwork network = network_of(s);
  SinglePhaseProblem problem;
  problem.faces[4] = {FaceCondition::Kind::pressure, 1e5};
  problem.faces[5] = {FaceCondition::Kind::pressure, 0.0};
  SinglePhaseMemory memory;
  const SinglePhaseFlow flow = solve_single_phase(network, s.domain, problem, memory);
  const double through = flow.face_inflow[4];
  EXPECT_NEAR(flow.face_inflow[5], -through, 1e-10 * through);
  for (double height = 0.5; height < 1.6; height += 0.1) {
    // Halves of one pore share its flow, so a pore is above or below as a whole.
    std::vector<char> is_above(to_size(memory.graph.nodes()));
    for (int n = 0; n < memory.graph.nodes(); ++n)
      is_above[to_size(n)] = network.pore_centre[to_size(memory.graph.node_pore[to_size(n)])].z > height;
    double sum = 0.0;
    for (int t = 0; t < network.throats(); ++t) {
      const auto [i, j] = network.throat_pores[to_size(t)];
      sum += flow.throat_flow[to_size(t)] *
             (is_above[to_size(memory.graph.pore_node[to_size(j)])] - is_above[to_size(memory.graph.pore_node[to_size(i)])]);
    }
    EXPECT_NEAR(sum, through, 1e-10 * through) << height;
  }
}

TEST(Permeability, SameBitsOnAnyNumberOfThreads) {
  const Spheres s = random_spheres(300, 2.0, {1, 1, 1}, {true, false, false}, 8, 0.3);
  for (const auto method : {PressureSolverOptions::Method::cholesky, PressureSolverOptions::Method::multigrid}) {
    const auto tensor = [&](int count) {
      set_threads(count);
      const auto k = measure_permeability(network_of(s), s.domain, {.method = method}).tensor;
      set_threads(0);
      return k;
    };
    EXPECT_EQ(tensor(1), tensor(2));
  }
}

TEST(Permeability, LimitsAreCountedAndMatterLittle) {
  const Spheres s = random_spheres(300, 2.0, {1, 1, 1}, {true, true, true}, 9, 0.35);
  const PoreNetwork network = network_of(s);
  const Permeability free = measure_permeability(network, s.domain);
  const Permeability limited = measure_permeability(network, s.domain, {}, ConductanceLimits{1e-2, 1e2});
  EXPECT_EQ(free.limited_low + free.limited_high, 0);
  EXPECT_GT(limited.limited_low, 0);
  EXPECT_GT(limited.limited_high, 0);
  EXPECT_NEAR(limited.mean() / free.mean(), 1.0, 0.02);
}

// The numbers of the simple, body-centred and face-centred lattices.
TEST(Permeability, KozenyCarman) {
  EXPECT_NEAR(kozeny_carman(0.4764, 1.0), 8.76e-3, 0.6e-5);
  EXPECT_NEAR(kozeny_carman(0.3198, 1.0), 1.571e-3, 0.6e-6);
  EXPECT_NEAR(kozeny_carman(0.2595, 1.0), 7.08e-4, 0.6e-6);
}
