#include "puadem/flow/invasion_moves.hpp"

#include <algorithm>
#include <cassert>

#include "puadem/flow/invasion_queue.hpp"
#include "puadem/flow/local_law.hpp"

namespace puadem {

namespace {

using EventKind = InvasionEventKind;
using CandidateKind = InvasionCandidate::Kind;

void report(const InvasionEventCallback& on_event, const InvasionEvent& event) {
  if (on_event) on_event(event);
}

// @return what is booked: 0 in a pore that is not counted
double exchange(const PoreNetwork& network, int pore, double new_volume, InvasionState& state) {
  assert(!state.is_reservoir(pore));
  double& wetting = state.wetting_volume[to_size(pore)];
  const double whole = network.pore_volume[to_size(pore)];
  const double change = new_volume - wetting;
  const double gas_change = (whole - new_volume) - (whole - wetting);
  wetting = new_volume;
  if (!state.is_counted(pore)) return 0.0;
  state.ledger.book(change, gas_change);
  return change;
}

double volume_at_rest(const PoreNetwork& network, int pore, const InvasionState& state) {
  const CapillaryUnit& unit = state.thresholds.unit[to_size(pore)];
  const double drop = state.thresholds.body_pressure[to_size(pore)] - state.refill_pressure(pore);
  return network.pore_volume[to_size(pore)] * law_saturation(state.options.retention_law, unit, drop, state.capillary_pressure);
}

bool is_stable(int pore, const InvasionState& state) { return state.capillary_pressure >= state.refill_pressure(pore); }

void set_open(int throat, bool open, InvasionState& state) {
  state.nonwetting.passes[to_size(throat)] = open;
  state.wetting.passes[to_size(throat)] = !open || state.options.corner_films;
}

FluidClusters& fluid_of(EventKind kind, InvasionState& state) {
  return kind == EventKind::trap_wetting || kind == EventKind::free_wetting ? state.wetting : state.nonwetting;
}

// What is cut off keeps the wetting volume it has at this pressure.
void freeze(const PoreNetwork& network, const Csr& lost, EventKind kind, InvasionState& state,
            const InvasionEventCallback& on_event) {
  const FluidClusters& other = kind == EventKind::trap_wetting ? state.nonwetting : state.wetting;
  for (const int pore : lost.index)
    if (other.connected[to_size(pore)] && !state.is_reservoir(pore) && is_stable(pore, state))
      exchange(network, pore, volume_at_rest(network, pore, state), state);
  for (int row = 0; row < lost.rows(); ++row)
    report(on_event, {kind, state.capillary_pressure, std::ranges::min(lost[row]), -1, size_of(lost[row])});
}

void trap(const PoreNetwork& network, std::span<const int> around, EventKind kind, InvasionState& state,
          const InvasionEventCallback& on_event) {
  if (state.options.trap_check == TrapCheck::step) return;
  freeze(network, cut_off(state.links, around, fluid_of(kind, state), state.search), kind, state, on_event);
}

// What is reached again comes to rest at the pressure of the reservoirs.
void release(const PoreNetwork& network, int pore, EventKind kind, InvasionState& state, const InvasionEventCallback& on_event) {
  FluidClusters& fluid = fluid_of(kind, state);
  if (!fluid.holds[to_size(pore)] || fluid.connected[to_size(pore)]) return;
  const std::vector<int> gained = reconnect(state.links, pore, fluid);
  double change = 0.0;
  for (const int p : gained) change += settle(network, p, state);
  for (const int p : gained) queue_pore(network, p, state);
  report(on_event, {kind, state.capillary_pressure, std::ranges::min(gained), -1, size_of(gained), change});
}

// A throat that closes changes the law of its pores: they have the volume of the old one until then.
void settle_before(const PoreNetwork& network, int pore, InvasionState& state) {
  if (state.options.cooperative_filling) settle(network, pore, state);
}

void drain(const PoreNetwork& network, int pore, int throat, InvasionState& state, const InvasionEventCallback& on_event) {
  FluidClusters &wetting = state.wetting, &nonwetting = state.nonwetting;
  const std::size_t p = to_size(pore);
  const bool keeps_water = state.thresholds.keeps_water[p];
  nonwetting.holds[p] = nonwetting.connected[p] = 1;
  const double change = exchange(network, pore, keeps_water ? volume_at_rest(network, pore, state) : 0.0, state);
  report(on_event, {EventKind::drain, state.capillary_pressure, pore, throat, 0, change});

  // All throats to gas whose entry pressure is passed open with the first: their order decides nothing.
  std::vector<int> around{pore}, behind;
  for (const auto [neighbour, t] : state.links[pore]) {
    if (!keeps_water && wetting.passes[to_size(t)]) around.push_back(neighbour);
    const bool opens = t == throat || (nonwetting.holds[to_size(neighbour)] && state.thresholds.may_open[to_size(t)] &&
                                       state.thresholds.entry_pressure[to_size(t)] < state.capillary_pressure);
    if (!opens) continue;
    set_open(t, true, state);
    around.push_back(neighbour);
    behind.push_back(neighbour);
    if (t != throat) report(on_event, {EventKind::open_throat, state.capillary_pressure, -1, t});
  }
  if (!keeps_water) wetting.holds[p] = wetting.connected[p] = 0;
  trap(network, around, EventKind::trap_wetting, state, on_event);
  for (const int neighbour : behind) release(network, neighbour, EventKind::free_nonwetting, state, on_event);
  queue_pore(network, pore, state);
}

void join(const PoreNetwork& network, int throat, InvasionState& state, const InvasionEventCallback& on_event) {
  const std::array<int, 2> ends = network.throat_pores[to_size(throat)];
  set_open(throat, true, state);
  report(on_event, {EventKind::open_throat, state.capillary_pressure, -1, throat});
  trap(network, ends, EventKind::trap_wetting, state, on_event);
  for (const int pore : ends) release(network, pore, EventKind::free_nonwetting, state, on_event);
  queue_throat(network, throat, state);
}

void fill(const PoreNetwork& network, int pore, InvasionState& state, const InvasionEventCallback& on_event) {
  FluidClusters &wetting = state.wetting, &nonwetting = state.nonwetting;
  const std::size_t p = to_size(pore);
  settle(network, pore, state);
  const double change = exchange(network, pore, network.pore_volume[p], state);
  nonwetting.holds[p] = nonwetting.connected[p] = 0;
  wetting.holds[p] = wetting.connected[p] = 1;
  report(on_event, {EventKind::fill, state.capillary_pressure, pore, -1, 0, change});

  std::vector<int> around;
  for (const auto [neighbour, t] : state.links[pore])
    if (nonwetting.passes[to_size(t)]) around.push_back(neighbour);
  for (const int neighbour : around) settle_before(network, neighbour, state);
  for (const auto [neighbour, t] : state.links[pore])
    if (nonwetting.passes[to_size(t)]) set_open(t, false, state);
  trap(network, around, EventKind::trap_nonwetting, state, on_event);
  for (const auto [neighbour, t] : state.links[pore]) release(network, neighbour, EventKind::free_wetting, state, on_event);
  queue_pore(network, pore, state);
}

void snap_off(const PoreNetwork& network, int throat, InvasionState& state, const InvasionEventCallback& on_event) {
  const auto [i, j] = network.throat_pores[to_size(throat)];
  for (const int pore : {i, j}) settle_before(network, pore, state);
  set_open(throat, false, state);
  report(on_event, {EventKind::snap_off, state.capillary_pressure, -1, throat});
  trap(network, std::array{i, j}, EventKind::trap_nonwetting, state, on_event);
  if (state.wetting.connected[to_size(i)]) release(network, j, EventKind::free_wetting, state, on_event);
  if (state.wetting.connected[to_size(j)]) release(network, i, EventKind::free_wetting, state, on_event);
  for (const int pore : {i, j}) queue_pore(network, pore, state);
}

}  // namespace

double settle(const PoreNetwork& network, int pore, InvasionState& state) {
  if (!state.is_in_equilibrium(pore) || !is_stable(pore, state)) return 0.0;
  return exchange(network, pore, volume_at_rest(network, pore, state), state);
}

void trap_at_stop(const PoreNetwork& network, InvasionState& state, const InvasionEventCallback& on_event) {
  for (const EventKind kind : {EventKind::trap_wetting, EventKind::trap_nonwetting})
    freeze(network, cut_off_anywhere(state.links, fluid_of(kind, state)), kind, state, on_event);
}

void carry_out(const PoreNetwork& network, const InvasionCandidate& candidate, InvasionState& state,
               const InvasionEventCallback& on_event) {
  const int index = candidate.index;
  switch (candidate.kind) {
    case CandidateKind::enter_first:
      return drain(network, network.throat_pores[to_size(index)][0], index, state, on_event);
    case CandidateKind::enter_second:
      return drain(network, network.throat_pores[to_size(index)][1], index, state, on_event);
    case CandidateKind::join:
      return join(network, index, state, on_event);
    case CandidateKind::fill:
      return fill(network, index, state, on_event);
    case CandidateKind::snap_off:
      return snap_off(network, index, state, on_event);
  }
}

}  // namespace puadem
