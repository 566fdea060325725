// What the rows of a loading stage say, against closed forms.
#include "puadem/coupling/loading_results.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace puadem;

namespace {

HistoryRow row_of(double axial, double lateral) {
  HistoryRow row;
  row.stress = {lateral, lateral, axial};
  row.mean = (axial + 2.0 * lateral) / 3.0;
  row.deviator = axial - lateral;
  return row;
}

}  // namespace

TEST(MobilisedFriction, IsThatOfMohrAndCoulomb) {
  const double angle = 0.6;  // sigma_1 / sigma_3 = (1 + sin) / (1 - sin)
  const double ratio = (1.0 + std::sin(angle)) / (1.0 - std::sin(angle));
  EXPECT_NEAR(mobilised_friction(row_of(ratio * 5e4, 5e4)), angle, 1e-12);
  EXPECT_NEAR(mobilised_friction(row_of(5e4, ratio * 5e4)), angle, 1e-12);
  EXPECT_EQ(mobilised_friction(row_of(5e4, 5e4)), 0.0);
  EXPECT_EQ(mobilised_friction(row_of(0.0, 0.0)), 0.0);
  // In compression q / p = 6 sin / (3 - sin).
  EXPECT_NEAR(row_of(ratio * 5e4, 5e4).stress_ratio(), 6.0 * std::sin(angle) / (3.0 - std::sin(angle)), 1e-12);
}

TEST(Dilatancy, IsTheSteepestFallOfTheVolume) {
  std::vector<HistoryRow> rows(201);
  for (int k = 0; k <= 200; ++k) {
    const double axial = 1e-3 * k;
    rows[to_size(k)].strain.z = axial;
    rows[to_size(k)].volumetric = 0.01 * std::cos(30.0 * axial);  // falls fastest, by 0.3, at a quarter turn
  }
  EXPECT_NEAR(largest_dilatancy(rows), 0.3, 1e-3);
  EXPECT_NEAR(std::sin(dilation_angle(0.5)), 0.2, 1e-12);
  EXPECT_EQ(dilation_angle(0.0), 0.0);
}

TEST(HeldStress, IsJudgedByItsMeanAndItsFluctuation) {
  LoadingLeg leg;
  leg.end = LoadingLeg::End::strain;
  leg.box.stress = {100.0, 100.0, std::nullopt};
  std::vector<HistoryRow> rows(2);
  rows[0].stress = {103.0, 100.0, 7.0};
  rows[1].stress = {99.0, 96.0, 9.0};
  EXPECT_NEAR(held_stress(leg, rows).error, 0.02, 1e-15);
  EXPECT_NEAR(held_stress(leg, rows).fluctuation, std::sqrt((9e-4 + 1e-4 + 16e-4) / 4.0), 1e-15);
  leg.end = LoadingLeg::End::rest;
  EXPECT_NEAR(held_stress(leg, rows).error, 0.04, 1e-15);
  leg.box.stress = {};
  leg.box.mean_stress = 50.0;
  rows[1].mean = 51.0;
  EXPECT_NEAR(held_stress(leg, rows).error, 0.02, 1e-15);
}

TEST(StageName, CountsStagesOfAKind) {
  Case c;
  c.stages = {CompactStage{}, TriaxialStage{}, IsotropicStage{}, TriaxialStage{}};
  EXPECT_EQ(stage_name(c, 0), "compact");
  EXPECT_EQ(stage_name(c, 1), "triaxial");
  EXPECT_EQ(stage_name(c, 3), "triaxial-2");
}

TEST(LoadingProgram, OfAnOedometerGoesUpAndDown) {
  LoadingScale scale{
      .diameter = 1e-3, .density = 2500.0, .youngs_modulus = 1e8, .size = {1e-2, 1e-2, 1e-2}, .stress = {1e5, 1e5, 1e5}};
  OedometerStage stage;
  stage.path = {4e5, 25e3, 5e4};
  const LoadingProgram p = loading_program(stage, {}, scale);
  ASSERT_EQ(p.legs.size(), 3u);
  // Quasi-static at the lowest stress: 5e-4 sqrt(25e3 / 2500) / 1e-3.
  const double rate = 5e-4 * std::sqrt(10.0) / 1e-3;
  EXPECT_NEAR(p.strain_rate, rate, 1e-12 * rate);
  EXPECT_EQ(p.legs[0].box.strain_rate.z, p.strain_rate);
  EXPECT_EQ(p.legs[1].box.strain_rate.z, -p.strain_rate);
  EXPECT_EQ(p.legs[2].box.strain_rate.z, p.strain_rate);
  EXPECT_EQ(p.legs[1].target, 25e3);
}
