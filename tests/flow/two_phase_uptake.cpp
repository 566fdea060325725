// Wetting fluid that grains take out of pores.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flow/two_phase_samples.hpp"
#include "puadem/base/error.hpp"

namespace puadem {
namespace {

using namespace puadem::testing;
using ::testing::HasSubstr;

/// Water taken from inner pores of a drained random network at constant rates.
struct Drained {
  PoreNetwork network = with_conductance(random_network(200, 11));
  TwoPhaseModel model;
  TwoPhaseState state;
  std::vector<double> uptake;
  double rate = 0.0;  ///< of all pores

  Drained(TwoPhaseScheme scheme, GasKind gas) {
    TwoPhaseOptions options;
    options.scheme = scheme;
    options.gas = gas;
    model = make_model(network, unit_fluids(), options, Schedule::constant(-6.0));
    state = start_two_phase(network, model);
    advance_two_phase(network, model, 20.0 * model.time_scale, {}, state);
    uptake.resize(to_size(network.pores()));
    for (int i = 0; i < network.pores(); i += 3)
      if (model.is_counted(i)) rate += uptake[to_size(i)] = 1e-3 * state.wetting_volume[to_size(i)] / model.time_scale;
  }
};

class Uptake : public ::testing::TestWithParam<std::pair<TwoPhaseScheme, GasKind>> {};

TEST_P(Uptake, IsBookedAndLeavesTheBalanceClosed) {
  Drained d(GetParam().first, GetParam().second);
  const TwoPhaseState before = d.state;
  const double time = 5.0 * d.model.time_scale;
  advance_two_phase(d.network, d.model, time, {{}, d.uptake}, d.state);
  double water = 0.0, space = 0.0;
  for (int i = 0; i < d.network.pores(); ++i) {
    if (!d.model.is_counted(i)) continue;
    water += d.state.wetting_volume[to_size(i)] - before.wetting_volume[to_size(i)];
    space += d.network.pore_volume[to_size(i)];
  }
  const double through_faces = d.state.boundary_inflow[1][0] - before.boundary_inflow[1][0];
  EXPECT_NEAR(water, through_faces - time * d.rate, 1e-10 * space);
  const double booked = d.state.ledger.wetting_in.value() - d.state.ledger.wetting_out.value() -
                        (before.ledger.wetting_in.value() - before.ledger.wetting_out.value());
  EXPECT_NEAR(booked, water, 1e-10 * space);
  EXPECT_GT(time * d.rate, 1e-5 * space) << "the test takes too little";
}

INSTANTIATE_TEST_SUITE_P(Schemes, Uptake,
                         ::testing::Values(std::pair{TwoPhaseScheme::implicit, GasKind::incompressible},
                                           std::pair{TwoPhaseScheme::implicit, GasKind::connected},
                                           std::pair{TwoPhaseScheme::impes, GasKind::connected}));

TEST(TwoPhaseUptake, AGrainThatSwellsInASaturatedPoreMovesNoFluid) {
  const PoreNetwork network = upright_chain({1.0, 1.0, 1.0, 1.0, 1.0}, 1.0);
  const TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  const std::vector<double> volume{0.0, 0.0, -0.1, -0.2, 0.0, 0.0}, uptake{0.0, 0.0, 0.1, 0.2, 0.0, 0.0};
  advance_two_phase(network, model, 1.0, {volume, uptake}, state);
  EXPECT_NEAR(state.boundary_inflow[1][0], 0.0, 1e-12);
  EXPECT_NEAR(state.wetting_volume[3], 1e3 - 0.2, 1e-9);
}

TEST(TwoPhaseUptake, FlowsInFromTheReservoirWherePoresStand) {
  const PoreNetwork network = upright_chain({1.0, 1.0, 1.0, 1.0, 1.0}, 1.0);
  const TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  const std::vector<double> uptake{0.0, 0.0, 0.1, 0.2, 0.0, 0.0};
  advance_two_phase(network, model, 1.0, {{}, uptake}, state);
  EXPECT_NEAR(state.boundary_inflow[1][0], 0.3, 1e-9);
}

TEST(TwoPhaseUptake, IsRefusedWhereNoFluidCanFollow) {
  PoreNetwork network = upright_chain({1.0, 1.0, 1.0, 1.0, 1.0}, 1.0);
  for (const int t : {1, 3}) network.throat_entry_radius[to_size(t)] = network.throat_snap_off_radius[to_size(t)] = 0.0;
  const TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  const std::vector<double> uptake{0.0, 0.0, 0.1, 0.0, 0.0, 0.0};
  try {
    advance_two_phase(network, model, 1.0, {{}, uptake}, state);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("pores 2, 3 can pass no fluid"));
  }
}

}  // namespace
}  // namespace puadem
