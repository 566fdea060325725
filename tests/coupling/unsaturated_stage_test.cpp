// Stage "unsaturated-flow": small beds through a path of capillary pressures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/coupling/unsaturated_results.hpp"

using namespace puadem;
using ::testing::HasSubstr;

namespace {

Case bed(double friction_angle) {
  Case c;
  c.seed = 4;
  c.domain.periodic = {true, true, false};
  c.domain.shape = {1, 1, 2};
  c.materials = {Material{.name = "glass", .density = 2650.0, .youngs_modulus = 1.5e8, .friction_angle = 0.52}};
  c.grains.count = 200;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::number, {{0.26e-3, 0.54e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  CompactStage compact;
  compact.stress = 10e3;
  compact.friction_angle = friction_angle;
  c.stages = {compact};
  return c;
}

UnsaturatedStage drying() {
  UnsaturatedStage stage;
  stage.path = {0.0, 2200.0, 0.0};
  stage.step = {550.0};
  stage.loaded[5] = true;
  stage.stress = 10e3;
  return stage;
}

UnsaturatedRow row_of(double saturation, std::optional<double> chi, double pc_star = 0.0) {
  UnsaturatedRow row;
  row.saturation = saturation;
  row.chi_contact = chi;
  row.pc_star = pc_star;
  return row;
}

}  // namespace

TEST(UnsaturatedStage, GrainsCarryWhatTheFluidsDoNot) {
  for (const double friction : {0.0, 0.5}) {
    Case c = bed(friction);
    c.stages.emplace_back(drying());
    State state;
    const RunResults results = run(c, state, {});
    const auto& rows = state.unsaturated_flows.back().rows;
    ASSERT_EQ(rows.size(), 9u);
    for (const UnsaturatedRow& r : rows) {
      SCOPED_TRACE(r.capillary_pressure);
      // The plate carries what it is to carry, and contacts what the fluids leave: two independent sums.
      EXPECT_NEAR(r.total_stress, 10e3, 20.0);
      EXPECT_NEAR(r.contact_stress.z + r.fluid_stress.z, r.total_stress, 0.002 * r.total_stress);
      EXPECT_EQ(r.chi_contact.has_value(), r.capillary_pressure > 0.0);
      EXPECT_LT(std::abs(r.wetting_error), 1e-9);
      EXPECT_LT(std::abs(r.nonwetting_error), 1e-9);
      EXPECT_GE(r.saturation, 0.0);
      EXPECT_LE(r.saturation, 1.0 + 1e-9);
      EXPECT_NEAR(r.pc_star, r.capillary_pressure * 0.2e-3 / c.fluids.surface_tension, 1e-2);
    }
    // Full of water, the pores push with the water's pressure.
    EXPECT_NEAR(rows[1].saturation, 1.0, 0.06);
    EXPECT_LT(rows[4].saturation, 0.4);
    EXPECT_GT(rows[4].saturation, 0.005);
    EXPECT_GT(rows[1].mean_force_ratio, 1.0);
    EXPECT_TRUE(rows[1].chains_span[2]);
    EXPECT_TRUE(state.grains->external_force.empty()) << "the fluids' forces end with the stage";
    EXPECT_EQ(state.unsaturated_flows.back().spreads.size(), rows.size());
    for (const ForceSpread& spread : state.unsaturated_flows.back().spreads) {
      double sum = 0.0;
      for (const double d : spread.contact) sum += d * ForceSpread::width;
      EXPECT_NEAR(sum, 1.0, 1e-12);
    }
    EXPECT_LT(results.scalars.at("unsaturated-flow_chi_apart"), 0.05);
  }
}

TEST(UnsaturatedStage, FullOfWaterBishopsCoefficientIsOne) {
  Case c = bed(0.0);
  UnsaturatedStage stage = drying();
  stage.path = {0.0, 200.0};
  stage.step = {100.0};
  c.stages.emplace_back(stage);
  State state;
  run(c, state, {});
  for (const UnsaturatedRow& r : state.unsaturated_flows.back().rows) {
    EXPECT_NEAR(r.saturation, 1.0, 1e-9);
    EXPECT_NEAR(r.chi_fluid.value_or(1.0), 1.0, 1e-9);
  }
}

TEST(UnsaturatedStage, GrainsThatDoNotYieldGiveTheCurveOfGrainsThatStand) {
  Case c = bed(0.0);
  c.materials[0].youngs_modulus = 1.5e9;
  UnsaturatedStage stage = drying();
  stage.loaded = {};
  stage.stress.reset();
  stage.step = {275.0};
  State still;
  run(c, still, {});
  const PoreNetwork network = checked_network(c, still, {});
  FlowBoundary air, water;
  air.name = "top";
  air.fluid = FluidPhase::nonwetting;
  air.pores = face_pores(network, 5);
  air.initial_gas_fraction = stage.initial_air_fraction;
  water.name = "bottom";
  water.pores = face_pores(network, 4);
  air.schedule = water.schedule = Schedule::constant(0.0);
  TwoPhaseOptions options;
  options.gas = GasKind::connected;
  options.touching_first = true;
  TwoPhaseModel model =
      make_two_phase_model(network, c.fluids, options, {air, water},
                           throat_films(network, PackingSites(still.particles.position, still.particles.radius, still.domain),
                                        c.fluids.contact_angle));
  TwoPhaseState flow = start_two_phase(network, model);
  RestCriterion rest;
  rest.saturation_change = 1e-5;

  c.stages.emplace_back(stage);
  State state;
  run(c, state, {});
  for (const UnsaturatedRow& row : state.unsaturated_flows.back().rows) {
    SCOPED_TRACE(row.branch + " " + std::to_string(row.capillary_pressure));
    model.boundaries[1].schedule = Schedule::constant(-row.capillary_pressure);
    equilibrate_two_phase(network, model, rest, flow);
    EXPECT_NEAR(row.saturation, totals(network, model, flow).saturation, 0.02)
        << "but for grains without contacts, which move all the same";
    EXPECT_LT(std::abs(row.strain), 1e-12);
  }
}

TEST(UnsaturatedStage, ABoxIsStrainedUnderItsSuction) {
  Case c = bed(0.2);
  c.domain.periodic = {false, false, false};
  c.domain.shape = {1, 1, 2};
  c.grains.count = 250;
  c.output.history_rows = 10;
  double strength[2];
  for (const double suction : {0.0, 1500.0}) {
    Case test = c;
    UnsaturatedStage stage = drying();
    stage.path = {0.0, std::max(suction, 1.0)};
    stage.step = {500.0};
    stage.loaded = {true, true, true, true, true, true};
    stage.stress = 10e3;
    stage.strain = 0.02;
    stage.strain_rate = 5.0;
    stage.strain_step = 2e-3;
    test.stages.emplace_back(stage);
    State state;
    const RunResults results = run(test, state, {});
    const auto& rows = state.unsaturated_flows.back().rows;
    EXPECT_NEAR(rows.back().strain, 0.02, 1e-5);
    EXPECT_EQ(rows.back().branch, "strain");
    long strained = 0;
    for (const UnsaturatedRow& r : rows) {
      EXPECT_LT(std::abs(r.wetting_error), 1e-9);
      EXPECT_LT(std::abs(r.nonwetting_error), 1e-9);
      if (r.branch != "strain") continue;
      ++strained;
      // The side walls hold their stress.
      EXPECT_NEAR(r.contact_stress.x + r.fluid_stress.x, 10e3, 1.5e3);
    }
    EXPECT_EQ(strained, 11);
    strength[suction > 0.0] = results.scalars.at("unsaturated-flow_peak_q_Pa");
  }
  EXPECT_GT(strength[1], strength[0]) << "suction makes the packing stronger";
}

TEST(UnsaturatedStage, BranchesOfOneSaturationHaveNoFit) {
  std::vector<UnsaturatedRow> rows{row_of(0.5, 0.5), row_of(0.5, 0.4), row_of(0.5, 0.6)};
  EXPECT_FALSE(fit_chi(rows, &UnsaturatedRow::chi_contact));
  rows = {row_of(1.0, std::nullopt), row_of(1.0, 0.9), row_of(0.5, 0.55)};
  EXPECT_FALSE(fit_chi(rows, &UnsaturatedRow::chi_contact)) << "two points make a line, not a fit";
}

TEST(UnsaturatedStage, FitOfBishopsCoefficientIsTheStraightLine) {
  // On chi = 0.2 + 0.7 S but for +-0.01 in turn.
  std::vector<UnsaturatedRow> rows{row_of(0.7, std::nullopt)};
  for (const auto& [s, e] : {std::pair{0.0, 0.01}, {0.2, -0.01}, {0.8, -0.01}, {1.0, 0.01}})
    rows.push_back(row_of(s, 0.2 + 0.7 * s + e));
  const auto fit = fit_chi(rows, &UnsaturatedRow::chi_contact);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->rows, 4);
  EXPECT_NEAR(fit->slope, 0.7, 1e-12);
  EXPECT_NEAR(fit->offset, 0.2, 1e-12);
  EXPECT_NEAR(fit->residual, 0.01, 1e-12);
  EXPECT_NEAR(fit->from_saturation, std::sqrt((0.21 * 0.21 + 0.13 * 0.13 + 0.05 * 0.05 + 0.09 * 0.09) / 4.0), 1e-12);
}

TEST(UnsaturatedStage, RegimesAreWhereTheSteepestTangentMeetsTheEnds) {
  const std::vector<UnsaturatedRow> rows{row_of(1.0, {}, 0.0), row_of(1.0, {}, 3.0), row_of(0.9, {}, 3.5), row_of(0.4, {}, 4.0),
                                         row_of(0.1, {}, 5.0)};
  const auto regimes = drainage_regimes(rows);
  ASSERT_TRUE(regimes);
  EXPECT_NEAR(regimes->air_entry, 3.4, 1e-12);
  EXPECT_NEAR(regimes->pendular, 4.3, 1e-12);
}

TEST(UnsaturatedStage, TooFewRoundsSayWhatStillChanges) {
  Case c = bed(0.5);
  UnsaturatedStage stage = drying();
  stage.rounds = 2;
  stage.strain_change = 1e-12;
  stage.saturation_change = 1e-12;
  c.stages.emplace_back(stage);
  State state;
  EXPECT_THAT([&] { run(c, state, {}); },
              ::testing::ThrowsMessage<NumericalError>(HasSubstr("do not come to rest at a capillary")));
}
