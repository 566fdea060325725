#pragma once

#include <cmath>

#include "flow/sample_networks.hpp"
#include "puadem/flow/two_phase_flow.hpp"

namespace puadem::testing {

/// Gives every throat the conductance of a tube of its entry radius and length 1.
inline PoreNetwork with_conductance(PoreNetwork network) {
  network.throat_conductance.clear();
  for (const double r : network.throat_entry_radius) network.throat_conductance.push_back(0.5 * r * r * r * r);
  return network;
}

/// A chain along z from the top (gas) to the bottom, pores 1 apart, all conductances g.
inline PoreNetwork upright_chain(const std::vector<double>& entry, double conductance, double volume = 1e3) {
  PoreNetwork network = chain(entry, volume);
  for (int i = 0; i < network.pores(); ++i) network.pore_centre[to_size(i)] = {0, 0, static_cast<double>(network.pores() - i)};
  network.throat_conductance.assign(to_size(network.throats()), conductance);
  return network;
}

inline FlowBoundary gas_boundary(const PoreNetwork& network, double pressure = 0.0) {
  return {"top", face_pores(network, 5), FluidPhase::nonwetting, FlowBoundary::Kind::pressure, Schedule::constant(pressure), {}};
}
inline FlowBoundary water_boundary(const PoreNetwork& network, const Schedule& pressure) {
  return {"bottom", face_pores(network, 4), FluidPhase::wetting, FlowBoundary::Kind::pressure, pressure, {}};
}

inline TwoPhaseModel make_model(const PoreNetwork& network, const Fluids& fluids, const TwoPhaseOptions& options,
                                const Schedule& water_pressure) {
  return make_two_phase_model(network, fluids, options, {gas_boundary(network), water_boundary(network, water_pressure)},
                              usual_throat_films(network));
}

/// Error of both ledgers, as a share of the void.
inline double ledger_error(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& start,
                           const TwoPhaseState& state) {
  double water = 0.0, before = 0.0;
  for (int i = 0; i < network.pores(); ++i) {
    if (!model.is_counted(i)) continue;
    water += state.wetting_volume[to_size(i)];
    before += start.wetting_volume[to_size(i)];
  }
  const FluidLedger& l = state.ledger;
  const double wetting = before + l.wetting_in.value() - l.wetting_out.value() - water;
  const double nonwetting = l.nonwetting_in.value() - l.nonwetting_out.value() + (water - before);
  return std::max(std::abs(wetting), std::abs(nonwetting)) / model.void_volume;
}

/// Empties all pores but the wetting reservoir down to a saturation; all throats between them are open.
inline void fill_with_gas(const PoreNetwork& network, const TwoPhaseModel& model, double saturation, double gas_pressure,
                          TwoPhaseState& state) {
  const auto holds = [&](int i) { return !state.wetting.reservoir[to_size(i)]; };
  for (int i = 0; i < network.pores(); ++i) {
    if (!holds(i) || !model.is_counted(i)) continue;
    state.nonwetting.holds[to_size(i)] = 1;
    state.wetting_volume[to_size(i)] = saturation * network.pore_volume[to_size(i)];
    state.nonwetting_pressure[to_size(i)] = gas_pressure;
    state.wetting_pressure[to_size(i)] = gas_pressure - capillary_pressure(network, model, i, state);
  }
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    state.nonwetting.passes[to_size(t)] = holds(i) && holds(j);
    state.wetting.passes[to_size(t)] = !state.nonwetting.passes[to_size(t)] || model.options.corner_films;
  }
  connect_all(model.links, state.nonwetting);
  connect_all(model.links, state.wetting);
}

}  // namespace puadem::testing
