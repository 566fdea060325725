// Dynamic two-phase flow against closed forms, on chains of pores.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "flow/two_phase_samples.hpp"
#include "flow/two_phase_scenes.hpp"
#include "puadem/base/error.hpp"

namespace puadem {
namespace {

using namespace puadem::testing;
using ::testing::HasSubstr;

double body_pressure(const TwoPhaseModel& model, int pore) { return model.thresholds.body_pressure[to_size(pore)]; }

TEST(TwoPhaseChain, AHainesJumpEndsWhereBothPoresFollowTheirLaw) {
  const HainesJumpScene scene = haines_jump_scene();
  EXPECT_FALSE(scene.enters_below);
  EXPECT_TRUE(scene.enters_above);
  EXPECT_NEAR(scene.lost_below, 0.0, 1e-9);
  // On its way the invaded pore only drains, and nothing is lost.
  EXPECT_LE(scene.regain, 1e-12);
  EXPECT_LT(scene.imbalance, 1e-12);
  EXPECT_GT(scene.rise, 0.1) << "the pressure in the invaded pore jumps up";
  EXPECT_LT(scene.law_difference, 1e-7);
}

TEST(TwoPhaseChain, TwoPoresDoNotFightOverAThroatWiderThanTheirBodies) {
  PoreNetwork network = upright_chain({1.0, 0.1, 0.1, 1.0}, 1e-3, 1.0);
  const TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule{{0.0, 1e5}, {0.0, -8.0}});
  ASSERT_GT(body_pressure(model, 2), 1.0);
  TwoPhaseState state = start_two_phase(network, model);
  const TwoPhaseReport report = advance_two_phase(network, model, 1e5, {}, state);
  EXPECT_TRUE(state.nonwetting.holds[3]);
  EXPECT_LE(report.events, 12);
}

TEST(TwoPhaseChain, ImbibitionGoesWithTheRootOfTime) {
  const WashburnScene scene = washburn_scene();
  ASSERT_EQ(scene.time.size(), 60U);
  for (const std::size_t n : {20U, 40U, 60U}) EXPECT_NEAR(scene.time[n - 1] / scene.by_sum[n - 1], 1.0, 0.1) << n;
  EXPECT_NEAR(scene.exponent, 0.5, 0.03);
}

TEST(TwoPhaseChain, ThroatsOfTwoFluidsResistInSeries) {
  for (const double gas_viscosity : {1e-4, 1e-3, 1e-2}) {
    const SeriesScene scene = series_scene(gas_viscosity);
    EXPECT_GT(scene.checked, 10);
    EXPECT_LT(scene.wetting_error, 1e-3);
    EXPECT_LT(scene.nonwetting_error, 1e-3);
    EXPECT_NEAR(scene.conserved, 0.0, 1e-7) << "gas that comes in displaces as much water";
  }
}

TEST(TwoPhaseChain, WaterStandsToTheHeightThatItsThroatsHold) {
  const RiseScene scene = rise_scene();
  EXPECT_LT(scene.start_error, 1e-11);
  EXPECT_NEAR(scene.drained, scene.drained_by_formula, 1.0);
  EXPECT_NEAR(scene.wetted, scene.wetted_by_formula, 1.0);
  EXPECT_GT(scene.drained, scene.wetted + 2.0);
  EXPECT_LT(scene.hydrostatic_error, 4e-6);
}

TEST(TwoPhaseChain, TrappedGasKeepsItsVolume) {
  // A bubble in the middle, water at both ends: pressure cannot press it out.
  const PoreNetwork network = upright_chain(std::vector<double>(9, 4.0), 1e-3, 1.0);
  FlowBoundary top = water_boundary(network, Schedule{{0.0, 1e4}, {0.0, 50.0}});
  top.name = "top";
  top.pores = face_pores(network, 5);
  const TwoPhaseModel model = make_two_phase_model(
      network, unit_fluids(), {}, {top, water_boundary(network, Schedule::constant(0.0))}, usual_throat_films(network));
  TwoPhaseState state = start_two_phase(network, model);
  for (const int i : {4, 5}) {
    state.nonwetting.holds[to_size(i)] = 1;
    state.wetting_volume[to_size(i)] = 0.4;
    state.nonwetting_pressure[to_size(i)] = capillary_pressure(network, model, i, state);
  }
  state.nonwetting.passes[4] = 1;
  connect_all(model.links, state.nonwetting);
  advance_two_phase(network, model, 1e4, {}, state);
  EXPECT_NEAR(std::accumulate(state.wetting_volume.begin() + 1, state.wetting_volume.end() - 1, 0.0), 8.0 - 1.2, 1e-8);
  EXPECT_NEAR(totals(network, model, state).trapped_nonwetting, 1.2 / 8.0, 1e-8);
}

TEST(TwoPhaseChain, CutOffIdealGasKeepsPressureTimesVolume) {
  // The bubble of the former test between tight throats, its absolute pressure doubled from both ends.
  const PoreNetwork network = upright_chain(std::vector<double>(9, 50.0), 1e-3, 1.0);
  FlowBoundary top = water_boundary(network, Schedule{{0.0, 1e3}, {0.0, 100.0}});
  FlowBoundary bottom = top;
  top.name = "top";
  top.pores = face_pores(network, 5);
  TwoPhaseOptions options;
  options.gas = GasKind::ideal;
  options.reference_pressure = 100.0;
  const TwoPhaseModel model = make_two_phase_model(network, unit_fluids(), options, {top, bottom}, usual_throat_films(network));
  TwoPhaseState state = start_two_phase(network, model);
  const auto gas = [&](int i) { return network.pore_volume[to_size(i)] - state.wetting_volume[to_size(i)]; };
  const auto amount = [&] {
    double sum = 0.0;
    for (const int i : {4, 5}) sum += (state.nonwetting_pressure[to_size(i)] + 100.0) * gas(i);
    return sum;
  };
  for (const int i : {4, 5}) {
    state.nonwetting.holds[to_size(i)] = 1;
    state.wetting_volume[to_size(i)] = 0.2;
    state.nonwetting_pressure[to_size(i)] = capillary_pressure(network, model, i, state);
    state.gas_amount[to_size(i)] = (state.nonwetting_pressure[to_size(i)] + 100.0) * gas(i);
  }
  state.nonwetting.passes[4] = 1;
  connect_all(model.links, state.nonwetting);
  const double before = amount();
  const TwoPhaseState start = state;
  advance_two_phase(network, model, 2e3, {}, state);
  EXPECT_NEAR(amount() / before, 1.0, 1e-6);
  EXPECT_LT(gas(4) + gas(5), 0.55 * 1.6);
  EXPECT_NEAR(state.gas_amount[4] + state.gas_amount[5], before, 1e-9 * before);
  EXPECT_LT(ledger_error(network, model, start, state), 1e-9);
}

TEST(TwoPhaseChain, DryPoresEmptyAndRefill) {
  // At 60 degrees no edge holds water: a pore drains to nothing, and water comes back where its front passes the throats.
  const PoreNetwork network = upright_chain({0.5, 0.6, 0.7, 2.0}, 1e-3, 1e3);
  Fluids fluids = unit_fluids();
  fluids.contact_angle = 1.05;
  TwoPhaseModel model = make_model(network, fluids, {}, Schedule::constant(-1.0));
  const TwoPhaseState start = start_two_phase(network, model);
  TwoPhaseState state = start;
  for (const double suction : {0.55, 0.65, 0.75}) {
    model.boundaries[1].schedule = Schedule::constant(-suction);
    equilibrate_two_phase(network, model, {}, state);
  }
  for (const int i : {1, 2, 3}) EXPECT_EQ(state.wetting_volume[to_size(i)], 0.0) << i;
  EXPECT_LT(ledger_error(network, model, start, state), 1e-9);
  model.boundaries[1].schedule = Schedule::constant(-0.01);
  equilibrate_two_phase(network, model, {}, state);
  for (const int i : {1, 2, 3}) EXPECT_NEAR(state.wetting_volume[to_size(i)], 1e3, 1e-5) << i;
  EXPECT_LT(ledger_error(network, model, start, state), 1e-9);
}

TEST(TwoPhaseChain, AGivenRateIsWhatLeaves) {
  const PoreNetwork network = with_conductance(random_network(200, 9));
  FlowBoundary outlet = water_boundary(network, Schedule::constant(0.0));
  outlet.kind = FlowBoundary::Kind::flow_rate;
  double volume = 0.0;
  for (const double v : network.pore_volume) volume += v;
  const double rate = 0.3 * volume / 100.0;
  outlet.schedule = Schedule{{0.0, 50.0, 50.0}, {-rate, -rate, -0.5 * rate}};
  const TwoPhaseModel model =
      make_two_phase_model(network, unit_fluids(), {}, {gas_boundary(network), outlet}, usual_throat_films(network));
  TwoPhaseState state = start_two_phase(network, model);
  advance_two_phase(network, model, 100.0, {}, state);
  EXPECT_NEAR(state.boundary_inflow[1][0] / (-0.75 * rate * 100.0), 1.0, 1e-8);
  EXPECT_NEAR(state.boundary_inflow[0][1] / (0.75 * rate * 100.0), 1.0, 1e-8);
}

TEST(TwoPhaseChain, ClosingPoresPressTheirFluidOut) {
  const PoreNetwork network = with_conductance(random_network(200, 10));
  const TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule::constant(-10.0));
  TwoPhaseState state = start_two_phase(network, model);
  equilibrate_two_phase(network, model, {}, state);
  const TwoPhaseState before = state;
  std::vector<double> rate(to_size(network.pores()));
  double pressed = 0.0;
  for (int i = 0; i < network.pores(); ++i) {
    if (!model.is_counted(i)) continue;
    rate[to_size(i)] = -0.01 * network.pore_volume[to_size(i)];
    pressed += 0.01 * network.pore_volume[to_size(i)];
  }
  advance_two_phase(network, model, 1.0, {rate}, state);
  const double in =
      state.boundary_inflow[0][1] + state.boundary_inflow[1][0] - before.boundary_inflow[0][1] - before.boundary_inflow[1][0];
  EXPECT_NEAR(-in / pressed, 1.0, 1e-8);
}

TEST(TwoPhaseErrors, AWithdrawalThatHasLostItsWaterSaysSo) {
  const PoreNetwork network = upright_chain({1.0, 1.0, 5.0}, 1e-3, 1.0);
  FlowBoundary outlet = water_boundary(network, Schedule::constant(-1.0));
  outlet.kind = FlowBoundary::Kind::flow_rate;
  TwoPhaseOptions options;
  options.steps.step_limit = 2000;
  const TwoPhaseModel model =
      make_two_phase_model(network, unit_fluids(), options, {gas_boundary(network), outlet}, usual_throat_films(network));
  TwoPhaseState state = start_two_phase(network, model);
  try {
    advance_two_phase(network, model, 10.0, {}, state);
    ADD_FAILURE() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("boundary \"bottom\" cannot pass -1 m3/s"), HasSubstr("t = "), HasSubstr("step "),
                                    HasSubstr("within reach")));
  }
  EXPECT_LT(state.wetting_volume[2], 0.05) << "the pore beside the outlet has given what it had";
}

template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

TEST(TwoPhaseErrors, ImpossibleSetUpsAreRefusedWithTheReason) {
  const PoreNetwork network = upright_chain({1.0, 3.0, 2.0}, 1e-3, 1.0);
  const auto refuse = [&](const Fluids& fluids, const TwoPhaseOptions& options, std::vector<FlowBoundary> boundaries) {
    return message_of(
        [&] { make_two_phase_model(network, fluids, options, std::move(boundaries), usual_throat_films(network)); });
  };
  const FlowBoundary gas = gas_boundary(network), water = water_boundary(network, Schedule::constant(0.0));
  EXPECT_THAT(refuse(unit_fluids(), {}, {}), HasSubstr("no reservoir"));
  Fluids fluids = unit_fluids();
  fluids.nonwetting.viscosity = 0.0;
  EXPECT_THAT(refuse(fluids, {}, {gas, water}), HasSubstr("viscosity"));
  fluids = unit_fluids();
  fluids.contact_angle = 2.0;
  EXPECT_THAT(refuse(fluids, {}, {gas, water}), HasSubstr("contact angle"));
  TwoPhaseOptions explicit_gas;
  explicit_gas.scheme = TwoPhaseScheme::impes;
  EXPECT_THAT(refuse(unit_fluids(), explicit_gas, {gas, water}), HasSubstr("impes"));
  FlowBoundary twice = water;
  twice.name = "again";
  EXPECT_THAT(refuse(unit_fluids(), {}, {gas, water, twice}), HasSubstr("\"bottom\" and \"again\""));
  FlowBoundary rate = water;
  rate.kind = FlowBoundary::Kind::flow_rate;
  EXPECT_THAT(refuse(unit_fluids(), {}, {rate}), HasSubstr("give the pressure at one of them"));
  FlowBoundary nowhere = water;
  nowhere.pores.clear();
  EXPECT_THAT(refuse(unit_fluids(), {}, {gas, nowhere}), HasSubstr("has no pore"));
}

}  // namespace
}  // namespace puadem
