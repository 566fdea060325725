#include "puadem/flow/retention_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "flow/sample_networks.hpp"
#include "puadem/base/error.hpp"

namespace puadem::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<double> pressures(const std::vector<RetentionStop>& stops) {
  std::vector<double> result;
  for (const auto& stop : stops) result.push_back(stop.capillary_pressure);
  return result;
}
std::vector<std::string> branches(const std::vector<RetentionStop>& stops) {
  std::vector<std::string> result;
  for (const auto& stop : stops) result.push_back(stop.branch);
  return result;
}

TEST(RetentionStops, GoFromTurningPointToTurningPoint) {
  const auto stops = retention_stops({{400, 750, 500}, {100}, 0});
  EXPECT_THAT(pressures(stops), ElementsAre(400, 500, 600, 700, 750, 650, 550, 500));
  EXPECT_THAT(branches(stops), ElementsAre("drainage-1", "drainage-1", "drainage-1", "drainage-1", "drainage-1", "imbibition-1",
                                           "imbibition-1", "imbibition-1"));
}

TEST(RetentionStops, CountBranches) {
  EXPECT_THAT(branches(retention_stops({{300, 200, 300, 400, 0}, {1000}, 0})),
              ElementsAre("drainage-1", "imbibition-1", "drainage-2", "drainage-2", "imbibition-2"));
  EXPECT_THAT(branches(retention_stops({{300, 400}, {1000}, 0}, 500)), ElementsAre("imbibition-1", "drainage-1"));
}

TEST(RetentionStops, MayHaveAStepForEachLeg) {
  EXPECT_THAT(pressures(retention_stops({{0, 200, 50}, {100, 75}, 0})), ElementsAre(0, 100, 200, 125, 50));
}

TEST(RetentionStops, BeginWithAnImbibitionWhereAllIsDry) {
  const auto stops = retention_stops({{300, 100, 200}, {100}, 0}, std::numeric_limits<double>::infinity());
  EXPECT_THAT(branches(stops), ElementsAre("imbibition-1", "imbibition-1", "imbibition-1", "drainage-1"));
}

TEST(RetentionStops, MayBeOne) { EXPECT_THAT(pressures(retention_stops({{0}, {50}, 0})), ElementsAre(0)); }

TEST(RetentionStops, EndOnTheTurningPointDespiteRounding) {
  EXPECT_THAT(pressures(retention_stops({{0.2, 1.1}, {0.3}, 0})), ElementsAre(0.2, 0.5, 0.8, 1.1));
  EXPECT_EQ(retention_stops({{0.2, 1.1}, {0.1}, 0}).size(), 10u);  // nine tenths fall short of the leg by a rounding
}

TEST(RetentionStops, RefuseBadPaths) {
  const auto message = [](const RetentionPath& path) -> std::string {
    try {
      retention_stops(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing thrown";
  };
  EXPECT_THAT(message({{}, {100}, 0}), HasSubstr("the retention path is empty"));
  EXPECT_THAT(message({{0, 100}, {0}, 0}), HasSubstr("step of the retention path is 0 Pa; it must be positive"));
  EXPECT_THAT(message({{0, -100}, {10}, 0}), HasSubstr("value 2 of the retention path is -100 Pa"));
  EXPECT_THAT(message({{0, 100, 100}, {10}, 0}), HasSubstr("values 2 and 3 of the retention path are both 100 Pa"));
  EXPECT_THAT(message({{0, 100, 0}, {10, 20, 30}, 0}), HasSubstr("has 3 steps for 2 legs"));
  EXPECT_THAT(message({{0, 100}, {1e-6}, 0}), HasSubstr("more than a million steps"));
}

TEST(FollowPath, GivesARowPerStop) {
  const PoreNetwork network = random_network(200, 1);
  const double high = high_pressure(network, unit_fluids());
  const RetentionPath path{{0.0, high, 0.0, high}, {high / 10.0}, 0.02};
  InvasionState state = start_invasion(network, unit_fluids(), {});
  int calls = 0;
  const auto rows = follow_path(network, unit_fluids(), path, state, [&](const RetentionRow& row) {
    EXPECT_EQ(row.step, calls++);
    EXPECT_EQ(row.saturation, totals(network, state).saturation);
    return true;
  });
  ASSERT_EQ(rows.size(), 31u);
  EXPECT_EQ(calls, 31);
  EXPECT_EQ(rows.front().saturation, 1.0);
  EXPECT_NEAR(rows[3].pc_star, rows[3].capillary_pressure * 0.02, 1e-12);
  EXPECT_EQ(rows[10].branch, "drainage-1");
  EXPECT_EQ(rows[11].branch, "imbibition-1");
  EXPECT_GT(rows[20].trapped_nonwetting, 0.0);
  EXPECT_NEAR(rows[20].trapped_nonwetting, 1.0 - rows[20].saturation, 1e-12);  // at p_c = 0 all gas left is trapped
  EXPECT_LT(rows[30].saturation, rows[20].saturation);
}

TEST(FollowPath, StopsWhereItIsTold) {
  const PoreNetwork network = random_network(50, 1);
  InvasionState state = start_invasion(network, unit_fluids(), {});
  const auto rows =
      follow_path(network, unit_fluids(), {{0, 100}, {10}, 1}, state, [](const RetentionRow& row) { return row.step < 2; });
  EXPECT_EQ(rows.size(), 3u);
}

}  // namespace
}  // namespace puadem::testing
