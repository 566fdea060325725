// Open throats of a pore delay its refilling.
#include "puadem/flow/cooperative_filling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "flow/two_phase_samples.hpp"
#include "puadem/flow/local_law.hpp"

namespace puadem {
namespace {

using namespace puadem::testing;

InvasionOptions cooperative(bool traps_gas = true) {
  InvasionOptions options;
  options.corner_films = true;
  options.cooperative_filling = true;
  options.trap_nonwetting = traps_gas;
  return options;
}

/// A pore with `arms` throats to the gas reservoir and one, tight, to the water; all its throats to gas differ.
PoreNetwork star(int arms) {
  PoreNetwork network;
  const int centre = add_pore(network, 1.0, 6), bottom = add_pore(network, 1.0, 6, at_bottom);
  add_throat(network, centre, bottom, 0.01, 0.01);
  for (int k = 0; k < arms; ++k)
    add_throat(network, centre, add_pore(network, 0.3 + 0.1 * k, 6, at_top), 0.05 + 0.03 * k, 0.1 + 0.06 * k);
  return network;
}

/// Capillary pressure at which the centre of the star refills, and its body's.
struct Refill {
  double pressure, body;
};
Refill refill(const PoreNetwork& network, const Fluids& fluids) {
  InvasionState state = start_invasion(network, fluids, cooperative());
  double pressure = -1.0;
  advance_to(network, 50.0, state);
  EXPECT_TRUE(state.nonwetting.holds[0]);
  advance_to(network, 0.0, state, [&](const InvasionEvent& event) {
    if (event.kind == InvasionEventKind::fill && event.pore == 0) pressure = event.capillary_pressure;
  });
  return {pressure, state.thresholds.body_pressure[0]};
}

TEST(CooperativeFilling, FollowsTheMeanRadiusOfTheMeniscus) {
  Fluids fluids = unit_fluids();
  fluids.contact_angle = 0.3;
  double last = 1e9;
  for (int n = 1; n <= 4; ++n) {
    const PoreNetwork network = star(n);
    const double radius = network.pore_radius[0], rate = 1000.0 * Random(1).uniform(1.0, 2.0);
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
      const double entry = 0.05 + 0.03 * k, turns = rate * (entry + network.pore_radius[to_size(2 + k)]) / radius;
      sum += std::abs(2.0 * (turns - std::floor(turns)) - 1.0) * 2.0 * entry * std::cos(0.3);
    }
    const auto [pressure, body] = refill(network, fluids);
    EXPECT_NEAR(pressure, body * radius / (radius + (n - 1.0) / n * sum), 1e-12 * body) << n;
    if (n == 1) {
      EXPECT_EQ(pressure, body);
    }
    EXPECT_LT(pressure, last) << "one more open throat";
    last = pressure;
  }
}

TEST(CooperativeFilling, WeightsAreUniformAndBelongToTheirSeed) {
  const PoreNetwork network = random_network(2000, 3);
  const PoreLinks links = pore_links(network);
  const auto weights = [&](std::uint64_t seed) {
    std::vector<double> w = filling_shares(network, links, unit_fluids(), seed);
    for (int i = 0; i < network.pores(); ++i)
      for (int k = links.start[to_size(i)]; k < links.start[to_size(i) + 1]; ++k)
        w[to_size(k)] /=
            2.0 * network.throat_entry_radius[to_size(links.link[to_size(k)].throat)] / network.pore_radius[to_size(i)];
    return w;
  };
  const std::vector<double> one = weights(1), two = weights(2);
  EXPECT_EQ(one, weights(1));
  const auto n = static_cast<double>(one.size());
  std::array<double, 10> share{};
  double product = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    share[to_size(std::min(static_cast<int>(10.0 * one[k]), 9))] += 1.0 / n;
    product += (one[k] - 0.5) * (two[k] - 0.5) * 12.0 / n;
  }
  for (const double s : share) EXPECT_NEAR(s, 0.1, 4.0 * std::sqrt(0.09 / n));
  EXPECT_NEAR(product, 0.0, 4.0 / std::sqrt(n)) << "another seed, other weights";
}

TEST(CooperativeFilling, TheBentLawFallsSteadilyToItsEnd) {
  for (const AnyRetentionLaw& law : {AnyRetentionLaw{ExponentialRetention{}}, AnyRetentionLaw{PolyhedronRetention{}}})
    for (const int faces : {4, 6, 13, 20})
      for (const double share : {0.0, 0.1, 0.6}) {
        const CapillaryUnit unit{3.0, faces};
        const double body = std::visit([&](const auto&l) { return l.saturated_pressure(unit); }, law), drop = share * body;
        EXPECT_NEAR(law_pressure(law, unit, drop, 1.0), body - drop, 1e-12);
        double last = law_pressure(law, unit, drop, 0.02);
        for (int k = 3; k <= 100; ++k) {
          const double s = k / 100.0, p = law_pressure(law, unit, drop, s);
          EXPECT_LE(p, last);
          last = p;
          if (p > body || drop > 0.0) {
            EXPECT_NEAR(law_saturation(law, unit, drop, p), s, drop > 0.0 ? 1e-9 : 1e-6);
          }
          const double slope = (law_pressure(law, unit, drop, s + 1e-6) - law_pressure(law, unit, drop, s - 1e-6)) / 2e-6;
          if (k < 100) {
            EXPECT_NEAR(law_slope(law, unit, drop, s), slope, 1e-4 * (1.0 + std::abs(slope)));
          }
        }
      }
}

/// Saturations of all pores at the stops of a way down and back, the steps cut into parts.
std::vector<std::vector<double>> way_back(const PoreNetwork& network, const InvasionOptions& options, int parts) {
  InvasionState state = start_invasion(network, unit_fluids(), options);
  const double high = 0.4 * high_pressure(network, unit_fluids());
  std::vector<std::vector<double>> result;
  for (int k = 0; k <= 10 * parts; ++k) {
    advance_to(network, high * (1.0 - 0.1 * k / parts), state);
    if (k % parts == 0) result.push_back(saturation(network, state));
  }
  return result;
}

TEST(CooperativeFilling, DoesNotDependOnTheStep) {
  for (const bool traps : {false, true})
    for (const bool snaps : {false, true}) {
      InvasionOptions options = cooperative(traps);
      options.snap_off = snaps;
      const PoreNetwork network = random_network(400, 4);
      const auto coarse = way_back(network, options, 1), fine = way_back(network, options, 16);
      for (std::size_t k = 0; k < coarse.size(); ++k)
        for (std::size_t i = 0; i < coarse[k].size(); ++i) ASSERT_NEAR(coarse[k][i], fine[k][i], 1e-12) << traps << snaps;
    }
}

TEST(CooperativeFilling, DoesNotDependOnTheNumbering) {
  const PoreNetwork network = random_network(400, 5);
  std::vector<int> pore_to;
  const PoreNetwork other = renumbered(network, 8, pore_to);
  const auto a = way_back(network, cooperative(), 1), b = way_back(other, cooperative(), 1);
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t i = 0; i < pore_to.size(); ++i) ASSERT_NEAR(a[k][i], b[k][to_size(pore_to[i])], 1e-9);
}

TEST(CooperativeFilling, LetsLessGasBeCutOff) {
  double with = 0.0, without = 0.0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const PoreNetwork network = random_network(400, seed);
    for (const bool on : {false, true}) {
      InvasionOptions options = cooperative();
      options.cooperative_filling = on;
      InvasionState state = start_invasion(network, unit_fluids(), options);
      advance_to(network, 0.4 * high_pressure(network, unit_fluids()), state);
      advance_to(network, 0.0, state);
      (on ? with : without) += totals(network, state).trapped_nonwetting / 4.0;
    }
  }
  EXPECT_LT(with, 0.9 * without);
}

/// The dynamic flow at rest is the quasi-static invasion, on the way down and back.
TEST(CooperativeFilling, TheSlowLimitIsTheInvasion) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const PoreNetwork network = with_conductance(random_network(300, seed));
    TwoPhaseOptions options;
    options.gas = GasKind::connected;
    options.cooperative_filling = true;
    TwoPhaseModel model = make_model(network, unit_fluids(), options, Schedule::constant(0.0));
    TwoPhaseState state = start_two_phase(network, model);
    InvasionState invasion = start_invasion(network, unit_fluids(), cooperative(false));
    const double high = 0.4 * high_pressure(network, unit_fluids());
    for (int k = 0; k <= 8; ++k) {
      const double pressure = high * (1.0 - k / 8.0);
      model.boundaries[1].schedule = Schedule::constant(-pressure);
      equilibrate_two_phase(network, model, {}, state);
      advance_to(network, pressure, invasion);
      const std::vector<double> s = saturation(network, state), expected = saturation(network, invasion);
      for (std::size_t i = 0; i < s.size(); ++i) ASSERT_NEAR(s[i], expected[i], 1e-6) << "seed " << seed << ", " << pressure;
    }
  }
}

}  // namespace
}  // namespace puadem
