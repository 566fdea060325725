#include "puadem/flow/invasion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "flow/sample_networks.hpp"

namespace puadem::testing {
namespace {

using ::testing::ElementsAre;
using Kind = InvasionEventKind;

// Closed form of the default local law for pores of six faces (surface tension 1).
double law(const PoreNetwork& network, int pore, double pressure) {
  const double kappa = 1.2591 * 6 - 1.1041;
  return -std::log(1.0 - 2.0 / network.pore_radius[to_size(pore)] / pressure) / kappa;
}
double body_pressure(const PoreNetwork& network, int pore) {
  return 2.0 / network.pore_radius[to_size(pore)] / (1.0 - std::exp(-(1.2591 * 6 - 1.1041)));
}

struct Log {
  std::vector<InvasionEvent> events;
  InvasionEventCallback callback() {
    return [this](const InvasionEvent& e) { events.push_back(e); };
  }
  std::vector<int> pores(Kind kind) const {
    std::vector<int> found;
    for (const auto& e : events)
      if (e.kind == kind) found.push_back(e.pore);
    return found;
  }
  const InvasionEvent& only(Kind kind) const {
    const auto it = std::ranges::find(events, kind, &InvasionEvent::kind);
    EXPECT_EQ(std::ranges::count(events, kind, &InvasionEvent::kind), 1);
    return *it;
  }
};

/// A chain whose inner pores also touch the bottom reservoir through throats too tight to open.
PoreNetwork drained_chain(const std::vector<double>& entry) {
  PoreNetwork network = chain(entry);
  const int last = network.pores() - 1;
  for (int i = 1; i < last; ++i) add_throat(network, i, last, 1e-6, 1e-6);
  return network;
}

// Model of a Haines jump: nothing moves below the threshold; above it both units follow the local law.
TEST(HainesJump, MatchesTheClosedForm) {
  const PoreNetwork network = drained_chain({0.5, 0.7, 1e6});
  const double volume = network.pore_volume[1];
  InvasionState state = start_invasion(network, unit_fluids(), {});
  Log log;
  advance_to(network, 0.7, state, log.callback());
  EXPECT_THAT(log.pores(Kind::drain), ElementsAre(1));
  EXPECT_NEAR(saturation(network, state)[1], law(network, 1, 0.7), 1e-13);
  EXPECT_EQ(saturation(network, state)[2], 1.0);

  advance_to(network, 0.9, state, log.callback());
  EXPECT_THAT(log.pores(Kind::drain), ElementsAre(1, 2));
  EXPECT_EQ(log.events.back().capillary_pressure, 0.7);
  EXPECT_EQ(log.events.back().throat, 1);
  EXPECT_NEAR(log.events.back().wetting_volume, -volume * (1.0 - law(network, 2, 0.7)), 1e-13 * volume);
  const double expected = law(network, 1, 0.9);
  EXPECT_THAT(saturation(network, state),
              ElementsAre(0.0, ::testing::DoubleNear(expected, 1e-13), ::testing::DoubleNear(expected, 1e-13), 1.0));
  EXPECT_NEAR(state.ledger.wetting_out.value(), 2.0 * volume * (1.0 - expected), 1e-12 * volume);
  EXPECT_NEAR(state.ledger.nonwetting_in.value(), 2.0 * volume * (1.0 - expected), 1e-12 * volume);
  EXPECT_EQ(state.ledger.wetting_in.value(), 0.0);
}

// A throat wider than its body: the body decides, and the unit is not invaded and refilled in turns.
TEST(HainesJump, WaitsForTheBody) {
  const PoreNetwork network = drained_chain({0.1, 1e6});
  const double body = body_pressure(network, 1);
  ASSERT_GT(body, 0.1);
  InvasionState state = start_invasion(network, unit_fluids(), {});
  Log log;
  advance_to(network, 0.999 * body, state, log.callback());
  EXPECT_TRUE(log.events.empty());
  for (int cycle = 0; cycle < 3; ++cycle) {
    advance_to(network, 1.001 * body, state, log.callback());
    advance_to(network, 0.999 * body, state, log.callback());
  }
  EXPECT_THAT(log.pores(Kind::drain), ElementsAre(1, 1, 1));
  EXPECT_THAT(log.pores(Kind::fill), ElementsAre(1, 1, 1));
  EXPECT_NEAR(log.events.front().capillary_pressure, body, 1e-12);
}

TEST(Chain, DrainsInKnownOrder) {
  const PoreNetwork network = drained_chain({1.0, 3.0, 2.0, 5.0, 1e6});
  InvasionState state = start_invasion(network, unit_fluids(), {});
  Log log;
  advance_to(network, 10.0, state, log.callback());
  EXPECT_THAT(log.pores(Kind::drain), ElementsAre(1, 2, 3, 4));
  std::vector<double> pressures;
  for (const auto& e : log.events) pressures.push_back(e.capillary_pressure);
  EXPECT_THAT(pressures, ElementsAre(1.0, 3.0, 3.0, 5.0));  // pore 3 follows at once through its wider throat
}

TEST(Chain, WidestThroatFirst) {
  PoreNetwork network = drained_chain({1.0, 1e6});
  network.throat_entry_radius[0] = 1.0 / 3.0;
  add_throat(network, 0, 1, 1.0 / 2.0, 1.0);
  add_throat(network, 0, 1, 1.0 / 4.0, 1.0);
  InvasionState state = start_invasion(network, unit_fluids(), {});
  Log log;
  advance_to(network, 3.5, state, log.callback());
  ASSERT_EQ(log.events.size(), 2u);
  EXPECT_EQ(log.events[0].throat, 3);
  EXPECT_EQ(log.events[1].kind, Kind::open_throat);
  EXPECT_EQ(log.events[1].throat, 0);
  EXPECT_EQ(log.events[1].capillary_pressure, 3.0);
}

TEST(InkBottle, DrainsThroughItsNeckAndRefillsByItsBody) {
  const PoreNetwork network = drained_chain({5.0, 1e6});
  InvasionOptions options;
  options.snap_off = false;
  InvasionState state = start_invasion(network, unit_fluids(), options);
  Log log;
  advance_to(network, 6.0, state, log.callback());
  advance_to(network, 0.0, state, log.callback());
  EXPECT_EQ(log.only(Kind::drain).capillary_pressure, 5.0);
  EXPECT_NEAR(log.only(Kind::fill).capillary_pressure, body_pressure(network, 1), 1e-12);
  EXPECT_EQ(totals(network, state).saturation, 1.0);
}

// With a law that ends at S_thr the bubble leaves at once; what flowed in before belongs to no event.
TEST(InkBottle, JumpsFromTheTouchingBubbleToFull) {
  const PoreNetwork network = drained_chain({5.0, 1e6});
  InvasionOptions options;
  options.snap_off = false;
  options.retention_law = PolyhedronRetention{};
  InvasionState state = start_invasion(network, unit_fluids(), options);
  Log log;
  advance_to(network, 6.0, state, log.callback());
  advance_to(network, 0.0, state, log.callback());
  const double bubble = 4.0 / 3.0 * std::numbers::pi * std::pow(network.pore_radius[1], 3);
  EXPECT_NEAR(log.only(Kind::fill).wetting_volume, bubble, 1e-12 * bubble);
}

// Without corner water the pore is emptied and a front through its tightest throat to water refills it.
TEST(InkBottle, WithoutCornerWaterRefillsThroughTheTighterOfThroatAndBody) {
  PoreNetwork network = chain({5.0, 0.3});
  network.throat_at_wall[1] = 1;  // water only
  InvasionOptions options;
  options.corner_water = options.wall_throats = false;
  for (const double front : {0.3, 5.0}) {
    network.throat_entry_radius[1] = network.throat_snap_off_radius[1] = 1.0 / front;
    InvasionState state = start_invasion(network, unit_fluids(), options);
    Log log;
    advance_to(network, 6.0, state, log.callback());
    EXPECT_EQ(totals(network, state).saturation, 0.0);
    advance_to(network, 0.0, state, log.callback());
    EXPECT_NEAR(log.only(Kind::fill).capillary_pressure, std::min(front, 2.0 / network.pore_radius[1]), 1e-12);
    EXPECT_EQ(totals(network, state).saturation, 1.0);
  }
}

// In a bare chain each invasion takes the last way of the water behind the front.
TEST(TrappedWater, KeepsTheVolumeItHad) {
  const PoreNetwork network = chain({1.0, 3.0, 1e6});
  InvasionState state = start_invasion(network, unit_fluids(), with_snap_off());
  Log log;
  advance_to(network, 8.0, state, log.callback());
  EXPECT_EQ(log.only(Kind::trap_wetting).capillary_pressure, 3.0);
  EXPECT_EQ(log.only(Kind::trap_wetting).pore, 1);
  EXPECT_NEAR(saturation(network, state)[1], law(network, 1, 3.0), 1e-13);
  EXPECT_NEAR(saturation(network, state)[2], law(network, 2, 8.0), 1e-13);
  EXPECT_NEAR(totals(network, state).trapped_wetting, 0.5 * law(network, 1, 3.0), 1e-13);

  // Snap-off of the throat between them, at half its entry pressure, lets it flow again.
  advance_to(network, 1.2, state, log.callback());
  EXPECT_EQ(log.only(Kind::snap_off).capillary_pressure, 1.5);
  EXPECT_NEAR(log.only(Kind::free_wetting).wetting_volume, network.pore_volume[1] * (law(network, 1, 1.5) - law(network, 1, 3.0)),
              1e-10);
  EXPECT_NEAR(saturation(network, state)[1], law(network, 1, 1.2), 1e-13);
  EXPECT_EQ(totals(network, state).trapped_wetting, 0.0);
}

TEST(TrappedWater, OfAPoreNeverInvadedStays) {
  PoreNetwork network = chain({1.0, 1e6});
  add_pore(network, 500.0, 6);
  add_throat(network, 1, 3, 1.0 / 2.0, 1.0);  // a dead end
  InvasionOptions options;
  options.corner_water = false;
  InvasionState state = start_invasion(network, unit_fluids(), options);
  advance_to(network, 10.0, state);
  EXPECT_THAT(saturation(network, state), ElementsAre(0.0, 0.0, 1.0, 1.0));
  EXPECT_NEAR(totals(network, state).trapped_wetting, 500.0 / 1500.0, 1e-15);

  options.trap_wetting = false;
  state = start_invasion(network, unit_fluids(), options);
  advance_to(network, 10.0, state);
  EXPECT_EQ(totals(network, state).saturation, 0.0);
}

TEST(TrappedGas, IsCutOffBySnapOffAndFreedBySecondaryDrainage) {
  PoreNetwork network = drained_chain({1.0, 4.0, 1e6});  // the second throat snaps off at 2
  network.throat_snap_off_radius[0] = 100.0;
  InvasionState state = start_invasion(network, unit_fluids(), with_snap_off());
  Log log;
  advance_to(network, 5.0, state, log.callback());
  advance_to(network, 0.0, state, log.callback());
  EXPECT_EQ(log.events[2].kind, Kind::snap_off);
  EXPECT_EQ(log.only(Kind::trap_nonwetting).capillary_pressure, 2.0);
  EXPECT_EQ(log.only(Kind::trap_nonwetting).pore, 2);
  const double trapped = 1.0 - law(network, 2, 2.0);
  EXPECT_NEAR(totals(network, state).trapped_nonwetting, 0.5 * trapped, 1e-13);
  EXPECT_NEAR(totals(network, state).saturation, 1.0 - 0.5 * trapped, 1e-13);

  log.events.clear();
  advance_to(network, 3.9, state, log.callback());
  EXPECT_NEAR(totals(network, state).trapped_nonwetting, 0.5 * trapped, 1e-13);
  advance_to(network, 5.0, state, log.callback());
  const InvasionEvent& freed = log.only(Kind::free_nonwetting);
  EXPECT_EQ(freed.capillary_pressure, 4.0);
  EXPECT_NEAR(freed.wetting_volume, -network.pore_volume[2] * (law(network, 2, 2.0) - law(network, 2, 4.0)), 1e-10);
  EXPECT_EQ(totals(network, state).trapped_nonwetting, 0.0);
  EXPECT_NEAR(totals(network, state).saturation, law(network, 1, 5.0), 1e-13);
}

TEST(TrappedGas, DoesNotOccurWhereItIsSwitchedOff) {
  const PoreNetwork network = drained_chain({1.0, 4.0, 1e6});
  for (const bool snap_off : {false, true}) {
    InvasionOptions options;
    options.trap_nonwetting = !snap_off;
    options.snap_off = snap_off;
    InvasionState state = start_invasion(network, unit_fluids(), options);
    advance_to(network, 5.0, state);
    advance_to(network, 0.0, state);
    EXPECT_NEAR(totals(network, state).trapped_nonwetting, 0.0, 1e-13);
    EXPECT_NEAR(totals(network, state).saturation, 1.0, 1e-13);
  }
}

TEST(CornerFilms, ConnectWaterThroughOpenThroats) {
  const PoreNetwork network = chain({1.0, 3.0, 1e6});
  InvasionOptions options;
  options.corner_films = true;
  InvasionState state = start_invasion(network, unit_fluids(), options);
  advance_to(network, 8.0, state);
  EXPECT_EQ(totals(network, state).trapped_wetting, 0.0);
  EXPECT_NEAR(totals(network, state).saturation, law(network, 1, 8.0), 1e-13);
}

TEST(WallThroats, StayClosedWhereTheyAreExcluded) {
  PoreNetwork network = drained_chain({1.0, 1e6});
  network.throat_at_wall[0] = 1;
  InvasionOptions options;
  for (const bool wall_throats : {true, false}) {
    options.wall_throats = wall_throats;
    InvasionState state = start_invasion(network, unit_fluids(), options);
    advance_to(network, 5.0, state);
    EXPECT_EQ(totals(network, state).saturation < 1.0, wall_throats);
  }
}

TEST(ClosedThroat, IsNeverEntered) {
  PoreNetwork network = drained_chain({1.0, 1e6});
  network.throat_entry_radius[0] = network.throat_snap_off_radius[0] = 0.0;
  InvasionState state = start_invasion(network, unit_fluids(), {});
  advance_to(network, 1e9, state);
  EXPECT_EQ(totals(network, state).saturation, 1.0);
}

// At 40 degrees a cube keeps corner water (limit 45), a unit of eight faces does not (35.3).
TEST(ContactAngle, EmptiesUnitsWhoseEdgesHoldNothing) {
  PoreNetwork network = drained_chain({1.0, 2.0, 1e6});
  network.pore_faces[2] = 8;
  Fluids fluids = unit_fluids();
  fluids.contact_angle = 40.0 * std::numbers::pi / 180.0;
  InvasionState state = start_invasion(network, fluids, {});
  advance_to(network, 3.0, state);
  const double threshold = 2.0 * std::cos(fluids.contact_angle) / network.pore_radius[1];
  EXPECT_NEAR(saturation(network, state)[1], -std::log(1.0 - threshold / 3.0) / (1.2591 * 6 - 1.1041), 1e-13);
  EXPECT_EQ(saturation(network, state)[2], 0.0);
}

}  // namespace
}  // namespace puadem::testing
