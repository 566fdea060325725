// The flow does not depend on the number of threads, the order of pores or the units.
#include <gtest/gtest.h>

#include "flow/two_phase_samples.hpp"

namespace puadem {
namespace {

using namespace puadem::testing;

struct DrainedRun {
  TwoPhaseModel model;
  TwoPhaseState state;
};

DrainedRun drain(const PoreNetwork& network, const Fluids& fluids, double suction, double drainage_times) {
  DrainedRun run{make_model(network, fluids, {}, Schedule::constant(-suction)), {}};
  run.state = start_two_phase(network, run.model);
  advance_two_phase(network, run.model, drainage_times * run.model.time_scale, {}, run.state);
  return run;
}

TEST(TwoPhaseInvariance, ThreadsChangeNoBit) {
  const PoreNetwork network = with_conductance(random_network(600, 21));
  set_threads(1);
  const TwoPhaseState one = drain(network, unit_fluids(), 20.0, 100.0).state;
  set_threads(4);
  const TwoPhaseState four = drain(network, unit_fluids(), 20.0, 100.0).state;
  set_threads(0);
  EXPECT_EQ(one.wetting_volume, four.wetting_volume);
  EXPECT_EQ(one.nonwetting_pressure, four.nonwetting_pressure);
  EXPECT_EQ(one.steps, four.steps);
}

TEST(TwoPhaseInvariance, TheOrderOfPoresDecidesNothing) {
  // A suction high above the thresholds: many pores are due at the same instant, at the start.
  for (const std::uint64_t seed : {22, 23, 24, 25})
    for (const double suction : {20.0, 60.0}) {
      const PoreNetwork network = with_conductance(random_network(300, seed));
      std::vector<int> pore_to;
      PoreNetwork other = with_conductance(renumbered(network, 5, pore_to));
      for (int i = 0; i < network.pores(); ++i) other.pore_centre[to_size(pore_to[to_size(i)])] = network.pore_centre[to_size(i)];
      const TwoPhaseState a = drain(network, unit_fluids(), suction, 10.0).state,
                          b = drain(other, unit_fluids(), suction, 10.0).state;
      double worst = 0.0;
      for (int i = 0; i < network.pores(); ++i)
        worst = std::max(worst, std::abs(a.wetting_volume[to_size(i)] - b.wetting_volume[to_size(pore_to[to_size(i)])]) /
                                    network.pore_volume[to_size(i)]);
      EXPECT_LT(worst, 1e-5) << "seed " << seed << ", suction " << suction;
    }
}

TEST(TwoPhaseInvariance, UnitsDecideNothing) {
  // Lengths in thousandths, surface tension and viscosities in others of their own: the same flow at another pace.
  const PoreNetwork network = with_conductance(random_network(300, 23));
  PoreNetwork small = network;
  const double length = 1e-3;
  for (Vec3& c : small.pore_centre) c = length * c;
  for (double& v : small.pore_volume) v *= length * length * length;
  for (auto* lengths : {&small.pore_radius, &small.throat_entry_radius, &small.throat_snap_off_radius})
    for (double& x : *lengths) x *= length;
  for (double& g : small.throat_conductance) g *= length * length * length;
  Fluids fluids = unit_fluids();
  fluids.surface_tension *= 0.07;
  fluids.wetting.viscosity *= 10.0;
  fluids.nonwetting.viscosity *= 10.0;
  const DrainedRun a = drain(network, unit_fluids(), 20.0, 100.0), b = drain(small, fluids, 20.0 * 0.07 / length, 100.0);
  EXPECT_NEAR(b.model.time_scale / a.model.time_scale, length * 10.0 / 0.07, 1e-6 * length * 10.0 / 0.07);
  const std::vector<double> s = saturation(network, a.state), t = saturation(small, b.state);
  for (int i = 0; i < network.pores(); ++i) EXPECT_NEAR(s[to_size(i)], t[to_size(i)], 1e-5);
}

TEST(TwoPhaseInvariance, ACallGoesOnWhereTheLastOneStopped) {
  // All that a restart needs is the state: a new model goes on to the same bits.
  const PoreNetwork network = with_conductance(random_network(200, 24));
  DrainedRun whole = drain(network, unit_fluids(), 20.0, 50.0);
  const TwoPhaseState saved = whole.state;
  advance_two_phase(network, whole.model, 50.0 * whole.model.time_scale, {}, whole.state);
  TwoPhaseState resumed = saved;
  const TwoPhaseModel fresh = make_model(network, unit_fluids(), {}, Schedule::constant(-20.0));
  advance_two_phase(network, fresh, 50.0 * fresh.time_scale, {}, resumed);
  EXPECT_EQ(whole.state.wetting_volume, resumed.wetting_volume);
  EXPECT_EQ(whole.state.time_step, resumed.time_step);
}

}  // namespace
}  // namespace puadem
