#include "puadem/flow/two_phase_newton.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"

namespace puadem {

namespace {

using Filling = PoreFilling;

/// Least slope of the local law in the matrix, over p_thr: where the law is flat the capacitor would be infinite. The
/// iteration still ends on the law itself.
constexpr double least_slope = 1e-6;
/// Capacitance of a full or emptied pore in the matrix, as a share of V / p_thr. It only keeps the equations regular:
/// what it seems to store is taken back by the next iteration.
constexpr double closed_capacitance = 1e-6;

Filling filling_at_start(const TwoPhaseModel& model, int i, const TwoPhaseState& state) {
  if (!model.is_counted(i)) return Filling::reservoir;
  if (!state.nonwetting.holds[to_size(i)]) return Filling::saturated;
  return state.wetting.holds[to_size(i)] ? Filling::mixed : Filling::empty;
}

/// What leaves a pore's wetting fluid by the linear model, per time: (W_new - W_old) / dt.
double storage(const Newton& n, int i) {
  const std::size_t p = to_size(i);
  const double linear = n.has_capacitor(i) ? n.capacitance[p] * (n.difference(i) - n.law_pressure[p]) : 0.0;
  return (n.trial.wetting_volume[p] - n.state.wetting_volume[p] - linear) / n.step;
}

/// Absolute pressure of cut-off ideal gas in a pore [Pa]; 0 for gas that keeps its volume.
double ideal_pressure(const Newton& n, int i) {
  if (n.state.gas_amount[to_size(i)] <= 0.0) return 0.0;
  const double pressure =
      n.trial.nonwetting[to_size(i)] + hydrostatic(n.model, FluidPhase::nonwetting, n.network.pore_centre[to_size(i)]);
  const double absolute = pressure + n.model.options.reference_pressure;
  ensure(absolute > 0.0,
         "cut-off gas in pore {} has the absolute pressure {:.4g} Pa at t = {:.6g} s (step {}); is reference_pressure right?", i,
         absolute, n.state.time, n.state.steps);
  return absolute;
}

/// residual = what does not balance at the present potentials [m3/s].
void find_residual(Newton& n) {
  const auto& solver = n.solver;
  net_outflow(n.network, n.throat.wetting, n.trial.wetting, n.trial.wetting_outflow);
  net_outflow(n.network, n.throat.nonwetting, n.trial.nonwetting, n.trial.nonwetting_outflow);
  std::ranges::fill(n.solver.residual, 0.0);
  for (int i = 0; i < n.network.pores(); ++i) {
    const std::size_t p = to_size(i);
    const double stored = n.model.is_counted(i) ? storage(n, i) : 0.0;
    const double grown = n.model.is_counted(i) ? (n.volume[p] - n.old_volume[p]) / n.step : 0.0;
    if (solver.wetting[p] >= 0 && n.trial.filling[p] != Filling::empty)
      n.solver.residual[to_size(solver.wetting[p])] += n.trial.wetting_outflow[p] + stored + n.taken(i);
    if (solver.nonwetting[p] >= 0 && n.trial.filling[p] != Filling::saturated)
      n.solver.residual[to_size(solver.nonwetting[p])] +=
          n.trial.nonwetting_outflow[p] + grown - stored - gas_expansion(n, i) / n.step;
  }
  for (int b = 0; b < size_of(n.model.boundaries); ++b) {
    const FlowBoundary& boundary = n.model.boundaries[to_size(b)];
    if (boundary.kind == FlowBoundary::Kind::pressure) continue;
    const auto& unknown = boundary.fluid == FluidPhase::wetting ? solver.wetting : solver.nonwetting;
    n.solver.residual[to_size(unknown[to_size(boundary.pores.front())])] -= n.boundary[to_size(b)];
  }
}

/// Conductances to prescribed potentials go to the diagonal, all others to the links.
void add_throats(const Newton& n, std::span<const double> conductance, std::span<const int> unknown,
                 std::span<const int> link_of) {
  for (int t = 0; t < n.network.throats(); ++t) {
    const double g = conductance[to_size(t)];
    if (g == 0.0) continue;
    if (const int link = link_of[to_size(t)]; link >= 0) {
      n.solver.conductance[to_size(link)] = g;
      continue;
    }
    const auto [i, j] = n.network.throat_pores[to_size(t)];
    const int a = unknown[to_size(i)], b = unknown[to_size(j)];
    if (a >= 0 && b < 0) n.solver.diagonal[to_size(a)] += g;
    if (b >= 0 && a < 0) n.solver.diagonal[to_size(b)] += g;
  }
}

/// A part without any prescribed pressure floats, and its balance sums to nothing: one of its pressures stays.
/// Unknowns without a fluid get an equation of their own.
void tie_down(Newton& n) {
  auto& solver = n.solver;
  DisjointSets parts(solver.unknowns);
  std::vector<double> weight(solver.diagonal);
  for (std::size_t k = 0; k < solver.link.size(); ++k) {
    if (solver.conductance[k] <= 0.0) continue;
    parts.join(solver.link[k][0], solver.link[k][1]);
    for (const int a : solver.link[k]) weight[to_size(a)] += solver.conductance[k];
  }
  const double largest = std::ranges::max(weight);
  std::vector<std::uint8_t> held(to_size(solver.unknowns));
  for (int a = 0; a < solver.unknowns; ++a)
    if (solver.diagonal[to_size(a)] > 0.0) held[to_size(parts.find(a))] = 1;
  for (int a = 0; a < solver.unknowns; ++a) {
    std::uint8_t& is_held = held[to_size(parts.find(a))];
    if (is_held) continue;
    is_held = 1;
    solver.diagonal[to_size(a)] = weight[to_size(a)] > 0.0 ? weight[to_size(a)] : (largest > 0.0 ? largest : 1.0);
  }
}

void assemble(Newton& n) {
  auto& solver = n.solver;
  std::ranges::fill(solver.conductance, 0.0);
  std::ranges::fill(solver.diagonal, 0.0);
  add_throats(n, n.throat.wetting, solver.wetting, solver.wetting_link);
  add_throats(n, n.throat.nonwetting, solver.nonwetting, solver.nonwetting_link);
  for (int i = 0; i < n.network.pores(); ++i) {
    if (const double pressure = ideal_pressure(n, i); pressure > 0.0)
      solver.diagonal[to_size(solver.nonwetting[to_size(i)])] += n.state.gas_amount[to_size(i)] / (pressure * pressure * n.step);
    if (!n.has_capacitor(i)) continue;
    const double c = n.capacitance[to_size(i)] / n.step;
    if (const int link = solver.capacitor[to_size(i)]; link >= 0)
      solver.conductance[to_size(link)] = c;
    else
      solver.diagonal[to_size(solver.wetting[to_size(i)])] += c;
  }
  tie_down(n);
}

}  // namespace

double gas_expansion(const Newton& n, int i) {
  const double pressure = ideal_pressure(n, i);
  if (pressure == 0.0) return 0.0;
  return n.state.gas_amount[to_size(i)] / pressure - (n.old_volume[to_size(i)] - n.state.wetting_volume[to_size(i)]);
}

void set_capacitor(Newton& n, int i) {
  const std::size_t p = to_size(i);
  const double unit = n.volume[p] / n.threshold(i);
  if (n.trial.filling[p] != Filling::mixed) {
    n.capacitance[p] = closed_capacitance * unit;
    return;
  }
  const double s = std::min(n.trial.wetting_volume[p] / n.volume[p], 1.0);
  n.law_pressure[p] = n.law(i, s);
  n.capacitance[p] = unit / std::max(-n.law_slope(i, s) / n.threshold(i), least_slope);
}

void start_newton(Newton& n) {
  const auto& [network, model, state] = std::tie(n.network, n.model, n.state);
  TwoPhaseTrial& trial = n.trial;
  trial.wetting_volume = state.wetting_volume;
  trial.wetting = state.wetting_pressure;
  trial.nonwetting = state.nonwetting_pressure;
  trial.wetting_clusters = state.wetting;
  trial.nonwetting_clusters = state.nonwetting;
  trial.filling.resize(to_size(network.pores()));
  trial.entered.resize(to_size(network.pores()));
  for (auto* v : {&n.law_pressure, &n.capacitance, &n.predicted, &trial.wetting_outflow, &trial.nonwetting_outflow})
    v->resize(to_size(network.pores()));
  for (int i = 0; i < network.pores(); ++i) {
    const std::size_t p = to_size(i);
    trial.wetting[p] -= hydrostatic(model, FluidPhase::wetting, network.pore_centre[p]);
    trial.nonwetting[p] -= hydrostatic(model, FluidPhase::nonwetting, network.pore_centre[p]);
    trial.filling[p] = filling_at_start(model, i, state);
    if (trial.filling[p] == Filling::saturated) trial.wetting_volume[p] = n.volume[p];
  }
  for (int b = 0; b < size_of(model.boundaries); ++b) {
    const FlowBoundary& boundary = model.boundaries[to_size(b)];
    const bool wets = boundary.fluid == FluidPhase::wetting;
    std::vector<double>& potential = wets ? trial.wetting : trial.nonwetting;
    const double given =
        boundary.kind == FlowBoundary::Kind::pressure ? n.boundary[to_size(b)] : state.boundary_pressure[to_size(b)];
    const double value = given - hydrostatic(model, boundary.fluid, model.boundary_place[to_size(b)]);
    for (const int i : boundary.pores) potential[to_size(i)] = value;
    if (wets || model.options.gas != GasKind::connected) continue;
    for (int i = 0; i < network.pores(); ++i) potential[to_size(i)] = value;  // gas of one pressure
  }
}

void solve_newton(Newton& n, double tolerance) {
  const Clock assembling;
  find_residual(n);
  for (double& r : n.solver.residual) r = -r;
  assemble(n);
  n.trial.seconds_assemble += assembling.seconds();
  const Clock solving;
  PressureSystem& system = pressure_system(n.model, n.to_rest);
  system.set(n.solver.conductance, n.solver.diagonal);
  std::ranges::fill(n.solver.increment, 0.0);
  system.solve(n.solver.residual, n.solver.increment, tolerance);
  ++n.trial.solves;
  n.trial.seconds_solve += solving.seconds();
  n.gas_misfit = 0.0;
  for (int i = 0; i < n.network.pores(); ++i) {
    const std::size_t p = to_size(i);
    n.predicted[p] = n.trial.wetting_volume[p];
    if (const int a = n.solver.wetting[p]; a >= 0 && n.trial.filling[p] != Filling::empty)
      n.trial.wetting[p] += n.solver.increment[to_size(a)];
    if (const double pressure = ideal_pressure(n, i); pressure > 0.0) {
      const double share = n.solver.increment[to_size(n.solver.nonwetting[p])] / pressure;
      n.gas_misfit = std::max(n.gas_misfit, n.state.gas_amount[p] / pressure * share * share / n.volume[p]);
    }
    if (const int a = n.solver.nonwetting[p]; a >= 0 && n.trial.filling[p] != Filling::saturated)
      n.trial.nonwetting[p] += n.solver.increment[to_size(a)];
    if (n.has_capacitor(i)) n.predicted[p] -= n.capacitance[p] * (n.difference(i) - n.law_pressure[p]);
  }
}

}  // namespace puadem
