// Energy over long runs.
#include "puadem/dem/energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem/support.hpp"
#include "puadem/dem/motion.hpp"
#include "triaxial.hpp"

namespace puadem::verification {
namespace {

TEST(TriaxialEnergy, InputIsStoredOrLostWithTheLinearLaw) {
  struct Drive {
    bool is_periodic, grains_follow_box;
  };
  for (const Drive& drive : {Drive{true, true}, Drive{false, true}, Drive{false, false}}) {
    const TriaxialBalance b =
        run_triaxial({.is_periodic = drive.is_periodic, .grains_follow_box = drive.grains_follow_box});
    printf("residual %g input %g kin %g normal %g shear %g friction %g damping %g steps %ld q/p %g\n", b.residual(), b.end.input, b.end.kinetic, b.end.normal, b.end.shear, b.end.friction, b.end.damping, b.steps, b.rows.back().deviator/b.rows.back().mean);
    EXPECT_LT(std::abs(b.residual()), 1e-4);
    EXPECT_GT(b.end.friction, 0.2 * b.end.input);
    EXPECT_GT(b.rows.back().deviator, 0.8 * b.rows.back().mean);
    EXPECT_NEAR(b.rows.back().stress.x, 100e3, 3e3);
  }
}

// The shear springs of the incremental Mindlin law have no potential; what they take up is one term.
TEST(TriaxialEnergy, InputIsStoredOrTakenUpWithMindlin) {
  const TriaxialBalance b = run_triaxial({.law = ContactOptions::Law::hertz_mindlin});
    printf("residual %g input %g kin %g normal %g shear %g friction %g damping %g steps %ld q/p %g\n", b.residual(), b.end.input, b.end.kinetic, b.end.normal, b.end.shear, b.end.shear_work, b.end.damping, b.steps, b.rows.back().deviator/b.rows.back().mean);
  EXPECT_LT(std::abs(b.residual()), 1e-4);
  EXPECT_GT(b.end.shear_work, 0.2 * b.end.input);
}

}  // namespace
}  // namespace puadem::verification
