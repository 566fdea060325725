// Where the energy goes, over long runs.
#include "puadem/dem/energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gas.hpp"
#include "triaxial.hpp"

namespace puadem::verification {
namespace {

TEST(TriaxialEnergy, InputIsStoredOrLostWithTheLinearLaw) {
  struct Drive {
    bool is_periodic, grains_follow_box;
  };
  for (const Drive& drive : {Drive{true, true}, Drive{false, true}, Drive{false, false}}) {
    const TriaxialBalance b = run_triaxial(
        {.is_periodic = drive.is_periodic, .grains_follow_box = drive.grains_follow_box, .count = 400, .axial_strain = 0.02});
    EXPECT_LT(std::abs(b.residual()), 1e-4) << drive.is_periodic << drive.grains_follow_box;
    EXPECT_GT(b.end.friction, 0.2 * b.end.input);
    EXPECT_GT(b.rows.back().deviator, 0.5 * b.rows.back().mean);
  }
}

// The shear springs of the incremental Mindlin law have no potential; what they take up is one term.
TEST(TriaxialEnergy, InputIsStoredOrTakenUpWithMindlin) {
  const TriaxialBalance b = run_triaxial({.law = ContactOptions::Law::hertz_mindlin, .count = 400, .axial_strain = 0.02});
  EXPECT_LT(std::abs(b.residual()), 5e-4);
  EXPECT_GT(b.end.shear_work, 0.2 * b.end.input);
}

// 160 steps a contact.
TEST(LongElasticGas, KeepsItsEnergyOverAHundredThousandSteps) {
  const GasRun run = run_gas({.grains_across = 10, .steps = 100000, .steps_per_contact = 160});
  EXPECT_LT(run.largest_error, 1e-4);
  EXPECT_GT(run.largest_stored, 0.01);
}

TEST(ElasticGas, ErrorFallsWithTheSquareOfTheTimeStep) {
  for (const auto law : {ContactOptions::Law::linear_spring, ContactOptions::Law::hertz_mindlin}) {
    const auto error = [&](int steps) {
      return run_gas({.law = law, .grains_across = 6, .steps = 100 * steps, .steps_per_contact = 1.0 * steps}).largest_error;
    };
    EXPECT_NEAR(std::log(error(20) / error(160)) / std::log(8.0), 2.0, 0.3);
  }
}

}  // namespace
}  // namespace puadem::verification
