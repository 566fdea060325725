// At rest, dynamic two-phase flow is the quasi-static invasion; on the way, no fluid is lost.
#include <gtest/gtest.h>

#include "flow/two_phase_samples.hpp"

namespace puadem {
namespace {

using namespace puadem::testing;

struct Drainage {
  double saturation_error = 0.0, mean_error = 0.0;
  int wrong_pores = 0;
};

/// Largest differences from the quasi-static invasion over the equilibria of a primary drainage.
Drainage compare_drainage(const PoreNetwork& network, const TwoPhaseOptions& options) {
  TwoPhaseModel model = make_model(network, unit_fluids(), options, Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  InvasionOptions rules;
  rules.corner_films = options.corner_films;
  InvasionState invasion = start_invasion(network, unit_fluids(), rules);
  Drainage worst;
  const double highest = 0.4 * high_pressure(network, unit_fluids());
  for (int k = 1; k <= 8; ++k) {
    const double pressure = highest * k / 8.0;
    model.boundaries[1].schedule = Schedule::constant(-pressure);
    equilibrate_two_phase(network, model, {}, state);
    advance_to(network, pressure, invasion);
    const std::vector<double> s = saturation(network, state), expected = saturation(network, invasion);
    for (int i = 0; i < network.pores(); ++i) {
      worst.saturation_error = std::max(worst.saturation_error, std::abs(s[to_size(i)] - expected[to_size(i)]));
      worst.wrong_pores += state.nonwetting.holds[to_size(i)] != invasion.nonwetting.holds[to_size(i)];
    }
    worst.mean_error =
        std::max(worst.mean_error, std::abs(totals(network, model, state).saturation - totals(network, invasion).saturation));
  }
  return worst;
}

class SlowLimit : public ::testing::TestWithParam<GasKind> {};

TEST_P(SlowLimit, ConnectedDrainageInvadesTheSamePoresToTheSameSaturations) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    TwoPhaseOptions options;
    options.gas = GetParam();
    const Drainage worst = compare_drainage(with_conductance(random_network(300, seed)), options);
    EXPECT_EQ(worst.wrong_pores, 0) << "seed " << seed;
    EXPECT_LT(worst.saturation_error, 1e-6) << "seed " << seed;
  }
}

TEST_P(SlowLimit, TrappingChangesTheMeansLittle) {
  double mean = 0.0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    TwoPhaseOptions options;
    options.gas = GetParam();
    options.corner_films = false;
    mean += compare_drainage(with_conductance(random_network(300, seed)), options).mean_error / 4.0;
  }
  EXPECT_LT(mean, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Gas, SlowLimit, ::testing::Values(GasKind::connected, GasKind::incompressible));

/// Gas of a chain from the top: a small pore, then a large one. In one jump of the pressure that would refill both, the small
/// one fills first and cuts the other's gas off at the volume it has then.
TEST(Refilling, GasBehindAFilledPoreKeepsItsVolume) {
  PoreNetwork network = upright_chain({0.3, 0.6, 0.3}, 1.0);
  network.pore_volume[2] *= 8.0;
  network.pore_radius[2] *= 2.0;
  TwoPhaseOptions options;
  const CapillaryUnit small = {2.0 / network.pore_radius[1], 6}, large = {2.0 / network.pore_radius[2], 6};
  TwoPhaseModel model = make_model(network, unit_fluids(), options, Schedule::constant(-3.0 * small.threshold));
  TwoPhaseState state = start_two_phase(network, model);
  equilibrate_two_phase(network, model, {}, state);
  ASSERT_TRUE(state.nonwetting.holds[1] && state.nonwetting.holds[2]);
  model.boundaries[1].schedule = Schedule::constant(-0.5 * large.threshold);
  equilibrate_two_phase(network, model, {}, state);
  EXPECT_FALSE(state.nonwetting.holds[1]);
  ASSERT_TRUE(state.nonwetting.holds[2]);
  EXPECT_FALSE(state.nonwetting.connected[2]);
  const ExponentialRetention law;
  const double gas = 1.0 - law.saturation(large, law.saturated_pressure(small));
  EXPECT_NEAR(1.0 - saturation(network, state)[2], gas, 0.02 * gas);
}

/// Largest difference of the mean saturation from the quasi-static invasion when the wetting fluid comes back in large steps.
double compare_imbibition(const PoreNetwork& network, int steps) {
  TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  InvasionOptions rules;
  rules.corner_films = true;
  InvasionState invasion = start_invasion(network, unit_fluids(), rules);
  const double highest = 0.4 * high_pressure(network, unit_fluids());
  double worst = 0.0;
  for (int k = -1; k <= steps; ++k) {
    const double pressure = highest * std::min(1.0 - static_cast<double>(k) / steps, 1.0);
    model.boundaries[1].schedule = Schedule::constant(-pressure);
    equilibrate_two_phase(network, model, {}, state);
    advance_to(network, pressure, invasion);
    worst = std::max(worst, std::abs(totals(network, model, state).saturation - totals(network, invasion).saturation));
  }
  EXPECT_GT(totals(network, invasion).trapped_nonwetting, 0.1) << "nothing to compare";
  return worst;
}

TEST(Refilling, FollowsTheOrderOfPressures) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    EXPECT_LT(compare_imbibition(with_conductance(random_network(300, seed)), 5), 0.05) << "seed " << seed;
  }
}

/// Gas may enter a pore within a step and be pressed out of it before its end: none of it stays, cut off and without a volume.
TEST(Refilling, GasThatCameAndWentWithinAStepLeavesNothingBehind) {
  const PoreNetwork network = with_conductance(random_network(300, 7));
  const TwoPhaseModel model =
      make_model(network, unit_fluids(), {}, Schedule::constant(-0.4 * high_pressure(network, unit_fluids())));
  TwoPhaseState state = start_two_phase(network, model);
  double least = 1.0;
  int cut_off = 0;
  TwoPhaseCallbacks callbacks;
  callbacks.on_step = [&](const TwoPhaseState& now) {
    for (int i = 0; i < network.pores(); ++i) {
      const std::size_t p = to_size(i);
      if (!now.nonwetting.holds[p] || now.nonwetting.connected[p]) continue;
      ++cut_off;
      least = std::min(least, 1.0 - now.wetting_volume[p] / network.pore_volume[p]);
    }
    return true;
  };
  advance_two_phase(network, model, 20.0 * model.time_scale, {}, state, callbacks);
  EXPECT_GT(cut_off, 0);
  EXPECT_GT(least, 1e-9);
}

struct Scheme {
  TwoPhaseScheme scheme;
  GasKind gas;
};
class Ledger : public ::testing::TestWithParam<Scheme> {};

TEST_P(Ledger, ClosesAtEveryStepOfDrainageAndImbibition) {
  const PoreNetwork network = with_conductance(random_network(300, 5));
  TwoPhaseOptions options;
  options.scheme = GetParam().scheme;
  options.gas = GetParam().gas;
  const double high = 0.3 * high_pressure(network, unit_fluids());
  TwoPhaseModel model = make_model(network, unit_fluids(), options, Schedule::constant(0.0));
  const double t = 800.0 * model.time_scale;
  model.boundaries[1].schedule = {{0.0, t, t, 2.0 * t}, {0.0, -high, -0.5 * high, 0.0}};
  const TwoPhaseState start = start_two_phase(network, model);
  TwoPhaseState state = start;
  double worst = 0.0, lowest = 1.0, least = 1.0, most = 0.0;
  int cut_off = 0;
  TwoPhaseCallbacks callbacks;
  callbacks.on_event = [&](const TwoPhaseEvent& event) { cut_off += event.kind == InvasionEventKind::trap_nonwetting; };
  callbacks.on_step = [&](const TwoPhaseState& now) {
    worst = std::max(worst, ledger_error(network, model, start, now));
    lowest = std::min(lowest, totals(network, model, now).saturation);
    for (const double s : saturation(network, now)) {
      least = std::min(least, s);
      most = std::max(most, s);
    }
    return true;
  };
  const TwoPhaseReport report = advance_two_phase(network, model, 2.0 * t, {}, state, callbacks);
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(lowest, 0.6) << "the run should have drained";
  EXPECT_GT(totals(network, model, state).saturation, lowest + 0.05) << "and refilled";
  EXPECT_GE(least, 0.0);
  EXPECT_LE(most, 1.0 + 1e-8);
  EXPECT_DOUBLE_EQ(state.time, 2.0 * t);
  EXPECT_GT(report.events, 100);
  EXPECT_GT(cut_off, 0) << "gas that loses its reservoir is reported";
}

INSTANTIATE_TEST_SUITE_P(Schemes, Ledger,
                         ::testing::Values(Scheme{TwoPhaseScheme::implicit, GasKind::connected},
                                           Scheme{TwoPhaseScheme::implicit, GasKind::incompressible},
                                           Scheme{TwoPhaseScheme::impes, GasKind::connected}));

/// Solves that end early while gas looks for pores, and iterations with incomplete and with older factors, beside full factors
/// for every solve: with viscous gas, where one that ends too early sends gas into other pores.
TEST(TwoPhaseFlow, DoesNotDependOnHowPressuresAreSolved) {
  const PoreNetwork network = with_conductance(random_network(300, 6));
  const double suction = 0.4 * high_pressure(network, unit_fluids());
  std::vector<TwoPhaseState> states;
  std::vector<TwoPhaseModel> models;
  using Method = PressureSolverOptions::Method;
  for (const Method method : {Method::automatic, Method::cholesky}) {
    TwoPhaseOptions options;
    options.solver.method = method;
    models.push_back(make_model(network, unit_fluids(), options, Schedule::constant(-suction)));
    states.push_back(start_two_phase(network, models.back()));
  }
  double worst = 0.0;
  for (int k = 0; k < 20; ++k) {
    for (const std::size_t s : {0U, 1U}) advance_two_phase(network, models[s], 5.0 * models[s].time_scale, {}, states[s]);
    const std::vector<double> a = saturation(network, states[0]), b = saturation(network, states[1]);
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_EQ(states[0].steps, states[1].steps);
  EXPECT_LT(totals(network, models[0], states[0]).saturation, 0.8);
}

TEST(TwoPhaseFlow, TheSchemesAgree) {
  const PoreNetwork network = with_conductance(random_network(300, 6));
  const double suction = 0.4 * high_pressure(network, unit_fluids());
  double worst = 0.0;
  std::vector<TwoPhaseState> states;
  std::vector<TwoPhaseModel> models;
  for (const TwoPhaseScheme scheme : {TwoPhaseScheme::implicit, TwoPhaseScheme::impes}) {
    TwoPhaseOptions options;
    options.scheme = scheme;
    options.gas = GasKind::connected;
    models.push_back(make_model(network, unit_fluids(), options, Schedule::constant(-suction)));
    states.push_back(start_two_phase(network, models.back()));
  }
  for (int k = 0; k < 40; ++k) {
    for (const std::size_t s : {0U, 1U}) advance_two_phase(network, models[s], 5.0 * models[s].time_scale, {}, states[s]);
    worst = std::max(
        worst, std::abs(totals(network, models[0], states[0]).saturation - totals(network, models[1], states[1]).saturation));
  }
  EXPECT_LT(worst, 0.02);
  EXPECT_LT(totals(network, models[0], states[0]).saturation, 0.75);
}

}  // namespace
}  // namespace puadem
