#include "puadem/coupling/checked_network.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "puadem/base/error.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

State state_of(const Spheres& s) {
  State state;
  state.particles = make_particles(s.centre, s.radius, Material{});
  state.domain = s.domain;
  return state;
}

/// Messages of the network of a packing.
std::vector<std::string> messages_of(const Spheres& s) {
  std::vector<std::string> messages;
  Observer observer;
  observer.message = [&](std::string_view text) { messages.emplace_back(text); };
  checked_network(Case{}, state_of(s), observer);
  return messages;
}

}  // namespace

TEST(CheckedNetwork, SaysNothingOfASoundPacking) {
  EXPECT_THAT(messages_of(random_spheres(60, 2.0, {1, 1, 1}, {true, false, false}, 4)), ElementsAre());
  EXPECT_THAT(messages_of(simple_cubic(1e-3, 3)), ElementsAre());
}

TEST(CheckedNetwork, WarnsOfOverlapsByNameAndPlace) {
  Spheres s = simple_cubic(1e-3, 2);
  s.radius[0] *= 1.3;
  EXPECT_THAT(messages_of(s), ElementsAre(::testing::AllOf(HasSubstr("warning: overlaps of grains count twice and take"),
                                                           ::testing::ContainsRegex("grains 0 and [1-7] at .* m, 30 % of"))));
}

TEST(CheckedNetwork, NamesAPoreThatIsCutOffWithItsGrain) {
  // A grain that pokes through three walls: it fills the sections along the edges of the corner, but not the corner.
  Spheres s{{{0.8, 0.8, 0.8}, {0.378, 0.378, 0.378}}, {0.1, 0.45}, {{0, 0, 0}, {1, 1, 1}, {false, false, false}}};
  try {
    messages_of(s);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("the packing makes no sound network:"));
    EXPECT_THAT(e.what(), ::testing::ContainsRegex("pore [0-9]+ at .*the left wall and grain 1, .*cut off"));
  }
}
