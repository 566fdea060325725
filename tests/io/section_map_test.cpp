#include "puadem/io/section_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/random.hpp"

namespace puadem {
namespace {

/// Pores at random in a flat box with a few grains.
State flat_box() {
  State state;
  state.domain.lower = {1.0, -2.0, 0.5};
  state.domain.upper = {3.0, 1.0, 0.8};
  Random random(3);
  const auto place = [&] { return Vec3{random.uniform(1.0, 3.0), random.uniform(-2.0, 1.0), random.uniform(0.5, 0.8)}; };
  for (int i = 0; i < 60; ++i) {
    state.network.pore_centre.push_back(place());
    state.network.pore_radius.push_back(random.uniform(0.02, 0.3));
    state.network.pore_volume.push_back(1.0);
  }
  for (int k = 0; k < 5; ++k) {
    state.particles.position.push_back(place());
    state.particles.radius.push_back(0.2);
  }
  return state;
}

TEST(SectionMap, AgreesWithALookAtEveryPoreAndGrain) {
  const State state = flat_box();
  const SectionMap map = cut_section(state, 90);
  EXPECT_EQ(map.axis, 2);
  EXPECT_EQ(map.columns, 60);
  EXPECT_EQ(map.rows, 90);
  ASSERT_GT(map.planes, 1);
  ASSERT_EQ(size_of(map.pore), map.planes * 60 * 90);
  for (int k = 0; k < size_of(map.pore); ++k) {
    const int column = k % 60, row = k / 60 % 90, plane = k / (60 * 90);
    const Vec3 at{1.0 + (column + 0.5) * map.pixel, -2.0 + (row + 0.5) * map.pixel, 0.5 + (plane + 0.5) * 0.3 / map.planes};
    int wanted = 0;
    const auto power = [&](int i) {
      const double r = state.network.pore_radius[to_size(i)];
      return squared_norm(at - state.network.pore_centre[to_size(i)]) - r * r;
    };
    for (int i = 1; i < state.network.pores(); ++i)
      if (power(i) < power(wanted)) wanted = i;
    for (int g = 0; g < state.particles.size(); ++g)
      if (norm(at - state.particles.position[to_size(g)]) < 0.2) wanted = -1;
    ASSERT_EQ(map.pore[to_size(k)], wanted) << column << ", " << row << ", " << plane;
  }
}

TEST(SectionMap, AnUprightBoxIsCutOnceInItsMiddle) {
  State state = flat_box();
  state.domain.upper.z = 2.5;
  const SectionMap map = cut_section(state, 30);
  EXPECT_EQ(map.axis, 0);
  EXPECT_EQ(map.planes, 1);
  EXPECT_EQ(size_of(map.pore), map.columns * map.rows);
}

TEST(SectionMap, PictureIsBase64OfABytePerPixel) {
  SectionMap map;
  map.pore = {0, 1, -1, 0};  // bytes 254, 0, 255, 254
  EXPECT_EQ(section_picture(map, {1.0, 0.0}), "/gD//g==");
  map.pore = {1, 1};
  EXPECT_EQ(section_picture(map, {1.0, 0.0}), "AAA=");
  map.planes = 2;
  map.pore = {-1, 0, -1, -1, 1, 0};  // bytes 255, 127, 254
  EXPECT_EQ(section_picture(map, {1.0, 0.0}), "/3/+");
}

}  // namespace
}  // namespace puadem
