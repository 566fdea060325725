#include "puadem/coupling/two_phase_results.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/flow/flow_numbers.hpp"

namespace puadem {

namespace {

/// The region of the air at the start, and the pores of the water's reservoir, as boundaries name them.
const FlowBoundary& boundary_of(const TwoPhaseModel& model, FluidPhase fluid) {
  return *std::ranges::find(model.boundaries, fluid, &FlowBoundary::fluid);
}

void describe_numbers(const TwoPhaseModel& model, const State& state, double initial_area, const std::string& name,
                      RunResults& results) {
  const std::vector<FlowRow>& rows = state.flows.back().rows;
  const std::vector<int>&air = boundary_of(model, FluidPhase::nonwetting).pores,
        &water = boundary_of(model, FluidPhase::wetting).pores;
  auto& s = results.scalars;
  s[name + "_capillary_number"] = capillary_number_at_half(rows, model.fluids, initial_area);
  s[name + "_viscosity_ratio"] = viscosity_ratio(model.fluids);
  s[name + "_bond_number"] = bond_number(model.fluids, norm(model.options.gravity),
                                         state.particles.size() > 0 ? statistics_of(state.particles.radius).mean_radius : 0.0);
  const double conductance = conductance_between(state.network, air, water);
  const double breakthrough =
      breakthrough_pressure(state.network, model.thresholds.entry_pressure, model.thresholds.body_pressure, air, water);
  s[name + "_breakthrough_pressure_Pa"] = breakthrough;
  if (boundary_of(model, FluidPhase::wetting).kind == FlowBoundary::Kind::pressure) {
    const double excess = rows.back().capillary_pressure - breakthrough;
    s[name + "_capillary_number_darcy"] =
        excess > 0.0 ? conductance * excess / (model.fluids.surface_tension * initial_area) : 0.0;
  }
}

void describe_ledger(const TwoPhaseModel& model, const State& state, const FlowVolumes& start, const std::string& name,
                     RunResults& results) {
  const FlowVolumes end = flow_volumes(state.network, model, *state.flow);
  const FluidLedger& book = state.flow->ledger;
  results.ledger = {model.void_volume, start.wetting,    book.wetting_in.value(),    book.wetting_out.value(),
                    end.wetting,       start.nonwetting, book.nonwetting_in.value(), book.nonwetting_out.value(),
                    end.nonwetting};
  results.scalars[name + "_ledger_wetting_error"] = results.ledger.wetting_error();
  results.scalars[name + "_ledger_nonwetting_error"] = results.ledger.nonwetting_error();
}

}  // namespace

FlowVolumes flow_volumes(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state) {
  CompensatedSum wetting, nonwetting;
  for (int i = 0; i < network.pores(); ++i)
    if (model.is_counted(i)) {
      wetting.add(state.wetting_volume[to_size(i)]);
      nonwetting.add(network.pore_volume[to_size(i)] - state.wetting_volume[to_size(i)]);
    }
  return {wetting.value(), nonwetting.value()};
}

void describe_two_phase(const TwoPhaseModel& model, const State& state, const FlowVolumes& start, double initial_area,
                        RunResults& results) {
  const FlowRecord& record = state.flows.back();
  const FlowRow& last = record.rows.back();
  const std::string& name = record.stage;
  auto& s = results.scalars;
  s["pores"] = state.network.pores();
  s["throats"] = state.network.throats();
  s[name + "_throats_without_menisci"] = model.films.without_menisci;
  s[name + "_steps"] = static_cast<double>(state.flow->steps);
  s[name + "_time_s"] = last.time;
  s[name + "_saturation_end"] = last.saturation;
  s[name + "_trapped_wetting_end"] = last.trapped_wetting;
  s[name + "_trapped_nonwetting_end"] = last.trapped_nonwetting;
  s[name + "_clusters_nonwetting_end"] = last.nonwetting.clusters;
  s[name + "_euler_nonwetting_end"] = last.nonwetting.euler();
  s[name + "_euler_wetting_end"] = last.wetting.euler();
  s[name + "_meniscus_area_end_per_m"] = last.meniscus_area / state.domain.volume();
  describe_numbers(model, state, initial_area, name, results);
  if (record.breakthrough_time) {
    s[name + "_breakthrough_time_s"] = *record.breakthrough_time;
    s[name + "_breakthrough_saturation"] = *record.breakthrough_saturation;
  }
  if (record.pattern) {
    s[name + "_box_dimension"] = record.pattern->mostly.dimension;
    s[name + "_box_dimension_projected"] = record.pattern->projected.dimension;
    s[name + "_finger_width_m"] = record.pattern->finger_width;
  }
  describe_ledger(model, state, start, name, results);
}

}  // namespace puadem
