#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "puadem/coupling/run.hpp"
#include "puadem/coupling/two_phase_results.hpp"
#include "puadem/dem/packing.hpp"
#include "puadem/flow/flow_numbers.hpp"

namespace puadem {
namespace {

/// A thin bed of few grains at rest, made once.
const State& thin_bed() {
  static const State bed = [] {
    Case c;
    c.seed = 5;
    c.materials = {Material{}};
    c.grains.count = 500;
    c.grains.material = c.materials[0].name;
    c.grains.grading = {Grading::By::number, {{0.24e-3, 0.36e-3, 1.0}}};
    c.domain.shape = {10, 10, 4};
    c.stages = {CompactStage{10e3, {}, {}, CompactStage::Region::core, 2e-2, 0.4}};
    State state;
    run(c, state, {});
    return state;
  }();
  return bed;
}

Case flow_case(const TwoPhaseStage& stage) {
  Case c;
  c.materials = {Material{}};
  c.grains.material = c.materials[0].name;
  c.stages = {stage};
  return c;
}

TwoPhaseStage from_the_middle() {
  TwoPhaseStage stage;
  stage.air = TwoPhaseStage::disc;
  stage.disc_radius = 0.3e-3;
  stage.water = {true, true, true, true, false, false};
  stage.duration = 0.5;
  return stage;
}

TwoPhaseStage from_the_top() {
  TwoPhaseStage stage;
  stage.path = {1500.0, 3500.0};
  stage.step = 1000.0;
  return stage;
}

TEST(TwoPhaseStage, FollowsAPathToRestAtEveryPressure) {
  State state = thin_bed();
  const RunResults results = run(flow_case(from_the_top()), state, {});
  ASSERT_EQ(state.flows.size(), 1u);
  const std::vector<FlowRow>& rows = state.flows[0].rows;
  EXPECT_EQ(state.flows[0].stage, "two-phase-flow");
  EXPECT_NEAR(rows.front().saturation, 1.0, 1e-12);
  EXPECT_EQ(rows.back().capillary_pressure, 3500.0);
  EXPECT_LT(rows.back().saturation, 0.6);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_GE(rows[k].time, rows[k - 1].time);
    EXPECT_LE(rows[k].saturation, rows[k - 1].saturation + 1e-9);  // primary drainage
  }
  EXPECT_LT(std::abs(results.ledger.wetting_error()), 1e-9);
  EXPECT_LT(std::abs(results.ledger.nonwetting_error()), 1e-9);
  EXPECT_EQ(results.scalars.at("two-phase-flow_saturation_end"), rows.back().saturation);
}

TEST(TwoPhaseStage, RefillsWithSnapOffAndWithIdealGas) {
  TwoPhaseStage stage = from_the_top();
  stage.path = {1500.0, 3500.0, 500.0};
  const auto last_row = [&](bool snap_off, GasKind gas, double reference_pressure) {
    stage.options.snap_off = snap_off;
    stage.options.gas = gas;
    stage.options.reference_pressure = reference_pressure;
    State state = thin_bed();
    const RunResults results = run(flow_case(stage), state, {});
    EXPECT_LT(std::abs(results.ledger.wetting_error()), 1e-9);
    EXPECT_LT(std::abs(results.ledger.nonwetting_error()), 1e-9);
    return state.flows[0].rows.back();
  };
  const FlowRow plain = last_row(false, GasKind::incompressible, 101325.0);
  const FlowRow snapped = last_row(true, GasKind::incompressible, 101325.0);
  EXPECT_GT(snapped.trapped_nonwetting, plain.trapped_nonwetting + 0.02);
  EXPECT_LT(snapped.saturation, plain.saturation);
  // Air that is cut off at some 2 kPa of suction comes to some 2 kPa more pressure: it shrinks by that over its own.
  const FlowRow thin_air = last_row(true, GasKind::ideal, 10000.0);
  EXPECT_LT(thin_air.trapped_nonwetting, 0.99 * snapped.trapped_nonwetting);
  EXPECT_GT(thin_air.trapped_nonwetting, 0.6 * snapped.trapped_nonwetting);
}

TEST(TwoPhaseStage, VolumesThroughTheBordersExplainTheSaturation) {
  State state = thin_bed();
  run(flow_case(from_the_top()), state, {});
  const std::vector<FlowRow>& rows = state.flows[0].rows;
  double void_volume = 0.0;
  for (int i = 0; i < state.network.pores(); ++i)
    if (!state.flow->wetting.reservoir[to_size(i)] && !state.flow->nonwetting.reservoir[to_size(i)])
      void_volume += state.network.pore_volume[to_size(i)];
  for (const FlowRow& row : rows) {
    EXPECT_NEAR((row.wetting_out - row.wetting_in) / void_volume, 1.0 - row.saturation, 1e-9);
    EXPECT_NEAR((row.nonwetting_in - row.nonwetting_out) / void_volume, 1.0 - row.saturation, 1e-9);
  }
  EXPECT_GT(rows.back().meniscus_area, 0.0);
  EXPECT_EQ(rows.front().nonwetting.pores, 0);
  EXPECT_GT(rows.back().nonwetting.pores, 10);
}

TEST(TwoPhaseStage, AGivenCapillaryNumberIsMeasuredAgain) {
  State state = thin_bed();
  TwoPhaseStage stage = from_the_middle();
  stage.capillary_number = 1e-3;
  stage.initial_air_fraction = 0.5;
  stage.until_saturation = 0.9;
  const RunResults results = run(flow_case(stage), state, {});
  EXPECT_NEAR(results.scalars.at("two-phase-flow_capillary_number"), 1e-3, 1e-8);
  EXPECT_LE(state.flows[0].rows.back().saturation, 0.9);
  EXPECT_GT(state.flows[0].rows.back().saturation, 0.5);
}

TEST(TwoPhaseStage, EndsAtBreakthroughAndTakesThePatternThere) {
  State state = thin_bed();
  TwoPhaseStage stage = from_the_middle();
  stage.water_pressure = {-6e3};
  stage.until_breakthrough = true;
  const RunResults results = run(flow_case(stage), state, {});
  const FlowRecord& record = state.flows[0];
  ASSERT_TRUE(record.breakthrough_time);
  EXPECT_EQ(*record.breakthrough_time, record.rows.back().time);
  EXPECT_EQ(*record.breakthrough_saturation, record.rows.back().saturation);
  ASSERT_TRUE(record.pattern);
  EXPECT_EQ(record.pattern->saturation, *record.breakthrough_saturation);
  EXPECT_GT(results.scalars.at("two-phase-flow_finger_width_m"), 0.0);
  const double breakthrough = results.scalars.at("two-phase-flow_breakthrough_pressure_Pa");
  EXPECT_GT(breakthrough, 1000.0);
  EXPECT_LT(breakthrough, 6000.0);
  EXPECT_GT(results.scalars.at("two-phase-flow_capillary_number_darcy"), 0.0);
}

TEST(TwoPhaseStage, BelowTheBreakthroughPressureAirStopsOnItsWay) {
  State state = thin_bed();
  TwoPhaseStage stage = from_the_middle();
  stage.water_pressure = {-6e3};
  stage.duration = 1e-9;
  const double breakthrough = run(flow_case(stage), state, {}).scalars.at("two-phase-flow_breakthrough_pressure_Pa");
  for (const double share : {0.98, 1.02}) {
    State again = thin_bed();
    TwoPhaseStage slow = from_the_middle();
    slow.path = {share * breakthrough};
    slow.duration.reset();
    run(flow_case(slow), again, {});
    EXPECT_EQ(again.flows[0].breakthrough_time.has_value(), share > 1.0) << share;
  }
}

TEST(TwoPhaseStage, TellsTheObserverOfPicturesAtTheSaturationsAskedFor) {
  State state = thin_bed();
  TwoPhaseStage stage = from_the_middle();
  stage.water_pressure = {-6e3};
  stage.until_saturation = 0.85;
  Case c = flow_case(stage);
  c.output.fields_at.saturation = {0.95, 0.9};
  std::vector<double> pictures;
  int rows = 0, events = 0;
  Observer observer;
  observer.flow_fields = [&](const State& s, const TwoPhaseModel&, double saturation) {
    pictures.push_back(saturation);
    EXPECT_EQ(size_of(s.saturation), s.network.pores());
  };
  observer.flow = [&](const State&, const TwoPhaseModel&, const FlowRow&) { ++rows; };
  observer.flow_event = [&](const State&, const TwoPhaseEvent&) { ++events; };
  run(c, state, observer);
  ASSERT_EQ(pictures.size(), 3u);  // and at the end
  EXPECT_NEAR(pictures[0], 0.95, 0.02);
  EXPECT_NEAR(pictures[1], 0.9, 0.02);
  EXPECT_LE(pictures[2], 0.85);
  EXPECT_EQ(rows, size_of(state.flows[0].rows));
  EXPECT_GT(events, 5);
}

TEST(TwoPhaseStage, RecordsAHainesJump) {
  State state = thin_bed();
  TwoPhaseStage stage = from_the_top();
  stage.record_jump = 0.95;
  run(flow_case(stage), state, {});
  ASSERT_TRUE(state.flows[0].jump);
  const HainesJump& jump = *state.flows[0].jump;
  EXPECT_NE(jump.invaded, jump.retracting);
  std::size_t first = 0;
  while (first < jump.time.size() && std::isnan(jump.invaded_pressure[first])) ++first;
  ASSERT_LT(first + 1, jump.time.size());
  EXPECT_GT(first, 0u);
  // The new bubble fills its pore as far as water leaves: it begins at the pressure of its body, below what the pore beside it
  // comes to, and catches up; the water that it pushes out lets the pore beside it fall back, although the bed drains.
  const auto after = std::ranges::subrange(jump.retracting_pressure.begin() + static_cast<std::ptrdiff_t>(first),
                                           jump.retracting_pressure.end());
  EXPECT_LT(jump.invaded_pressure[first], std::ranges::max(after));
  EXPECT_FALSE(std::ranges::is_sorted(after));
  EXPECT_GT(jump.invaded_pressure.back(), jump.invaded_pressure[first]);
  for (std::size_t k = 1; k < jump.time.size(); ++k) EXPECT_GT(jump.time[k], jump.time[k - 1]);
}

TEST(TwoPhaseStage, DoesNotDependOnThreadsOrOnWhatIsWatched) {
  TwoPhaseStage stage = from_the_middle();
  stage.water_pressure = {-6e3};
  stage.until_saturation = 0.9;
  State alone = thin_bed(), watched = thin_bed();
  set_threads(1);
  run(flow_case(stage), alone, {});
  set_threads(2);
  Case c = flow_case(stage);
  c.output.history_rows = 17;
  c.output.fields_at.saturation = {0.97, 0.93};
  run(c, watched, {});
  set_threads(0);
  EXPECT_EQ(alone.flow->wetting_volume, watched.flow->wetting_volume);
  EXPECT_EQ(alone.flow->time, watched.flow->time);
}

FlowRow row_at(double time, double wetting_out) {
  FlowRow row;
  row.time = time;
  row.wetting_out = wetting_out;
  return row;
}

TEST(FlowRecord, CapillaryNumberAtHalfOfTheDisplacedVolume) {
  // Slow, then fast: half of the volume is reached in the fast part, 4e-6 m3 in 1 s over 2e-4 m2.
  const std::vector<FlowRow> rows{row_at(0, 0), row_at(10, 1e-6), row_at(11, 5e-6), row_at(12, 9e-6), row_at(13, 10e-6)};
  const Fluids fluids;
  EXPECT_NEAR(capillary_number_at_half(rows, fluids, 2e-4), capillary_number(fluids, 4e-6 / 2e-4), 1e-15);
  EXPECT_EQ(capillary_number_at_half({rows[0], rows[1]}, fluids, 2e-4), 0.0);
}

TEST(FlowRecord, ThinBeds) {
  Domain d;
  d.upper = {10, 1, 8};
  EXPECT_TRUE(is_thin(d));
  d.upper = {10, 5, 8};
  EXPECT_FALSE(is_thin(d));
}

}  // namespace
}  // namespace puadem
