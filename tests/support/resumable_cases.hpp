#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "puadem/coupling/run.hpp"

namespace puadem::testing {

/// A small case of each kind of stage that can be taken up again.
struct ResumableCase {
  std::string name;
  Case (*make)();
  int interval;  ///< of its safe places that are worth a copy
};

inline void PrintTo(const ResumableCase &c, std::ostream *out) { *out << c.name; }

inline Case grains_of(int count, Vec3 shape) {
  Case c;
  c.seed = 5;
  c.materials = {Material{}};
  c.contact.rolling_stiffness = 1.0;
  c.contact.rolling_friction = 0.1;
  c.grains.count = count;
  c.grains.material = c.materials[0].name;
  c.grains.grading = {Grading::By::number, {{0.24e-3, 0.36e-3, 1.0}}};
  c.domain.shape = shape;
  CompactStage compact;
  compact.unbalanced = 2e-2;
  c.stages = {compact};
  c.output.history_rows = 30;
  return c;
}

inline Case loading_case() {
  Case c = grains_of(200, {1, 1, 1});
  c.domain.periodic = {true, true, false};
  c.motion.gravity = {0, 0, -9.81};
  OedometerStage oedometer;
  oedometer.path = {20e3, 12e3};
  oedometer.strain_rate = 8.0;
  ShearStage shear;
  shear.normal_stress = 10e3;
  shear.strain = 0.02;
  shear.shear_rate = 20.0;
  c.stages.insert(c.stages.end(), {oedometer, shear});
  return c;
}

/// Liquid bridges that form and rupture, across periodic faces and at walls.
inline Case wet_case() {
  Case c = grains_of(200, {1, 1, 1});
  c.domain.periodic = {true, true, false};
  c.bridges.emplace().water_content = 0.005;
  StrainStage strain;
  strain.strain_rate = {5.0, 0.0, -20.0};
  strain.time = 4e-3;
  c.stages.emplace_back(strain);
  return c;
}

inline Case retention_case() {
  Case c = grains_of(250, {1, 1, 1});
  RetentionStage retention;
  retention.path = {1000.0, 4000.0, 0.0, 3000.0};
  retention.step = 500.0;
  c.stages.insert(c.stages.end(), {PermeabilityStage{}, retention});
  return c;
}

/// Steps of pressure to rest, with trapped water, and a rate of withdrawal behind them.
inline Case two_phase_case(GasKind gas, TwoPhaseScheme scheme, bool holds) {
  Case c = grains_of(350, {10, 10, 4});
  TwoPhaseStage steps;
  steps.path = {2000.0, 2750.0};
  steps.step = 750.0;
  if (holds) steps.hold = 0.01;
  steps.options.gas = gas;
  steps.options.scheme = scheme;
  steps.options.corner_films = gas == GasKind::connected;
  steps.record_jump = 0.98;
  TwoPhaseStage withdrawal;
  withdrawal.air = TwoPhaseStage::disc;
  withdrawal.disc_radius = 0.3e-3;
  withdrawal.water = {true, true, true, true, false, false};
  withdrawal.capillary_number = 1e-4;
  withdrawal.initial_air_fraction = 0.5;
  withdrawal.duration = 0.5;
  withdrawal.until_saturation = 0.93;
  withdrawal.options.gas = gas;
  withdrawal.options.scheme = scheme;
  c.output.fields_at.saturation = {0.97, 0.95};
  c.stages.insert(c.stages.end(), {steps, withdrawal});
  return c;
}

/// Two fluids and grains that move each other, there and back.
inline Case unsaturated_case() {
  Case c = grains_of(150, {1, 1, 1.5});
  c.domain.periodic = {true, true, false};
  UnsaturatedStage stage;
  stage.path = {0.0, 3000.0, 0.0};
  stage.step = {1000.0};
  stage.loaded[5] = true;
  stage.stress = 10e3;
  c.stages.emplace_back(stage);
  return c;
}

/// A packing that liquid bridges hold, wetted until pores take them in, and dried again.
inline Case wetting_case() {
  Case c = grains_of(150, {1, 1, 1});
  c.bridges = BridgeCase{};
  c.bridges->control = BridgeControl::suction;
  c.bridges->capillary_pressure = 20e3;
  IsotropicStage isotropic;
  isotropic.stress = 12e3;
  c.stages.emplace_back(isotropic);
  UnsaturatedStage stage;
  stage.start = UnsaturatedStage::Start::dry;
  stage.path = {20e3, 500.0, 3000.0};
  stage.step = {5e3, 1e3};
  stage.loaded.fill(true);
  stage.stress = 12e3;
  c.stages.emplace_back(stage);
  return c;
}

/// Grains and two fluids in time, some of them swelling.
inline Case swelling_case() {
  Case c = grains_of(120, {1, 1, 1.5});
  c.domain.periodic = {true, true, false};
  c.materials.push_back(Material{.name = "gel", .density = 1200.0, .swelling = SwellingLaw{5e-8, 3.0, 1e5}});
  c.grains.added = {{.diameter = 0.4e-3, .material = "gel", .count = 3, .at = {}}};
  UnsaturatedStage stage;
  stage.path = {500.0, 3000.0};
  stage.times = {0.0, 2e-3};
  stage.loaded[5] = true;
  stage.stress = 10e3;
  c.stages.emplace_back(stage);
  return c;
}

inline Case implicit_case() { return two_phase_case(GasKind::incompressible, TwoPhaseScheme::implicit, false); }
inline Case ideal_gas_case() { return two_phase_case(GasKind::ideal, TwoPhaseScheme::implicit, true); }
inline Case impes_case() { return two_phase_case(GasKind::connected, TwoPhaseScheme::impes, true); }

/// A loaded column with a pressure that rises beneath it: new networks on the way, and grains that are followed over periods.
inline Case saturated_case() {
  Case c = grains_of(100, {1, 1, 2});
  c.domain.periodic = {true, true, false};
  c.contact.law = ContactOptions::Law::linear_spring;
  c.fluids.wetting = {0.05, 950.0};
  SaturatedStage stage;
  stage.loaded = 5;
  stage.stress = 14e3;
  stage.inlet = 4;
  stage.inlet_pressure = {0.0, 3e3};
  stage.inlet_times = {0.0, 3e-4};
  stage.bulk_modulus = 1e8;
  stage.duration = 3e-4;
  stage.remesh_displacement = 2e-3;
  c.stages.emplace_back(stage);
  return c;
}

inline std::vector<ResumableCase> resumable_cases() {
  return {{"Loading", loading_case, 10},    {"Wet", wet_case, 5},
          {"Retention", retention_case, 3}, {"Implicit", implicit_case, 20},
          {"IdealGas", ideal_gas_case, 20}, {"Impes", impes_case, 20},
          {"Saturated", saturated_case, 5}, {"Unsaturated", unsaturated_case, 3},
          {"Wetting", wetting_case, 3},     {"Swelling", swelling_case, 5}};
}

struct Outcome {
  State state;
  RunResults results;
};

/// The same numbers everywhere: results, places, fluids, records.
inline void expect_same_run(const Outcome &a, const Outcome &b) {
  EXPECT_EQ(a.results.scalars, b.results.scalars);
  EXPECT_EQ(a.state.time, b.state.time);
  EXPECT_EQ(a.state.particles.position, b.state.particles.position);
  EXPECT_EQ(a.state.particles.velocity, b.state.particles.velocity);
  EXPECT_EQ(a.state.saturation, b.state.saturation);
  ASSERT_EQ(a.state.history.size(), b.state.history.size());
  for (std::size_t k = 0; k < a.state.history.size(); ++k) {
    EXPECT_EQ(a.state.history[k].step, b.state.history[k].step);
    EXPECT_EQ(a.state.history[k].stress, b.state.history[k].stress);
    EXPECT_EQ(a.state.history[k].energy_residual, b.state.history[k].energy_residual);
  }
  ASSERT_EQ(a.state.grains.has_value() && a.state.grains->bridges, b.state.grains.has_value() && b.state.grains->bridges);
  if (a.state.grains && a.state.grains->bridges) {
    const GrainBridges &one = *a.state.grains->bridges, &other = *b.state.grains->bridges;
    EXPECT_EQ(one.bridges.pairs.ends, other.bridges.pairs.ends);
    EXPECT_EQ(one.bridges.volume, other.bridges.volume);
    EXPECT_EQ(one.film, other.film);
    EXPECT_EQ(one.ruptured, other.ruptured);
    EXPECT_TRUE(one.model.table.control == BridgeControl::suction || one.ruptured > 0);
  }
  ASSERT_EQ(a.state.retention.size(), b.state.retention.size());
  for (std::size_t k = 0; k < a.state.retention.size(); ++k)
    EXPECT_EQ(a.state.retention[k].saturation, b.state.retention[k].saturation);
  ASSERT_EQ(a.state.flows.size(), b.state.flows.size());
  for (std::size_t k = 0; k < a.state.flows.size(); ++k) {
    const auto &one = a.state.flows[k].rows, &other = b.state.flows[k].rows;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t r = 0; r < one.size(); ++r) {
      EXPECT_EQ(one[r].time, other[r].time);
      EXPECT_EQ(one[r].saturation, other[r].saturation);
      EXPECT_EQ(one[r].meniscus_area, other[r].meniscus_area);
    }
    EXPECT_EQ(a.state.flows[k].jump.has_value(), b.state.flows[k].jump.has_value());
  }
  ASSERT_EQ(a.state.saturated_flows.size(), b.state.saturated_flows.size());
  for (std::size_t k = 0; k < a.state.saturated_flows.size(); ++k) {
    const auto &one = a.state.saturated_flows[k].rows, &other = b.state.saturated_flows[k].rows;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t r = 0; r < one.size(); ++r) {
      EXPECT_EQ(one[r].time, other[r].time);
      EXPECT_EQ(one[r].inlet_pressure, other[r].inlet_pressure);
      EXPECT_EQ(one[r].settlement, other[r].settlement);
      EXPECT_EQ(one[r].ledger_error, other[r].ledger_error);
    }
    EXPECT_EQ(a.state.saturated_flows[k].profiles.size(), b.state.saturated_flows[k].profiles.size());
  }
  ASSERT_EQ(a.state.saturated.has_value(), b.state.saturated.has_value());
  if (a.state.saturated) {
    EXPECT_EQ(a.state.saturated->pressure, b.state.saturated->pressure);
    EXPECT_EQ(a.state.saturated->pore_volume, b.state.saturated->pore_volume);
    EXPECT_EQ(a.state.saturated->remeshes, b.state.saturated->remeshes);
  }
  ASSERT_EQ(a.state.unsaturated_flows.size(), b.state.unsaturated_flows.size());
  for (std::size_t k = 0; k < a.state.unsaturated_flows.size(); ++k) {
    const auto &one = a.state.unsaturated_flows[k].rows, &other = b.state.unsaturated_flows[k].rows;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t r = 0; r < one.size(); ++r) {
      EXPECT_EQ(one[r].saturation, other[r].saturation);
      EXPECT_EQ(one[r].strain, other[r].strain);
      EXPECT_EQ(one[r].contact_stress, other[r].contact_stress);
      EXPECT_EQ(one[r].wetting_error, other[r].wetting_error);
    }
    const UnsaturatedRecord &left = a.state.unsaturated_flows[k], &right = b.state.unsaturated_flows[k];
    EXPECT_EQ(left.pore_density, right.pore_density);
    EXPECT_EQ(left.blocks, right.blocks);
    ASSERT_EQ(left.pore_space.size(), one.size());
    ASSERT_EQ(right.pore_space.size(), one.size());
    for (std::size_t r = 0; r < one.size(); ++r) {
      EXPECT_EQ(left.pore_space[r].porosity.part, right.pore_space[r].porosity.part);
      EXPECT_EQ(left.pore_space[r].throat_radius.mean, right.pore_space[r].throat_radius.mean);
    }
    ASSERT_EQ(left.local.size(), right.local.size());
    EXPECT_FALSE(left.local.empty());
    for (std::size_t r = 0; r < left.local.size(); ++r) {
      EXPECT_EQ(left.local[r].porosity, right.local[r].porosity);
      EXPECT_EQ(left.local[r].displacement, right.local[r].displacement);
    }
  }
  ASSERT_EQ(a.state.unsaturated.has_value(), b.state.unsaturated.has_value());
  if (a.state.unsaturated) {
    EXPECT_EQ(a.state.unsaturated->flow.wetting_volume, b.state.unsaturated->flow.wetting_volume);
    EXPECT_EQ(a.state.unsaturated->forces.grain, b.state.unsaturated->forces.grain);
  }
  ASSERT_EQ(a.state.flow.has_value(), b.state.flow.has_value());
  if (a.state.flow) {
    EXPECT_EQ(a.state.flow->wetting_volume, b.state.flow->wetting_volume);
    EXPECT_EQ(a.state.flow->wetting_pressure, b.state.flow->wetting_pressure);
    EXPECT_EQ(a.state.flow->nonwetting, b.state.flow->nonwetting);
    EXPECT_EQ(a.state.flow->time_step, b.state.flow->time_step);
  }
}

}  // namespace puadem::testing
