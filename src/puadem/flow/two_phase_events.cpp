#include "puadem/flow/two_phase_events.hpp"

#include <algorithm>

#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"
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
  void set_open(int throat, bool open) {
    const auto [i, j] = network.throat_pores[to_size(throat)];
    const bool corners =
        model.options.corner_films && model.thresholds.keeps_water[to_size(i)] && model.thresholds.keeps_water[to_size(j)];
    state.nonwetting.passes[to_size(throat)] = open;
    state.wetting.passes[to_size(throat)] = !open || corners;
  }
  /// Pressure of gas in one pore over that of the wetting fluid in another, at the throat between them [Pa].
  double across(int throat, int gas, int water) const {
    const auto [i, j] = network.throat_pores[to_size(throat)];
    const Vec3 place = 0.5 * (network.pore_centre[to_size(i)] + network.pore_centre[to_size(j)]);
    return trial.nonwetting[to_size(gas)] - trial.wetting[to_size(water)] + hydrostatic(model, FluidPhase::nonwetting, place) -
           hydrostatic(model, FluidPhase::wetting, place);
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

/// May gas leave a pore for a throat?
bool may_leave(const Moves& m, int i) {
  if (!m.model.options.touching_first || !m.model.is_counted(i)) return true;
  const RegularPolyhedron shape = regular_polyhedron(m.model.thresholds.unit[to_size(i)].faces);
  return m.trial.wetting_volume[to_size(i)] <= shape.touching_saturation() * m.network.pore_volume[to_size(i)];
}

struct Opening {
  int throat, invaded;  // -1: none
  double pressure;
};

std::vector<Opening> find_openings(const Moves& m) {
  std::vector<Opening> openings;
  const auto& holds = m.state.nonwetting.holds;
  std::vector<std::uint8_t> invaded(holds.size()), opens(m.state.nonwetting.passes.size());
  const auto usable = [&](int t) {
    return !m.state.nonwetting.passes[to_size(t)] && m.model.thresholds.may_open[to_size(t)] &&
           m.network.throat_pores[to_size(t)][0] != m.network.throat_pores[to_size(t)][1];
  };
  for (int t = 0; t < m.network.throats(); ++t) {
    const auto [i, j] = m.network.throat_pores[to_size(t)];
    if (!usable(t) || holds[to_size(i)] == holds[to_size(j)]) continue;
    const int from = holds[to_size(i)] ? i : j, into = holds[to_size(i)] ? j : i;
    if (!m.model.is_counted(into) || !may_leave(m, from)) continue;
    const double pressure = m.across(t, from, into);
    if (pressure <= std::max(m.model.thresholds.entry_pressure[to_size(t)], m.model.thresholds.body_pressure[to_size(into)]))
      continue;
    openings.push_back({t, into, pressure});
    invaded[to_size(into)] = opens[to_size(t)] = 1;
  }
  // Throats that join gas, an invaded pore's further ones among them.
  for (int t = 0; t < m.network.throats(); ++t) {
    const auto [i, j] = m.network.throat_pores[to_size(t)];
    if (opens[to_size(t)] || !usable(t)) continue;
    const bool both = holds[to_size(i)] && holds[to_size(j)];
    const bool beside = (holds[to_size(i)] && invaded[to_size(j)]) || (holds[to_size(j)] && invaded[to_size(i)]);
    if (!both && !beside) continue;
    const double pressure = both ? push(m, t) : holds[to_size(i)] ? m.across(t, i, j) : m.across(t, j, i);
    if (pressure > m.model.thresholds.entry_pressure[to_size(t)]) openings.push_back({t, -1, pressure});
  }
  return openings;
}

void open(Moves& m, const Opening& opening) {
  const auto [i, j] = m.network.throat_pores[to_size(opening.throat)];
  const int into = opening.invaded;
  const bool enters = into >= 0 && !m.state.nonwetting.holds[to_size(into)];
  if (enters) {
    m.state.nonwetting.holds[to_size(into)] = 1;
    m.state.nonwetting_pressure[to_size(into)] = m.state.nonwetting_pressure[to_size(i == into ? j : i)];
  }
  m.set_open(opening.throat, true);
  m.report(enters ? Kind::drain : Kind::open_throat, opening.pressure, enters ? into : -1, opening.throat);
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
      m.set_open(t, false);
      closed = true;
    }
  if (closed || m.model.pore_boundary[p] < 0) m.report(Kind::fill, m.trial.nonwetting[p] - m.trial.wetting[p], pore, -1);
}

}  // namespace

long carry_out_events(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseTrial& trial, TwoPhaseState& state,
                      const TwoPhaseCallbacks& callbacks) {
  Moves m{network, model, trial, state, callbacks};
  const std::vector<Opening> openings = find_openings(m);
  std::vector<int> closing;
  if (model.options.snap_off)
    for (int t = 0; t < network.throats(); ++t)
      if (state.nonwetting.passes[to_size(t)] && push(m, t) < model.thresholds.snap_off_pressure[to_size(t)] &&
          (state.wetting.connected[to_size(network.throat_pores[to_size(t)][0])] ||
           state.wetting.connected[to_size(network.throat_pores[to_size(t)][1])]))
        closing.push_back(t);
  for (const Opening& opening : openings) open(m, opening);
  for (const int t : closing) {
    m.set_open(t, false);
    m.report(Kind::snap_off, push(m, t), -1, t);
  }
  for (int i = 0; i < network.pores(); ++i) {
    if (trial.filling[to_size(i)] == PoreFilling::full) fill(m, i);
    if (trial.filling[to_size(i)] == PoreFilling::emptied) state.wetting.holds[to_size(i)] = 0;
  }
  if (m.count > 0) find_clusters(model, state, callbacks);
  return m.count;
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
