#include "puadem/bridges/bridges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/base/random.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using test::bridge_ends;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double gamma = 0.0728, radius = 3e-4;
using Pair = std::array<int, 2>;

const BridgeModel& at_suction() {
  static const BridgeModel model = bridge_model(gamma, 0.0, BridgeControl::suction);
  return model;
}
const BridgeModel& of_volume() {
  static const BridgeModel model = bridge_model(gamma, 0.0, BridgeControl::volume);
  return model;
}

/// Pairs (i, i + 1) of a chain of grains, each with its own radius and gap.
BridgePairs chain(int grains, double least_gap, double most_gap, std::uint64_t seed = 5) {
  Random random(seed);
  std::vector<double> r(to_size(grains));
  for (double& value : r) value = radius * random.uniform(0.5, 1.5);
  BridgePairs pairs;
  for (int i = 0; i + 1 < grains; ++i) {
    pairs.ends.push_back({i, i + 1});
    pairs.radius.push_back({r[to_size(i)], r[to_size(i + 1)]});
    pairs.gap.push_back(random.uniform(least_gap, most_gap));
  }
  return pairs;
}

Bridges one_bridge(const BridgeModel& model, double amount) {
  Bridges b;
  form_bridges(model, {{{0, 1}}, {{radius, radius}}, {0.0}}, std::array{amount}, BridgeFormation::at_contact, b);
  return b;
}

TEST(Bridges, FormOnWettingWhereEndsTouchAndOnDryingWhereverTheyCanStand) {
  BridgePairs pairs{{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}}, {}, {-1e-6, 1e-7, 0.0, 0.4 * radius, 1e-7}};
  pairs.radius.assign(5, {radius, radius});
  std::vector<double> suction(5, 5e4);
  suction[4] = 0.0;  // nothing there to make it of
  Bridges b;
  EXPECT_EQ(form_bridges(at_suction(), pairs, suction, BridgeFormation::at_contact, b), 2);
  EXPECT_THAT(b.pairs.ends, ElementsAre(Pair{0, 1}, Pair{1, 2}));
  EXPECT_EQ(form_bridges(at_suction(), pairs, suction, BridgeFormation::at_any_distance, b), 1);
  EXPECT_THAT(b.pairs.ends, ElementsAre(Pair{0, 1}, Pair{0, 2}, Pair{1, 2}));
  EXPECT_EQ(form_bridges(at_suction(), pairs, suction, BridgeFormation::at_any_distance, b), 0);
  EXPECT_EQ(b.pairs.gap[1], 1e-7);
  EXPECT_GT(b.force[0], b.force[1]);
  EXPECT_EQ(b.force[0], b.force[2]);
}

TEST(Bridges, PullAndHoldWhatTheExactSolutionSays) {
  for (const BridgeModel* model : {&at_suction(), &of_volume()}) {
    const bool suction = model == &at_suction();
    const BridgePairs pairs = chain(40, -1e-6, 4e-6);
    Bridges b;
    form_bridges(*model, pairs, std::vector<double>(39, suction ? 5e3 : 2e-14), BridgeFormation::at_any_distance, b);
    ASSERT_GT(b.size(), 30);
    for (std::size_t k = 0; k < to_size(b.size()); ++k) {
      const auto& r = b.pairs.radius[k];
      const StableBranch branch =
          stable_branch(bridge_ends(r[0], r[1], 0.0), model->table.control, suction ? 5e3 / gamma : 2e-14);
      const BridgeShape shape = *bridge_on(branch, b.pairs.gap[k]);
      EXPECT_NEAR(b.force[k], 2.0 * pi * gamma * shape.pull, 0.005 * b.force[k]);
      EXPECT_NEAR(b.volume[k], shape.volume, 0.005 * shape.volume);
      EXPECT_NEAR(b.capillary_pressure[k], gamma * shape.suction, 0.005 * gamma * shape.suction);
      EXPECT_NEAR(rupture_distance(*model, b, static_cast<int>(k)), branch.rupture.gap, 0.001 * branch.rupture.gap);
    }
  }
}

// The force integrated over a slow pull-off is the work that the model holds, which comes from areas; of the fits, from
// their own force.
TEST(Bridges, WorkOfAPullOffIsTheEnergyOfTheBridge) {
  const auto worked = [](const BridgeModel& model, double amount) {
    Bridges b = one_bridge(model, amount);
    const double energy = rupture_work(model, b), reach = rupture_distance(model, b, 0);
    const int steps = 4000;
    double work = 0.0;
    for (int i = 0; i < steps; ++i) {
      b.pairs.gap[0] = reach * (i + 0.5) / steps;
      update_forces(model, b);
      EXPECT_GT(b.force[0], 0.0);
      work += b.force[0] * reach / steps;
    }
    EXPECT_NEAR(work, energy, 0.01 * energy);
    b.pairs.gap[0] = 1.0001 * reach;
    update_forces(model, b);
    EXPECT_EQ(b.force[0], 0.0);
    EXPECT_EQ(rupture_work(model, b), 0.0);
    return energy;
  };
  worked(at_suction(), 5e3);
  const double exact = worked(of_volume(), 1e-13);
  BridgeModel fit = of_volume();
  fit.law = BridgeModel::Law::willett;
  EXPECT_NEAR(worked(fit, 1e-13), exact, 0.02 * exact);
  fit.law = BridgeModel::Law::soulie;
  EXPECT_NEAR(worked(fit, 1e-13), exact, 0.1 * exact);
}

// Chains pulled apart and pressed together again, their liquid split at every rupture and shared anew: none is lost.
TEST(Bridges, KeepTheirLiquidThroughRuptureAndReturn) {
  for (const RuptureSplit split : {RuptureSplit::halves, RuptureSplit::neck}) {
    const int grains = 200;
    const BridgePairs near = chain(grains, -1e-6, 0.0), far = chain(grains, 0.0, 4e-5, 7);
    std::vector<double> film(to_size(grains), 0.0);
    Bridges b;
    form_bridges(of_volume(), near, std::vector<double>(to_size(grains - 1), 3e-14), BridgeFormation::at_contact, b);
    const auto total = [&] {
      return std::accumulate(film.begin(), film.end(), std::accumulate(b.volume.begin(), b.volume.end(), 0.0));
    };
    const double before = total();
    int ruptured = 0;
    for (int cycle = 0; cycle < 5; ++cycle) {
      for (std::size_t k = 0; k < to_size(b.size()); ++k) b.pairs.gap[k] = far.gap[to_size(b.pairs.ends[k][0])];
      for (const RupturedBridge& r : rupture_bridges(of_volume(), split, b)) {
        ++ruptured;
        for (std::size_t k = 0; k < 2; ++k) film[to_size(r.ends[k])] += r.volume[k];
        EXPECT_GE(std::min(r.volume[0], r.volume[1]), 0.0);
      }
      share_films(of_volume(), film, b);
      EXPECT_NEAR(total(), before, 1e-13 * before);
      std::vector<double> taken(to_size(grains - 1), 0.0);  // what is left on both grains makes a bridge where they touch
      for (int i = 0; i + 1 < grains; ++i) {
        if (std::ranges::binary_search(b.pairs.ends, Pair{i, i + 1})) continue;
        for (const int g : {i, i + 1}) taken[to_size(i)] += std::exchange(film[to_size(g)], 0.0);
        if (taken[to_size(i)] < 1e-20) film[to_size(i)] += std::exchange(taken[to_size(i)], 0.0);
      }
      form_bridges(of_volume(), near, taken, BridgeFormation::at_contact, b);
      EXPECT_NEAR(total(), before, 1e-13 * before);
      EXPECT_TRUE(std::ranges::is_sorted(b.pairs.ends));
    }
    EXPECT_GT(ruptured, 50);
  }
}

TEST(Bridges, LeaveMoreOfTheirLiquidToTheLargerGrain) {
  Bridges b;
  form_bridges(of_volume(), {{{3, 8}}, {{3 * radius, radius}}, {0.0}}, std::array{1e-14}, BridgeFormation::at_contact, b);
  b.pairs.gap[0] = 1.01 * rupture_distance(of_volume(), b, 0);
  Bridges copy = b;
  const auto halves = rupture_bridges(of_volume(), RuptureSplit::halves, b);
  const auto neck = rupture_bridges(of_volume(), RuptureSplit::neck, copy);
  ASSERT_EQ(halves.size(), 1u);
  EXPECT_EQ(b.size(), 0);
  EXPECT_EQ(halves[0].ends, (Pair{3, 8}));
  EXPECT_EQ(halves[0].volume[0], halves[0].volume[1]);
  EXPECT_GT(neck[0].volume[0], 1.1 * neck[0].volume[1]);
  EXPECT_EQ(neck[0].volume[0] + neck[0].volume[1], 1e-14);
}

TEST(Bridges, TakeNoMoreFromFilmsThanTheTableReaches) {
  Bridges b = one_bridge(of_volume(), 1e-14);
  std::vector<double> film{1e-12, 1e-9};
  share_films(of_volume(), film, b);
  EXPECT_NEAR(b.volume[0], of_volume().table.most * std::pow(radius, 3), 1e-12 * b.volume[0]);
  EXPECT_NEAR(film[0] + film[1] + b.volume[0], 1e-12 + 1e-9 + 1e-14, 1e-21);
}

TEST(Bridges, FollowRadiiThatGrow) {
  Bridges b = one_bridge(at_suction(), 1e4);
  b.pairs.radius[0] = {2 * radius, 2 * radius};
  update_curves(at_suction(), b);
  update_forces(at_suction(), b);
  update_contents(at_suction(), b);
  Bridges fresh;
  form_bridges(at_suction(), b.pairs, std::array{1e4}, BridgeFormation::at_contact, fresh);
  EXPECT_EQ(b.force[0], fresh.force[0]);
  EXPECT_EQ(b.volume[0], fresh.volume[0]);
}

TEST(Bridges, JoinGrainsToWalls) {
  Bridges b;
  const BridgePairs pairs{{{-1, 0}, {0, 1}}, {{std::numeric_limits<double>::infinity(), radius}, {radius, radius}}, {0.0, 0.0}};
  EXPECT_EQ(form_bridges(at_suction(), pairs, std::array{5e5, 5e5}, BridgeFormation::at_contact, b), 2);
  EXPECT_NEAR(b.force[0], 4.0 * pi * gamma * radius, 0.05 * b.force[0]);  // R* = 2 R
  EXPECT_NEAR(b.force[1], 2.0 * pi * gamma * radius, 0.05 * b.force[1]);
  std::vector<double> film{1e-15};  // only grain 0 has a film
  Bridges wet;
  form_bridges(of_volume(), pairs, std::array{1e-15, 1e-15}, BridgeFormation::at_contact, wet);
  share_films(of_volume(), film, wet);
  EXPECT_NEAR(wet.volume[0], 1.5e-15, 1e-27);
}

TEST(Bridges, HaveTheSameBitsOnAnyNumberOfThreads) {
  std::vector<std::vector<double>> force;
  for (const int count : {1, 3}) {
    set_threads(count);
    Bridges b;
    form_bridges(at_suction(), chain(3000, -1e-6, 3e-6), std::vector<double>(2999, 2e3), BridgeFormation::at_any_distance, b);
    force.push_back(b.force);
    force.back().push_back(rupture_work(at_suction(), b));
  }
  set_threads(0);
  EXPECT_EQ(force[0], force[1]);
}

TEST(Bridges, SayWhatTheyCannotDo) {
  const auto message = [](double tension, double angle, BridgeControl control, BridgeModel::Law law) {
    try {
      bridge_model(tension, angle, control, law);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message(0.0, 0.0, BridgeControl::suction, BridgeModel::Law::table),
              HasSubstr("surface tension 0 N/m must be positive"));
  EXPECT_THAT(message(0.07, 0.0, BridgeControl::suction, BridgeModel::Law::willett), HasSubstr("for given volumes"));
  EXPECT_THROW(one_bridge(at_suction(), 10.0), InputError);
  BridgeModel fit = of_volume();
  fit.law = BridgeModel::Law::willett;
  EXPECT_THROW(one_bridge(fit, 1e-17), InputError);
  EXPECT_NO_THROW(one_bridge(of_volume(), 1e-17));
}

}  // namespace
}  // namespace puadem
