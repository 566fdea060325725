// Grains and one fluid: what docs/validation.md, chapter 11, is written from.
#include "coupled.hpp"

#include <gtest/gtest.h>

namespace puadem::verification {
namespace {

TEST(CoupledForces, HoldTheirIdentities) {
  for (const Identity& i : force_identities()) EXPECT_LT(i.found, 1e-12) << i.what;
}

TEST(CoupledForces, TheBottomBearsTheWeightUnderWater) {
  const RestingBed bed = rest_in_water(100);
  EXPECT_LT(bed.unbalanced, 1e-5);
  EXPECT_LT(std::abs(bed.force / bed.weight - 1.0), 10.0 * bed.unbalanced);
}

TEST(CoupledEnergy, WhatFrozenForcesAddIsSmallAndFallsWithTheInterval) {
  const EnergyGain two = gain_of_energy(2), four = gain_of_energy(4), eight = gain_of_energy(8);
  EXPECT_GT(two.taken, 0.05) << "the fluid takes too little to test it";
  EXPECT_LT(eight.gained, 0.01);
  EXPECT_GT(two.gained, 0.0);
  EXPECT_NEAR(four.gained / two.gained, 2.0, 0.4);
  EXPECT_NEAR(eight.gained / four.gained, 2.0, 0.4);
}

TEST(CoupledTimeStep, IsTheGrainsOwnHoweverOftenANetworkIsMade) { EXPECT_EQ(time_step_change_by_remeshing(), 0.0); }

}  // namespace
}  // namespace puadem::verification
