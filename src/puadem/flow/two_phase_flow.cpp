#include "puadem/flow/two_phase_flow.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/flow/two_phase_events.hpp"
#include "puadem/flow/two_phase_step.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

/// A step this short, over the time scale, means that the run has come to a stand.
constexpr double shortest_step = 1e-12;

/// A step to rest may be this long over the drainage time of the fastest pore: in a longer one the rounding of its flows
/// alone would move more than 1e-8 of its volume.
constexpr double longest_rest = 1e7;

/// Steps in a row without change that count as rest whatever events they have: gas may come and go in a pore whose wetting
/// fluid is cut off, where nothing else can move.
constexpr int idle_events = 3;

/// Share of a given flow rate that may go missing: more means that its boundary is cut off.
constexpr double lost_rate = 1e-6;

/// Where gas would be cut off within a step to rest, boundaries move first by this share of what leads there, ...
constexpr double stop_before = 0.9;
/// ... but never by less than this.
constexpr double least_share = 1e-3;

bool has_rates(const PoreRates& rates) { return !rates.volume.empty() || !rates.uptake.empty(); }

bool gives_pressure(const FlowBoundary& boundary) { return boundary.kind == FlowBoundary::Kind::pressure; }

/// Prescribed values on the way from the present ones to others.
BoundaryValues between(const TwoPhaseState& state, const TwoPhaseModel& model, const BoundaryValues& to, double share) {
  BoundaryValues values = to;
  for (std::size_t b = 0; b < to.size(); ++b)
    if (gives_pressure(model.boundaries[b]))
      values[b] = state.boundary_pressure[b] + share * (to[b] - state.boundary_pressure[b]);
  return values;
}

/// Books what crossed the boundaries and takes the trial's volumes and pressures over.
void accept(const PoreNetwork& network, const TwoPhaseModel& model, double step, const StepPores& pores,
            const BoundaryValues& values, const TwoPhaseTrial& trial, TwoPhaseState& state) {
  const bool one_pressure = model.options.gas == GasKind::connected;
  const auto gas_gain = [&](int i) {
    const std::size_t p = to_size(i);
    return (pores.volume[p] - pores.old_volume[p]) - (trial.wetting_volume[p] - state.wetting_volume[p]);
  };
  for (int b = 0; b < size_of(model.boundaries); ++b) {
    const FlowBoundary& boundary = model.boundaries[to_size(b)];
    const bool is_gas = boundary.fluid == FluidPhase::nonwetting;
    CompensatedSum in;
    for (const int i : boundary.pores) {
      in.add(step * (is_gas ? trial.nonwetting_outflow : trial.wetting_outflow)[to_size(i)]);
      if (is_gas && !one_pressure && model.is_counted(i)) in.add(gas_gain(i));
    }
    if (is_gas && one_pressure)
      for (int i = 0; i < network.pores(); ++i)
        if (model.is_counted(i)) in.add(gas_gain(i));
    const double volume_in = in.value();
    if (!gives_pressure(boundary) &&
        std::abs(volume_in - step * values[to_size(b)]) > lost_rate * step * std::abs(values[to_size(b)]))
      throw NumericalError(fmt::format("two-phase flow cannot go on at t = {:.6g} s (step {}): {}", state.time, state.steps,
                                       unmet_rates(network, model, values, state)));
    state.boundary_inflow[to_size(b)][is_gas ? 1 : 0] += volume_in;
    state.ledger.book(is_gas ? 0.0 : volume_in, is_gas ? volume_in : 0.0);
    const int first = boundary.pores.front();
    state.boundary_pressure[to_size(b)] = gives_pressure(boundary)
                                              ? values[to_size(b)]
                                              : (is_gas ? trial.nonwetting : trial.wetting)[to_size(first)] +
                                                    hydrostatic(model, boundary.fluid, model.boundary_place[to_size(b)]);
  }
  state.ledger.book(0.0, trial.expansion);
  for (int i = 0; i < size_of(pores.uptake); ++i)
    if (model.is_counted(i)) state.ledger.book(-step * pores.uptake[to_size(i)], 0.0);
  for (int i = 0; i < network.pores(); ++i) {
    const std::size_t p = to_size(i);
    const bool gas = trial.nonwetting_clusters.holds[p];
    const double gas_pressure = trial.nonwetting[p] + hydrostatic(model, FluidPhase::nonwetting, network.pore_centre[p]);
    state.wetting_volume[p] = trial.wetting_volume[p];
    state.nonwetting_pressure[p] = gas ? gas_pressure : 0.0;
    state.wetting_pressure[p] = trial.wetting[p] + hydrostatic(model, FluidPhase::wetting, network.pore_centre[p]);
    // An explicit step ends beside the local laws; the pressures go with the volumes.
    if (model.options.scheme == TwoPhaseScheme::impes && trial.filling[p] == PoreFilling::mixed)
      state.wetting_pressure[p] = gas_pressure - capillary_pressure(network, model, i, state);
  }
}

/// Stepping of one call.
struct Stepper {
  const PoreNetwork& network;
  const TwoPhaseModel& model;
  TwoPhaseState& state;
  const TwoPhaseCallbacks& callbacks;
  double front_change;
  TwoPhaseReport report;
  std::vector<double> old_volume, volume;  ///< per pore, at the ends of the step [m3]
  PoreRates rates;

  TwoPhaseTrial attempt(double step, bool in_order, const BoundaryValues& values) {
    for (std::size_t p = 0; p < rates.volume.size(); ++p) volume[p] = old_volume[p] + step * rates.volume[p];
    const double most = front_change < 1.0 ? 2.0 * front_change : std::numeric_limits<double>::infinity();
    TwoPhaseTrial trial =
        try_two_phase_step(network, model, step, most, in_order, {old_volume, volume, rates.uptake}, values, state);
    report.solves += trial.solves;
    report.seconds_assemble += trial.seconds_assemble;
    report.seconds_solve += trial.seconds_solve;
    return trial;
  }

  /// One accepted step of at most `longest`; @return its length. `values(step, share)` gives the boundaries at its end; where
  /// boundaries jump a share of the jump may be taken first, so that pores fill in the order of their pressures.
  template <class Values>
  double advance(double longest, const Values& values, long& events) {
    double step = std::min(state.time_step, longest);
    const double tried = step;
    double share = 1.0;  // of what is given at the boundaries
    for (;;) {
      const BoundaryValues at_end = values(step, share);
      const bool in_order = front_change >= 1.0 && share > least_share;
      const TwoPhaseTrial trial = attempt(step, in_order, at_end);
      const StepChange change = trial.change;
      const bool too_long = front_change < 1.0 && change.front > 2.0 * front_change;
      if (trial.converged && in_order && trial.in_order < 1.0) {
        share *= stop_before * trial.in_order;
        ++report.retries;
        continue;
      }
      if (trial.converged && !too_long) {
        accept(network, model, step, {old_volume, volume, rates.uptake}, at_end, trial, state);
        state.time += step;
        ++state.steps;
        ++report.steps;
        report.largest_change = change.largest;
        const auto begin = std::chrono::steady_clock::now();
        const std::vector<std::uint8_t> was_connected = state.nonwetting.connected;
        state.wetting = trial.wetting_clusters;
        state.nonwetting = trial.nonwetting_clusters;
        spread_cut_off_gas(network, model, state);
        events = carry_out_events(network, model, trial, state, callbacks);
        note_cut_off_gas(network, model, was_connected, state);
        report.seconds_events += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        report.events += events;
        if (events > 0 && has_rates(rates)) {
          const std::string closed_off = closed_off_parts(network, model, rates, state);
          ensure(closed_off.empty(), "two-phase flow cannot go on at t = {:.6g} s (step {}): {}", state.time, state.steps,
                 closed_off);
        }
        std::swap(old_volume, volume);
        const double growth = model.options.steps.growth;
        const double factor =
            front_change < 1.0 && change.front > 0.0 ? std::clamp(front_change / change.front, 0.3, growth) : growth;
        // A step cut short by the end of the call or a schedule says little of the next.
        state.time_step = std::max(step * factor, step == tried && tried < state.time_step ? state.time_step : 0.0);
        return step;
      }
      ++report.retries;
      step *= trial.converged ? std::clamp(front_change / change.front, 0.1, 0.6) : 0.25;
      if (step > shortest_step * model.time_scale) continue;
      const std::string unmet = unmet_rates(network, model, at_end, state);
      ensure(unmet.empty(), "two-phase flow cannot go on at t = {:.6g} s (step {}): {}", state.time, state.steps, unmet);
      throw NumericalError(fmt::format(
          "two-phase flow stands still at t = {:.6g} s (step {}): no step above {:.3g} s succeeds; pore {} misses its local law "
          "by {:.2g} of its saturation",
          state.time, state.steps, step, trial.worst_pore, trial.mismatch));
    }
  }

  bool goes_on() {
    if (report.steps >= model.options.steps.step_limit)
      throw NumericalError(
          fmt::format("two-phase flow has taken {} steps up to t = {:.6g} s, the limit (step_limit)", report.steps, state.time));
    report.stopped = callbacks.on_step && !callbacks.on_step(state);
    return !report.stopped;
  }
};

Stepper make_stepper(const PoreNetwork& network, const TwoPhaseModel& model, TwoPhaseState& state,
                     const TwoPhaseCallbacks& callbacks, double front_change) {
  Stepper stepper{network, model, state, callbacks, front_change, {}, network.pore_volume, network.pore_volume, {}};
  if (state.time_step <= 0.0) state.time_step = model.options.steps.front_change * model.time_scale;
  return stepper;
}

}  // namespace

TwoPhaseState start_two_phase(const PoreNetwork& network, const TwoPhaseModel& model) {
  TwoPhaseState state;
  const std::size_t pores = to_size(network.pores()), throats = to_size(network.throats());
  state.wetting_volume = network.pore_volume;
  state.nonwetting_pressure.assign(pores, 0.0);
  state.gas_amount.assign(pores, 0.0);
  state.nonwetting.holds.assign(pores, 0);
  state.wetting.holds.assign(pores, 1);
  state.wetting.reservoir = state.nonwetting.reservoir = state.nonwetting.holds;
  state.nonwetting.passes.assign(throats, 0);
  state.wetting.passes.assign(throats, 1);
  double at_rest = 0.0;  // potential of the wetting fluid
  for (int b = size_of(model.boundaries) - 1; b >= 0; --b) {
    const FlowBoundary& boundary = model.boundaries[to_size(b)];
    const double given = gives_pressure(boundary) ? boundary.schedule.at(0.0) : 0.0;
    state.boundary_pressure.insert(state.boundary_pressure.begin(), given);
    const bool is_gas = boundary.fluid == FluidPhase::nonwetting;
    if (!is_gas) at_rest = given - hydrostatic(model, FluidPhase::wetting, model.boundary_place[to_size(b)]);
    for (const int i : boundary.pores) {
      const std::size_t p = to_size(i);
      (is_gas ? state.nonwetting : state.wetting).reservoir[p] = 1;
      if (!is_gas) continue;
      state.nonwetting.holds[p] = 1;
      state.nonwetting_pressure[p] = given;
      state.wetting.holds[p] = model.is_counted(i);
      state.wetting_volume[p] = network.pore_volume[p] * (1.0 - boundary.initial_gas_fraction.value_or(1.0));
    }
  }
  for (int i = 0; i < network.pores(); ++i)
    state.wetting_pressure.push_back(at_rest + hydrostatic(model, FluidPhase::wetting, network.pore_centre[to_size(i)]));
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    const auto is_gas = [&](int p) { return !model.is_counted(p) && state.nonwetting.holds[to_size(p)]; };
    state.nonwetting.passes[to_size(t)] = is_gas(i) && is_gas(j);
    state.wetting.passes[to_size(t)] = !state.nonwetting.passes[to_size(t)];
  }
  connect_all(model.links, state.wetting);
  connect_all(model.links, state.nonwetting);
  state.boundary_inflow.resize(model.boundaries.size());
  return state;
}

TwoPhaseReport advance_two_phase(const PoreNetwork& network, const TwoPhaseModel& model, double duration, const PoreRates& rates,
                                 TwoPhaseState& state, const TwoPhaseCallbacks& callbacks) {
  require(std::isfinite(duration) && duration >= 0.0, "two-phase flow cannot be followed for {} s", duration);
  return advance_two_phase_to(network, model, state.time + duration, rates, state, callbacks);
}

TwoPhaseReport advance_two_phase_to(const PoreNetwork& network, const TwoPhaseModel& model, double end, const PoreRates& rates,
                                    TwoPhaseState& state, const TwoPhaseCallbacks& callbacks) {
  for (const auto given : {rates.volume, rates.uptake})
    require(given.empty() || size_of(given) == network.pores(), "{} rates are given for {} pores", given.size(), network.pores());
  if (has_rates(rates)) {
    const std::string closed_off = closed_off_parts(network, model, rates, state);
    require(closed_off.empty(), "two-phase flow cannot follow the grains: {}", closed_off);
  }
  Stepper stepper = make_stepper(network, model, state, callbacks, model.options.steps.front_change);
  stepper.rates = rates;
  state.is_settling = false;
  while (state.time < end) {
    double until = end;
    for (const FlowBoundary& boundary : model.boundaries) until = std::min(until, boundary.schedule.next_corner(state.time));
    const double before = state.time;
    const auto values = [&](double step, double) {
      BoundaryValues v;
      for (const FlowBoundary& boundary : model.boundaries) v.push_back(boundary.schedule.just_before(before + step));
      return v;
    };
    long events = 0;
    const double longest = until - before;
    if (stepper.advance(std::min(longest, model.options.steps.longest), values, events) == longest) state.time = until;
    if (!stepper.goes_on()) break;
  }
  return stepper.report;
}

TwoPhaseReport equilibrate_two_phase(const PoreNetwork& network, const TwoPhaseModel& model, const RestCriterion& rest,
                                     TwoPhaseState& state, const TwoPhaseCallbacks& callbacks) {
  Stepper stepper = make_stepper(network, model, state, callbacks, 1.0);
  BoundaryValues now;
  for (const FlowBoundary& boundary : model.boundaries) now.push_back(boundary.schedule.at(state.time));
  const double longest = std::min(rest.duration * model.time_scale, longest_rest * model.shortest_time);
  if (!state.is_settling) {
    state.time_step = std::max(state.time_step, std::min(model.time_scale, longest));
    state.is_settling = true;
    state.quiet_steps = 0;
  }
  while (state.quiet_steps < idle_events) {
    long events = 0;
    const double step = stepper.advance(
        longest, [&](double, double share) { return share < 1.0 ? between(state, model, now, share) : now; }, events);
    const bool arrived = between(state, model, now, 0.0) == now;
    const bool is_quiet = arrived && step >= longest && stepper.report.largest_change < rest.saturation_change;
    state.quiet_steps = !is_quiet ? 0 : events == 0 ? idle_events : state.quiet_steps + 1;
    if (!stepper.goes_on()) return stepper.report;
  }
  state.is_settling = false;
  return stepper.report;
}

}  // namespace puadem
