#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "puadem/coupling/run.hpp"

using namespace puadem;

namespace {

std::vector<RetentionRow> branch(const std::vector<RetentionRow>& rows, const char* name) {
  std::vector<RetentionRow> found;
  std::ranges::copy_if(rows, std::back_inserter(found), [&](const auto& r) { return r.branch == name; });
  return found;
}

}  // namespace

// Hysteresis as it must be: at one saturation the capillary pressure of imbibition lies below that of
// drainage, and secondary drainage between the two; the pressure step changes nothing.
TEST(RetentionLoop, OfPackedBeads) {
  Case c;
  c.seed = 5;
  c.materials = {Material{}};
  c.grains.material = c.materials[0].name;
  c.grains.count = 1000;
  c.grains.grading = {Grading::By::mass, {{0.6e-3, 0.6e-3, 0.35}, {0.85e-3, 0.85e-3, 0.35}, {1.0e-3, 1.4e-3, 0.30}}};
  CompactStage compact;
  compact.unbalanced = 5e-3;  // a packing near rest will do
  RetentionStage retention;
  retention.path = {100.0, 2000.0, 0.0, 2000.0};
  retention.step = 20.0;
  c.stages = {compact, retention};
  State state;
  run(c, state, {});

  const auto drainage = branch(state.retention, "drainage-1"), imbibition = branch(state.retention, "imbibition-1"),
             second = branch(state.retention, "drainage-2");
  const double low = imbibition.front().saturation + 0.05, high = imbibition.back().saturation - 0.05;
  ASSERT_GT(high, low);
  for (int k = 0; k <= 20; ++k) {
    const double s = low + (high - low) * k / 20;
    const auto down = capillary_pressure_at(drainage, s), up = capillary_pressure_at(imbibition, s),
               again = capillary_pressure_at(second, s);
    ASSERT_TRUE(down && up && again) << s;
    EXPECT_LT(*up, *again) << s;
    EXPECT_LT(*again, *down) << s;
  }
  EXPECT_GT(imbibition.back().trapped_nonwetting, 0.0);

  // The same packing in coarse steps: the same saturations to rounding.
  Case coarse = c;
  coarse.stages.erase(coarse.stages.begin());
  std::get<RetentionStage>(coarse.stages[0]).step = 380.0;
  State other;
  other.particles = state.particles;
  other.domain = state.domain;
  run(coarse, other, {});
  int common = 0;
  for (const RetentionRow& row : other.retention)
    for (const RetentionRow& fine : state.retention)
      if (fine.branch == row.branch && fine.capillary_pressure == row.capillary_pressure) {
        EXPECT_NEAR(fine.saturation, row.saturation, 1e-12);
        ++common;
      }
  EXPECT_GT(common, 10);
}
