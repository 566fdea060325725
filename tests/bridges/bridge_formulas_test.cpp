#include "puadem/bridges/bridge_formulas.hpp"

#include <gtest/gtest.h>

#include "puadem/bridges/stable_bridge.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using test::bridge_ends;
using test::degrees;

double exact_pull(const std::array<double, 2>& radius, double angle, double volume, double share_of_reach, double& gap) {
  const StableBranch branch = stable_branch(bridge_ends(radius[0], radius[1], angle), BridgeControl::volume, volume);
  gap = share_of_reach * branch.rupture.gap;
  return bridge_on(branch, gap)->pull;
}

// Willett et al. state their fit within some per cent; so do we over its range up to 0.6 of the rupture distance.
TEST(BridgeFormulas, WillettFitsTheExactForceOfEqualAndUnequalSpheres) {
  for (const double angle : {0.0, 20 * degrees, 40 * degrees})
    for (const double ratio : {1.0, 3.0})
      for (const double volume : {1e-4, 1e-3, 0.01, 0.05})
        for (const double share : {0.0, 0.1, 0.3, 0.6}) {
          const std::array<double, 2> radius{0.5 * (1.0 + 1.0 / ratio), 0.5 * (1.0 + ratio)};
          double gap = 0.0;
          const double pull = exact_pull(radius, angle, volume, share, gap);
          EXPECT_NEAR(willett_pull(radius, angle, volume, gap), pull, 0.04 * pull) << ratio << ' ' << volume << ' ' << share;
        }
}

TEST(BridgeFormulas, WillettAndLianGiveTheRuptureDistance) {
  for (const double volume : {1e-4, 1e-3, 0.01}) {
    for (const double ratio : {1.0, 2.0, 5.0}) {
      const std::array<double, 2> radius{0.5 * (1.0 + 1.0 / ratio), 0.5 * (1.0 + ratio)};
      for (const double angle : {0.0, 20 * degrees}) {
        const auto ends = bridge_ends(radius[0], radius[1], angle);
        const double reach = stable_branch(ends, BridgeControl::volume, volume).rupture.gap;
        EXPECT_NEAR(willett_reach(radius, angle, volume), reach, 0.05 * reach) << ratio << ' ' << volume;
      }
    }
    const double equal = stable_branch(bridge_ends(1, 1, 0), BridgeControl::volume, volume).rupture.gap;
    EXPECT_NEAR(lian_reach(0.0, volume), equal, 0.02 * equal);
  }
}

TEST(BridgeFormulas, SoulieIsNearForEqualWettingSpheres) {
  for (const double volume : {1e-3, 0.01, 0.05})
    for (const double share : {0.0, 0.3, 0.6}) {
      double gap = 0.0;
      const double pull = exact_pull({1, 1}, 0.0, volume, share, gap);
      EXPECT_NEAR(soulie_pull({1, 1}, 0.0, volume, gap), pull, 0.1 * pull) << volume << ' ' << share;
    }
}

// (-0.148 ln v - 0.96) theta^2: at one volume the contact angle does not matter.
TEST(BridgeFormulas, SoulieHasAVolumeAtWhichTheContactAngleDropsOut) {
  const double volume = std::exp(-0.96 / 0.148);
  EXPECT_NEAR(soulie_pull({1, 1}, 0.6, volume, 0.02), soulie_pull({1, 1}, 0.0, volume, 0.02), 1e-14);
  EXPECT_GT(soulie_pull({1, 1}, 0.6, 0.1 * volume, 0.0), soulie_pull({1, 1}, 0.0, 0.1 * volume, 0.0));
}

TEST(BridgeFormulas, ScaleAndDoNotHangOnTheOrderOfTheSpheres) {
  const double s = 1e-4, volume = 2e-3, gap = 0.03, angle = 0.3;
  for (const auto& pull : {willett_pull, soulie_pull}) {
    EXPECT_NEAR(pull({s, 3 * s}, angle, s * s * s * volume, s * gap) / s, pull({1, 3}, angle, volume, gap), 1e-12);
    EXPECT_EQ(pull({1, 3}, angle, volume, gap), pull({3, 1}, angle, volume, gap));
    EXPECT_EQ(pull({1, 3}, angle, volume, -gap), pull({1, 3}, angle, volume, 0.0));
  }
  EXPECT_NEAR(willett_reach({s, 3 * s}, angle, s * s * s * volume) / s, willett_reach({3, 1}, angle, volume), 1e-12);
}

}  // namespace
}  // namespace puadem
