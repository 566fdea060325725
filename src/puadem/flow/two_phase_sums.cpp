#include <algorithm>

#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

double capillary_pressure(const PoreNetwork& network, const TwoPhaseModel& model, int pore, const TwoPhaseState& state) {
  return local_pressure(model, state.nonwetting, pore,
                        std::clamp(state.wetting_volume[to_size(pore)] / network.pore_volume[to_size(pore)], 0.0, 1.0));
}

std::vector<double> saturation(const PoreNetwork& network, const TwoPhaseState& state) {
  std::vector<double> result(to_size(network.pores()));
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = state.wetting_volume[i] / network.pore_volume[i];
  return result;
}

InvasionTotals totals(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state) {
  CompensatedSum wetting, trapped_wetting, trapped_nonwetting;
  for (int i = 0; i < network.pores(); ++i) {
    if (!model.is_counted(i)) continue;
    const double water = state.wetting_volume[to_size(i)];
    wetting.add(water);
    if (!state.wetting.connected[to_size(i)]) trapped_wetting.add(water);
    if (!state.nonwetting.connected[to_size(i)] && state.nonwetting.holds[to_size(i)])
      trapped_nonwetting.add(network.pore_volume[to_size(i)] - water);
  }
  return {wetting.value() / model.void_volume, trapped_wetting.value() / model.void_volume,
          trapped_nonwetting.value() / model.void_volume};
}

ThroatFlows throat_flows(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state) {
  const TwoPhaseConductances k = two_phase_conductances(network, model, state);
  ThroatFlows flows{std::vector<double>(to_size(network.throats())), std::vector<double>(to_size(network.throats()))};
  for (int t = 0; t < network.throats(); ++t) {
    const std::size_t i = to_size(network.throat_pores[to_size(t)][0]), j = to_size(network.throat_pores[to_size(t)][1]);
    const Vec3 along = network.pore_centre[j] - network.pore_centre[i];
    const auto flow = [&](FluidPhase fluid, double conductance, std::span<const double> pressure) {
      return conductance == 0.0 ? 0.0 : conductance * (pressure[i] - pressure[j] + hydrostatic(model, fluid, along));
    };
    flows.wetting[to_size(t)] = flow(FluidPhase::wetting, k.wetting[to_size(t)], state.wetting_pressure);
    flows.nonwetting[to_size(t)] = flow(FluidPhase::nonwetting, k.nonwetting[to_size(t)], state.nonwetting_pressure);
  }
  return flows;
}

}  // namespace puadem
