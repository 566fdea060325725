// The fast invasion against the plainest one, event by event.
#include <gtest/gtest.h>

#include <numbers>

#include "flow/reference_invasion.hpp"
#include "flow/sample_networks.hpp"

namespace puadem::testing {
namespace {

using Events = std::vector<std::tuple<int, int, double>>;

void expect_same(const Events& events, const Events& reference) {
  const auto [a, b] = std::ranges::mismatch(events, reference);
  if (a != events.end()) ADD_FAILURE() << "event " << a - events.begin() << ::testing::PrintToString(*a);
  if (b != reference.end()) ADD_FAILURE() << "reference " << b - reference.begin() << ::testing::PrintToString(*b);
}

// @return number of events
int compare_on(const PoreNetwork& network, const Fluids& fluids, const InvasionOptions& options) {
  InvasionState state = start_invasion(network, fluids, options);
  ReferenceInvasion reference(network, fluids, options);
  Events events;
  const auto log = [&](const InvasionEvent& e) {
    if (e.kind <= InvasionEventKind::snap_off)
      events.emplace_back(static_cast<int>(e.kind), e.pore >= 0 ? e.pore : e.throat, e.capillary_pressure);
  };
  const double high = high_pressure(network, fluids);
  double start_water = 0.0;
  for (int i = 0; i < network.pores(); ++i)
    if (reference.is_counted(i)) start_water += state.wetting_volume[to_size(i)];
  for (const double fraction : {0.2, 0.35, 0.6, 1.0, 0.5, 0.3, 0.1, 0.4, 0.7, 0.2, 0.0, 0.9, 0.45, 0.05, 1.0}) {
    advance_to(network, fraction * high, state, log);
    reference.advance_to(fraction * high);
    expect_same(events, reference.events);
    if (::testing::Test::HasFailure()) return 0;
    EXPECT_EQ(state.nonwetting.holds, reference.gas);
    EXPECT_EQ(state.nonwetting.passes, reference.open);
    EXPECT_EQ(state.nonwetting.connected, reference.gas_connected);
    EXPECT_EQ(state.wetting.connected, reference.water_connected);
    double water = 0.0, trapped_water = 0.0, trapped_gas = 0.0;
    for (int i = 0; i < network.pores(); ++i) {
      EXPECT_NEAR(state.wetting_volume[to_size(i)], reference.water[to_size(i)], 1e-13 * network.pore_volume[to_size(i)]) << i;
      EXPECT_GE(state.wetting_volume[to_size(i)], 0.0);
      EXPECT_LE(state.wetting_volume[to_size(i)], network.pore_volume[to_size(i)]);
      if (!reference.is_counted(i)) continue;
      water += reference.water[to_size(i)];
      if (!reference.water_connected[to_size(i)]) trapped_water += reference.water[to_size(i)];
      if (!reference.gas_connected[to_size(i)]) trapped_gas += reference.volume(i) - reference.water[to_size(i)];
    }
    const double tolerance = 1e-12 * state.void_volume;
    const InvasionTotals sums = totals(network, state);
    EXPECT_NEAR(sums.saturation * state.void_volume, water, tolerance);
    EXPECT_NEAR(sums.trapped_wetting * state.void_volume, trapped_water, tolerance);
    EXPECT_NEAR(sums.trapped_nonwetting * state.void_volume, trapped_gas, tolerance);
    EXPECT_NEAR(start_water + state.ledger.wetting_in.value() - state.ledger.wetting_out.value(), water, tolerance);
    EXPECT_NEAR(state.ledger.nonwetting_in.value() - state.ledger.nonwetting_out.value(), state.void_volume - water, tolerance);
  }
  return size_of(events);
}

class EveryCombination : public ::testing::TestWithParam<int> {};

TEST_P(EveryCombination, EqualsTheFloodAfterEachEvent) {
  InvasionOptions options;
  options.snap_off = GetParam() & 1;
  options.trap_wetting = GetParam() & 2;
  options.trap_nonwetting = GetParam() & 4;
  options.corner_films = GetParam() & 8;
  options.corner_water = GetParam() & 16;
  options.wall_throats = GetParam() & 32;
  if (GetParam() & 64) options.retention_law = PolyhedronRetention{};
  options.body_entry = options.corner_water || !(GetParam() & 64);  // no local law without corner water
  options.side_pores = !(GetParam() & 128);
  const std::uint64_t seed = static_cast<std::uint64_t>(GetParam()) % 7;
  int events = compare_on(random_network(60, seed, 3), unit_fluids(), options);
  Fluids slanted = unit_fluids();
  slanted.contact_angle = 40.0 / 180.0 * std::numbers::pi;  // some shapes keep corner water, some do not
  events += compare_on(random_network(60, seed + 10, 3), slanted, options);
  EXPECT_GT(events, 30);
}

INSTANTIATE_TEST_SUITE_P(Options, EveryCombination, ::testing::Range(0, 256));

}  // namespace
}  // namespace puadem::testing
