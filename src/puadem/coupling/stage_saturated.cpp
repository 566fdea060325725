#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/consolidation.hpp"
#include "puadem/coupling/loose_grains.hpp"
#include "puadem/coupling/ready_grains.hpp"
#include "puadem/coupling/saturated_results.hpp"
#include "puadem/coupling/stages.hpp"
#include "puadem/coupling/wall_servo.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/time_step.hpp"
#include "puadem/flow/flow_boundary.hpp"

namespace puadem {

namespace {

constexpr long check_interval = 50;  // coupled steps between two looks at the time step
constexpr double profiles_a_stage = 10;

/// A stage under way.
struct Coupled {
  const Case& c;
  const SaturatedStage& stage;
  State& state;
  const Observer& observer;
  RunResults& results;
  GrainSystem& grains;
  SaturatedRecord& record;
  SaturatedProgress& at;
  SaturatedOptions options{};
  SaturatedCache cache{};
  Schedule inlet{};

  SaturatedState& fluid() { return *state.saturated; }
  double time() const { return state.time - at.began; }
};

/// Conditions at the faces after a time of the stage.
void set_faces(Coupled& k, double time) {
  for (int face = 0; face < 6; ++face)
    if (k.stage.drained[to_size(face)]) k.options.faces[to_size(face)] = {FaceCondition::Kind::pressure, 0.0};
  if (k.stage.inlet) k.options.faces[to_size(*k.stage.inlet)] = {FaceCondition::Kind::pressure, k.inlet.at(time)};
}

Schedule inlet_of(const SaturatedStage& stage) {
  if (!stage.inlet) return {};
  return stage.inlet_times.empty() ? Schedule::constant(stage.inlet_pressure.front())
                                   : Schedule{stage.inlet_times, stage.inlet_pressure};
}

SaturatedOptions options_of(const Case& c, const SaturatedStage& stage, double mean_radius) {
  SaturatedOptions options;
  options.viscosity = c.fluids.wetting.viscosity;
  options.density = c.fluids.wetting.density;
  options.bulk_modulus = stage.bulk_modulus;
  options.remesh_displacement = stage.remesh_displacement * mean_radius;
  options.network = c.pores;
  options.network.contact_angle = c.fluids.contact_angle;
  options.network.merge_criterion = MergeCriterion::entry_ratio;
  options.network.merge_ratio = std::numeric_limits<double>::infinity();
  options.limits = c.pores.conductance_limits;
  return options;
}

void keep_in_step(Coupled& k) {
  collect(k.grains, k.state.particles);
  k.state.domain = k.grains.domain;
}

void write_profile(Coupled& k) {
  std::vector<double> theory(k.fluid().pressure.size(), 0.0);
  const SaturatedRow& row = k.record.rows.back();
  const int axis = k.record.axis;
  if (k.record.reference)
    for (std::size_t p = 0; p < theory.size(); ++p) {
      const double below = std::abs(k.state.network.pore_centre[p][axis] - k.state.domain.face_position(*k.stage.loaded));
      theory[p] = k.record.reference->load *
                  terzaghi_pressure(*row.time_factor, std::min(below / k.record.reference->drainage_length, 1.0));
    }
  PressureProfile& profile = k.record.profiles.emplace_back();
  profile.time = k.time();
  profile.time_factor = row.time_factor;
  profile.layers = pressure_layers(k.state.network, k.state.domain, axis, k.stage.layers, k.fluid().pressure, theory);
  if (k.observer.saturated_fields) k.observer.saturated_fields(k.state, k.record);
}

void write_row(Coupled& k, const GrainMeasures& m) {
  HistoryRow history = history_row(k.grains, m, k.at.start, k.state.time);
  history.fraction = k.time() / k.at.duration;
  history.stage = k.record.stage;
  complete_row(k.grains, k.at.start, history);
  keep_in_step(k);
  k.state.history.push_back(history);
  if (k.observer.history) k.observer.history(k.state, history);

  SaturatedRow row = saturated_row(k.state.network, k.fluid(), k.grains, m, k.record, k.at.height);
  row.time = k.time();
  row.porosity = history.porosity;
  if (k.stage.inlet) {
    row.inlet_pressure = k.options.faces[to_size(*k.stage.inlet)].value;
    const double weight = k.options.density * norm(k.c.motion.gravity);
    row.gradient = weight > 0.0 ? row.inlet_pressure / (weight * k.grains.domain.size()[k.record.axis]) : 0.0;
  }
  if (k.record.reference) set_degrees(*k.record.reference, row);
  k.record.rows.push_back(row);
  if (k.observer.saturated) k.observer.saturated(k.state, k.record.rows.back());
  if (k.time() / k.at.duration * profiles_a_stage >= k.at.profiles) {
    write_profile(k);
    k.at.profiles = static_cast<int>(k.time() / k.at.duration * profiles_a_stage) + 1;
  }
}

void tell_progress(Coupled& k, const GrainMeasures& m) {
  Progress progress;
  progress.stage = SaturatedStage::kind;
  progress.fraction = k.time() / k.at.duration;
  progress.step = k.grains.steps;
  progress.time = k.state.time;
  progress.unbalanced = m.unbalanced;
  progress.stress = m.mean_stress;
  progress.porosity = 1.0 - k.at.start.solid_volume / k.grains.domain.volume();
  keep_in_step(k);
  tell_at_safe_place(k.observer, progress, k.state, k.results);
}

/// Steps of the grains over which the fluid's forces stay frozen.
long substeps(const Coupled& k) {
  const double time = std::min(k.at.interval, k.at.duration - k.time());
  return std::max(1L, static_cast<long>(time / k.grains.time_step * (1.0 + 1e-9)));
}

void run_steps(Coupled& k) {
  for (;; ++k.at.step) {
    evaluate_forces(k.grains);
    const bool ends = k.time() >= k.at.duration * (1.0 - 1e-12);
    const bool is_row = ends || k.time() / k.at.duration * k.c.output.history_rows >= k.at.rows;
    const bool is_check = k.at.step % check_interval == 0;
    if (is_row || is_check) {
      const GrainMeasures m = measure(k.grains);
      const bool is_written = !k.record.rows.empty() && k.record.rows.back().step == k.fluid().steps;  // by a run now taken up
      if (is_row && !is_written) write_row(k, m);
      if (is_row) k.at.rows = static_cast<int>(k.time() / k.at.duration * k.c.output.history_rows) + 1;
      tell_progress(k, m);
    }
    if (ends) return;
    if (is_check) renew_time_step(k.grains, k.at.longest_step);
    const long n = substeps(k);
    const double end = k.time() + static_cast<double>(n) * k.grains.time_step;
    set_faces(k, end);
    if (end >= k.at.duration * (1.0 - 1e-12))
      k.options.remesh_displacement = -1.0;  // the stage leaves a network of the last places
    saturated_step(k.options, n, k.grains, k.state.particles, k.state.network, k.fluid(), k.cache);
    if (k.stage.stress) correct_servo(*k.stage.stress, n, k.grains);
    k.state.domain = k.grains.domain;
    k.state.time += static_cast<double>(n) * k.grains.time_step;
  }
}

/// Duration from the time factor; how long the forces may be frozen.
void set_times(Coupled& k) {
  if (k.stage.time_factor) {
    const int face = *k.stage.loaded;
    const bool both = k.stage.drained[to_size(opposite(face))];
    k.record.reference =
        measure_consolidation(k.grains, k.state.network, face, both ? 0.5 * k.at.height : k.at.height, k.options.viscosity);
    const ConsolidationReference& r = *k.record.reference;
    k.at.duration = *k.stage.time_factor * r.drainage_length * r.drainage_length / r.coefficient;
  } else {
    k.at.duration = *k.stage.duration;
  }
  k.record.coupling_limit = coupling_limit(k.options, k.state.network, k.state.particles, k.grains.domain, k.cache);
  k.at.interval = k.stage.coupling_interval.value_or(
      std::min(k.stage.coupling_safety * k.record.coupling_limit, k.at.duration / k.c.output.history_rows));
  require_below_limit(k.record.stage, k.at.interval, k.record.coupling_limit);
  k.at.longest_step = std::min(k.at.longest_step, k.at.interval);
  k.record.coupling_interval = k.at.interval;
}

/// The wall is at the mercy of a fluid that cannot yield.
void require_yield(const SaturatedStage& stage, std::string_view name) {
  const bool is_open = stage.inlet || std::ranges::any_of(stage.drained, [](bool drained) { return drained; });
  require(
      !stage.loaded || is_open || stage.bulk_modulus,
      "stage {}: no fluid can leave the box, and it does not yield: the {} wall cannot move to hold its stress; drain a face or "
      "give the fluid a bulk modulus",
      name, face_names[to_size(stage.loaded.value_or(0))]);
}

SaturatedRecord& begin_record(const SaturatedStage& stage, State& state, const std::string& name) {
  SaturatedRecord& record = state.saturated_flows.emplace_back();
  record.stage = name;
  record.axis = stage.loaded ? axis_of(*stage.loaded) : stage.inlet ? axis_of(*stage.inlet) : 2;
  return record;
}

/// Grains, network and fluid at the start.
void begin(const Case& c, int index, State& state, const Observer& observer, RunResults& results) {
  const auto& stage = std::get<SaturatedStage>(c.stages[to_size(index)]);
  require_yield(stage, stage_name(c, index));
  GrainSystem& grains = ready_grains(c, state, observer);
  grains.motion.strain_with_box = false;
  if (stage.seat_loose_grains) {
    const int loose = seat_loose_grains(outward_normal(*stage.seat_loose_grains), grains);
    if (observer.message)
      observer.message(fmt::format("stage {}: {} loose grains of {} laid against their neighbours", stage_name(c, index), loose,
                                   grains.owned));
  }
  collect(grains, state.particles);
  state.domain = grains.domain;
  const GrainMeasures m = measure(grains);
  const LoadingScale scale = loading_scale(c, grains, state.particles, m);
  SaturatedRecord& record = begin_record(stage, state, stage_name(c, index));
  state.network = checked_network(c, state, observer, false);
  auto& at = state.position.progress.emplace<SaturatedProgress>();
  at.diameter = scale.diameter;
  at.height = scale.size[record.axis];
  at.began = state.time;
  Coupled k{c, stage, state, observer, results, grains, record, at, options_of(c, stage, 0.5 * at.diameter)};
  k.inlet = inlet_of(stage);
  set_faces(k, 0.0);
  grains.motion.damping = stage.damping;
  if (stage.loaded) hold_stress(*stage.loaded, *stage.stress, scale, grains);
  state.saturated = start_saturated(k.options, state.network, state.particles, grains, k.cache);
  at.longest_step = grains.motion.safety * critical_time_step_at(grains, std::max(stage.stress.value_or(0.0), m.mean_stress));
  grains.time_step = 0.0;
  renew_time_step(grains, at.longest_step);
  set_times(k);
  renew_time_step(grains, at.longest_step);
  at.start = begin_history(grains);
}

}  // namespace

void run_saturated_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results) {
  if (!has_begun(state)) begin(c, index, state, observer, results);
  const auto& stage = std::get<SaturatedStage>(c.stages[to_size(index)]);
  auto& at = std::get<SaturatedProgress>(state.position.progress);
  GrainSystem& grains = *state.grains;
  SaturatedRecord& record = state.saturated_flows.back();
  Coupled k{c, stage, state, observer, results, grains, record, at, options_of(c, stage, 0.5 * at.diameter)};
  k.inlet = inlet_of(stage);
  set_faces(k, k.time());
  renew_cache(k.options, state.network, state.particles.radius, state.saturated->place, k.cache);

  run_steps(k);
  grains.energy.is_kept = false;
  release_forces(grains);
  describe_saturated(c, stage, record, *state.saturated, grains, results);
  if (observer.message)
    observer.message(
        fmt::format("stage {}: {} coupled steps of at most {:.3g} s (limit {:.3g} s), grains' steps of {:.3g} s; {} "
                    "new networks, {} cells renewed",
                    record.stage, state.saturated->steps, at.interval, record.coupling_limit, grains.time_step,
                    state.saturated->remeshes, state.saturated->cells_renewed));
}

}  // namespace puadem
