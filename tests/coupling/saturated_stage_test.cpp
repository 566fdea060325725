// Stage "saturated-flow": consolidation and seepage of small packings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/coupling/wall_guard.hpp"

using namespace puadem;
using ::testing::AllOf;
using ::testing::HasSubstr;

namespace {

/// Dimensionless consolidation by small explicit steps: pressure at the nodes of a layer drained at depth 0.
std::vector<double> diffused(double time_factor, int nodes) {
  std::vector<double> p(to_size(nodes + 1), 1.0), next(p);
  p[0] = 0.0;
  const double h = 1.0 / nodes, most = 0.25 * h * h;
  const int steps = static_cast<int>(std::ceil(time_factor / most));
  for (int k = 0; k < steps; ++k) {
    for (std::size_t i = 1; i < p.size(); ++i) {
      const double beyond = i + 1 < p.size() ? p[i + 1] : p[i - 1];
      next[i] = p[i] + time_factor / steps / (h * h) * (p[i - 1] - 2.0 * p[i] + beyond);
    }
    next[0] = 0.0;
    p = next;
  }
  return p;
}

Case column() {
  Case c;
  c.seed = 3;
  c.domain.periodic = {true, true, false};
  c.domain.shape = {1, 1, 2};
  c.materials = {Material{.name = "glass", .density = 2500.0, .youngs_modulus = 1.5e8, .friction_angle = 0.4}};
  c.grains.count = 120;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::mass, {{0.8e-3, 1.2e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  c.fluids.wetting = {0.3, 950.0};
  CompactStage compact;
  compact.stress = 100e3;
  compact.friction_angle = 0.1;
  c.stages = {compact};
  c.output.history_rows = 40;
  return c;
}

SaturatedStage load() {
  SaturatedStage stage;
  stage.loaded = 5;
  stage.stress = 110e3;
  return stage;
}

}  // namespace

TEST(Consolidation, DegreeAndPressureAreThoseOfTheDiffusionEquation) {
  for (const double t : {0.02, 0.1, 0.5}) {
    const std::vector<double> p = diffused(t, 200);
    double left = 0.5 * p.back();
    for (std::size_t i = 1; i + 1 < p.size(); ++i) left += p[i];
    EXPECT_NEAR(terzaghi_degree(t), 1.0 - left / 200.0, 2e-4);
    for (const double depth : {0.1, 0.5, 1.0})
      EXPECT_NEAR(terzaghi_pressure(t, depth), p[to_size(static_cast<int>(std::lround(200 * depth)))], 2e-4);
  }
  EXPECT_EQ(terzaghi_degree(0.0), 0.0);
  EXPECT_EQ(terzaghi_pressure(0.0, 0.5), 1.0);
}

TEST(Consolidation, ShortTimesJoinTheSeries) {
  EXPECT_NEAR(terzaghi_degree(0.0099999), terzaghi_degree(0.0100001), 1e-5);
  EXPECT_NEAR(terzaghi_pressure(0.0099999, 0.2), terzaghi_pressure(0.0100001, 0.2), 1e-5);
}

TEST(SaturatedStage, ASmallColumnConsolidates) {
  Case c = column();
  SaturatedStage stage = load();
  stage.time_factor = 1.0;
  c.stages.emplace_back(stage);
  State state;
  const RunResults results = run(c, state, {});
  // A column of ten grains' height; the cases hold the finer bounds.
  EXPECT_LT(results.scalars.at("saturated-flow_degree_error"), 0.15);
  EXPECT_GT(results.scalars.at("saturated-flow_degree_end"), 0.85);
  EXPECT_LT(results.scalars.at("saturated-flow_ledger_error"), 1e-12);
  const SaturatedRecord& record = state.saturated_flows.back();
  // All of the load is on the fluid at first and on the grains at last; the porous plate carries it all along.
  double most = 0.0;
  for (const SaturatedRow& row : record.rows) most = std::max(most, row.pressure_largest);
  EXPECT_GT(most, 7e3);
  EXPECT_NEAR(record.rows.back().contact_stress_upper, 110e3, 300.0);
  EXPECT_GE(record.profiles.size(), 10u);
  EXPECT_TRUE(state.grains->external_force.empty()) << "the fluid's forces end with the stage";
}

TEST(SaturatedStage, TooLongAnIntervalIsRefusedWithTheLimit) {
  Case c = column();
  SaturatedStage stage = load();
  stage.duration = 1e-3;
  stage.coupling_interval = 1e-4;
  c.stages.emplace_back(stage);
  State state;
  EXPECT_THAT([&] { run(c, state, {}); }, ::testing::ThrowsMessage<InputError>(HasSubstr("the limit is")));
}

TEST(SaturatedStage, AClosedBoxUnderALoadedWallIsRefusedBeforeTheFirstStep) {
  Case c = column();
  SaturatedStage stage = load();
  stage.drained = {};
  stage.duration = 1e-3;
  c.stages.emplace_back(stage);
  State state;
  EXPECT_THAT([&] { run(c, state, {}); },
              ::testing::ThrowsMessage<InputError>(AllOf(HasSubstr("the top wall cannot move"), HasSubstr("drain a face"))));
  EXPECT_FALSE(state.saturated);
}

TEST(SaturatedStage, ARunThatStopsSaysWhereAndGoesOnFromItsLastSafePlace) {
  Case c = column();
  State state, safe;
  run(c, state, {});
  for (Wall& wall : state.grains->walls)
    if (wall.face == 5) wall.point.z += 5e-3;  // far above the grains
  state.grains->domain.upper.z += 5e-3;
  SaturatedStage stage = load();
  stage.duration = 1e-3;
  c.stages = {stage};
  RunResults results;
  Observer observer;
  observer.safe_place = [&](const State& at, const RunResults& so_far, bool) {
    safe = at;
    results = so_far;
  };
  std::string first, second;
  try {
    run(c, state, observer);
  } catch (const NumericalError& error) {
    first = error.what();
  }
  EXPECT_THAT(first, AllOf(HasSubstr("stage saturated-flow at "), HasSubstr("the top wall, which holds 1.1e+05 Pa, has outrun")));
  ASSERT_TRUE(safe.saturated);
  try {
    run(c, safe, {}, results);
  } catch (const NumericalError& error) {
    second = error.what();
  }
  EXPECT_EQ(first, second);
}

TEST(WallGuard, AWallThatHasOutrunTheGrainsStopsTheRunWithPlaceAndCause) {
  Case c = column();
  State state;
  run(c, state, {});
  GrainSystem& grains = *state.grains;
  EXPECT_NO_THROW(guard_walls(grains));
  for (Wall& wall : grains.walls)
    if (wall.face == 5) {
      wall.target = 1e3;
      wall.stiffness = 0.0;
    }
  EXPECT_NO_THROW(guard_walls(grains)) << "a wall that lost its last contact a moment ago is no fault";
  for (Wall& wall : grains.walls) wall.point += 0.01 * Vec3{0, 0, wall.face == 5 ? 1.0 : 0.0};
  EXPECT_THAT([&] { guard_walls(grains); },
              ::testing::ThrowsMessage<NumericalError>(HasSubstr("the top wall, which holds 1000 Pa")));
}
