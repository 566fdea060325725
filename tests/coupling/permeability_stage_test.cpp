#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/run.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

Case permeability_case() {
  Case c;
  c.stages = {PermeabilityStage{}};
  return c;
}

State state_of(const Spheres& s) {
  State state;
  state.particles = make_particles(s.centre, s.radius, Material{});
  state.domain = s.domain;
  return state;
}

/// Flow over the simple cubic lattice of touching spheres of radius 1, as in the tests of permeability [m2].
double cubic_permeability() {
  const double window = 2.0 - 0.5 * std::numbers::pi, space = 4.0 / 3.0 - 2.0 * std::numbers::pi / 9.0;
  return 0.25 * window * std::pow(space / (2.0 * std::numbers::pi / 3.0), 2);
}

}  // namespace

TEST(PermeabilityStage, OfALatticeInClosedForm) {
  Case c = permeability_case();
  auto& stage = std::get<PermeabilityStage>(c.stages[0]);
  stage.layers = 4;
  stage.pressure_drop = 250.0;
  c.fluids.wetting.viscosity = 3e-3;
  c.pores.merge_criterion = MergeCriterion::insphere_overlap;
  for (const std::array<bool, 3>& periodic : {std::array{true, true, true}, {false, false, false}}) {
    stage.merged = periodic[0];  // each pore a cube
    const double radius = 0.4e-3, side = 2.0 * 4.0 * radius, k = cubic_permeability() * radius * radius;
    State state = state_of(simple_cubic(radius, 4, periodic));
    const RunResults results = run(c, state, {});
    const auto& s = results.scalars;
    ASSERT_EQ(state.permeability.size(), 1u);
    const PermeabilityResult& r = state.permeability[0];
    for (const char* axes : {"xx", "yy", "zz"}) EXPECT_NEAR(s.at(std::string("permeability_") + axes + "_m2"), k, 1e-9 * k);
    EXPECT_NEAR(s.at("permeability_xy_m2"), 0.0, 1e-9 * k);
    EXPECT_NEAR(s.at("permeability_principal_3_m2"), k, 1e-9 * k);
    EXPECT_EQ(s.contains("permeability_asymmetry"), periodic[0]);
    EXPECT_NEAR(s.at("permeability_porosity"), 1.0 - std::numbers::pi / 6.0, 1e-12);
    EXPECT_NEAR(s.at("permeability_darcy_velocity_m_s"), k * 250.0 / (side * 3e-3), 1e-9 * k * 250.0 / (side * 3e-3));
    // n^3 (2 R)^2 / (180 (1 - n)^2) with n = 1 - pi / 6.
    const double n = 1.0 - std::numbers::pi / 6.0,
                 reference = n * n * n * 4.0 * radius * radius / (180.0 * (1.0 - n) * (1.0 - n));
    EXPECT_NEAR(s.at("permeability_over_kozeny_carman"), k / reference, 1e-9);
    EXPECT_EQ(s.at("permeability_throats_raised") + s.at("permeability_throats_lowered"), 0.0);
    if (!periodic[0]) continue;
    // Every cube lies on the straight line.
    EXPECT_LT(r.linear_error, 1e-12);
    EXPECT_FALSE(r.profile.empty());
    for (const PressureLayer& layer : r.profile) EXPECT_NEAR(layer.pressure, layer.linear, 1e-9);
  }
}

TEST(PermeabilityStage, TheDropAndItsSignChangeOnlyTheScale) {
  const Spheres s = random_spheres(200, 1.5, {1e-3, 1.2e-3, 2e-3}, {true, true, false}, 3, 0.35);
  const auto measured = [&](int inlet, double drop) {
    Case c = permeability_case();
    auto& stage = std::get<PermeabilityStage>(c.stages[0]);
    stage.inlet = inlet;
    stage.pressure_drop = drop;
    State state = state_of(s);
    run(c, state, {});
    return state.permeability.at(0);
  };
  const PermeabilityResult top = measured(5, 1000.0), half = measured(5, 500.0), bottom = measured(4, 1000.0);
  EXPECT_EQ(top.permeability.tensor, half.permeability.tensor);
  EXPECT_NEAR(half.darcy_velocity, 0.5 * top.darcy_velocity, 1e-15);
  EXPECT_NEAR(half.linear_error, top.linear_error, 1e-12);
  EXPECT_NEAR(bottom.linear_error, top.linear_error, 1e-12);
  ASSERT_EQ(top.profile.size(), bottom.profile.size());
  for (std::size_t k = 0; k < top.profile.size(); ++k) {
    EXPECT_NEAR(top.profile[k].pressure + bottom.profile[k].pressure, 1000.0, 1e-9);
    EXPECT_NEAR(half.profile[k].pressure, 0.5 * top.profile[k].pressure, 1e-9);
  }
  EXPECT_GT(top.profile.back().pressure, 900.0);
  EXPECT_LT(top.profile.front().pressure, 100.0);
}

TEST(PermeabilityStage, FieldsCarryTheFlowThroughEverySection) {
  const Spheres s = random_spheres(150, 1.5, {1e-3, 1e-3, 1e-3}, {true, true, false}, 5, 0.35);
  State state = state_of(s);
  Observer observer;
  int seen = 0;
  observer.permeability = [&](const State& now, const DrivenFlow& flow, const PermeabilityResult& r) {
    ++seen;
    ASSERT_EQ(flow.pressure.size(), flow.network.pore_volume.size());
    // What crosses the middle of the box, by the side on which the two pores of a throat lie.
    double down = 0.0;
    for (int t = 0; t < flow.network.throats(); ++t) {
      const auto [i, j] = flow.network.throat_pores[to_size(t)];
      const bool above_i = flow.network.pore_centre[to_size(i)].z > 0.5e-3,
                 above_j = flow.network.pore_centre[to_size(j)].z > 0.5e-3;
      if (above_i != above_j) down += (above_i ? 1.0 : -1.0) * flow.throat_flow[to_size(t)];
    }
    EXPECT_NEAR(down / (r.darcy_velocity * 1e-6), 1.0, 1e-9);
    EXPECT_EQ(now.permeability.size(), 1u);
  };
  run(permeability_case(), state, observer);
  EXPECT_EQ(seen, 1);
}

TEST(PermeabilityStage, LeavesThePoresOfARetentionStageAlone) {
  const Spheres s = random_spheres(150, 1.5, {5e-3, 5e-3, 5e-3}, {true, true, false}, 4, 0.3);
  Case c;
  RetentionStage retention;
  retention.path = {100.0, 500.0};
  c.stages = {PermeabilityStage{}, retention, PermeabilityStage{}};
  State state = state_of(s);
  int packed = 0;
  Observer observer;
  observer.packed = [&](const State&) { ++packed; };
  const RunResults results = run(c, state, observer);
  EXPECT_EQ(packed, 1);  // the grains have not moved in between
  EXPECT_EQ(state.saturation.size(), state.network.pore_volume.size());
  EXPECT_EQ(state.permeability.size(), 2u);
  EXPECT_EQ(results.scalars.at("permeability_zz_m2"), results.scalars.at("permeability-2_zz_m2"));
  EXPECT_GT(results.scalars.at("permeability_pores"), results.scalars.at("pores"));
}

TEST(PermeabilityStage, CountsWhatTheLimitsChange) {
  State state = state_of(random_spheres(150, 2.0, {1e-3, 1e-3, 1e-3}, {true, true, true}, 5, 0.35));
  Case c = permeability_case();
  c.pores.conductance_limits = ConductanceLimits{0.5, 2.0};
  const PoreNetwork network = checked_network(c, state, {}, false);
  std::vector<double> g = network.throat_conductance;
  std::ranges::sort(g);
  const double median = g[g.size() / 2];
  const auto low = std::ranges::count_if(g, [&](double x) { return x > 0.0 && x < 0.5 * median; });
  const auto high = std::ranges::count_if(g, [&](double x) { return x > 2.0 * median; });
  const RunResults results = run(c, state, {});
  EXPECT_EQ(results.scalars.at("permeability_throats_raised"), low);
  EXPECT_EQ(results.scalars.at("permeability_throats_lowered"), high);
  EXPECT_GT(low, 0);
  EXPECT_GT(high, 0);
}

TEST(PermeabilityStage, NeedsPores) {
  State empty;
  EXPECT_THROW(run(permeability_case(), empty, {}), InputError);
  State asked = state_of(random_spheres(60, 1.5, {1e-3, 1e-3, 1e-3}, {true, true, true}, 5, 0.3));
  Observer observer;
  observer.progress = [](const Progress& p) { return p.stage != "permeability"; };
  EXPECT_TRUE(run(permeability_case(), asked, observer).interrupted);
  EXPECT_TRUE(asked.permeability.empty());
}
