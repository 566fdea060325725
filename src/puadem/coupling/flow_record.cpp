#include "puadem/coupling/flow_record.hpp"

#include <algorithm>
#include <array>

#include "puadem/flow/flow_numbers.hpp"
#include "puadem/flow/interfacial_area.hpp"

namespace puadem {

namespace {

/// A fluid in the counted pores only.
FluidTopology topology_of(const PoreNetwork& network, const TwoPhaseModel& model, const FluidClusters& fluid) {
  std::vector<std::uint8_t> holds = fluid.holds;
  for (int i = 0; i < network.pores(); ++i)
    if (!model.is_counted(i)) holds[to_size(i)] = 0;
  return fluid_topology(network, holds, fluid.passes);
}

double meniscus_area(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state) {
  return parallel_sum<double>(network.pores(), [&](int i) {
    if (!model.is_counted(i) || !state.nonwetting.holds[to_size(i)]) return 0.0;
    const double volume = network.pore_volume[to_size(i)];
    return interfacial_area(model.thresholds.unit[to_size(i)], volume, state.wetting_volume[to_size(i)] / volume,
                            model.options.retention_law);
  });
}

/// Pressure of the first boundary of a fluid [Pa].
double reservoir_pressure(const TwoPhaseModel& model, const TwoPhaseState& state, FluidPhase fluid) {
  for (int b = 0; b < size_of(model.boundaries); ++b)
    if (model.boundaries[to_size(b)].fluid == fluid) return state.boundary_pressure[to_size(b)];
  return 0.0;
}

double displaced(const FlowRow& row) { return row.wetting_out - row.wetting_in; }

double capillary_number_between(const FlowRow& a, const FlowRow& b, const Fluids& fluids, double initial_area) {
  return capillary_number(fluids, (displaced(b) - displaced(a)) / ((b.time - a.time) * initial_area));
}

}  // namespace

FlowRow flow_row(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state, const FlowRow* last,
                 double initial_area) {
  FlowRow row;
  row.step = state.steps;
  row.time = state.time;
  row.water_pressure = reservoir_pressure(model, state, FluidPhase::wetting);
  row.capillary_pressure = reservoir_pressure(model, state, FluidPhase::nonwetting) - row.water_pressure;
  for (const auto& [wetting, nonwetting] : state.boundary_inflow) {
    (wetting > 0.0 ? row.wetting_in : row.wetting_out) += std::abs(wetting);
    (nonwetting > 0.0 ? row.nonwetting_in : row.nonwetting_out) += std::abs(nonwetting);
  }
  const InvasionTotals sums = totals(network, model, state);
  row.saturation = sums.saturation;
  row.trapped_wetting = sums.trapped_wetting;
  row.trapped_nonwetting = sums.trapped_nonwetting;
  row.wetting = topology_of(network, model, state.wetting);
  row.nonwetting = topology_of(network, model, state.nonwetting);
  row.meniscus_area = meniscus_area(network, model, state);
  if (last != nullptr && row.time > last->time)
    row.capillary_number = capillary_number_between(*last, row, model.fluids, initial_area);
  return row;
}

bool is_thin(const Domain& domain) {
  std::array<double, 3> size{domain.size().x, domain.size().y, domain.size().z};
  std::ranges::sort(size);
  return size[0] < 0.5 * size[1];
}

FlowPattern flow_pattern(const PoreNetwork& network, const Domain& domain, const TwoPhaseModel& model,
                         const TwoPhaseState& state) {
  const Vec3 size = domain.size();
  int axis = 2;
  for (int a = 0; a < 3; ++a)
    if (size[a] < size[axis]) axis = a;
  const double pixel = pore_spacing(network, domain);
  const PatternImage mostly = project_pattern(network, domain, axis, state.nonwetting.holds, pixel, 0.5);
  FlowPattern pattern;
  pattern.saturation = totals(network, model, state).saturation;
  pattern.finger_width = finger_width(mostly);
  pattern.mostly = count_boxes(mostly);
  pattern.projected = count_boxes(project_pattern(network, domain, axis, state.nonwetting.holds, pixel, 0.0));
  return pattern;
}

double capillary_number_at_half(const std::vector<FlowRow>& rows, const Fluids& fluids, double initial_area) {
  if (rows.size() < 3) return 0.0;
  const double half = 0.5 * displaced(rows.back());
  std::size_t k = 1;
  while (k + 2 < rows.size() && displaced(rows[k]) < half) ++k;
  const FlowRow &before = rows[k - 1], &after = rows[k + 1];
  return after.time > before.time ? capillary_number_between(before, after, fluids, initial_area) : 0.0;
}

}  // namespace puadem
