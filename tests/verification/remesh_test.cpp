// Two fluids through new networks: what docs/validation.md, chapter 11, is written from, with fewer of them.
#include "remesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace puadem::verification {
namespace {

TEST(Remesh, BooksCloseWhileALayerIsSheared) {
  const ShearedLayer layer = shear_under_suction(100, 60);
  EXPECT_GT(layer.cells_renewed, 20) << "the motion is too small to test it";
  EXPECT_LT(layer.ledger, 1e-13);
  EXPECT_LT(layer.overfull, 1e-8);
}

TEST(Remesh, AtRestChangesNoBit) { EXPECT_EQ(bits_changed_at_rest(60, 50), 0); }

TEST(Remesh, KeepsAFrontWithinAPore) {
  const RemeshedFront front = front_through(300, 50, 0.02);
  EXPECT_GT(front.cells_renewed, 1000) << "the motion is too small to test it";
  EXPECT_LT(front.passed, 0.1);
  EXPECT_LT(front.farthest, 1.0);
}

TEST(Remesh, HowOftenLeavesSaturationAndStrainAlone) {
  const RemeshedDrainage each = drain_with_remeshes(150, 1, 7), tenth = drain_with_remeshes(150, 10, 7);
  EXPECT_GT(each.remeshes, 5 * tenth.remeshes);
  const double largest = *std::ranges::max_element(each.strain);
  for (std::size_t k = 0; k < each.strain.size(); ++k) {
    EXPECT_NEAR(each.saturation[k], tenth.saturation[k], 0.02);
    EXPECT_NEAR(each.strain[k], tenth.strain[k], 0.05 * largest);
  }
}

}  // namespace
}  // namespace puadem::verification
