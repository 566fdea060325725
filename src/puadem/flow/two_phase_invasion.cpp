#include <algorithm>
#include <cmath>
#include <utility>

#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"
#include "puadem/flow/two_phase_step.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

/// Invasions due within this share of a step are taken together where they are far from each other ...
constexpr double together = 0.1;
/// ... by more throats than this. Gas that enters a pore lifts the pressures around it, and others are then not due any more:
/// taken at once, those of half a step made S(t) differ by up to 0.1 between steps of different lengths.
constexpr int near = 3;

/// May gas leave a pore for a throat?
bool may_leave(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseTrial& trial, int i) {
  if (!model.options.touching_first || !model.is_counted(i)) return true;
  const RegularPolyhedron shape = regular_polyhedron(model.thresholds.unit[to_size(i)].faces);
  return trial.wetting_volume[to_size(i)] <= shape.touching_saturation() * network.pore_volume[to_size(i)];
}

/// Has the wetting fluid of a pore a way out that stays once gas comes through a throat? All throats to other gas whose
/// entry the pressure has passed open with the first.
bool has_outlet(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseTrial& trial, int throat, int into) {
  if (model.options.corner_films && model.thresholds.keeps_water[to_size(into)]) return true;
  for (const auto [neighbour, t] : model.links[into]) {
    if (t == throat || !trial.wetting_clusters.passes[to_size(t)] || !trial.wetting_clusters.holds[to_size(neighbour)]) continue;
    if (!trial.nonwetting_clusters.holds[to_size(neighbour)] || !model.thresholds.may_open[to_size(t)]) return true;
    if (pressure_across(network, model, t, trial.nonwetting[to_size(neighbour)], trial.wetting[to_size(into)]) <=
        model.thresholds.entry_pressure[to_size(t)])
      return true;
  }
  return false;
}

/// Share of the step at which a throat's pressure difference passed its threshold, but not before gas came to it; 0 where both
/// were so before.
double crossing(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state, const TwoPhaseTrial& trial,
                int throat, int from, int into, double threshold, double at_end) {
  const double gas = state.nonwetting.holds[to_size(from)]
                         ? state.nonwetting_pressure[to_size(from)] -
                               hydrostatic(model, FluidPhase::nonwetting, network.pore_centre[to_size(from)])
                         : trial.nonwetting[to_size(from)];
  const double at_start = pressure_across(
      network, model, throat, gas,
      state.wetting_pressure[to_size(into)] - hydrostatic(model, FluidPhase::wetting, network.pore_centre[to_size(into)]));
  const double passed = at_start >= threshold ? 0.0 : (threshold - at_start) / (at_end - at_start);
  return std::max(passed, trial.entered[to_size(from)]);
}

double threshold_of(const TwoPhaseModel& model, int throat, int into) {
  return std::max(model.thresholds.entry_pressure[to_size(throat)], model.thresholds.body_pressure[to_size(into)]);
}

/// Of pores that are near each other leaves only the first; the others are found again if they are still due.
void keep_apart(const TwoPhaseModel& model, std::vector<PoreInvasion>& due) {
  std::vector<std::uint8_t> is_near(model.links.start.size() - 1);
  std::erase_if(due, [&](const PoreInvasion& invasion) {
    if (is_near[to_size(invasion.into)]) return true;
    std::vector<int> around{invasion.into};
    std::size_t next = 0;
    for (int ring = 0; ring < near; ++ring)
      for (const std::size_t end = around.size(); next < end; ++next)
        for (const auto [neighbour, t] : model.links[around[next]])
          if (std::ranges::find(around, neighbour) == around.end()) around.push_back(neighbour);
    for (const int pore : around) is_near[to_size(pore)] = 1;
    return false;
  });
}

}  // namespace

std::vector<PoreInvasion> next_invasions(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                                         const TwoPhaseTrial& trial) {
  std::vector<PoreInvasion> due;
  const auto& holds = trial.nonwetting_clusters.holds;
  double first = 1.0;
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    if (holds[to_size(i)] == holds[to_size(j)] || !model.thresholds.may_open[to_size(t)]) continue;
    const int from = holds[to_size(i)] ? i : j, into = holds[to_size(i)] ? j : i;
    if (!model.is_counted(into) || !may_leave(network, model, trial, from)) continue;
    const double threshold = threshold_of(model, t, into);
    const double pressure = pressure_across(network, model, t, trial.nonwetting[to_size(from)], trial.wetting[to_size(into)]);
    if (pressure <= threshold || !has_outlet(network, model, trial, t, into)) continue;
    due.push_back({t, from, into, pressure, crossing(network, model, state, trial, t, from, into, threshold, pressure)});
    first = std::min(first, due.back().crossing);
  }
  std::erase_if(due, [&](const PoreInvasion& invasion) { return invasion.crossing > first + together; });
  // Those due at once by what they are past their thresholds, not by their numbers.
  std::ranges::stable_sort(due, {}, [&](const PoreInvasion& invasion) {
    return std::pair(invasion.crossing, threshold_of(model, invasion.throat, invasion.into) - invasion.pressure);
  });
  keep_apart(model, due);
  return due;
}

}  // namespace puadem
