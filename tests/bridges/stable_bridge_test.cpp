#include "puadem/bridges/stable_bridge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "puadem/base/error.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using test::bridge_ends;
using test::degrees;
using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;
constexpr double plane = std::numeric_limits<double>::infinity();

std::vector<StableBranch> branches() {
  std::vector<StableBranch> all;
  for (const auto& ends : {bridge_ends(1, 1, 0), bridge_ends(1, 1, 20 * degrees), bridge_ends(1, 1, 40 * degrees),
                           bridge_ends(0.7, 3, 20 * degrees), bridge_ends(0.5, plane, 0), bridge_ends(2, 1, 50 * degrees)}) {
    for (const double suction : {2.0, 30.0, 1000.0}) all.push_back(stable_branch(ends, BridgeControl::suction, suction));
    for (const double volume : {1e-6, 1e-3, 0.02}) all.push_back(stable_branch(ends, BridgeControl::volume, volume));
  }
  return all;
}

TEST(StableBridge, KeepsItsSuctionOrVolumeAndStandsAtTheGapAsked) {
  for (const StableBranch& branch : branches())
    for (const double share : {0.0, 0.3, 0.9, 0.999}) {
      const auto shape = bridge_on(branch, share * branch.rupture.gap);
      ASSERT_TRUE(shape);
      EXPECT_NEAR(shape->gap, share * branch.rupture.gap, 1e-9 * branch.rupture.gap);
      EXPECT_NEAR(branch.control == BridgeControl::suction ? shape->suction : shape->volume, branch.amount, 1e-9 * branch.amount);
    }
}

// Virtual work: 2 pi f = d(A_lg - cos(theta) A_ls)/dD at one volume, and with p V added at one suction; the conjugate of the
// amount is -p or V. Areas know nothing of the first integral that the pull comes from.
TEST(StableBridge, PullsAsItsEnergyChanges) {
  for (const StableBranch& branch : branches())
    for (const double share : {0.1, 0.6}) {
      const double gap = share * branch.rupture.gap, h = 1e-4 * branch.rupture.gap, grown = 1.0 + 1e-4;
      const auto at = [&](double d) { return free_energy(branch, *bridge_on(branch, d)); };
      const auto shape = *bridge_on(branch, gap);
      EXPECT_NEAR((at(gap + h) - at(gap - h)) / (2.0 * h), 2.0 * pi * shape.pull, 1e-4 * 2.0 * pi * shape.pull);
      const StableBranch more = stable_branch(branch.ends, branch.control, branch.amount * grown);
      const StableBranch less = stable_branch(branch.ends, branch.control, branch.amount / grown);
      const double slope = (free_energy(more, *bridge_on(more, gap)) - free_energy(less, *bridge_on(less, gap))) /
                           (branch.amount * (grown - 1.0 / grown));
      const double expected = branch.control == BridgeControl::suction ? shape.volume : -shape.suction;
      EXPECT_NEAR(slope, expected, 1e-4 * std::abs(expected) + 1e-5 * shape.pull / shape.sides[0].contact_radius);
    }
}

TEST(StableBridge, PullsLessTheWiderTheGap) {
  for (const StableBranch& branch : branches()) {
    double last = std::numeric_limits<double>::infinity();
    for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const double pull = bridge_on(branch, share * branch.rupture.gap)->pull;
      EXPECT_LT(pull, last);
      EXPECT_GT(pull, 0.0);
      last = pull;
    }
    EXPECT_FALSE(bridge_on(branch, 1.000001 * branch.rupture.gap));
    EXPECT_EQ(bridge_on(branch, -0.1)->pull, bridge_on(branch, 0.0)->pull);
  }
}

// Of the two bridges at one suction and gap the one with the smaller pull is the way to rupture: of higher energy.
TEST(StableBridge, HasLessEnergyThanTheOtherBridgeAtTheSameGap) {
  const StableBranch branch = stable_branch(bridge_ends(1, 1.5, 10 * degrees), BridgeControl::suction, 12.0);
  for (const double share : {0.5, 0.9}) {
    double low = 1e-4, high = branch.rupture.pull;
    for (int k = 0; k < 80; ++k) {
      const double middle = 0.5 * (low + high);
      (bridge_shape(branch.ends, branch.amount, middle)->gap < share * branch.rupture.gap ? low : high) = middle;
    }
    const auto other = *bridge_shape(branch.ends, branch.amount, low), stable = *bridge_on(branch, share * branch.rupture.gap);
    EXPECT_NEAR(other.gap, stable.gap, 1e-12);
    EXPECT_LT(free_energy(branch, stable), free_energy(branch, other));
  }
}

// The widest gap over all filling angles, from the Young-Laplace equation itself.
TEST(StableBridge, RupturesAtTheWidestGapOfItsSuction) {
  for (const double ratio : {1.0, 3.0}) {
    const auto ends = bridge_ends(1, ratio, 15 * degrees);
    const StableBranch branch = stable_branch(ends, BridgeControl::suction, 6.0);
    const double at = branch.rupture.sides[0].filling_angle;
    double widest = 0.0;
    for (int k = -20; k <= 20; ++k)
      widest = std::max(widest, test::integrate_meridian(ends, 6.0, at * (1.0 + 0.02 * k), 1e-3).gap);
    EXPECT_NEAR(branch.rupture.gap, widest, 1e-8);
  }
}

// Beyond the rupture at one suction a bridge closed off from its liquid still holds.
TEST(StableBridge, HoldsFartherAtOneVolumeThanAtOneSuction) {
  for (const double suction : {3.0, 100.0}) {
    const StableBranch open = stable_branch(bridge_ends(1, 1, 0), BridgeControl::suction, suction);
    const StableBranch closed = stable_branch(open.ends, BridgeControl::volume, open.rupture.volume);
    EXPECT_GT(closed.rupture.gap, 1.05 * open.rupture.gap);
    EXPECT_NEAR(bridge_on(closed, open.rupture.gap)->suction, suction, 1e-3 * suction);
  }
}

// Rupture of small bridges as printed by Willett et al. (2000, Langmuir 16, 9396, equation 20):
// (1 + theta/2) (V^(1/3) + V^(2/3) / 10) for equal spheres of radius 1, a fit good to 1 % without contact angle.
TEST(StableBridge, RupturesWhereThePrintedFitSays) {
  for (const double volume : {1e-4, 1e-3, 1e-2}) {
    const double reach = stable_branch(bridge_ends(1, 1, 0), BridgeControl::volume, volume).rupture.gap;
    EXPECT_NEAR(reach, std::cbrt(volume) + 0.1 * std::pow(volume, 2.0 / 3.0), 0.01 * reach);
  }
}

// Two equal spheres that the liquid wets poorly: the bridge slides to one of them before its gap is the widest one,
// where both circles on which the meniscus can meet a sphere are one (theory 8.2).
TEST(StableBridge, LosesItsSymmetryBeforeItsTurningPointWherePoorlyWetting) {
  const StableBranch branch = stable_branch(bridge_ends(1, 1, 40 * degrees), BridgeControl::volume, 0.01);
  EXPECT_NEAR(branch.rupture.pull, greatest_pull(branch.ends[0], branch.rupture.suction), 1e-6);
  // On the lopsided branch that meets it there the gap is smaller, and at equal gaps the energy higher.
  const auto lopsided = [&](double pull) {
    double low = least_suction(branch.ends[0], pull), high = low + 1.0;
    for (int k = 0; k < 80; ++k) {
      const double middle = 0.5 * (low + high);
      (bridge_shape(branch.ends, middle, pull, 1)->volume < branch.amount ? low : high) = middle;
    }
    return *bridge_shape(branch.ends, low, pull, 1);
  };
  for (const double share : {0.99, 0.95, 0.8}) {
    const BridgeShape shape = lopsided(share * branch.rupture.pull);
    EXPECT_NEAR(shape.volume, branch.amount, 1e-12);
    EXPECT_LT(shape.gap, branch.rupture.gap);
    EXPECT_GT(surface_energy(branch.ends, shape), surface_energy(branch.ends, *bridge_on(branch, shape.gap)));
  }
  // The least difference of the radii turns the corner into a smooth fold, a little earlier.
  const double unlike = stable_branch(bridge_ends(0.999, 1.001, 40 * degrees), BridgeControl::volume, 0.01).rupture.gap;
  EXPECT_LT(unlike, branch.rupture.gap);
  EXPECT_NEAR(unlike, branch.rupture.gap, 0.01 * branch.rupture.gap);
}

TEST(StableBridge, OfLittleLiquidSlidesBeyondThirtyOneDegrees) {
  const auto slides = [](double angle, double volume) {
    const StableBranch branch = stable_branch(bridge_ends(1, 1, angle * degrees), BridgeControl::volume, volume);
    return std::abs(greatest_pull(branch.ends[0], branch.rupture.suction) / branch.rupture.pull - 1.0) < 1e-4;
  };
  EXPECT_FALSE(slides(30.5, 1e-6));
  EXPECT_TRUE(slides(31.5, 1e-6));
  EXPECT_FALSE(slides(26.0, 0.2));
  EXPECT_TRUE(slides(28.0, 0.2));
}

TEST(StableBridge, InContactWithLittleLiquidPullsWithTwoPiRGammaCosine) {
  for (const double angle : {0.0, 20 * degrees, 60 * degrees})
    for (const double ratio : {1.0, 4.0, plane}) {
      const auto ends = bridge_ends(1, ratio, angle);
      const double radius = reduced_radius(ends);
      EXPECT_NEAR(bridge_on(stable_branch(ends, BridgeControl::suction, 1e8), 0.0)->pull, radius * std::cos(angle),
                  4e-4 * radius);
      EXPECT_NEAR(bridge_on(stable_branch(ends, BridgeControl::volume, 1e-15), 0.0)->pull, radius * std::cos(angle),
                  4e-4 * radius);
    }
}

TEST(StableBridge, TendsToTheSmallBridge) {
  for (const auto control : {BridgeControl::suction, BridgeControl::volume}) {
    const double amount = control == BridgeControl::suction ? 1e8 : 1e-15;
    const StableBranch branch = stable_branch(bridge_ends(1, 2, 30 * degrees), control, amount);
    const SmallBridge small = small_bridge(branch.ends, control, amount);
    const double scale = small.zero_gap(0.0);
    for (const double share : {0.2, 0.5})
      EXPECT_NEAR(bridge_on(branch, share * scale)->pull / small.pull_at(share * scale), 1.0, 2e-3);
  }
}

TEST(StableBridge, ScalesWithTheUnitOfLength) {
  const double s = 1e-6;
  for (const StableBranch& branch : branches()) {
    auto ends = branch.ends;
    for (BridgeEnd& end : ends) end.radius *= s;
    const bool at_suction = branch.control == BridgeControl::suction;
    const StableBranch small = stable_branch(ends, branch.control, at_suction ? branch.amount / s : branch.amount * s * s * s);
    EXPECT_NEAR(small.rupture.gap / s, branch.rupture.gap, 1e-6 * branch.rupture.gap);
    EXPECT_NEAR(bridge_on(small, 0.4 * small.rupture.gap)->pull / s, bridge_on(branch, 0.4 * branch.rupture.gap)->pull, 1e-6);
  }
}

TEST(StableBridge, SaysWhatItCannotDo) {
  const auto message = [](const std::array<BridgeEnd, 2>& ends, double amount, BridgeControl control = BridgeControl::volume) {
    try {
      stable_branch(ends, control, amount);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message(bridge_ends(1, -1, 0), 1e-3), HasSubstr("radius -1 m must be positive"));
  EXPECT_THAT(message(bridge_ends(1, 1, 90 * degrees), 1e-3), HasSubstr("must lie in [0, 90)"));
  EXPECT_THAT(message(bridge_ends(plane, plane, 0), 1e-3), HasSubstr("must be a sphere"));
  EXPECT_THAT(message(bridge_ends(1, 1, 0), 0.0), HasSubstr("volume 0 must be positive"));
  EXPECT_THAT(message(bridge_ends(1, 1, 0), -2.0, BridgeControl::suction), HasSubstr("suction over surface tension -2"));
  EXPECT_THAT(message(bridge_ends(1, 1, 80 * degrees), 0.3), HasSubstr("too much"));
}

}  // namespace
}  // namespace puadem
