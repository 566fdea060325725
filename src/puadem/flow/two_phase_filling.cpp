#include <algorithm>

#include "puadem/flow/two_phase_step.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

/// A pore that the wetting fluid has filled by the step's end.
struct Filling {
  int pore;
  double crossing;  ///< share of the step at which its pressure fell below the lowest it can have with gas [-]
  double pressure;  ///< that pressure [Pa]
  double drop;      ///< by which it had fallen until then [Pa]
};

/// In their order; those due at once by pressure.
std::vector<Filling> fillings(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                              const TwoPhaseTrial& trial) {
  std::vector<Filling> result;
  for (int i = 0; i < network.pores(); ++i) {
    const std::size_t p = to_size(i);
    if (trial.filling[p] != PoreFilling::full || model.pore_boundary[p] >= 0) continue;
    const double threshold = local_pressure(model, trial.nonwetting_clusters, i, 1.0);
    const double before = state.nonwetting.holds[p] ? capillary_pressure(network, model, i, state) : threshold;
    const Vec3& place = network.pore_centre[p];
    const double after = trial.nonwetting[p] - trial.wetting[p] + hydrostatic(model, FluidPhase::nonwetting, place) -
                         hydrostatic(model, FluidPhase::wetting, place);
    result.push_back(
        {i, before > threshold ? (before - threshold) / (before - after) : 0.0, threshold, std::max(before - threshold, 0.0)});
  }
  std::ranges::stable_sort(result, [](const Filling& a, const Filling& b) {
    return std::tie(a.crossing, b.pressure) < std::tie(b.crossing, a.pressure);
  });
  return result;
}

/// By how much of its volume cut-off gas may differ from what it would be had the step ended when it was cut off.
constexpr double gas_error = 0.02;

/// Takes the gas out of a pore. @return the clusters this cuts off
Csr take_out(const PoreLinks& links, int pore, FluidClusters& gas, ClusterSearch& search) {
  std::vector<int> around;
  for (const auto [neighbour, t] : links[pore])
    if (gas.passes[to_size(t)]) around.push_back(neighbour);
  gas.holds[to_size(pore)] = gas.connected[to_size(pore)] = 0;
  return cut_off(links, around, gas, search);
}

/// Gas of a cluster at the step's start, and what of it the cluster would have lost by the time it is cut off [m3].
struct ClusterGas {
  double volume = 0.0, lost = 0.0;
};
ClusterGas gas_of(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state, double pressure_drop,
                  std::span<const int> cluster) {
  ClusterGas gas;
  for (const int i : cluster) {
    if (!state.nonwetting.holds[to_size(i)]) continue;
    const double volume = network.pore_volume[to_size(i)], water = state.wetting_volume[to_size(i)];
    const double pressure = capillary_pressure(network, model, i, state) - pressure_drop;
    gas.volume += volume - water;
    gas.lost +=
        (pressure > local_pressure(model, state.nonwetting, i, 1.0) ? local_saturation(model, state.nonwetting, i, pressure)
                                                                    : 1.0) *
            volume -
        water;
  }
  return gas;
}

}  // namespace

FillingsWithinStep fillings_within_step(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                                        const TwoPhaseTrial& trial) {
  FillingsWithinStep result;
  if (model.options.gas == GasKind::connected) return result;  // gas needs no ways
  FluidClusters gas = trial.nonwetting_clusters;
  connect_all(model.links, gas);
  FluidClusters ways = gas;  // of gas that still finds one, through pores that fill too
  ClusterSearch search;
  bool any = false;
  for (const Filling& filling : fillings(network, model, state, trial)) {
    if (!gas.connected[to_size(filling.pore)]) continue;
    const Csr lost = take_out(model.links, filling.pore, gas, search);
    for (int row = 0; row < lost.rows(); ++row) {
      const ClusterGas held = gas_of(network, model, state, filling.drop, lost[row]);
      if (held.volume <= 0.0) continue;  // entered within the step, and left again
      any = true;
      for (const int pore : lost[row]) ways.holds[to_size(pore)] = 0;
      if (result.in_order == 1.0 && held.lost > gas_error * held.volume) result.in_order = filling.crossing;
    }
  }
  if (!any) return result;
  connect_all(model.links, ways);
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    if (gas.passes[to_size(t)] && ways.connected[to_size(i)] != ways.connected[to_size(j)]) result.closed_throats.push_back(t);
  }
  return result;
}

}  // namespace puadem
