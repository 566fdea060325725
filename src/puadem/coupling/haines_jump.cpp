#include "puadem/coupling/haines_jump.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace puadem {

namespace {

constexpr double fine_change = 0.002;  // of the front in a step [-]
constexpr double fine_step = 0.05;     // behind the invasion, of the time in which a pore drains
constexpr int most_steps = 1000;
constexpr int steps_after = 300;  // recorded behind the invasion

TwoPhaseModel fine_model(const PoreNetwork& network, const TwoPhaseModel& model, double longest) {
  TwoPhaseOptions options = model.options;
  options.steps.front_change = std::min(options.steps.front_change, fine_change);
  options.steps.longest = std::min(options.steps.longest, longest);
  return make_two_phase_model(network, model.fluids, options, model.boundaries, model.films);
}

/// The next invasion from a counted pore: names of throat and pores only.
HainesJump find_jump(const PoreNetwork& network, const TwoPhaseModel& model, TwoPhaseState state, double duration) {
  HainesJump jump;
  int steps = 0;
  TwoPhaseCallbacks callbacks;
  callbacks.on_event = [&](const TwoPhaseEvent& event) {
    if (jump.throat >= 0 || event.kind != InvasionEventKind::drain || event.throat < 0) return;
    const auto [i, j] = network.throat_pores[to_size(event.throat)];
    const int other = event.pore == i ? j : i;
    if (!model.is_counted(other)) return;
    jump.throat = event.throat;
    jump.invaded = event.pore;
    jump.retracting = other;
  };
  callbacks.on_step = [&](const TwoPhaseState&) { return jump.throat < 0 && ++steps < most_steps; };
  advance_two_phase(network, model, duration, {}, state, callbacks);
  return jump;
}

}  // namespace

std::optional<HainesJump> record_haines_jump(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& before,
                                             double duration) {
  constexpr double any = std::numeric_limits<double>::infinity();
  const TwoPhaseModel up_to = fine_model(network, model, any), beyond = fine_model(network, model, fine_step * model.time_scale);
  HainesJump jump = find_jump(network, up_to, before, duration);
  if (jump.throat < 0) return std::nullopt;
  TwoPhaseState state = before;
  const auto pressure = [&](int pore) {
    return state.nonwetting.holds[to_size(pore)] ? capillary_pressure(network, model, pore, state)
                                                 : std::numeric_limits<double>::quiet_NaN();
  };
  const auto note = [&] {
    jump.time.push_back(state.time);
    jump.invaded_pressure.push_back(pressure(jump.invaded));
    jump.retracting_pressure.push_back(pressure(jump.retracting));
  };
  note();
  TwoPhaseCallbacks callbacks;
  callbacks.on_step = [&](const TwoPhaseState& now) {
    note();
    return now.nonwetting.holds[to_size(jump.invaded)] == 0;
  };
  advance_two_phase(network, up_to, duration, {}, state, callbacks);
  int after = 0;
  callbacks.on_step = [&](const TwoPhaseState&) {
    note();
    return ++after < steps_after;
  };
  state.time_step = std::min(state.time_step, beyond.options.steps.longest);
  advance_two_phase(network, beyond, steps_after * fine_step * model.time_scale, {}, state, callbacks);
  return jump;
}

}  // namespace puadem
