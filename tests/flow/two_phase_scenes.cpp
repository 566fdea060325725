#include "flow/two_phase_scenes.hpp"

#include <algorithm>
#include <cmath>

#include "flow/two_phase_samples.hpp"

namespace puadem::testing {

namespace {

/// Of pore 2 less, while it is full, the water's deficit alone.
double pressure_difference(const TwoPhaseState& state, int pore) {
  const double gas = state.nonwetting.holds[to_size(pore)] ? state.nonwetting_pressure[to_size(pore)] : 0.0;
  return gas - state.wetting_pressure[to_size(pore)];
}

}  // namespace

HainesJumpScene haines_jump_scene() {
  const PoreNetwork network = upright_chain({1.0, 6.0, 20.0}, 1e-3, 1.0);
  TwoPhaseModel model = make_model(network, unit_fluids(), {}, Schedule::constant(-1.0));
  HainesJumpScene scene;
  scene.threshold = std::max(6.0, model.thresholds.body_pressure[2]);
  TwoPhaseState state = start_two_phase(network, model);
  const auto rest_at = [&](double pressure) {
    model.boundaries[1].schedule = Schedule::constant(-pressure);
    equilibrate_two_phase(network, model, {}, state);
  };
  rest_at(scene.threshold * (1.0 - 1e-6));
  scene.enters_below = !state.nonwetting.holds[1] || state.nonwetting.holds[2];
  scene.lost_below = 1.0 - state.wetting_volume[2] / network.pore_volume[2];

  const double pressure = scene.threshold * (1.0 + 1e-6), before = state.wetting_volume[1] + state.wetting_volume[2];
  const double out = state.boundary_inflow[1][0], start = state.time;
  model.boundaries[1].schedule = Schedule::constant(-pressure);
  double last = state.wetting_volume[2];
  TwoPhaseCallbacks callbacks;
  callbacks.on_step = [&](const TwoPhaseState& now) {
    scene.regain = std::max(scene.regain, now.wetting_volume[2] - last);
    last = now.wetting_volume[2];
    scene.rise = std::max(scene.rise, now.wetting_pressure[2] / pressure + 1.0);
    const double change = now.wetting_volume[1] + now.wetting_volume[2] - before;
    scene.imbalance = std::max(scene.imbalance, std::abs(change - (now.boundary_inflow[1][0] - out)));
    scene.rows.push_back(
        {(now.time - start) / model.time_scale, pressure_difference(now, 2) / pressure, pressure_difference(now, 1) / pressure});
    return true;
  };
  advance_two_phase(network, model, 50.0 * model.time_scale, {}, state, callbacks);
  rest_at(pressure);
  scene.enters_above = state.nonwetting.holds[2];
  const ExponentialRetention law;
  for (const int i : {1, 2})
    scene.law_difference =
        std::max(scene.law_difference, std::abs(state.wetting_volume[to_size(i)] / network.pore_volume[to_size(i)] -
                                                law.saturation(model.thresholds.unit[to_size(i)], pressure)));
  return scene;
}

WashburnScene washburn_scene() {
  // With a pore's suction 1 / p_c = (1 - e^(-kappa S)) / p_thr the integral is closed. The throats hold against the suction
  // ahead.
  const int pores = 62;
  const double g = 1e-3, start = 0.1;
  const PoreNetwork network = upright_chain(std::vector<double>(pores - 1, 2.0), g);
  TwoPhaseOptions options;
  options.gas = GasKind::connected;
  options.corner_films = false;
  options.steps.front_change = 0.01;
  const TwoPhaseModel model = make_model(network, unit_fluids(), options, Schedule::constant(0.0));
  TwoPhaseState state = start_two_phase(network, model);
  fill_with_gas(network, model, start, 0.0, state);
  const CapillaryUnit& unit = model.thresholds.unit[1];
  const double kappa = ExponentialRetention{}.kappa(unit.faces);
  const double unit_time = network.pore_volume[1] * model.fluids.wetting.viscosity / g / unit.threshold *
                           (1.0 - start - (std::exp(-kappa * start) - std::exp(-kappa)) / kappa);
  WashburnScene scene;
  TwoPhaseCallbacks callbacks;
  callbacks.on_event = [&](const TwoPhaseEvent& event) {
    if (event.kind == InvasionEventKind::fill) scene.time.push_back(event.time / unit_time);
  };
  callbacks.on_step = [&](const TwoPhaseState&) { return scene.time.size() < 60; };
  advance_two_phase(network, model, 1e12, {}, state, callbacks);
  for (int n = 1; n <= size_of(scene.time); ++n) scene.by_sum.push_back(0.5 * n * (n + 1));
  if (scene.time.size() >= 60) scene.exponent = std::log(60.0 / 20.0) / std::log(scene.time[59] / scene.time[19]);
  return scene;
}

SeriesScene series_scene(double gas_viscosity) {
  const double g = 1e-3, suction = 0.6;
  const PoreNetwork network = upright_chain(std::vector<double>(20, 0.5), g);
  Fluids fluids = unit_fluids();
  fluids.nonwetting.viscosity = gas_viscosity;
  TwoPhaseOptions options;
  options.corner_films = false;
  const TwoPhaseModel model = make_model(network, fluids, options, Schedule::constant(-suction));
  TwoPhaseState state = start_two_phase(network, model);
  SeriesScene scene;
  long events = 0;
  TwoPhaseCallbacks callbacks;
  callbacks.on_event = [&](const TwoPhaseEvent&) { ++events; };
  callbacks.on_step = [&](const TwoPhaseState& now) {
    const bool is_quiet = events == 0;  // conductances of this step are those the state has now
    events = 0;
    const auto front = static_cast<int>(std::ranges::find(now.nonwetting.holds, 0) - now.nonwetting.holds.begin()) - 1;
    if (!is_quiet || front < 5 || front > 15) return front <= 15;
    const double share = now.wetting_volume[to_size(front)] / network.pore_volume[to_size(front)];
    if (share > 0.9 || share < 0.3) return true;  // behind the front, pores then still adjust
    const double water = (network.throats() - front) * fluids.wetting.viscosity / g, gas = front * gas_viscosity / g;
    const double flow = (suction - capillary_pressure(network, model, front, now)) / (water + gas);
    const ThroatFlows flows = throat_flows(network, model, now);
    scene.wetting_error = std::max(scene.wetting_error, std::abs(flows.wetting[to_size(network.throats() - 1)] / flow - 1.0));
    scene.nonwetting_error = std::max(scene.nonwetting_error, std::abs(flows.nonwetting[0] / flow - 1.0));
    ++scene.checked;
    return true;
  };
  advance_two_phase(network, model, 1e9, {}, state, callbacks);
  scene.conserved = state.boundary_inflow[0][1] / -state.boundary_inflow[1][0] - 1.0;
  return scene;
}

RiseScene rise_scene() {
  const int pores = 40;
  const double weight = 0.25, gas_density = 0.2;
  const PoreNetwork network = upright_chain(std::vector<double>(pores - 1, 6.0), 1e-3, 1.0);
  Fluids fluids = unit_fluids();
  fluids.wetting.density = 1.0;
  fluids.nonwetting.density = gas_density;
  TwoPhaseOptions options;
  options.gravity = {0, 0, -weight};
  const TwoPhaseModel model = make_model(network, fluids, options, Schedule::constant(0.0));
  const auto highest_full = [&](const TwoPhaseState& state) {
    int i = 0;
    while (state.nonwetting.holds[to_size(i)]) ++i;
    return network.pore_centre[to_size(i)].z - network.pore_centre.back().z + 0.5;  // in the throat above it
  };
  const auto height = [&](double pressure) {
    return (pressure - weight * gas_density * (pores - 1)) / (weight * (1.0 - gas_density));
  };
  RiseScene scene;
  TwoPhaseState state = start_two_phase(network, model);
  scene.start_error = std::abs(state.wetting_pressure[10] - state.wetting_pressure[9] - weight) / weight;
  equilibrate_two_phase(network, model, {}, state);
  scene.drained = highest_full(state);
  scene.drained_by_formula = height(6.0);
  for (int i = 25; i < pores - 1; ++i)
    scene.hydrostatic_error =
        std::max(scene.hydrostatic_error,
                 std::abs(state.wetting_pressure[to_size(i)] + weight * (network.pore_centre[to_size(i)].z - 1.0)) / weight);

  TwoPhaseState wetted = start_two_phase(network, model);
  fill_with_gas(network, model, 0.05, 0.0, wetted);
  equilibrate_two_phase(network, model, {}, wetted);
  scene.wetted = highest_full(wetted);
  scene.wetted_by_formula = height(model.thresholds.body_pressure[5]);
  return scene;
}

}  // namespace puadem::testing
