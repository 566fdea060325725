#include "puadem/flow/two_phase_events.hpp"

#include <algorithm>
#include <limits>

#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

using Kind = InvasionEventKind;

struct Moves {
  const PoreNetwork& network;
  const TwoPhaseModel& model;
  const TwoPhaseTrial& trial;
  TwoPhaseState& state;
  const TwoPhaseCallbacks& callbacks;
  long count = 0;

  void report(Kind kind, double pressure, int pore, int throat) {
    ++count;
    if (callbacks.on_event) callbacks.on_event({kind, state.time, pressure, pore, throat, 0});
  }
  void set(int throat, bool open) { set_open(network, model, throat, open, state.wetting, state.nonwetting); }
  double across(int throat, int gas, int water) const {
    return pressure_across(network, model, throat, trial.nonwetting[to_size(gas)], trial.wetting[to_size(water)]);
  }
  bool has_water(int i) const { return state.wetting.holds[to_size(i)]; }
};

/// Largest difference by which gas of either side pushes into a throat between two pores that hold it.
double push(const Moves& m, int throat) {
  const auto [i, j] = m.network.throat_pores[to_size(throat)];
  double largest = 0.0;
  if (m.has_water(j)) largest = std::max(largest, m.across(throat, i, j));
  if (m.has_water(i)) largest = std::max(largest, m.across(throat, j, i));
  return largest;
}

void fill(Moves& m, int pore) {
  const std::size_t p = to_size(pore);
  // Gas of a boundary keeps touching its pores.
  if (m.model.pore_boundary[p] < 0) {
    m.state.nonwetting.holds[p] = 0;
    m.state.nonwetting_pressure[p] = 0.0;
  }
  bool closed = false;
  for (const auto [neighbour, t] : m.model.links[pore])
    if (m.state.nonwetting.passes[to_size(t)]) {
      m.set(t, false);
      closed = true;
    }
  if (closed || m.model.pore_boundary[p] < 0) m.report(Kind::fill, m.trial.nonwetting[p] - m.trial.wetting[p], pore, -1);
}

/// Does a front enter a dry pore again? It does through the tightest throat that holds wetting fluid back (theory 4.4).
bool front_comes(const Moves& m, int pore) {
  double tightest = 0.0, least = std::numeric_limits<double>::infinity();
  for (const auto [neighbour, t] : m.model.links[pore]) {
    if (m.state.nonwetting.passes[to_size(t)] || !m.has_water(neighbour)) continue;
    tightest = std::max(tightest, m.model.thresholds.entry_pressure[to_size(t)]);
    least = std::min(least, m.across(t, pore, neighbour));
  }
  return least < std::min(tightest, refill_pressure(m.model, m.state.nonwetting, pore));
}

}  // namespace

long carry_out_events(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseTrial& trial, TwoPhaseState& state,
                      const TwoPhaseCallbacks& callbacks) {
  Moves m{network, model, trial, state, callbacks};
  for (const PoreInvasion& invasion : trial.invasions) m.report(Kind::drain, invasion.pressure, invasion.into, invasion.throat);
  // Throats that join gas, and throats whose menisci meet: p_so <= p_e, so that none is both.
  std::vector<int> opening, closing;
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    if (i == j || !state.nonwetting.holds[to_size(i)] || !state.nonwetting.holds[to_size(j)]) continue;
    const bool is_open = state.nonwetting.passes[to_size(t)];
    if (!is_open && model.thresholds.may_open[to_size(t)] && push(m, t) > model.thresholds.entry_pressure[to_size(t)])
      opening.push_back(t);
    if (is_open && model.options.snap_off && push(m, t) < model.thresholds.snap_off_pressure[to_size(t)] &&
        (state.wetting.connected[to_size(i)] || state.wetting.connected[to_size(j)]))
      closing.push_back(t);
  }
  for (const int t : opening) {
    m.set(t, true);
    m.report(Kind::open_throat, push(m, t), -1, t);
  }
  for (const int t : closing) {
    m.set(t, false);
    m.report(Kind::snap_off, push(m, t), -1, t);
  }
  long changed = 0;  // pores that ran dry, or that a front enters
  for (int i = 0; i < network.pores(); ++i) {
    if (trial.filling[to_size(i)] == PoreFilling::full) fill(m, i);
    if (trial.filling[to_size(i)] == PoreFilling::emptied) {
      state.wetting.holds[to_size(i)] = 0;
      state.wetting_volume[to_size(i)] = 0.0;
      ++changed;
    }
    if (trial.filling[to_size(i)] == PoreFilling::empty && front_comes(m, i)) {
      state.wetting.holds[to_size(i)] = 1;
      ++changed;
    }
  }
  if (m.count + changed > 0) find_clusters(model, state, callbacks);
  return m.count + changed;
}

void find_clusters(const TwoPhaseModel& model, TwoPhaseState& state, const TwoPhaseCallbacks& callbacks) {
  const auto update = [&](FluidClusters& fluid, Kind lost_kind, Kind gained_kind) {
    const std::vector<std::uint8_t> before = fluid.connected;
    const Csr lost = cut_off_anywhere(model.links, fluid);
    if (!callbacks.on_event) return;
    for (int row = 0; row < lost.rows(); ++row)
      callbacks.on_event({lost_kind, state.time, 0.0, std::ranges::min(lost[row]), -1, size_of(lost[row])});
    FluidClusters gained = fluid;
    for (std::size_t i = 0; i < before.size(); ++i) {
      gained.holds[i] = fluid.connected[i] && !before[i];
      gained.connected[i] = 0;
    }
    for (int i = 0; i < size_of(before); ++i)
      if (gained.holds[to_size(i)] && !gained.connected[to_size(i)])
        callbacks.on_event({gained_kind, state.time, 0.0, i, -1, size_of(reconnect(model.links, i, gained))});
  };
  update(state.nonwetting, Kind::trap_nonwetting, Kind::free_nonwetting);
  update(state.wetting, Kind::trap_wetting, Kind::free_wetting);
}

}  // namespace puadem
