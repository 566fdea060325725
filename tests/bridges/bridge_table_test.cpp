#include "puadem/bridges/bridge_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "puadem/base/error.hpp"
#include "puadem/base/parallel.hpp"
#include "puadem/base/random.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using test::bridge_ends;
using test::degrees;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double plane = std::numeric_limits<double>::infinity();

const BridgeTable& suction_table(double angle) {
  static const BridgeTable wetting = make_bridge_table(BridgeControl::suction, 0.0);
  static const BridgeTable poor = make_bridge_table(BridgeControl::suction, 50 * degrees);
  return angle == 0.0 ? wetting : poor;
}
const BridgeTable& volume_table(double angle) {
  static const BridgeTable wetting = make_bridge_table(BridgeControl::volume, 0.0);
  static const BridgeTable poor = make_bridge_table(BridgeControl::volume, 50 * degrees);
  return angle == 0.0 ? wetting : poor;
}
std::vector<const BridgeTable*> tables() {
  return {&suction_table(0.0), &suction_table(1.0), &volume_table(0.0), &volume_table(1.0)};
}

/// Amounts over the whole range of a table with ratios of the radii, R* = 1, from a fixed seed.
struct Draw {
  double amount;
  std::array<double, 2> radius;
};
std::vector<Draw> draws(const BridgeTable& table, int n) {
  Random random(11);
  std::vector<Draw> all;
  for (int i = 0; i < n; ++i) {
    const double ratio = i % 5 == 0 ? 1.0 : i % 5 == 1 ? 0.0 : random.uniform();
    all.push_back({table.least * std::pow(table.most / table.least, random.uniform()),
                   {0.5 * (1.0 + ratio), ratio > 0.0 ? 0.5 * (1.0 + ratio) / ratio : plane}});
  }
  return all;
}

TEST(BridgeTable, AgreesWithTheExactSolutionOffTheGrid) {
  for (const BridgeTable* table : tables())
    for (const auto& [amount, radius] : draws(*table, 60)) {
      const StableBranch branch = stable_branch(bridge_ends(radius[0], radius[1], table->contact_angle), table->control, amount);
      const BridgeCurve curve = bridge_curve(*table, radius, amount);
      EXPECT_NEAR(curve.reach, branch.rupture.gap, 1e-3 * branch.rupture.gap);
      const double work = free_energy(branch, branch.rupture) - free_energy(branch, *bridge_on(branch, 0.0));
      for (const double share : {0.0, 0.07, 0.4, 0.8, 0.95, 0.98}) {
        const double gap = share * branch.rupture.gap;
        const BridgeShape shape = *bridge_on(branch, gap);
        EXPECT_NEAR(bridge_pull(curve, gap), shape.pull, 0.005 * shape.pull) << amount << ' ' << radius[1] << ' ' << share;
        const bool at_suction = table->control == BridgeControl::suction;
        const double scale = at_suction ? shape.volume : 2.0 * std::cos(table->contact_angle) / curve.small.zero_gap(gap);
        EXPECT_NEAR(bridge_content(curve, gap), at_suction ? shape.volume : shape.suction, 0.01 * scale)
            << amount << ' ' << share;
        EXPECT_NEAR(bridge_work(curve, gap), free_energy(branch, branch.rupture) - free_energy(branch, shape), 0.005 * work);
      }
    }
}

// The work to pull a pair apart is the integral of the force; the table holds it from areas alone.
void expect_work(const BridgeTable& table) {
  for (const auto& [amount, radius] : draws(table, 10)) {
    const BridgeCurve curve = bridge_curve(table, radius, amount);
    const int steps = 2000;
    double integral = 0.0;  // over zeta = sqrt(1 - D / D_max), so that the end does not matter
    for (int k = 0; k < steps; ++k) {
      const double zeta = (k + 0.5) / steps;
      integral += bridge_pull(curve, curve.reach * (1.0 - zeta * zeta)) * 2.0 * zeta * curve.reach / steps;
    }
    EXPECT_NEAR(2.0 * pi * integral, bridge_work(curve, 0.0), 0.005 * bridge_work(curve, 0.0)) << amount;
    EXPECT_EQ(bridge_work(curve, curve.reach), 0.0);
  }
}

void expect_slope(const BridgeTable& table) {
  for (const auto& [amount, radius] : draws(table, 10)) {
    const BridgeCurve curve = bridge_curve(table, radius, amount);
    for (const double share : {0.05, 0.5, 0.9}) {
      const double gap = share * curve.reach, h = 1e-5 * curve.reach;
      const double slope = (bridge_pull(curve, gap + h) - bridge_pull(curve, gap - h)) / (2.0 * h);
      EXPECT_NEAR(bridge_pull_slope(curve, gap), slope, 1e-6 * std::abs(slope));
      EXPECT_LT(slope, 0.0);
    }
  }
}

void expect_order(const BridgeTable& table) {
  for (const auto& [amount, radius] : draws(table, 10)) {
    const BridgeCurve here = bridge_curve(table, radius, amount), there = bridge_curve(table, {radius[1], radius[0]}, amount);
    EXPECT_EQ(bridge_pull(here, 0.4 * here.reach), bridge_pull(there, 0.4 * here.reach));
    EXPECT_EQ(bridge_content(here, 0.4 * here.reach), bridge_content(there, 0.4 * here.reach));
    EXPECT_NEAR(here.share + there.share, radius[0] == radius[1] ? 2.0 * here.share : 1.0, 1e-15);
  }
}

void expect_scaling(const BridgeTable& table) {
  const double s = 3e-5;
  for (const auto& [amount, radius] : draws(table, 10)) {
    const bool at_suction = table.control == BridgeControl::suction;
    const BridgeCurve large = bridge_curve(table, radius, amount);
    const BridgeCurve small = bridge_curve(table, {s * radius[0], s * radius[1]}, at_suction ? amount / s : amount * s * s * s);
    const double gap = 0.6 * large.reach;
    EXPECT_NEAR(small.reach / s, large.reach, 1e-12 * large.reach);
    EXPECT_NEAR(bridge_pull(small, s * gap) / s, bridge_pull(large, gap), 1e-11);
    EXPECT_NEAR(bridge_work(small, s * gap) / (s * s), bridge_work(large, gap), 1e-11);
    EXPECT_NEAR(bridge_content(small, s * gap) / (at_suction ? s * s * s : 1 / s), bridge_content(large, gap),
                1e-10 * std::abs(bridge_content(large, gap)));
  }
}

void expect_contact(const BridgeTable& table) {
  const BridgeCurve curve = bridge_curve(table, {1.0, 2.0}, std::sqrt(table.least * table.most));
  EXPECT_EQ(bridge_pull(curve, -0.01), bridge_pull(curve, 0.0));
  EXPECT_EQ(bridge_content(curve, -0.01), bridge_content(curve, 0.0));
  EXPECT_EQ(bridge_work(curve, -0.01), bridge_work(curve, 0.0));
}

TEST(BridgeTable, WorkIsTheIntegralOfTheForce) {
  for (const double angle : {0.0, 1.0}) expect_work(suction_table(angle));
}

TEST(BridgeTable, SlopeIsTheChangeOfThePull) {
  for (const double angle : {0.0, 1.0}) expect_slope(suction_table(angle));
}

TEST(BridgeTable, DoesNotHangOnTheOrderOfTheEnds) {
  for (const double angle : {0.0, 1.0}) expect_order(suction_table(angle));
}

TEST(BridgeTable, ScalesWithTheUnitOfLength) {
  for (const double angle : {0.0, 1.0}) expect_scaling(suction_table(angle));
}

TEST(BridgeTable, TakesOverlappingEndsAsTouching) {
  for (const double angle : {0.0, 1.0}) expect_contact(suction_table(angle));
}

// The dearer tables in one test: each test is a process of its own.
TEST(BridgeTable, OfGivenVolumeKeepsAllThis) {
  for (const double angle : {0.0, 1.0}) {
    const BridgeTable& table = volume_table(angle);
    expect_work(table);
    expect_slope(table);
    expect_order(table);
    expect_scaling(table);
    expect_contact(table);
  }
}

TEST(BridgeTable, InContactUnderGreatSuctionPullsWithTwoPiRGammaCosine) {
  for (const double ratio : {1.0, 3.0, plane})
    for (const double angle : {0.0, 50 * degrees}) {
      const BridgeCurve curve = bridge_curve(suction_table(angle), {1.0, ratio}, 5e4);
      const double radius = reduced_radius(bridge_ends(1.0, ratio, 0.0));
      EXPECT_NEAR(bridge_pull(curve, 0.0), radius * std::cos(angle), 0.005 * radius);
    }
}

TEST(BridgeTable, SharesTheLiquidAtRuptureByTheNeck) {
  for (const double ratio : {1.0, 2.0, 5.0}) {
    const StableBranch branch = stable_branch(bridge_ends(1.0, ratio, 0.0), BridgeControl::volume, 1e-3);
    const double share = bridge_curve(volume_table(0.0), {1.0, ratio}, 1e-3).share;
    EXPECT_NEAR(share, branch.rupture.sides[0].volume / branch.rupture.volume, 0.02);
    EXPECT_LE(share, 0.5 + 1e-6);
  }
  EXPECT_NEAR(bridge_curve(volume_table(0.0), {1.0, 1.0}, 1e-3).share, 0.5, 1e-6);
}

TEST(BridgeTable, HasTheSameBitsOnAnyNumberOfThreads) {
  set_threads(1);
  const BridgeTable one = make_bridge_table(BridgeControl::suction, 20 * degrees);
  set_threads(3);
  const BridgeTable three = make_bridge_table(BridgeControl::suction, 20 * degrees);
  set_threads(0);
  ASSERT_EQ(one.node.size(), three.node.size());
  EXPECT_EQ(std::memcmp(one.node.data(), three.node.data(), one.node.size() * sizeof(double)), 0);
  EXPECT_LT(one.node.size() * sizeof(double), 150000u);
}

TEST(BridgeTable, SaysWhatLiesOutside) {
  const auto message = [](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message([] { make_bridge_table(BridgeControl::suction, 85 * degrees); }),
              HasSubstr("contact angle 85 deg must lie in [0, 80]"));
  EXPECT_THAT(message([] {
                bridge_curve(suction_table(0.0), {1, 1}, 0.5);
              }),
              HasSubstr("p_c R*/gamma = 0.5 must lie in [1, 100000]"));
  EXPECT_THAT(message([] { bridge_curve(volume_table(0.0), {1, 1}, 0.6); }), HasSubstr("V/R*^3 = 0.6 must lie in [1e-12, 0.16]"));
}

}  // namespace
}  // namespace puadem
