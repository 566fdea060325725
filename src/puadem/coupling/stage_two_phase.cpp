#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/coupling/checked_network.hpp"
#include "puadem/coupling/flow_record.hpp"
#include "puadem/coupling/stages.hpp"
#include "puadem/coupling/two_phase_results.hpp"
#include "puadem/flow/flow_numbers.hpp"
#include "puadem/flow/retention_path.hpp"

namespace puadem {

namespace {

constexpr int air_boundary = 0, water_boundary = 1;

/// Area of the boundary of the region that holds air at the start (theory 5.6) [m2].
double initial_area(const TwoPhaseStage& stage, const Domain& domain) {
  const Vec3 size = domain.size();
  if (stage.air == TwoPhaseStage::disc) return 2.0 * std::numbers::pi * *stage.disc_radius * size.z;
  const int axis = axis_of(stage.air);
  return size[(axis + 1) % 3] * size[(axis + 2) % 3];
}

FlowBoundary air_of(const TwoPhaseStage& stage, const PoreNetwork& network, const Domain& domain) {
  FlowBoundary air;
  air.fluid = FluidPhase::nonwetting;
  air.schedule = Schedule::constant(stage.air_pressure);
  air.initial_gas_fraction = stage.initial_air_fraction;
  if (stage.air == TwoPhaseStage::disc) {
    const Vec3 middle = 0.5 * (domain.lower + domain.upper);
    air.name = "disc";
    air.pores = cylinder_pores(network, middle.x, middle.y, *stage.disc_radius);
    require(!air.pores.empty(), "no pore lies in the disc of radius {} m about the middle of the box", *stage.disc_radius);
  } else {
    air.name = face_names[to_size(stage.air)];
    air.pores = face_pores(network, stage.air);
  }
  return air;
}

FlowBoundary water_of(const TwoPhaseStage& stage, const PoreNetwork& network, const Domain& domain, const Fluids& fluids) {
  FlowBoundary water;
  for (int face = 0; face < 6; ++face) {
    if (!stage.water[to_size(face)]) continue;
    water.name += fmt::format("{}{}", water.name.empty() ? "" : ", ", face_names[to_size(face)]);
    const std::vector<int> pores = face_pores(network, face);
    water.pores.insert(water.pores.end(), pores.begin(), pores.end());
  }
  std::ranges::sort(water.pores);
  water.pores.erase(std::ranges::unique(water.pores).begin(), water.pores.end());
  if (!stage.path.empty()) {
    water.schedule = Schedule::constant(stage.air_pressure - stage.path.front());
  } else if (!stage.water_pressure.empty()) {
    water.schedule = stage.water_times.empty() ? Schedule::constant(stage.water_pressure.front())
                                               : Schedule{stage.water_times, stage.water_pressure};
  } else {
    water.kind = FlowBoundary::Kind::flow_rate;
    const double rate = stage.withdrawal ? *stage.withdrawal
                                         : *stage.capillary_number * fluids.surface_tension / fluids.wetting.viscosity *
                                               initial_area(stage, domain);
    water.schedule = Schedule::constant(-rate);
  }
  return water;
}

/// A stage under way.
struct Flowing {
  const Case& c;
  const TwoPhaseStage& stage;
  State& state;
  const Observer& observer;
  TwoPhaseModel model;
  double area;  ///< A_0 [m2]
  FlowRecord& record;
  RunResults& results;
  TwoPhaseProgress& at;

  TwoPhaseState& flow() { return *state.flow; }
};

void add_row(Flowing& f) {
  std::vector<FlowRow>& rows = f.record.rows;
  if (!rows.empty() && rows.back().step == f.flow().steps) return;
  FlowRow row = flow_row(f.state.network, f.model, f.flow(), rows.empty() ? nullptr : &rows.back(), f.area);
  row.stage = f.record.stage;
  rows.push_back(row);
  if (f.observer.flow) f.observer.flow(f.state, f.model, row);
}

void take_picture(Flowing& f) {
  if (f.at.last_picture == f.flow().steps) return;
  f.at.last_picture = f.flow().steps;
  f.state.saturation = saturation(f.state.network, f.flow());
  if (f.observer.flow_fields) f.observer.flow_fields(f.state, f.model, f.at.saturation);
}

void report_progress(Flowing& f) {
  Progress progress;
  progress.stage = TwoPhaseStage::kind;
  progress.fraction = f.at.done;
  progress.step = f.flow().steps;
  progress.time = f.flow().time;
  progress.saturation = f.at.saturation;
  if (!f.record.rows.empty()) progress.capillary_pressure = f.record.rows.back().capillary_pressure;
  tell_at_safe_place(f.observer, progress, f.state, f.results);
}

/// Air is beside a reservoir of water.
bool reaches_water(const Flowing& f, int pore) {
  return std::ranges::any_of(f.model.links[pore], [&](const PoreLinks::Link& link) {
    return f.model.pore_boundary[to_size(link.pore)] == water_boundary;
  });
}

void note_event(Flowing& f, const TwoPhaseEvent& event) {
  if (f.observer.flow_event) f.observer.flow_event(f.state, event);
  if (event.kind == InvasionEventKind::drain && !f.record.breakthrough_time && reaches_water(f, event.pore))
    f.at.breaks_through = true;
}

void note_breakthrough(Flowing& f) {
  f.at.breaks_through = false;
  f.record.breakthrough_time = f.flow().time;
  f.record.breakthrough_saturation = f.at.saturation;
  if (is_thin(f.state.domain)) f.record.pattern = flow_pattern(f.state.network, f.state.domain, f.model, f.flow());
  add_row(f);
  f.at.ends = f.at.ends || f.stage.until_breakthrough;
}

/// Records the jump that comes next, once air has entered so much.
void look_for_jump(Flowing& f) {
  if (!f.stage.record_jump || f.record.jump || f.at.saturation > *f.stage.record_jump) return;
  const bool has_jumped = f.at.before_jump && f.flow().nonwetting.holds != f.at.before_jump->nonwetting.holds;
  if (has_jumped)
    f.record.jump = record_haines_jump(f.state.network, f.model, *f.at.before_jump, f.flow().time - f.at.before_jump->time);
  f.at.before_jump = f.record.jump ? std::nullopt : std::optional(f.flow());
}

/// After every step: rows and pictures where they are due, and whether the stage goes on.
bool note_step(Flowing& f) {
  const double before = f.at.saturation;
  f.at.saturation = totals(f.state.network, f.model, f.flow()).saturation;
  if (f.stage.duration) f.at.done = f.flow().time / *f.stage.duration;
  if (f.stage.until_saturation > 0.0) f.at.done = std::max(f.at.done, (1.0 - f.at.saturation) / (1.0 - f.stage.until_saturation));
  f.at.ends = f.at.ends || f.at.saturation <= f.stage.until_saturation;
  if (f.at.breaks_through) note_breakthrough(f);
  const FlowRow last = f.record.rows.back();
  const bool is_late = f.stage.duration && f.flow().time - last.time >= *f.stage.duration / f.c.output.history_rows;
  if (is_late || std::abs(f.at.saturation - last.saturation) >= 1.0 / f.c.output.history_rows) add_row(f);
  const auto passed = [&](double s) { return (before - s) * (f.at.saturation - s) <= 0.0 && before != f.at.saturation; };
  if (std::erase_if(f.at.awaited, passed) > 0) take_picture(f);
  look_for_jump(f);
  report_progress(f);
  return !f.at.ends;
}

/// The capillary pressures of the path one after the other, each for its time or until the fluids rest.
void follow_pressures(Flowing& f, const TwoPhaseCallbacks& callbacks) {
  const std::vector<RetentionStop> stops = retention_stops({f.stage.path, {f.stage.step}, 1.0});
  // Newton's method leaves saturations within its tolerance; rest is no less than that.
  RestCriterion rest;
  rest.saturation_change = std::max(rest.saturation_change, 10.0 * f.model.options.steps.tolerance);
  TwoPhaseProgress& at = f.at;
  for (; at.stop < size_of(stops) && !at.ends; ++at.stop) {
    const double pressure = f.stage.air_pressure - stops[to_size(at.stop)].capillary_pressure;
    f.model.boundaries[water_boundary].schedule = Schedule::constant(pressure);
    if (f.stage.hold) {
      if (!at.stop_end) at.stop_end = f.flow().time + *f.stage.hold;
      advance_two_phase_to(f.state.network, f.model, *at.stop_end, {}, f.flow(), callbacks);
      at.stop_end.reset();
    } else {
      equilibrate_two_phase(f.state.network, f.model, rest, f.flow(), callbacks);
    }
    at.done = (at.stop + 1.0) / size_of(stops);
    add_row(f);
  }
}

TwoPhaseModel make_model(const Case& c, const TwoPhaseStage& stage, const State& state) {
  const PoreNetwork& network = state.network;
  TwoPhaseOptions options = stage.options;
  ThroatFilms films = state.particles.size() > 0
                          ? throat_films(network, PackingSites(state.particles.position, state.particles.radius, state.domain),
                                         c.fluids.contact_angle)
                          : usual_throat_films(network);
  return make_two_phase_model(network, c.fluids, options,
                              {air_of(stage, network, state.domain), water_of(stage, network, state.domain, c.fluids)},
                              std::move(films));
}

/// Network and fluids at the start.
void begin(const Case& c, int index, State& state, const Observer& observer) {
  if (!c.network_file) state.network = checked_network(c, state, observer, true);
  state.flows.emplace_back().stage = stage_name(c, index);
  const TwoPhaseModel model = make_model(c, std::get<TwoPhaseStage>(c.stages[to_size(index)]), state);
  state.flow = start_two_phase(state.network, model);
  state.saturation = saturation(state.network, *state.flow);
  TwoPhaseProgress at;
  at.saturation = totals(state.network, model, *state.flow).saturation;
  at.awaited = c.output.fields_at.saturation;
  at.start = flow_volumes(state.network, model, *state.flow);
  state.position.progress = std::move(at);
  if (observer.packed) observer.packed(state);
}

}  // namespace

void run_two_phase_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results) {
  const auto& stage = std::get<TwoPhaseStage>(c.stages[to_size(index)]);
  const bool begins = !has_begun(state);
  if (begins) begin(c, index, state, observer);
  Flowing f{c,
            stage,
            state,
            observer,
            make_model(c, stage, state),
            initial_area(stage, state.domain),
            state.flows.back(),
            results,
            std::get<TwoPhaseProgress>(state.position.progress)};
  if (begins) {
    add_row(f);
    report_progress(f);
  }

  TwoPhaseCallbacks callbacks;
  callbacks.on_event = [&](const TwoPhaseEvent& event) { note_event(f, event); };
  callbacks.on_step = [&](const TwoPhaseState&) { return note_step(f); };
  if (!stage.path.empty())
    follow_pressures(f, callbacks);
  else if (!f.at.ends)
    advance_two_phase_to(state.network, f.model, *stage.duration, {}, *state.flow, callbacks);
  add_row(f);
  take_picture(f);
  if (!f.record.pattern && is_thin(state.domain))
    f.record.pattern = flow_pattern(state.network, state.domain, f.model, *state.flow);
  describe_two_phase(f.model, state, f.at.start, f.area, results);
}

}  // namespace puadem
