#include "puadem/bridges/bridge_shape.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace puadem {
namespace {

using test::bridge_ends;
using test::degrees;

constexpr double pi = std::numbers::pi;

struct Sample {
  std::array<BridgeEnd, 2> ends;
  double suction, pull;
};

/// Necks, no neck between the ends, liquid under suction and under pressure, equal and unequal spheres and angles.
std::vector<Sample> samples() {
  return {{bridge_ends(1, 1, 0), 10, 0.6},
          {bridge_ends(1, 1, 0), -0.5, 0.3},
          {bridge_ends(0.6, 3, 0), 10, 0.6},
          {bridge_ends(0.6, 3, 20 * degrees), 2, 0.4},
          {bridge_ends(0.6, 8, 20 * degrees), -0.4, 0.2},
          {{BridgeEnd{1, 0.2}, BridgeEnd{2, 0.9}}, 5, 0.5},
          {{BridgeEnd{1, 50 * degrees}, BridgeEnd{1, 20 * degrees}}, -1, 0.35},
          {{BridgeEnd{0.55, 80 * degrees}, BridgeEnd{20, 65 * degrees}}, 1.0, 0.2},
          {bridge_ends(1, 1, 0), 200, 0.7}};
}

TEST(BridgeShape, SolvesTheYoungLaplaceEquation) {
  for (const auto& [ends, suction, pull] : samples()) {
    const auto shape = bridge_shape(ends, suction, pull);
    ASSERT_TRUE(shape);
    const auto exact = test::integrate_meridian(ends, suction, shape->sides[0].filling_angle,
                                                (shape->sides[0].arc + shape->sides[1].arc) / 500.5);
    EXPECT_NEAR(shape->gap, exact.gap, 1e-9 * shape->sides[0].contact_radius) << suction << ' ' << pull;
    EXPECT_NEAR(shape->volume, exact.volume, 1e-8 * exact.volume);
    EXPECT_NEAR(shape->sides[0].meniscus_area + shape->sides[1].meniscus_area, exact.meniscus_area, 1e-9 * exact.meniscus_area);
    EXPECT_NEAR(exact.pull[0], pull, 1e-12);
    EXPECT_NEAR(exact.pull[1], pull, 1e-9);
  }
}

TEST(BridgeShape, HasMenisciWithAndWithoutANeckAmongTheSamples) {
  int necks = 0, monotone = 0, under_pressure = 0;
  for (const auto& [ends, suction, pull] : samples()) {
    const auto shape = bridge_shape(ends, suction, pull);
    (std::min(shape->sides[0].arc, shape->sides[1].arc) > 0.0 ? necks : monotone) += 1;
    under_pressure += shape->suction < 0.0;
  }
  EXPECT_GE(necks, 3);
  EXPECT_GE(monotone, 1);
  EXPECT_GE(under_pressure, 2);
}

// y = a cosh(z / a) touches a sphere of radius 1 at the filling angle beta where a = sin(beta)^2.
TEST(BridgeShape, IsACatenoidWithoutSuction) {
  for (const double beta : {0.1, 0.4, 1.0}) {
    const double a = std::sin(beta) * std::sin(beta), z = a * std::acosh(1.0 / std::sin(beta));
    const double cap = pi / 3.0 * std::pow(1.0 - std::cos(beta), 2) * (2.0 + std::cos(beta));
    const auto shape = bridge_shape(bridge_ends(1, 1, 0), 0.0, a);
    ASSERT_TRUE(shape);
    EXPECT_NEAR(shape->gap, 2.0 * (z - 1.0 + std::cos(beta)), 1e-14);
    EXPECT_NEAR(shape->volume, pi * a * a * (z + 0.5 * a * std::sinh(2.0 * z / a)) - 2.0 * cap, 1e-13);
    EXPECT_NEAR(shape->sides[1].meniscus_area, pi * a * (z + 0.5 * a * std::sinh(2.0 * z / a)), 1e-13);
    EXPECT_NEAR(shape->sides[1].wetted_area, 2.0 * pi * (1.0 - std::cos(beta)), 1e-14);
    EXPECT_NEAR(shape->sides[1].filling_angle, beta, 1e-14);
    EXPECT_NEAR(shape->neck_radius, a, 1e-15);
    const auto nearly = bridge_shape(bridge_ends(1, 1, 0), 1e-12, a);
    EXPECT_NEAR(nearly->gap, shape->gap, 1e-11);
  }
}

TEST(BridgeShape, DoesNotHangOnTheOrderOfTheEnds) {
  for (auto [ends, suction, pull] : samples()) {
    const auto shape = bridge_shape(ends, suction, pull);
    std::swap(ends[0], ends[1]);
    const auto other = bridge_shape(ends, suction, pull);
    EXPECT_EQ(shape->gap, other->gap);
    EXPECT_EQ(shape->volume, other->volume);
    EXPECT_EQ(shape->sides[0].contact_radius, other->sides[1].contact_radius);
  }
}

TEST(BridgeShape, ScalesWithTheUnitOfLength) {
  const double s = 1e-5;
  for (auto [ends, suction, pull] : samples()) {
    const auto shape = bridge_shape(ends, suction, pull);
    for (BridgeEnd& end : ends) end.radius *= s;
    const auto small = bridge_shape(ends, suction / s, pull * s);
    EXPECT_NEAR(small->gap / s, shape->gap, 1e-13);
    EXPECT_NEAR(small->volume / (s * s * s), shape->volume, 1e-13 * shape->volume);
    EXPECT_NEAR(surface_energy(ends, *small) / (s * s), surface_energy({ends[0], ends[1]}, *shape),
                1e-13 * shape->volume + 1e-13);
  }
}

TEST(BridgeShape, TakesAPlaneAsTheLimitOfLargeSpheres) {
  for (const double angle : {0.0, 0.5}) {
    const auto plane = bridge_shape(bridge_ends(1, std::numeric_limits<double>::infinity(), angle), 8.0, 0.8);
    const auto large = bridge_shape(bridge_ends(1, 1e8, angle), 8.0, 0.8);
    EXPECT_NEAR(plane->gap, large->gap, 1e-7);
    EXPECT_NEAR(plane->volume, large->volume, 1e-7);
    EXPECT_EQ(plane->sides[1].filling_angle, 0.0);
    EXPECT_NEAR(plane->sides[1].wetted_area, pi * std::pow(plane->sides[1].contact_radius, 2), 1e-14);
  }
}

TEST(BridgeShape, MeetsAnEndOnTwoCirclesThatJoinAtTheGreatestPull) {
  const auto ends = bridge_ends(1, 1, 40 * degrees);
  for (const double suction : {-4.0, -2.0, -1.5}) {
    const double pull = greatest_pull(ends[0], suction);
    EXPECT_NEAR(least_suction(ends[0], pull), suction, 1e-13);
    EXPECT_FALSE(bridge_shape(ends, suction, pull * (1.0 + 1e-6)));
    const auto small = bridge_shape(ends, suction, 0.99 * pull), wide = bridge_shape(ends, suction, 0.99 * pull, 1);
    ASSERT_TRUE(small && wide);
    EXPECT_LT(small->sides[1].filling_angle, wide->sides[1].filling_angle - 0.03);
    for (const auto& shape : {small, wide}) {  // theory 8.1: both bear the pull at the contact angle
      const double beta = shape->sides[1].filling_angle, y = std::sin(beta);
      EXPECT_NEAR(y * std::sin(beta + 40 * degrees) + 0.5 * suction * y * y, 0.99 * pull, 1e-13);
    }
  }
}

TEST(BridgeShape, IsNoneWithoutANeckOrAMeniscus) {
  EXPECT_FALSE(bridge_shape(bridge_ends(1, 1, 0), -2.0, 0.3));              // 1 + 2 p f < 0
  EXPECT_FALSE(bridge_shape(bridge_ends(1, 1, 60 * degrees), -0.3, 0.49));  // both contact lines past the neck
}

}  // namespace
}  // namespace puadem
