#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/coupling/case_bridges.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/loading_program.hpp"
#include "puadem/coupling/pore_space.hpp"
#include "puadem/coupling/ready_grains.hpp"
#include "puadem/coupling/saturated_step.hpp"
#include "puadem/coupling/stages.hpp"
#include "puadem/coupling/unsaturated_motion.hpp"
#include "puadem/coupling/unsaturated_results.hpp"
#include "puadem/coupling/wall_servo.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/flow/retention_path.hpp"

namespace puadem {

namespace {

constexpr double frozen_share = 0.5;           // of the longest time over which the fluids' forces may stay frozen
constexpr double front_change_at_rest = 0.02;  // of a step of the fluids: to where they come to rest its length matters little

/// A stage under way.
struct Unsaturated {
  const Case& c;
  const UnsaturatedStage& stage;
  State& state;
  const Observer& observer;
  RunResults& results;
  UnsaturatedProgress& at;
  UnsaturatedOptions options;
  UnsaturatedCache cache{};
  std::vector<RetentionStop> stops{};

  GrainSystem& grains() { return *state.grains; }
  UnsaturatedState& fluids() { return *state.unsaturated; }
  UnsaturatedRecord& record() { return state.unsaturated_flows.back(); }
  double strain() { return std::log(at.start_size[record().axis] / grains().domain.size()[record().axis]); }
};

UnsaturatedOptions options_of(const Case& c, const UnsaturatedStage& stage, const GrainSystem& grains, double mean_radius) {
  UnsaturatedOptions options;
  options.fluids = c.fluids;
  options.flow.gas = GasKind::connected;
  options.flow.touching_first = true;
  options.flow.corner_films = stage.corner_films;
  options.flow.snap_off = stage.snap_off;
  options.flow.retention_law = stage.retention_law;
  if (stage.times.empty()) options.flow.steps.front_change = front_change_at_rest;
  options.network = c.pores;
  options.network.contact_angle = c.fluids.contact_angle;
  options.air = stage.air;
  options.water = stage.water;
  options.initial_air_fraction = stage.initial_air_fraction;
  options.remesh_displacement = stage.remesh_displacement * mean_radius;
  options.unbalanced = stage.unbalanced;
  if (stage.start == UnsaturatedStage::Start::dry) options.dry_at = stage.path.front();
  if (c.bridges)
    options.bridges = {grains.bridges ? grains.bridges->model : bridge_model(c), c.bridges->formation,
                       c.bridges->coalescence_saturation.value_or(default_coalescence)};
  return options;
}

/// The pressures at which all come to rest; motion in time begins from the first.
std::vector<RetentionStop> stops_of(const UnsaturatedStage& stage, double mean_radius) {
  RetentionPath path{stage.path, stage.step, mean_radius};
  if (!stage.times.empty()) path.turning_points.resize(1);
  const bool is_dry = stage.start == UnsaturatedStage::Start::dry;
  return retention_stops(path, is_dry ? std::numeric_limits<double>::infinity() : 0.0);
}

UnsaturatedProgress begin(const Case& c, int index, State& state, const Observer& observer) {
  const auto& stage = std::get<UnsaturatedStage>(c.stages[to_size(index)]);
  GrainSystem& grains = ready_grains(c, state, observer);
  collect(grains, state.particles);
  state.domain = grains.domain;
  const LoadingScale scale = loading_scale(c, grains, state.particles, measure(grains));
  UnsaturatedRecord& record = state.unsaturated_flows.emplace_back();
  record.stage = stage_name(c, index);
  const auto loaded = std::ranges::find(stage.loaded, true);
  record.axis = loaded != stage.loaded.end() && !stage.strain ? axis_of(static_cast<int>(loaded - stage.loaded.begin())) : 2;
  UnsaturatedProgress at;
  at.mean_radius = 0.5 * scale.diameter;
  at.began = state.time;
  at.start_size = scale.size;
  if (stage.strain)
    at.strain_rate =
        stage.strain_rate.value_or(default_inertial_number / inertial_number(1.0, scale.diameter, scale.density, *stage.stress));
  state.network = checked_network(c, state, observer, true);
  grains.motion.strain_with_box = false;
  grains.motion.damping = stage.damping;
  for (int face = 0; face < 6; ++face)
    if (stage.loaded[to_size(face)]) hold_stress(face, *stage.stress, scale, grains);
  UnsaturatedCache cache;
  state.unsaturated =
      start_unsaturated(options_of(c, stage, grains, at.mean_radius), state.network, state.particles, grains, cache);
  state.unsaturated->swelling = start_swelling(state.particles, c.materials);
  return at;
}

double porosity(const Unsaturated& u) {
  const std::vector<double>& radius = u.state.particles.radius;
  return 1.0 - size_of(radius) * statistics_of(radius).mean_volume / u.state.grains->domain.volume();
}

void write_row(Unsaturated& u, const std::string& branch) {
  evaluate_forces(u.grains());
  UnsaturatedRow row = unsaturated_row(u.grains(), u.state.network, u.state.particles, u.fluids(), u.cache, u.record().axis);
  row.stage = u.record().stage;
  row.branch = branch;
  row.pc_star = row.capillary_pressure * u.at.mean_radius / u.c.fluids.surface_tension;
  const Vec3 size = u.grains().domain.size(), before = u.at.start_size;
  row.strain = u.strain();
  row.volume_strain = std::log(before.x * before.y * before.z / (size.x * size.y * size.z));
  row.porosity = porosity(u);
  if (u.at.motion_began) row.time = u.fluids().grain_time - *u.at.motion_began;
  if (u.record().rows.empty()) u.at.first_force = row.mean_force;
  if (u.at.first_force > 0.0) row.mean_force_ratio = row.mean_force / u.at.first_force;
  row.rounds = u.at.round;
  u.record().rows.push_back(row);
  u.record().spreads.push_back(force_spread(u.grains(), u.fluids()));
  if (SwellingState& swelling = u.fluids().swelling; swelling.size() > 0) {
    const auto centre = followed_centres(u.fluids().place, u.state.particles, u.grains().domain);
    set_wetting(u.state.network, *u.cache.model, u.fluids().flow, centre, u.state.particles.radius, u.grains().domain, swelling);
    u.record().swelling.push_back(swelling_row(u.grains(), u.state.network, u.state.particles, u.fluids().swelling));
  }
  record_pore_space(*u.cache.model, u.state);
  u.state.saturation = saturation(u.state.network, u.fluids().flow);
  if (u.observer.unsaturated) u.observer.unsaturated(u.state, u.record().rows.back());
}

void tell_progress(Unsaturated& u) {
  const bool goes_on = u.stage.strain || !u.stage.times.empty();  // after the path
  double after = 0.0;
  if (u.at.motion_began)
    after = (u.fluids().grain_time - *u.at.motion_began) / u.stage.times.back();
  else if (u.at.stop == size_of(u.stops) && u.stage.strain)
    after = u.strain() / *u.stage.strain;
  Progress progress;
  progress.stage = UnsaturatedStage::kind;
  progress.fraction = (u.at.stop + size_of(u.stops) * after) / (size_of(u.stops) * (goes_on ? 2.0 : 1.0));
  progress.step = u.grains().steps;
  progress.time = u.state.time;
  progress.saturation = totals(u.state.network, *u.cache.model, u.fluids().flow).saturation;
  progress.capillary_pressure = u.fluids().capillary_pressure;
  progress.porosity = porosity(u);
  tell_at_safe_place(u.observer, progress, u.state, u.results);
}

/// One round at the present stop. @return whether grains and fluids rest
bool make_round(Unsaturated& u) {
  UnsaturatedState& s = u.fluids();
  s.capillary_pressure = u.stops[to_size(u.at.stop)].capillary_pressure;
  rest_fluids(u.options, u.state.network, u.state.particles, u.grains(), s, u.cache);
  // Grains that touch nothing cannot come to rest; before they move in time they need not.
  const bool float_free = !u.stage.times.empty() && measure(u.grains()).contacts == 0;
  const bool grains_rest = float_free || rest_grains(u.options, u.grains(), u.state.particles, s);
  u.state.time = u.at.began + s.grain_time;
  const double now = totals(u.state.network, *u.cache.model, s.flow).saturation;
  if (grains_rest) ++u.at.round;
  const bool rest = grains_rest && u.at.round > 1 && std::abs(now - u.at.saturation_before) < u.stage.saturation_change &&
                    std::abs(u.strain() - u.at.strain_before) < u.stage.strain_change;
  if (!rest && grains_rest) {
    ensure(u.at.round < u.stage.rounds,
           "step {}: stage {}: grains and fluids do not come to rest at a capillary pressure of {:.4g} Pa within {} rounds; "
           "saturation {:.4f}, a round before {:.4f}, strain {:.4g}, before {:.4g}; smaller steps of the path help",
           u.grains().steps, u.record().stage, s.capillary_pressure, u.at.round, now, u.at.saturation_before, u.strain(),
           u.at.strain_before);
    u.at.saturation_before = now;
    u.at.strain_before = u.strain();
  }
  return rest;
}

/// Fluids and network follow the grains; the run could go on from here.
void follow(Unsaturated& u) {
  follow_grains(u.options, u.grains(), u.state.particles, u.state.network, u.fluids(), u.cache);
  u.state.domain = u.grains().domain;
  u.state.saturation = saturation(u.state.network, u.fluids().flow);
  tell_progress(u);
}

/// Rounds to rest at every pressure of the path.
void follow_path(Unsaturated& u) {
  while (u.at.stop < size_of(u.stops)) {
    if (make_round(u)) {
      // Strains are counted from rest under the first pressure.
      if (u.at.stop == 0) u.at.start_size = u.grains().domain.size();
      write_row(u, u.stops[to_size(u.at.stop)].branch);
      ++u.at.stop;
      u.at.round = 0;
      u.fluids().settling_steps = 0;
    }
    follow(u);
  }
}

/// The upper wall of z moves at the rate of the stage, the lower stands, the others keep to their stress.
/// @return time over which grains move [s]
double move_walls(Unsaturated& u) {
  GrainSystem& grains = u.grains();
  const double rate = std::copysign(u.at.strain_rate, *u.stage.strain), height = grains.domain.size().z;
  for (Wall& wall : grains.walls) {
    if (wall.face < 0 || axis_of(wall.face) != 2) continue;
    wall.target.reset();
    wall.velocity = {};
  }
  set_box_rate(grains, {0.0, 0.0, -rate * height});
  const double left = std::abs(*u.stage.strain - u.strain());
  return std::min(u.stage.strain_step, left) / u.at.strain_rate;
}

/// Grains move for a step of the strain, in parts where one goes far; then fluids and grains follow each other.
void strain_once(Unsaturated& u) {
  UnsaturatedState& s = u.fluids();
  rest_fluids(u.options, u.state.network, u.state.particles, u.grains(), s, u.cache);
  move_grains(u.options, move_walls(u), u.grains(), u.state.particles, s);
  u.state.time = u.at.began + s.grain_time;
}

/// The box is strained under the last capillary pressure.
void strain_box(Unsaturated& u) {
  const double whole = *u.stage.strain;
  if (u.at.strain_rows == 0) u.at.start_size = u.grains().domain.size();
  for (;;) {
    const double done = u.strain() / whole;
    const bool ends = done >= 1.0 - 1e-9;
    if (ends || done * u.c.output.history_rows >= u.at.strain_rows) {
      write_row(u, "strain");
      u.at.strain_rows = static_cast<int>(done * u.c.output.history_rows) + 1;
    }
    if (ends) return;
    strain_once(u);
    follow(u);
  }
}

/// Rest is left behind: how long the fluids' forces may stay the same.
void begin_motion(Unsaturated& u) {
  UnsaturatedState& s = u.fluids();
  u.at.motion_began = s.grain_time;
  s.flow.time = s.flow.time_step = 0.0;
  rest_fluids(u.options, u.state.network, u.state.particles, u.grains(), s, u.cache);
  const double limit = frozen_limit(u.options, u.state.network, u.state.particles, u.grains().domain);
  u.at.interval = u.stage.coupling_interval.value_or(frozen_share * limit);
  require_below_limit(u.record().stage, u.at.interval, limit);
  if (u.observer.message)
    u.observer.message(fmt::format("stage {}: forces of the fluids stay the same for {:.3g} s at most (limit {:.3g} s)",
                                   u.record().stage, u.at.interval, limit));
}

/// Grains and fluids move in time while the reservoirs' pressures do.
void move_through_times(Unsaturated& u) {
  UnsaturatedState& s = u.fluids();
  if (!u.at.motion_began) begin_motion(u);
  const Schedule pressure{u.stage.times, u.stage.path};
  const double whole = u.stage.times.back();
  for (;;) {
    const double time = s.grain_time - *u.at.motion_began;
    const bool ends = time >= whole * (1.0 - 1e-9);
    if (ends || time / whole * u.c.output.history_rows >= u.at.time_rows) {
      write_row(u, "time");
      u.at.time_rows = static_cast<int>(time / whole * u.c.output.history_rows) + 1;
    }
    tell_progress(u);
    if (ends) return;
    const double longest = std::min({u.at.interval, whole - time, whole / u.c.output.history_rows});
    const long before = s.grain_steps;
    move_in_time(u.options, u.c.materials, longest, pressure, time, u.grains(), u.state.particles, u.state.network, s, u.cache);
    if (u.stage.stress) correct_servo(*u.stage.stress, s.grain_steps - before, u.grains());
    u.state.time = u.at.began + s.grain_time;
    u.state.domain = u.grains().domain;
    u.state.saturation = saturation(u.state.network, s.flow);
  }
}

void tell_end(const Unsaturated& u) {
  if (!u.observer.message) return;
  const UnsaturatedState& s = *u.state.unsaturated;
  u.observer.message(fmt::format(
      "stage {}: {} steps of the grains, {} of the fluids; {} new networks, {} cells renewed, {} pores "
      "whose saturation changed by more than 0.01 by merging",
      u.state.unsaturated_flows.back().stage, s.grain_steps, s.fluid_steps, s.remeshes, s.cells_renewed, s.pores_changed));
}

}  // namespace

void run_unsaturated_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results) {
  const auto& stage = std::get<UnsaturatedStage>(c.stages[to_size(index)]);
  if (!has_begun(state)) state.position.progress = begin(c, index, state, observer);
  auto& at = std::get<UnsaturatedProgress>(state.position.progress);
  Unsaturated u{c, stage, state, observer, results, at, options_of(c, stage, *state.grains, at.mean_radius)};
  if (state.grains->bridges) state.grains->bridges->rules.by_pores = true;
  u.stops = stops_of(stage, at.mean_radius);
  renew_cache(u.options, state.network, state.particles, u.grains().domain, u.fluids(), u.cache);
  follow_path(u);
  if (!stage.times.empty()) move_through_times(u);
  if (stage.strain) strain_box(u);
  set_box_rate(u.grains(), {});
  release_forces(u.grains());
  if (u.grains().bridges) u.grains().bridges->rules.by_pores = false;
  describe_unsaturated(u.record(), u.fluids(), results);
  describe_pore_space(u.record(), results);
  tell_end(u);
}

}  // namespace puadem
