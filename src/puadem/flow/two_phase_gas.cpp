#include "puadem/flow/two_phase_step.hpp"

namespace puadem {

namespace {

/// Absolute pressure times volume of the gas in a pore [J].
double amount_in(const PoreNetwork& network, const TwoPhaseModel& model, int i, const TwoPhaseState& state) {
  const std::size_t p = to_size(i);
  return (state.nonwetting_pressure[p] + model.options.reference_pressure) * (network.pore_volume[p] - state.wetting_volume[p]);
}

}  // namespace

void spread_cut_off_gas(const PoreNetwork& network, const TwoPhaseModel& model, TwoPhaseState& state) {
  if (model.options.gas != GasKind::ideal) return;
  FluidClusters cut_off = state.nonwetting;
  for (std::size_t i = 0; i < cut_off.holds.size(); ++i) {
    cut_off.holds[i] = state.nonwetting.holds[i] && !state.nonwetting.connected[i];
    cut_off.connected[i] = 0;
  }
  for (int i = 0; i < network.pores(); ++i) {
    if (state.gas_amount[to_size(i)] <= 0.0 || !cut_off.holds[to_size(i)] || cut_off.connected[to_size(i)]) continue;
    const std::vector<int> cluster = reconnect(model.links, i, cut_off);
    double amount = 0.0, now = 0.0;
    for (const int j : cluster) {
      amount += state.gas_amount[to_size(j)];
      now += amount_in(network, model, j, state);
    }
    for (const int j : cluster) state.gas_amount[to_size(j)] = amount * amount_in(network, model, j, state) / now;
  }
}

void note_cut_off_gas(const PoreNetwork& network, const TwoPhaseModel& model, std::span<const std::uint8_t> was_connected,
                      TwoPhaseState& state) {
  if (model.options.gas != GasKind::ideal) return;
  for (int i = 0; i < network.pores(); ++i) {
    const std::size_t p = to_size(i);
    const bool is_cut_off = model.is_counted(i) && state.nonwetting.holds[p] && !state.nonwetting.connected[p];
    if (!is_cut_off)
      state.gas_amount[p] = 0.0;
    else if (was_connected[p])
      state.gas_amount[p] = amount_in(network, model, i, state);
  }
}

}  // namespace puadem
