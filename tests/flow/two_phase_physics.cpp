// Dynamic two-phase flow against closed forms, on chains of pores.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "flow/two_phase_samples.hpp"
#include "puadem/base/error.hpp"

namespace puadem {
namespace {

using namespace puadem::testing;
using ::testing::HasSubstr;

double body_pressure(const TwoPhaseModel& model, int pore) { return model.thresholds.body_pressure[to_size(pore)]; }

TEST(TwoPhaseChain, AHainesJumpEndsWhereBothPoresFollowTheirLaw) {
  // Reservoir - pore 1 - pore 2 - reservoir; the throat between the pores is the tightest.
  const PoreNetwork network = upright_chain({1.0, 6.0, 20.0}, 1e-3, 1.0);
  TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule::constant(-1.0));
  const double threshold = std::max(6.0, body_pressure(model, 2));
  TwoPhaseState state = start_two_phase(network, model);
  const auto rest_at = [&](double pressure) {
    model.boundaries[1].schedule = Schedule::constant(-pressure);
    equilibrate_two_phase(network, model, {}, state);
  };
  rest_at(threshold * (1.0 - 1e-6));
  EXPECT_TRUE(state.nonwetting.holds[1]);
  EXPECT_FALSE(state.nonwetting.holds[2]);
  EXPECT_NEAR(state.wetting_volume[2], network.pore_volume[2], 1e-9);

  // On its way the invaded pore only drains, and nothing is lost.
  const double pressure = threshold * (1.0 + 1e-6), before = state.wetting_volume[1] + state.wetting_volume[2];
  const double out = state.boundary_inflow[1][0];
  model.boundaries[1].schedule = Schedule::constant(-pressure);
  double last = network.pore_volume[2], rise = 0.0;
  TwoPhaseCallbacks callbacks;
  callbacks.on_step = [&](const TwoPhaseState& now) {
    EXPECT_LE(now.wetting_volume[2], last + 1e-12);
    last = now.wetting_volume[2];
    rise = std::max(rise, now.wetting_pressure[2] + pressure);
    EXPECT_NEAR(now.wetting_volume[1] + now.wetting_volume[2] - before, now.boundary_inflow[1][0] - out, 1e-12);
    return true;
  };
  advance_two_phase(network, model, 50.0 * model.time_scale, {}, state, callbacks);
  EXPECT_GT(rise, 0.1 * pressure) << "the pressure in the invaded pore jumps up";
  rest_at(pressure);
  const ExponentialRetention law;
  for (const int i : {1, 2})
    EXPECT_NEAR(state.wetting_volume[to_size(i)] / network.pore_volume[to_size(i)],
                law.saturation(model.thresholds.unit[to_size(i)], pressure), 1e-7);
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
  // Washburn: pore n fills through n - 1 full throats. With a pore's suction p_c(S) the time of the n-th is
  // mu V / g sum_k k int dS / p_c, and 1 / p_c = (1 - e^(-kappa S)) / p_thr. The throats hold against the suction ahead.
  const int pores = 62;
  const double g = 1e-3;
  const PoreNetwork network = upright_chain(std::vector<double>(pores - 1, 2.0), g);
  TwoPhaseOptions options;
  options.gas = GasKind::connected;
  options.corner_films = false;
  options.steps.front_change = 0.01;
  const TwoPhaseModel model = make_model(network, unit_fluids(), options, Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  const double start = 0.1;
  fill_with_gas(network, model, start, 0.0, state);
  std::vector<double> filled;
  TwoPhaseCallbacks callbacks;
  callbacks.on_event = [&](const TwoPhaseEvent& event) {
    if (event.kind == InvasionEventKind::fill) filled.push_back(event.time);
  };
  callbacks.on_step = [&](const TwoPhaseState&) { return filled.size() < 60; };
  advance_two_phase(network, model, 1e12, {}, state, callbacks);
  ASSERT_EQ(filled.size(), 60U);
  const CapillaryUnit& unit = model.thresholds.unit[1];
  const double kappa = ExponentialRetention{}.kappa(unit.faces);
  const double unit_time = network.pore_volume[1] * model.fluids.wetting.viscosity / g / unit.threshold *
                           (1.0 - start - (std::exp(-kappa * start) - std::exp(-kappa)) / kappa);
  for (const int n : {20, 40, 60}) EXPECT_NEAR(filled[to_size(n - 1)] / (unit_time * 0.5 * n * (n + 1)), 1.0, 0.1) << n;
  EXPECT_NEAR(std::log(60.0 / 20.0) / std::log(filled[59] / filled[19]), 0.5, 0.03);
}

TEST(TwoPhaseChain, ThroatsOfTwoFluidsResistInSeries) {
  // Gas behind the front, water ahead of it: one flow, driven by what the front's capillary pressure leaves.
  const double g = 1e-3;
  const PoreNetwork network = upright_chain(std::vector<double>(20, 0.5), g);
  for (const double gas_viscosity : {1e-4, 1e-3, 1e-2}) {
    Fluids fluids = unit_fluids();
    fluids.nonwetting.viscosity = gas_viscosity;
    TwoPhaseOptions options;
    options.corner_films = false;
    const TwoPhaseModel model = make_model(network, fluids, options, Schedule::constant(-0.6));
    TwoPhaseState state = start_two_phase(network, model);
    int checked = 0;
    long events = 0;
    TwoPhaseCallbacks callbacks;
    callbacks.on_event = [&](const TwoPhaseEvent&) { ++events; };
    callbacks.on_step = [&](const TwoPhaseState& now) {
      const bool is_quiet = events == 0;  // conductances of this step are those the state has now
      events = 0;
      const auto front = static_cast<int>(std::ranges::find(now.nonwetting.holds, 0) - now.nonwetting.holds.begin()) - 1;
      if (!is_quiet || front < 5 || front > 15) return front <= 15;
      const double share = now.wetting_volume[to_size(front)] / network.pore_volume[to_size(front)];
      if (share > 0.9 || share < 0.3) return true;  // behind the front, pores then still adjust
      const double water = (network.throats() - front) * fluids.wetting.viscosity / g, gas = front * gas_viscosity / g;
      const double flow = (0.6 - capillary_pressure(network, model, front, now)) / (water + gas);
      const ThroatFlows flows = throat_flows(network, model, now);
      EXPECT_NEAR(flows.wetting[to_size(network.throats() - 1)] / flow, 1.0, 1e-3);
      EXPECT_NEAR(flows.nonwetting[0] / flow, 1.0, 1e-3);
      ++checked;
      return true;
    };
    advance_two_phase(network, model, 1e9, {}, state, callbacks);
    EXPECT_GT(checked, 10);
    // Every volume of gas that came in has displaced as much water.
    EXPECT_NEAR(state.boundary_inflow[0][1] / -state.boundary_inflow[1][0], 1.0, 1e-7);
  }
}

TEST(TwoPhaseChain, WaterStandsToTheHeightThatItsThroatsHold) {
  // Drained from full, the water hangs on the throats: p_e = rho g h, less what the weight of the gas adds. Wetted from
  // below it rises to p_1 = rho g h.
  const int pores = 40;
  PoreNetwork network = upright_chain(std::vector<double>(pores - 1, 6.0), 1e-3, 1.0);
  Fluids fluids = unit_fluids();
  fluids.wetting.density = 1.0;
  fluids.nonwetting.density = 0.2;
  TwoPhaseOptions options;
  options.gravity = {0, 0, -0.25};
  const TwoPhaseModel model = make_model(network, fluids, options, Schedule::constant(0.0));
  ASSERT_LT(body_pressure(model, 5), 5.0);
  const auto highest_full = [&](const TwoPhaseState& state) {
    int i = 0;
    while (state.nonwetting.holds[to_size(i)]) ++i;
    return network.pore_centre[to_size(i)].z - network.pore_centre.back().z + 0.5;  // in the throat above it
  };
  const auto height = [&](double pressure) { return (pressure - 0.25 * 0.2 * (pores - 1)) / (0.25 * (1.0 - 0.2)); };
  TwoPhaseState state = start_two_phase(network, model);
  EXPECT_NEAR(state.wetting_pressure[10] - state.wetting_pressure[9], 0.25, 1e-12);
  equilibrate_two_phase(network, model, {}, state);
  EXPECT_NEAR(highest_full(state), height(6.0), 1.0);
  for (int i = 25; i < pores - 1; ++i)
    EXPECT_NEAR(state.wetting_pressure[to_size(i)], -0.25 * (network.pore_centre[to_size(i)].z - 1.0), 1e-6);

  TwoPhaseState wetted = start_two_phase(network, model);
  fill_with_gas(network, model, 0.05, 0.0, wetted);
  equilibrate_two_phase(network, model, {}, wetted);
  EXPECT_NEAR(highest_full(wetted), height(body_pressure(model, 5)), 1.0);
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
  advance_two_phase(network, model, 1.0, rate, state);
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
    EXPECT_THAT(error.what(), HasSubstr("stands still"));
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
