#include <algorithm>
#include <cmath>
#include <span>

#include "puadem/base/error.hpp"
#include "puadem/coupling/loading_program.hpp"
#include "puadem/coupling/loading_results.hpp"
#include "puadem/coupling/ready_grains.hpp"
#include "puadem/coupling/stages.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/time_step.hpp"
#include "puadem/dem/time_step_report.hpp"

namespace puadem {

namespace {

constexpr long check_interval = 50;      // steps between two looks at time step and progress
constexpr long rest_row_interval = 200;  // steps between two rows where nobody knows when a stage ends
constexpr long most_steps = 20'000'000;  // of a stage that waits for rest or for a stress

/// A stage under way.
struct Loading {
  const Case& c;
  const LoadingProgram& program;
  State& state;
  const Observer& observer;
  std::string name;
  std::string_view kind;
  RunResults& results;
  GrainSystem& system;
  LoadingProgress& at;
};

void keep_in_step(Loading& l) {
  collect(l.system, l.state.particles);
  l.state.domain = l.system.domain;
}

/// Share of the present leg that is done.
double leg_fraction(const Loading& l, const LoadingLeg& leg, const HistoryRow& row) {
  double done = 0.0;
  switch (leg.end) {
    case LoadingLeg::End::strain:
      done = (row.strain.z - l.at.leg_strain.z) / (leg.target - l.at.leg_strain.z);
      break;
    case LoadingLeg::End::axial_stress:
      done = row.stress.z > 0.0 && l.at.leg_stress.z > 0.0
                 ? std::log(row.stress.z / l.at.leg_stress.z) / std::log(leg.target / l.at.leg_stress.z)
                 : (row.stress.z - l.at.leg_stress.z) / (leg.target - l.at.leg_stress.z);
      break;
    case LoadingLeg::End::shear_strain:
      done = row.shear_strain / leg.target;
      break;
    case LoadingLeg::End::time:
      done = (row.time - l.at.leg_began) / leg.target;
      break;
    case LoadingLeg::End::rest:
      done = leg.target > 0.0 ? (row.time - l.at.leg_began) / leg.target : l.program.unbalanced / row.unbalanced;
      break;
  }
  return std::isfinite(done) ? std::clamp(done, 0.0, 1.0) : 0.0;
}

bool is_at_rest(const Loading& l, const LoadingLeg& leg, const HistoryRow& row) {
  // Over the contact force of a grain, not of a contact: a few impacts in a rain of grains are no rest.
  const double contacts_of_a_grain = 0.5 * row.coordination;
  if (!(row.coordination > 0.0 && row.unbalanced < l.program.unbalanced * std::min(contacts_of_a_grain, 1.0))) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (const auto target = leg.box.stress[to_size(axis)])
      if (std::abs(row.stress[axis] / *target - 1.0) > l.program.stress_tolerance) return false;
  return true;
}

bool has_ended(const Loading& l, const LoadingLeg& leg, const HistoryRow& row) {
  switch (leg.end) {
    case LoadingLeg::End::strain:
      return (row.strain.z - leg.target) * (leg.target - l.at.leg_strain.z) >= 0.0;
    case LoadingLeg::End::axial_stress:
      ensure(std::abs(row.strain.z) < 1.0,
             "step {}: stage {}: an axial stress of {:.4g} Pa is not reached at a strain of {:.3g}; it is {:.4g} Pa", row.step,
             l.name, leg.target, row.strain.z, row.stress.z);
      return (row.stress.z - leg.target) * leg.box.strain_rate.z >= 0.0;
    case LoadingLeg::End::shear_strain:
      return row.shear_strain >= leg.target;
    case LoadingLeg::End::time:
      return row.time - l.at.leg_began >= leg.target;
    case LoadingLeg::End::rest:
      return is_at_rest(l, leg, row) || (leg.target > 0.0 && row.time - l.at.leg_began >= leg.target);
  }
  return true;
}

void write_row(Loading& l, HistoryRow row) {
  if (row.step == l.at.last_row_step) return;
  l.at.last_row_step = row.step;
  row.stage = l.name;
  complete_row(l.system, l.at.start, row);
  keep_in_step(l);
  l.state.history.push_back(row);
  if (l.observer.history) l.observer.history(l.state, row);
}

void tell_progress(Loading& l, const HistoryRow& row) {
  Progress progress;
  progress.stage = l.kind;
  progress.fraction = row.fraction;
  progress.step = row.step;
  progress.time = row.time;
  progress.unbalanced = row.unbalanced;
  progress.stress = row.mean;
  progress.porosity = row.porosity;
  try {
    tell_at_safe_place(l.observer, progress, l.state, l.results);
  } catch (const Interrupted&) {
    keep_in_step(l);
    throw;
  }
}

void run_leg(Loading& l) {
  LoadingProgress& at = l.at;
  const LoadingLeg& leg = l.program.legs[to_size(at.leg)];
  GrainSystem& s = l.system;
  const int legs = size_of(l.program.legs), rows = std::max(l.c.output.history_rows / legs, 1);
  const bool is_open_ended = leg.end == LoadingLeg::End::rest && leg.target == 0.0;
  if (at.leg_step == 0) at.leg_began = l.state.time;
  for (;; at.leg_step += leg.box.interval) {
    evaluate_forces(s);
    const GrainMeasures m = measure(s);
    HistoryRow row = history_row(s, m, at.start, l.state.time);
    if (at.leg_step == 0) {
      at.leg_strain = row.strain;
      at.leg_stress = row.stress;
    }
    const double done = leg_fraction(l, leg, row);
    row.fraction = (at.leg + done) / legs;
    const bool ended = has_ended(l, leg, row);
    if (is_open_ended ? at.leg_step % rest_row_interval == 0 : done * rows >= at.leg_rows) {
      write_row(l, row);
      at.leg_rows = static_cast<int>(done * rows) + 1;
    }
    if (at.leg_step % check_interval == 0 || ended) tell_progress(l, row);
    if (ended) {
      row.fraction = (at.leg + 1.0) / legs;
      write_row(l, row);
      return;
    }
    ensure(at.leg_step < most_steps,
           "step {}: stage {} is not at its end after {} steps: mean stress {:.4g} Pa, unbalanced force {:.2g}", s.steps, l.name,
           at.leg_step, row.mean, row.unbalanced);
    if (at.leg_step % check_interval == 0) renew_time_step(s, at.longest_step);
    steer_box(s, leg.box, m, at.servo);
    advance_grains(s, leg.box.interval);
    l.state.time += leg.box.interval * s.time_step;
  }
}

LoadingProgram program_of(const Stage& stage, const Case& c, const LoadingScale& scale) {
  return std::visit(
      [&](const auto& s) -> LoadingProgram {
        if constexpr (is_loading<std::decay_t<decltype(s)>>)
          return loading_program(s, c, scale);
        else
          return {};
      },
      stage);
}

/// Gives the walls and the box the motion of the program.
HistoryStart begin(GrainSystem& s, const LoadingProgram& program) {
  s.motion.damping = program.damping;
  s.motion.strain_with_box = program.box_strains;
  if (!program.slide) return begin_history(s);
  const WallSlide& slide = *program.slide;
  Vec3 direction;
  direction[slide.direction] = 1.0;
  shear_by_walls(s, slide.axis, direction, slide.speed, slide.normal_stress, slide.speed_limit);
  return begin_history(s, slide.axis, slide.direction);
}

/// What bound the time step, and a stage that was to come to rest and did not.
void tell_end(const Loading& l, const Stage& stage) {
  if (!l.observer.message) return;
  const TimeStepLimit limit = critical_time_step(l.system);
  const HistoryRow& last = l.state.history.back();
  if (limit.grain >= 0)
    l.observer.message(fmt::format("stage {}: {} steps, the last of {:.3g} s; {}", l.name, last.step - l.at.first_step,
                                   last.time_step, time_step_text(l.system, limit)));
  if (std::holds_alternative<SettleStage>(stage) && !(last.unbalanced < l.program.unbalanced && last.coordination > 0.0))
    l.observer.message(
        fmt::format("warning: stage {}: not at rest after its time, the unbalanced force is {:.2g}; give it more time", l.name,
                    last.unbalanced));
}

LoadingProgress begin_stage(const Case& c, int index, State& state, const Observer& observer) {
  const Stage& stage = c.stages[to_size(index)];
  GrainSystem& s = ready_grains(c, state, observer);
  ready_bridges(c, s, observer);
  const GrainMeasures m = measure(s);
  LoadingProgress at;
  at.scale = loading_scale(c, s, state.particles, m);
  at.first_step = s.steps;
  at.first_row = size_of(state.history);
  const LoadingProgram program = program_of(stage, c, at.scale);
  if (observer.message && program.inertial_number > quasi_static_inertial_number)
    observer.message(fmt::format("warning: stage {}: {}", stage_name(c, index), inertia_warning(program)));
  at.longest_step = s.motion.safety * critical_time_step_at(s, std::max(program.pressure, m.mean_stress));
  s.time_step = 0.0;  // the whole share at once
  renew_time_step(s, at.longest_step);
  at.start = begin(s, program);
  return at;
}

}  // namespace

void run_loading_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results) {
  if (!has_begun(state)) state.position.progress = begin_stage(c, index, state, observer);
  auto& at = std::get<LoadingProgress>(state.position.progress);
  const Stage& stage = c.stages[to_size(index)];
  const LoadingProgram program = program_of(stage, c, at.scale);
  Loading l{c, program, state, observer, stage_name(c, index), kind_of(stage), results, *state.grains, at};
  for (; at.leg < size_of(program.legs); ++at.leg) {
    run_leg(l);
    at.leg_step = 0;
    at.leg_rows = 0;
    at.servo = {};
  }
  l.system.energy.is_kept = false;
  describe_loading(stage, l.name, program, std::span(state.history).subspan(to_size(at.first_row)), results);
  tell_end(l, stage);
}

}  // namespace puadem
