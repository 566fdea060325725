#include "puadem/dem/sphere_in_box.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"

namespace puadem {
namespace {

constexpr double whole = 4.0 / 3.0 * std::numbers::pi;
constexpr double far = 10.0;

Domain box(const Vec3& lower, const Vec3& upper) { return {lower, upper, {false, false, false}}; }

TEST(SphereInBox, WholeHalfQuarterAndEighth) {
  const Vec3 upper{far, far, far};
  EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({-far, -far, -far}, upper)), whole, 1e-14);
  EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({0, -far, -far}, upper)), whole / 2, 1e-14);
  EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({0, 0, -far}, upper)), whole / 4, 1e-14);
  EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({0, 0, 0}, upper)), whole / 8, 1e-14);
  EXPECT_EQ(sphere_volume_in_box({-1.5, 0, 0}, 1.0, box({0, -far, -far}, upper)), 0.0);
}

TEST(SphereInBox, CapsAndSlabsAreTheClosedForm) {
  const auto cap = [](double height) { return std::numbers::pi * height * height * (3.0 - height) / 3.0; };
  for (const double h : {-0.99, -0.5, 0.0, 0.3, 0.9, 0.999}) {
    EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({h, -far, -far}, {far, far, far})), cap(1.0 - h), 1e-14) << h;
    EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({-far, -far, -far}, {far, h, far})), cap(1.0 + h), 1e-14) << h;
  }
  EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({-far, -far, -0.2}, {far, far, 0.6})), whole - cap(0.8) - cap(0.4), 1e-14);
}

TEST(SphereInBox, InscribedBoxIsTheBox) {
  const double a = 1.0 / std::sqrt(3.0);
  EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box({-a, -a, -a}, {a, a, a})), 8 * a * a * a, 1e-13);
}

// Boxes that share faces share out the sphere, wherever the common point lies.
TEST(SphereInBox, EightBoxesAroundAPointShareOutTheSphere) {
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 p{random.uniform(-1.1, 1.1), random.uniform(-1.1, 1.1), random.uniform(-1.1, 1.1)};
    double sum = 0.0;
    for (int octant = 0; octant < 8; ++octant) {
      Vec3 low{-2, -2, -2}, high{2, 2, 2};
      for (int axis = 0; axis < 3; ++axis) ((octant >> axis & 1) != 0 ? low : high)[axis] = p[axis];
      const double part = sphere_volume_in_box({}, 1.0, box(low, high));
      EXPECT_GE(part, -1e-14);
      sum += part;
    }
    EXPECT_NEAR(sum, whole, 1e-13) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

// Chord by chord: trapezia over a fine grid, which know nothing of the closed form.
TEST(SphereInBox, MatchesChordsAddedUp) {
  const Vec3 low{-0.35, -0.6, -0.2}, high{0.7, 0.25, 2.0};
  constexpr int n = 1200;
  const double dx = (high.x - low.x) / n, dy = (high.y - low.y) / n;
  double volume = 0.0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = low.x + (i + 0.5) * dx, y = low.y + (j + 0.5) * dy, z2 = 1.0 - x * x - y * y;
      if (z2 <= 0.0) continue;
      const double z = std::sqrt(z2);
      volume += std::max(0.0, std::min(z, high.z) - std::max(-z, low.z)) * dx * dy;
    }
  EXPECT_NEAR(sphere_volume_in_box({}, 1.0, box(low, high)), volume, 1e-6);
}

TEST(SphereInBox, ScalesWithTheUnitOfLengthAndShift) {
  const Domain unit = box({-0.35, -0.6, -0.2}, {0.7, 0.25, 2.0});
  const double s = 1e-4;
  const Vec3 shift{3e-3, -2e-3, 1e-3};
  const Domain small = box(s * unit.lower + shift, s * unit.upper + shift);
  EXPECT_NEAR(sphere_volume_in_box(shift, s, small) / (s * s * s), sphere_volume_in_box({}, 1.0, unit), 1e-12);
}

TEST(SphereInBox, PeriodicFacesDoNotCut) {
  Domain b = box({0, 0, 0}, {4, 4, 4});
  b.periodic = {true, false, false};
  EXPECT_NEAR(sphere_volume_in_box({0.1, 2, 2}, 1.0, b), whole, 1e-14);
}

TEST(Porosity, OfASphereInItsCube) {
  const std::vector<Vec3> centre{{0.5, 0.5, 0.5}};
  const std::vector<double> radius{0.5};
  EXPECT_NEAR(porosity_of(centre, radius, box({0, 0, 0}, {1, 1, 1})), 1.0 - std::numbers::pi / 6.0, 1e-15);
}

TEST(Core, LiesInsideByTheMarginExceptAlongPeriodicAxes) {
  Domain b = box({0, 0, 0}, {4, 4, 4});
  b.periodic = {false, true, false};
  const Domain core = core_of(b, 0.5);
  EXPECT_EQ(core.lower, (Vec3{0.5, 0, 0.5}));
  EXPECT_EQ(core.upper, (Vec3{3.5, 4, 3.5}));
  EXPECT_THROW(core_of(b, 2.0), InputError);
}

}  // namespace
}  // namespace puadem
