#include "puadem/flow/two_phase_system.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/flow/local_law.hpp"

namespace puadem {

namespace {

/// A dry unit has no law: its bubble gives way at p_thr (theory 6.1). The slope keeps the equations regular.
constexpr double dry_slope = 0.01;

std::vector<int> number_unknowns(const PoreNetwork& network, const TwoPhaseModel& model, FluidPhase fluid, int& unknowns) {
  std::vector<int> unknown(to_size(network.pores()), -1);
  std::vector<int> of_boundary(model.boundaries.size(), -1);
  for (int i = 0; i < network.pores(); ++i) {
    const int b = model.pore_boundary[to_size(i)];
    if (b < 0 || model.boundaries[to_size(b)].fluid != fluid) {
      if (model.is_counted(i)) unknown[to_size(i)] = unknowns++;
      continue;
    }
    if (model.boundaries[to_size(b)].kind == FlowBoundary::Kind::pressure) continue;
    if (of_boundary[to_size(b)] < 0) of_boundary[to_size(b)] = unknowns++;
    unknown[to_size(i)] = of_boundary[to_size(b)];
  }
  return unknown;
}

std::vector<int> add_throat_links(const PoreNetwork& network, std::span<const int> unknown,
                                  std::vector<std::array<int, 2>>& link) {
  std::vector<int> link_of(to_size(network.throats()), -1);
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    const int a = unknown[to_size(i)], b = unknown[to_size(j)];
    if (a < 0 || b < 0 || a == b || network.throat_entry_radius[to_size(t)] <= 0.0) continue;
    link_of[to_size(t)] = size_of(link);
    link.push_back({a, b});
  }
  return link_of;
}

}  // namespace

std::shared_ptr<TwoPhaseModel::Solver> make_two_phase_solver(const PoreNetwork& network, const TwoPhaseModel& model) {
  auto solver = std::make_shared<TwoPhaseModel::Solver>();
  solver->wetting = number_unknowns(network, model, FluidPhase::wetting, solver->unknowns);
  solver->wetting_link = add_throat_links(network, solver->wetting, solver->link);
  solver->nonwetting.assign(to_size(network.pores()), -1);
  solver->nonwetting_link.assign(to_size(network.throats()), -1);
  solver->capacitor.assign(to_size(network.pores()), -1);
  if (model.options.gas != GasKind::connected) {
    solver->nonwetting = number_unknowns(network, model, FluidPhase::nonwetting, solver->unknowns);
    solver->nonwetting_link = add_throat_links(network, solver->nonwetting, solver->link);
    for (int i = 0; i < network.pores(); ++i) {
      if (!model.is_counted(i) || solver->wetting[to_size(i)] < 0 || solver->nonwetting[to_size(i)] < 0) continue;
      solver->capacitor[to_size(i)] = size_of(solver->link);
      solver->link.push_back({solver->wetting[to_size(i)], solver->nonwetting[to_size(i)]});
    }
  }
  solver->conductance.resize(solver->link.size());
  for (auto* v : {&solver->diagonal, &solver->residual, &solver->increment}) v->resize(to_size(solver->unknowns));
  return solver;
}

PressureSystem& pressure_system(const TwoPhaseModel& model, bool to_rest) {
  using Method = PressureSolverOptions::Method;
  TwoPhaseModel::Solver& solver = *model.solver;
  std::optional<PressureSystem>& system = to_rest ? solver.to_rest : solver.in_time;
  if (system) return *system;
  PressureSolverOptions options = model.options.solver;
  if (options.method == Method::automatic && !to_rest) options.method = Method::incomplete;
  return system.emplace(solver.unknowns, solver.link, options);
}

void set_conductance(const PoreNetwork& network, const TwoPhaseModel& model, const FluidClusters& wetting,
                     const FluidClusters& nonwetting, double pressure, int throat, TwoPhaseConductances& k) {
  const std::size_t t = to_size(throat);
  k.wetting[t] = k.nonwetting[t] = 0.0;
  if (network.throat_entry_radius[t] <= 0.0) return;
  const std::size_t i = to_size(network.throat_pores[t][0]), j = to_size(network.throat_pores[t][1]);
  const double whole = network.throat_conductance[t];
  if (nonwetting.passes[t]) k.nonwetting[t] = whole * model.films.nonwetting[t] / model.fluids.nonwetting.viscosity;
  // A pore without wetting fluid has none to give, and its side of the throat ends in a meniscus.
  if (!wetting.passes[t] || !wetting.holds[i] || !wetting.holds[j]) return;
  k.wetting[t] = whole / model.fluids.wetting.viscosity;
  if (!nonwetting.passes[t]) return;
  const double share =
      model.films.wetting_at_entry[t] * std::pow(model.thresholds.entry_pressure[t] / pressure, model.films.exponent[t]);
  k.wetting[t] *= std::min(share, 1.0);  // no corner carries more than the throat
}

TwoPhaseConductances two_phase_conductances(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state) {
  const std::size_t throats = to_size(network.throats());
  TwoPhaseConductances k{std::vector<double>(throats), std::vector<double>(throats)};
  std::vector<double> pressure(to_size(network.pores()));
  for (int i = 0; i < network.pores(); ++i)
    if (state.nonwetting.holds[to_size(i)] && model.is_counted(i))
      pressure[to_size(i)] = capillary_pressure(network, model, i, state);
  parallel_for(network.throats(), [&](int t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    set_conductance(network, model, state.wetting, state.nonwetting, 0.5 * (pressure[to_size(i)] + pressure[to_size(j)]), t, k);
  });
  return k;
}

void set_open(const PoreNetwork& network, const TwoPhaseModel& model, int throat, bool open, FluidClusters& wetting,
              FluidClusters& nonwetting) {
  const auto [i, j] = network.throat_pores[to_size(throat)];
  const auto& keeps = model.thresholds.keeps_water;
  nonwetting.passes[to_size(throat)] = open;
  wetting.passes[to_size(throat)] = !open || (model.options.corner_films && keeps[to_size(i)] && keeps[to_size(j)]);
}

double pressure_across(const PoreNetwork& network, const TwoPhaseModel& model, int throat, double gas_potential,
                       double wetting_potential) {
  const auto [i, j] = network.throat_pores[to_size(throat)];
  const Vec3 place = 0.5 * (network.pore_centre[to_size(i)] + network.pore_centre[to_size(j)]);
  return gas_potential - wetting_potential + hydrostatic(model, FluidPhase::nonwetting, place) -
         hydrostatic(model, FluidPhase::wetting, place);
}

void net_outflow(const PoreNetwork& network, std::span<const double> conductance, std::span<const double> potential,
                 std::span<double> outflow) {
  std::ranges::fill(outflow, 0.0);
  for (int t = 0; t < network.throats(); ++t) {
    if (conductance[to_size(t)] == 0.0) continue;
    const std::size_t i = to_size(network.throat_pores[to_size(t)][0]), j = to_size(network.throat_pores[to_size(t)][1]);
    const double q = conductance[to_size(t)] * (potential[i] - potential[j]);
    outflow[i] += q;
    outflow[j] -= q;
  }
}

double refill_pressure(const TwoPhaseModel& model, const FluidClusters& gas, int pore) {
  const InvasionThresholds& t = model.thresholds;
  return refill_pressure(t.filling_shares, model.links, gas, t.body_pressure[to_size(pore)], pore);
}

double local_pressure(const TwoPhaseModel& model, const FluidClusters& gas, int pore, double saturation) {
  const std::size_t p = to_size(pore);
  const double refill = refill_pressure(model, gas, pore);
  if (!model.thresholds.keeps_water[p]) return refill * (1.0 + dry_slope * (1.0 - saturation));
  return law_pressure(model.options.retention_law, model.thresholds.unit[p], model.thresholds.body_pressure[p] - refill,
                      saturation);
}

double local_slope(const TwoPhaseModel& model, const FluidClusters& gas, int pore, double saturation) {
  const std::size_t p = to_size(pore);
  const double refill = refill_pressure(model, gas, pore);
  if (!model.thresholds.keeps_water[p]) return -refill * dry_slope;
  return law_slope(model.options.retention_law, model.thresholds.unit[p], model.thresholds.body_pressure[p] - refill, saturation);
}

double local_saturation(const TwoPhaseModel& model, const FluidClusters& gas, int pore, double pressure) {
  const std::size_t p = to_size(pore);
  const double refill = refill_pressure(model, gas, pore);
  if (!model.thresholds.keeps_water[p]) return 1.0 - (pressure / refill - 1.0) / dry_slope;
  return law_saturation(model.options.retention_law, model.thresholds.unit[p], model.thresholds.body_pressure[p] - refill,
                        pressure);
}

}  // namespace puadem
