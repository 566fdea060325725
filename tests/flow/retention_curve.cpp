#include "puadem/flow/retention_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/random.hpp"

namespace puadem {
namespace {

RetentionRow at(double pressure, double saturation) {
  RetentionRow row;
  row.capillary_pressure = pressure;
  row.saturation = saturation;
  return row;
}

std::vector<RetentionRow> sampled(const VanGenuchten& curve, double from, double to, int count) {
  std::vector<RetentionRow> rows;
  for (int k = 0; k < count; ++k) {
    const double pressure = from + (to - from) * k / (count - 1);
    rows.push_back(at(pressure, curve.saturation(pressure)));
  }
  return rows;
}

TEST(VanGenuchten, IsTheFormula) {
  const VanGenuchten curve{2e-3, 5.0, 0.1, 0.9, 0.0};
  EXPECT_NEAR(curve.saturation(600.0), 0.1 + 0.8 * std::pow(1.0 + std::pow(1.2, 5.0), -0.8), 1e-14);
  EXPECT_EQ(curve.saturation(0.0), 0.9);
  EXPECT_NEAR(curve.saturation(1e30), 0.1, 1e-14);
  EXPECT_NEAR((VanGenuchten{1e-3, 400.0, 0.0, 1.0, 0.0}.saturation(1e6)), 0.0, 1e-14);  // no overflow
}

TEST(FitVanGenuchten, FindsTheCurveItWasGiven) {
  for (const VanGenuchten& curve : {VanGenuchten{1.3e-3, 9.0, 0.08, 1.0, 0.0}, VanGenuchten{2.5e-3, 4.0, 0.1, 0.75, 0.0},
                                    VanGenuchten{1e-3, 2.0, 0.0, 1.0, 0.0}, VanGenuchten{1.1e-3, 25.0, 0.2, 0.95, 0.0}}) {
    const auto fit = fit_van_genuchten(sampled(curve, 0.0, 2500.0, 60));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->alpha, curve.alpha, 1e-6 * curve.alpha);
    EXPECT_NEAR(fit->n, curve.n, 1e-5 * curve.n);
    EXPECT_NEAR(fit->residual_saturation, curve.residual_saturation, 1e-6);
    EXPECT_NEAR(fit->maximal_saturation, curve.maximal_saturation, 1e-6);
    EXPECT_LT(fit->rms_error, 1e-8);
  }
}

TEST(FitVanGenuchten, DoesNotDependOnTheUnitOfPressure) {
  const VanGenuchten curve{1.3e-3, 7.0, 0.08, 1.0, 0.0};
  std::vector<RetentionRow> rows = sampled(curve, 0.0, 2500.0, 40);
  for (RetentionRow& row : rows) row.capillary_pressure *= 1e6;
  const auto fit = fit_van_genuchten(rows);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->alpha, 1.3e-9, 1e-14);
  EXPECT_NEAR(fit->n, 7.0, 1e-4);
}

TEST(FitVanGenuchten, IsBetterThanTheTruthOnNoisyRows) {
  const VanGenuchten curve{1.3e-3, 7.0, 0.08, 1.0, 0.0};
  std::vector<RetentionRow> rows = sampled(curve, 0.0, 2500.0, 60);
  Random random(7);
  double truth = 0.0;
  for (RetentionRow& row : rows) {
    const double noise = random.uniform(-0.02, 0.02);
    row.saturation += noise;
    truth += noise * noise / 60.0;
  }
  const auto fit = fit_van_genuchten(rows);
  ASSERT_TRUE(fit);
  EXPECT_LE(fit->rms_error, std::sqrt(truth));
  EXPECT_LE(fit->maximal_saturation, 1.0);
  EXPECT_GE(fit->residual_saturation, 0.0);
  EXPECT_NEAR(fit->alpha, curve.alpha, 0.03 * curve.alpha);
}

TEST(FitVanGenuchten, RefusesWhatHasNoCurve) {
  EXPECT_FALSE(fit_van_genuchten({}));
  EXPECT_FALSE(fit_van_genuchten(std::vector{at(0, 1), at(1, 0.8), at(2, 0.5), at(3, 0.2)}));
  EXPECT_FALSE(fit_van_genuchten(std::vector<RetentionRow>(9, at(100.0, 0.5))));
  EXPECT_FALSE(fit_van_genuchten(std::vector{at(0, 1), at(1, 1), at(2, 1), at(3, 1), at(4, 1)}));
  EXPECT_FALSE(fit_van_genuchten(std::vector{at(1, 1), at(1, 0.9), at(1, 0.8), at(1, 0.5), at(1, 0.2)}));
}

TEST(FitVanGenuchten, StaysFiniteOnAStep) {
  std::vector<RetentionRow> rows;
  for (int k = 0; k < 20; ++k) rows.push_back(at(100.0 * k, k < 10 ? 1.0 : 0.1));
  const auto fit = fit_van_genuchten(rows);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(std::isfinite(fit->n) && std::isfinite(fit->alpha));
  EXPECT_LT(fit->rms_error, 0.05);
}

TEST(LoopArea, IsThatOfAParallelogram) {
  const std::vector upper{at(2, 1.0), at(4, 0.6), at(6, 0.2)};
  const std::vector lower{at(5, 0.2), at(1, 1.0)};  // imbibition, the other way round
  EXPECT_NEAR(loop_area(upper, lower), 0.8, 1e-14);
}

TEST(LoopArea, TakesTheSaturationsBothCover) {
  const std::vector upper{at(3, 1.0), at(3, 0.1)};
  const std::vector lower{at(1, 0.3), at(1, 0.7)};
  EXPECT_NEAR(loop_area(upper, lower), 0.8, 1e-14);
  EXPECT_EQ(loop_area(upper, std::vector{at(1, 0.05), at(1, 0.02)}), 0.0);
  EXPECT_EQ(loop_area(upper, {}), 0.0);
  EXPECT_EQ(loop_area(upper, upper), 0.0);
}

TEST(CapillaryPressureAt, InterpolatesWithinTheBranch) {
  const std::vector branch{at(0, 1.0), at(100, 1.0), at(200, 0.8), at(300, 0.4), at(400, 0.4)};
  EXPECT_NEAR(*capillary_pressure_at(branch, 0.9), 150.0, 1e-10);
  EXPECT_NEAR(*capillary_pressure_at(branch, 0.5), 275.0, 1e-10);
  EXPECT_NEAR(*capillary_pressure_at(branch, 0.4), 300.0, 1e-10);
  EXPECT_FALSE(capillary_pressure_at(branch, 0.39));
  EXPECT_FALSE(capillary_pressure_at({}, 0.5));
}

}  // namespace
}  // namespace puadem
