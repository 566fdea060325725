// Parts of a network that cannot follow a change of their volume.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flow/two_phase_samples.hpp"
#include "puadem/base/error.hpp"

namespace puadem {
namespace {

using namespace puadem::testing;
using ::testing::HasSubstr;

/// Pores 2 and 3 of a chain of six are joined to each other only.
PoreNetwork with_closed_pair() {
  PoreNetwork network = upright_chain({1.0, 1.0, 1.0, 1.0, 1.0}, 1.0);
  for (const int t : {1, 3}) network.throat_entry_radius[to_size(t)] = network.throat_snap_off_radius[to_size(t)] = 0.0;
  return network;
}

struct Kind {
  TwoPhaseScheme scheme;
  GasKind gas;
};
class ClosedOff : public ::testing::TestWithParam<Kind> {
 protected:
  TwoPhaseOptions options() const {
    TwoPhaseOptions result;
    result.scheme = GetParam().scheme;
    result.gas = GetParam().gas;
    return result;
  }
};

TEST_P(ClosedOff, WaterWithoutAWayOutIsRefusedWhenItsVolumeChanges) {
  const PoreNetwork network = with_closed_pair();
  const TwoPhaseModel model = make_model(network, unit_fluids(), options(), Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  const TwoPhaseState before = state;
  try {
    advance_two_phase(network, model, 1.0, {std::vector{0.0, 0.0, -0.1, 0.2, 0.1, 0.0}}, state);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("pores 2, 3 can pass no fluid"));
  }
  EXPECT_EQ(state.wetting_volume, before.wetting_volume);
  EXPECT_EQ(state.steps, 0);
}

TEST_P(ClosedOff, ItMayPassVolumeWithin) {
  const PoreNetwork network = with_closed_pair();
  const TwoPhaseModel model = make_model(network, unit_fluids(), options(), Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  advance_two_phase(network, model, 1.0, {std::vector{0.0, 0.0, -0.1, 0.1, 0.1, 0.0}}, state);
  EXPECT_NEAR(state.wetting_volume[2], 1e3 - 0.1, 1e-9);
  EXPECT_NEAR(state.wetting_volume[3], 1e3 + 0.1, 1e-9);
  EXPECT_NEAR(state.boundary_inflow[1][0], 0.1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ClosedOff,
                         ::testing::Values(Kind{TwoPhaseScheme::implicit, GasKind::incompressible},
                                           Kind{TwoPhaseScheme::implicit, GasKind::ideal},
                                           Kind{TwoPhaseScheme::implicit, GasKind::connected},
                                           Kind{TwoPhaseScheme::impes, GasKind::connected}));

/// Gas that is cut off in pore 1, between pores full of water without a way out.
TEST(ClosedOffGas, YieldsWhereItHasAPressureOfItsReservoirOrIsIdeal) {
  PoreNetwork network = upright_chain({1.0, 1.0, 1.0}, 1.0);
  for (const int t : {0, 2}) network.throat_entry_radius[to_size(t)] = network.throat_snap_off_radius[to_size(t)] = 0.0;
  for (const GasKind gas : {GasKind::connected, GasKind::incompressible, GasKind::ideal}) {
    TwoPhaseOptions options;
    options.gas = gas;
    const TwoPhaseModel model = make_model(network, unit_fluids(), options, Schedule::constant(0.0));
    TwoPhaseState state = start_two_phase(network, model);
    state.nonwetting.holds[1] = 1;
    state.wetting_volume[1] = 500.0;
    const double pressure = capillary_pressure(network, model, 1, state);
    state.nonwetting_pressure[1] = pressure;
    if (gas == GasKind::ideal) state.gas_amount[1] = 500.0 * (pressure + options.reference_pressure);
    const auto advance = [&] { advance_two_phase(network, model, 1.0, {std::vector{0.0, 0.0, -0.1, 0.0}}, state); };
    if (gas == GasKind::incompressible) {
      EXPECT_THROW(advance(), InputError);
      continue;
    }
    advance();
    EXPECT_NEAR(state.wetting_volume[2], 999.9, 1e-6);
    EXPECT_NEAR(state.wetting_volume[1], 500.1, 1e-6);
  }
}

TEST(ClosedOffWater, BehindAPoreThatRunsDryEndsTheRun) {
  PoreNetwork network = upright_chain({0.1, 2.0}, 1.0);
  const int dead_end = add_pore(network, 1e3, 6, 0, {1, 0, 1});
  add_throat(network, 1, dead_end, 1.0 / 50.0, 2.0 / 50.0);
  network.throat_conductance.push_back(1.0);
  Fluids fluids = unit_fluids();
  fluids.contact_angle = 0.9;  // no pore keeps water
  const TwoPhaseModel model = make_model(network, fluids, {}, Schedule::constant(-1.0));
  TwoPhaseState state = start_two_phase(network, model);
  try {
    advance_two_phase(network, model, 1e9, {std::vector{0.0, 0.0, 0.0, -1e-9}}, state);
    ADD_FAILURE() << "no error";
  } catch (const NumericalError& error) {
    EXPECT_THAT(error.what(), HasSubstr("pore 3 can pass no fluid"));
  }
}

}  // namespace
}  // namespace puadem
