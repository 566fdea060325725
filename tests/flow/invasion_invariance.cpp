// What the state reached must not depend on, and what must hold on any network.
#include <gtest/gtest.h>

#include "flow/sample_networks.hpp"
#include "puadem/flow/invasion.hpp"

namespace puadem::testing {
namespace {

std::vector<double> curve(const PoreNetwork& network, const Fluids& fluids, const std::vector<double>& pressures,
                          const InvasionOptions& options = with_snap_off()) {
  InvasionState state = start_invasion(network, fluids, options);
  std::vector<double> result;
  for (const double p : pressures) {
    advance_to(network, p, state);
    result.push_back(totals(network, state).saturation);
  }
  return result;
}

TEST(Invasion, DoesNotDependOnTheStep) {
  const PoreNetwork network = random_network(400, 3);
  const double high = high_pressure(network, unit_fluids());
  const auto reach = [&](int parts) {  // stops 40 * parts on each leg; common stops returned
    InvasionState state = start_invasion(network, unit_fluids(), with_snap_off());
    std::vector<std::vector<double>> common;
    for (const auto& [from, to] : {std::pair(0, 40), std::pair(40, 0), std::pair(0, 25), std::pair(25, 10), std::pair(10, 40)})
      for (int k = 1; k <= std::abs(to - from) * parts; ++k) {
        advance_to(network, high * (from + (to > from ? 1.0 : -1.0) * k / parts) / 40.0, state);
        if (k % (5 * parts) == 0) common.push_back(saturation(network, state));
      }
    return std::pair(common, state.ledger.wetting_in.value());
  };
  const auto [coarse, coarse_in] = reach(1);
  const auto [fine, fine_in] = reach(16);
  EXPECT_EQ(coarse, fine);
  EXPECT_NEAR(coarse_in, fine_in, 1e-12);
  EXPECT_GT(coarse_in, 0.1);
}

TEST(Invasion, DoesNotDependOnTheNumbering) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PoreNetwork network = random_network(300, seed);
    std::vector<int> pore_to;
    const PoreNetwork other = renumbered(network, seed, pore_to);
    const double high = high_pressure(network, unit_fluids());
    InvasionState a = start_invasion(network, unit_fluids(), with_snap_off()),
                  b = start_invasion(other, unit_fluids(), with_snap_off());
    for (const double fraction : {0.1, 0.2, 0.5, 0.9, 0.3, 0.1, 0.0, 0.4, 1.0}) {
      advance_to(network, fraction * high, a);
      advance_to(other, fraction * high, b);
      const std::vector<double> s = saturation(network, a), t = saturation(other, b);
      for (int i = 0; i < network.pores(); ++i) ASSERT_NEAR(s[to_size(i)], t[to_size(pore_to[to_size(i)])], 1e-12);
      EXPECT_NEAR(totals(network, a).saturation, totals(other, b).saturation, 1e-12);
    }
  }
}

// The same in millimetres: lengths times 1000, pressures as they are.
TEST(Invasion, DoesNotDependOnTheUnits) {
  const PoreNetwork network = random_network(300, 4);
  PoreNetwork in_millimetres = network;
  for (double& v : in_millimetres.pore_volume) v *= 1e9;
  for (auto* radii : {&in_millimetres.pore_radius, &in_millimetres.throat_entry_radius, &in_millimetres.throat_snap_off_radius})
    for (double& r : *radii) r *= 1e3;
  Fluids scaled = unit_fluids();
  scaled.surface_tension *= 1e3;
  const double high = high_pressure(network, unit_fluids());
  const std::vector<double> pressures{0.21 * high, 0.51 * high, high, 0.31 * high, 0.11 * high, 0.0, 0.61 * high};
  const auto a = curve(network, unit_fluids(), pressures), b = curve(in_millimetres, scaled, pressures);
  for (int k = 0; k < size_of(pressures); ++k) EXPECT_NEAR(a[to_size(k)], b[to_size(k)], 1e-12);
}

// Without trapping the invaded set at a turning point follows from its pressure alone: inner loops close.
TEST(ScanningLoop, ClosesWithoutTrapping) {
  const PoreNetwork network = random_network(400, 5);
  const double high = high_pressure(network, unit_fluids());
  InvasionOptions options = with_snap_off();
  options.trap_wetting = options.trap_nonwetting = false;
  const auto s = curve(network, unit_fluids(), {0.6 * high, 0.1 * high, 0.6 * high, 0.1 * high, 0.6 * high}, options);
  EXPECT_LT(s[0], s[1]);
  EXPECT_EQ(s[0], s[2]);
  EXPECT_EQ(s[1], s[3]);
  EXPECT_EQ(s[0], s[4]);
}

TEST(Invasion, ImbibitionLiesBelowDrainage) {
  const PoreNetwork network = random_network(600, 6);
  const double high = high_pressure(network, unit_fluids());
  InvasionState state = start_invasion(network, unit_fluids(), with_snap_off());
  std::vector<double> drainage, imbibition;
  for (int k = 0; k <= 20; ++k) {
    advance_to(network, high * k / 20.0, state);
    drainage.push_back(totals(network, state).saturation);
  }
  for (int k = 20; k >= 0; --k) {
    advance_to(network, high * k / 20.0, state);
    imbibition.push_back(totals(network, state).saturation);
  }
  std::ranges::reverse(imbibition);
  for (std::size_t k = 0; k < 20; ++k) EXPECT_LE(imbibition[k], drainage[k] + 1e-12);
  EXPECT_LT(drainage.back(), 0.5);
}

TEST(Invasion, BooksEachEvent) {
  const PoreNetwork network = random_network(200, 8);
  const double high = high_pressure(network, unit_fluids());
  InvasionOptions options;
  options.corner_water = false;  // water moves in events only
  InvasionState state = start_invasion(network, unit_fluids(), options);
  CompensatedSum in, out;
  const auto sum = [&](const InvasionEvent& e) { (e.wetting_volume > 0.0 ? in : out).add(std::abs(e.wetting_volume)); };
  for (const double fraction : {0.8, 0.0, 0.5, 0.1}) {
    advance_to(network, fraction * high, state, sum);
    EXPECT_NEAR(state.ledger.wetting_in.value(), in.value(), 1e-14);
    EXPECT_NEAR(state.ledger.wetting_out.value(), out.value(), 1e-14);
  }
  EXPECT_GT(in.value(), 0.0);
}

TEST(Invasion, DoesNothingWhereItStands) {
  const PoreNetwork network = random_network(100, 2);
  InvasionState state = start_invasion(network, unit_fluids(), with_snap_off());
  int events = 0;
  const auto count = [&](const InvasionEvent&) { ++events; };
  advance_to(network, 0.0, state, count);
  EXPECT_EQ(events, 0);
  EXPECT_EQ(totals(network, state).saturation, 1.0);
  const double p = 0.5 * high_pressure(network, unit_fluids());
  advance_to(network, p, state);
  const std::vector<double> before = saturation(network, state);
  advance_to(network, p, state, count);
  EXPECT_EQ(events, 0);
  EXPECT_EQ(saturation(network, state), before);
}

}  // namespace
}  // namespace puadem::testing
