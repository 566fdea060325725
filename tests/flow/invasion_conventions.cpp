// Conventions of other codes, each against the plainest code that follows it.
#include <gtest/gtest.h>

#include "flow/sample_networks.hpp"
#include "puadem/flow/invasion.hpp"

namespace puadem::testing {
namespace {

/// Drainage in steps: at each pressure a recursive flood of the gas through all throats that open, then one of the
/// water from below; what it does not reach is trapped for good. Pores hold water or gas, nothing between.
struct SteppedFlood {
  const PoreNetwork& network;
  bool side_pores, body_entry;
  double pressure = 0.0;
  std::vector<std::uint8_t> gas, water_reached, trapped;

  SteppedFlood(const PoreNetwork& n, bool sides, bool bodies) : network(n), side_pores(sides), body_entry(bodies) {
    for (const std::uint8_t walls : n.pore_walls) gas.push_back((walls & at_top) != 0);
    trapped.resize(gas.size());
  }

  bool lets_gas(int t, int from, int into) const {
    if (!side_pores && network.pore_walls[to_size(from)] && network.pore_walls[to_size(into)]) return false;
    if (body_entry && pressure <= 2.0 / network.pore_radius[to_size(into)]) return false;
    return pressure * network.throat_entry_radius[to_size(t)] > 1.0;
  }

  template <class Visit>
  void each_neighbour(int pore, const Visit& visit) const {
    for (int t = 0; t < network.throats(); ++t) {
      const auto [i, j] = network.throat_pores[to_size(t)];
      if (network.throat_entry_radius[to_size(t)] > 0.0 && (i == pore || j == pore)) visit(t, i == pore ? j : i);
    }
  }

  void invade_from(int pore) {
    each_neighbour(pore, [&](int t, int next) {
      const bool is_free = !gas[to_size(next)] && !trapped[to_size(next)] && !(network.pore_walls[to_size(next)] & at_bottom);
      if (!is_free || !lets_gas(t, pore, next)) return;
      gas[to_size(next)] = 1;
      invade_from(next);
    });
  }

  void reach_from(int pore) {
    water_reached[to_size(pore)] = 1;
    each_neighbour(pore, [&](int, int next) {
      if (!gas[to_size(next)] && !water_reached[to_size(next)]) reach_from(next);
    });
  }

  void step_to(double target) {
    pressure = target;
    const std::vector<std::uint8_t> start = gas;
    for (int i = 0; i < network.pores(); ++i)
      if (start[to_size(i)]) invade_from(i);
    water_reached.assign(gas.size(), 0);
    for (int i = 0; i < network.pores(); ++i)
      if ((network.pore_walls[to_size(i)] & at_bottom) && !water_reached[to_size(i)]) reach_from(i);
    for (int i = 0; i < network.pores(); ++i) trapped[to_size(i)] = !gas[to_size(i)] && !water_reached[to_size(i)];
  }

  double saturation() const {
    double whole = 0.0, water = 0.0;
    for (int i = 0; i < network.pores(); ++i) {
      const std::uint8_t walls = network.pore_walls[to_size(i)];
      if ((walls & (at_top | at_bottom)) || (!side_pores && walls)) continue;
      whole += network.pore_volume[to_size(i)];
      if (!gas[to_size(i)]) water += network.pore_volume[to_size(i)];
    }
    return water / whole;
  }
};

InvasionOptions stepped_options() {
  InvasionOptions options;
  options.corner_water = false;
  options.trap_check = TrapCheck::step;
  return options;
}

class SteppedDrainage : public ::testing::TestWithParam<std::tuple<bool, bool, int>> {};

TEST_P(SteppedDrainage, InvadesWhatTheRecursiveFloodInvades) {
  const auto [side_pores, body_entry, steps] = GetParam();
  InvasionOptions options = stepped_options();
  options.side_pores = side_pores;
  options.body_entry = body_entry;
  double trapped = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const PoreNetwork network = random_network(300, seed);
    const double high = high_pressure(network, unit_fluids());
    InvasionState state = start_invasion(network, unit_fluids(), options);
    SteppedFlood flood(network, side_pores, body_entry);
    for (int k = 1; k <= steps; ++k) {
      advance_to(network, high * k / steps, state);
      flood.step_to(high * k / steps);
      ASSERT_EQ(state.nonwetting.holds, flood.gas) << "seed " << seed << " stop " << k;
      ASSERT_EQ(state.wetting.connected, flood.water_reached) << "seed " << seed << " stop " << k;
      ASSERT_NEAR(totals(network, state).saturation, flood.saturation(), 1e-13);
    }
    trapped += totals(network, state).trapped_wetting;
  }
  EXPECT_GT(trapped, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Conventions, SteppedDrainage,
                         ::testing::Combine(::testing::Bool(), ::testing::Bool(), ::testing::Values(4, 40, 150)));

// In any sequence of stops: marks as by a flood from scratch, volumes within bounds, the ledger closed.
TEST(TrapCheckAtStops, LeavesAStateThatIsWhole) {
  for (int k = 0; k < 8; ++k) {
    SCOPED_TRACE(k);
    InvasionOptions options;
    options.trap_check = TrapCheck::step;
    options.corner_water = k & 1;
    options.snap_off = k & 2;
    options.side_pores = k & 4;
    const PoreNetwork network = random_network(300, 20 + static_cast<std::uint64_t>(k));
    const double high = high_pressure(network, unit_fluids());
    InvasionState state = start_invasion(network, unit_fluids(), options);
    for (const double fraction : {0.3, 0.6, 1.0, 0.4, 0.1, 0.0, 0.5, 0.2, 0.9}) {
      advance_to(network, fraction * high, state);
      for (const FluidClusters* fluid : {&state.wetting, &state.nonwetting}) {
        FluidClusters afresh = *fluid;
        connect_all(state.links, afresh);
        EXPECT_EQ(afresh.connected, fluid->connected);
      }
      for (int i = 0; i < network.pores(); ++i) {
        EXPECT_GE(state.wetting_volume[to_size(i)], 0.0);
        EXPECT_LE(state.wetting_volume[to_size(i)], network.pore_volume[to_size(i)]);
      }
      const double water = state.void_volume + state.ledger.wetting_in.value() - state.ledger.wetting_out.value();
      EXPECT_NEAR(totals(network, state).saturation, water / state.void_volume, 1e-12);
    }
  }
}

// Two branches behind one throat: the dead end is filled with gas on the way, or trapped, or drained first.
//
//   top - 1 - 2 - bottom      throats of the row open at 1, those to the dead end 3 at 2 (from 1) and at 1.5 (from 2)
TEST(TrapCheckAtStops, DrainsInOneStepWhatIsTrappedOnTheWay) {
  PoreNetwork network = chain({1.0, 1.0, 1.0});
  const int dead_end = add_pore(network, 1e3, 6);
  add_throat(network, 1, dead_end, 0.5, 1.0);
  add_throat(network, 2, dead_end, 1.0 / 1.5, 2.0 / 1.5);
  InvasionOptions options;
  options.corner_water = false;
  InvasionState state = start_invasion(network, unit_fluids(), options);
  advance_to(network, 3.0, state);
  EXPECT_EQ(state.nonwetting.holds[to_size(dead_end)], 0);
  EXPECT_NEAR(totals(network, state).trapped_wetting, 1.0 / 3.0, 1e-15);

  options.trap_check = TrapCheck::step;
  InvasionState stepped = start_invasion(network, unit_fluids(), options);
  std::vector<InvasionEventKind> kinds;
  const auto log = [&](const InvasionEvent& e) { kinds.push_back(e.kind); };
  advance_to(network, 1.2, stepped, log);
  EXPECT_EQ(kinds.back(), InvasionEventKind::trap_wetting);
  EXPECT_EQ(stepped.wetting.connected[to_size(dead_end)], 0);
  InvasionState coarse = start_invasion(network, unit_fluids(), options);
  advance_to(network, 3.0, coarse);
  EXPECT_EQ(coarse.nonwetting.holds[to_size(dead_end)], 1);
}

// Without its body condition a wide throat is passed at its own pressure, on the way in and on the way out.
TEST(BodyEntry, OffLeavesTheThroatAlone) {
  const PoreNetwork network = chain({0.1, 1e6});
  const double body = 2.0 / network.pore_radius[1];
  ASSERT_GT(body, 0.1);
  InvasionOptions options;
  options.corner_water = false;
  for (const bool body_entry : {true, false}) {
    options.body_entry = body_entry;
    const double threshold = body_entry ? body : 0.1;
    InvasionState state = start_invasion(network, unit_fluids(), options);
    std::vector<double> pressures;
    const auto log = [&](const InvasionEvent& e) {
      if (e.kind == InvasionEventKind::drain || e.kind == InvasionEventKind::fill) pressures.push_back(e.capillary_pressure);
    };
    for (const double p : {1.0, 0.0, 1.0, 0.0}) advance_to(network, p, state, log);
    EXPECT_EQ(pressures, std::vector<double>(4, threshold));
  }
}

// Gas gets into a side pore from an inner pore and from there into no other pore at a wall.
//
//   top - 1 - 2 - bottom, and at the right wall beside 1: 3, with 4 behind it
TEST(SidePores, OffLeavesThemOutOfTheCountAndLetsGasInFromWithin) {
  PoreNetwork network = chain({1.0, 2.0, 1e6});
  const int side = add_pore(network, 1e3, 6, 2), behind = add_pore(network, 1e3, 6, 2);
  add_throat(network, 1, side, 1.0, 2.0);
  add_throat(network, side, behind, 1.0, 2.0);
  for (const int pore : {1, 2, side, behind}) add_throat(network, pore, 3, 1e-6, 1e-6);
  InvasionOptions options;
  options.corner_water = false;
  InvasionState all = start_invasion(network, unit_fluids(), options);
  advance_to(network, 1.5, all);
  EXPECT_NEAR(totals(network, all).saturation, 0.25, 1e-15);
  options.side_pores = false;
  InvasionState inner = start_invasion(network, unit_fluids(), options);
  advance_to(network, 1.5, inner);
  EXPECT_EQ(inner.nonwetting.holds[to_size(side)], 1);
  EXPECT_EQ(inner.nonwetting.holds[to_size(behind)], 0);
  EXPECT_NEAR(totals(network, inner).saturation, 0.5, 1e-15);
  EXPECT_NEAR(inner.ledger.wetting_out.value(), 1e3, 1e-12);
}

}  // namespace
}  // namespace puadem::testing
