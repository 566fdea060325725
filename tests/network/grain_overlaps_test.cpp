#include "puadem/network/grain_overlaps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using std::numbers::pi;

namespace {

GrainOverlaps overlaps_of(const Spheres& s) {
  return find_overlaps(triangulate(s.centre, s.radius, s.domain), s.centre, s.radius, s.domain);
}

/// Volume common to two spheres, from their two caps.
double two_caps(double r, double s, double distance) {
  const double to_plane = (distance * distance + r * r - s * s) / (2 * distance);
  const auto cap = [](double radius, double height) { return pi * height * height * (radius - height / 3); };
  return cap(r, r - to_plane) + cap(s, s - (distance - to_plane));
}

}  // namespace

TEST(GrainOverlaps, OfTwoGrainsAreTheirCaps) {
  const Spheres s{{{1.0, 2.0, 2.0}, {2.4, 2.0, 2.0}}, {1.0, 0.6}, {{0, 0, 0}, {4, 4, 4}, {false, false, false}}};
  const GrainOverlaps found = overlaps_of(s);
  EXPECT_NEAR(found.volume, two_caps(1.0, 0.6, 1.4), 1e-14);
  EXPECT_NEAR(found.deepest, 0.2 / 0.6, 1e-14);
  EXPECT_NEAR(norm(found.place - Vec3{1.9, 2.0, 2.0}), 0.0, 1e-14);
  EXPECT_EQ(deepest_in_words(found), "the deepest is that of grains 0 and 1 at (1.9, 2, 2) m, 33 % of the smaller radius");
}

TEST(GrainOverlaps, AreNoneInAPackingThatTouches) {
  const GrainOverlaps found = overlaps_of(random_spheres(50, 3.0, {1, 1, 1}, {true, false, true}, 3));
  EXPECT_EQ(found.volume, 0.0);
  EXPECT_EQ(found.first, -1);
}

TEST(GrainOverlaps, CountEachPairOnceImagesIncluded) {
  for (const std::array<bool, 3>& periodic : {std::array{true, true, true}, {true, false, false}, {false, false, false}}) {
    Spheres s = random_spheres(80, 2.0, {1, 1, 1}, periodic, 6, 0.3);
    for (double& r : s.radius) r *= 1.2;
    double volume = 0.0, deepest = 0.0;
    for (std::size_t i = 0; i < s.centre.size(); ++i)
      for (std::size_t j = i + 1; j < s.centre.size(); ++j) {
        Vec3 way = s.centre[j] - s.centre[i];
        for (int a = 0; a < 3; ++a)
          if (periodic[to_size(a)]) way[a] -= std::nearbyint(way[a]);
        const double depth = s.radius[i] + s.radius[j] - norm(way);
        if (depth <= 0.0) continue;
        volume += two_caps(s.radius[i], s.radius[j], norm(way));
        deepest = std::max(deepest, depth / std::min(s.radius[i], s.radius[j]));
      }
    const GrainOverlaps found = overlaps_of(s);
    EXPECT_GT(volume, 0.0);
    EXPECT_NEAR(found.volume, volume, 1e-12);
    EXPECT_NEAR(found.deepest, deepest, 1e-12);
  }
}

TEST(GrainOverlaps, AreNamedWhereNoVoidIsLeft) {
  Spheres s = simple_cubic(1.0, 3);
  for (double& r : s.radius) r *= 1.3;
  s.radius[13] = 1.35;
  try {
    build_pore_network(s.centre, s.radius, s.domain, {});
    FAIL();
  } catch (const NumericalError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("no void is left"));
    EXPECT_THAT(e.what(), ::testing::ContainsRegex("grains [0-9]+ and 13 at|grains 13 and [0-9]+ at"));
  }
}
