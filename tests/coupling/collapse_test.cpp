// A packing that liquid bridges hold, wetted under a constant stress (theory 8.8).

#include <gtest/gtest.h>

#include "puadem/coupling/run.hpp"

using namespace puadem;

namespace {

/// A loose packing between six walls under `stress`, with bridges of 20 kPa of suction.
Case loose_bed(double stress) {
  Case c;
  c.seed = 3;
  c.materials = {Material{.name = "sand", .density = 2650.0, .youngs_modulus = 5e7, .friction_angle = 0.52}};
  c.contact.law = ContactOptions::Law::linear_spring;
  c.contact.rolling_stiffness = 1.0;
  c.contact.rolling_friction = 0.3;
  c.grains.count = 150;
  c.grains.material = "sand";
  c.grains.cloud = PackingSource::Cloud::clumped;
  c.grains.grading = {Grading::By::number, {{0.4e-3, 0.8e-3, 1.0}}};
  c.bridges.emplace();
  c.bridges->control = BridgeControl::suction;
  c.bridges->capillary_pressure = 20e3;
  CompactStage compact;
  compact.stress = stress / 10.0;
  compact.friction_angle = 0.52;
  IsotropicStage isotropic;
  isotropic.stress = stress;
  c.stages = {compact, isotropic};
  return c;
}

UnsaturatedStage wetting(double stress) {
  UnsaturatedStage stage;
  stage.start = UnsaturatedStage::Start::dry;
  stage.path = {20e3, 2e3, 0.0};
  stage.step = {18e3, 500.0};
  stage.loaded.fill(true);
  stage.stress = stress;
  return stage;
}

}  // namespace

TEST(Collapse, ContactsFluidsAndBridgesShareTheStress) {
  constexpr double stress = 300.0;
  Case c = loose_bed(stress);
  c.stages.emplace_back(wetting(stress));
  State state;
  run(c, state, {});
  const auto& rows = state.unsaturated_flows.back().rows;
  ASSERT_EQ(rows.size(), 6u);
  for (const UnsaturatedRow& r : rows) {
    SCOPED_TRACE(r.capillary_pressure);
    EXPECT_EQ(r.branch, "imbibition-1");
    // The walls carry what they are to carry; what acts on the grains, summed by itself, does too.
    EXPECT_NEAR(r.total_stress, stress, 0.01 * stress);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(r.contact_stress[axis] + r.fluid_stress[axis] + r.bridge_stress[axis], stress, 0.01 * stress);
    EXPECT_LT(std::abs(r.wetting_error), 1e-12);
    EXPECT_LT(std::abs(r.nonwetting_error), 1e-9);
    EXPECT_GE(r.saturation, r.bridge_saturation);
  }
  EXPECT_GT(rows.front().bridges, 60);
  EXPECT_LT(rows.front().saturation, 0.01);
  // Dry, the gas alone pushes the pores: all pull is that of the bridges.
  EXPECT_NEAR(norm(rows.front().fluid_stress), 0.0, 1e-9);
  EXPECT_LT(rows.front().bridge_stress.z, -0.1 * stress);
  EXPECT_EQ(rows.back().bridges, 0);
  EXPECT_NEAR(rows.back().saturation, 1.0, 1e-6);
  EXPECT_GT(rows.back().volume_strain, 0.001) << "without its bridges the packing is too loose to stand";
}

TEST(Collapse, WithoutBridgesTheWaterInCornersPulls) {
  constexpr double stress = 5e3;
  Case c = loose_bed(stress);
  c.bridges.reset();
  UnsaturatedStage stage = wetting(stress);
  stage.path = {20e3};
  stage.step = {1e3};
  c.stages.emplace_back(stage);
  State state;
  run(c, state, {});
  const UnsaturatedRow& r = state.unsaturated_flows.back().rows.front();
  EXPECT_EQ(r.bridges, 0);
  EXPECT_EQ(r.bridge_saturation, 0.0);
  EXPECT_LT(r.fluid_stress.z, 0.0);
  EXPECT_NEAR(r.contact_stress.z + r.fluid_stress.z, stress, 0.01 * stress);
}

TEST(Collapse, MoreSaturationIsLeftToThePoresTheSoonerTheyTakeBridgesIn) {
  constexpr double stress = 5e3;
  int bridges[2], n = 0;
  for (const double coalescence : {0.05, 0.5}) {
    Case c = loose_bed(stress);
    c.bridges->coalescence_saturation = coalescence;
    UnsaturatedStage stage = wetting(stress);
    stage.path = {20e3, 1e3};
    stage.step = {19e3};
    c.stages.emplace_back(stage);
    State state;
    run(c, state, {});
    bridges[n++] = state.unsaturated_flows.back().rows.back().bridges;
  }
  EXPECT_LT(bridges[0], bridges[1]);
}

TEST(Collapse, BridgesActByThemselvesAgainAfterTheStage) {
  constexpr double stress = 5e3;
  Case c = loose_bed(stress);
  UnsaturatedStage stage = wetting(stress);
  stage.path = {20e3};
  stage.step = {1e3};
  IsotropicStage isotropic;
  isotropic.stress = 2.0 * stress;
  c.stages.emplace_back(stage);
  c.stages.emplace_back(isotropic);
  State state;
  const RunResults results = run(c, state, {});
  EXPECT_FALSE(state.grains->bridges->rules.by_pores);
  EXPECT_GT(results.scalars.at("isotropic-2_bridges"), 0.0);
}
