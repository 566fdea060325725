#include "puadem/flow/two_phase_step.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"
#include "puadem/flow/two_phase_system.hpp"

namespace puadem {

namespace {

using Filling = PoreFilling;

/// Least slope of the local law in the matrix, over p_thr: where the law is flat the capacitor would be infinite. The
/// iteration still ends on the law itself.
constexpr double least_slope = 1e-6;
/// Capacitance of a full or emptied pore in the matrix, as a share of V / p_thr. It only keeps the equations regular:
/// what it seems to store is taken back by the next iteration.
constexpr double closed_capacitance = 1e-6;
/// Least share of a pore's wetting fluid that one iteration leaves.
constexpr double least_left = 0.2;
/// By how much of its volume a full pore may be too full, an emptied one too empty: the next step takes it back.
constexpr double overfill = 1e-9;
/// Largest error of the volume of ideal gas, over its pore's.
constexpr double gas_accuracy = 1e-12;
/// Slope of the local law over p_thr above which an iteration goes along the pressure, below along the volume.
constexpr double steep = 2.0;

/// Tolerance of the iterations while gas still finds pores to enter; the last are exact.
constexpr double rough = 1e-2;

struct Clock {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }
};

/// One step's equations and where their solution stands.
struct Newton {
  const PoreNetwork& network;
  const TwoPhaseModel& model;
  const TwoPhaseState& state;
  TwoPhaseModel::Solver& solver;
  const double step;
  const std::span<const double> old_volume, volume;
  const BoundaryValues& boundary;
  TwoPhaseConductances throat;
  TwoPhaseTrial& trial;
  std::vector<double> law_pressure;  ///< of a mixed pore; of a full or emptied one the difference it has
  std::vector<double> capacitance;   ///< [m3/Pa]
  std::vector<double> predicted;     ///< wetting volume after a solve [m3]
  double gas_misfit = 0.0;           ///< largest error of a pore's gas volume by its law made linear, over the pore's [-]

  double height(int i) const {  // turns a difference of potentials into one of pressures
    return hydrostatic(model, FluidPhase::nonwetting, network.pore_centre[to_size(i)]) -
           hydrostatic(model, FluidPhase::wetting, network.pore_centre[to_size(i)]);
  }
  double difference(int i) const { return trial.nonwetting[to_size(i)] - trial.wetting[to_size(i)] + height(i); }
  double threshold(int i) const { return model.thresholds.unit[to_size(i)].threshold; }
  bool has_capacitor(int i) const {
    const Filling f = trial.filling[to_size(i)];
    return f == Filling::mixed || f == Filling::full || f == Filling::emptied;
  }
};

Filling filling_at_start(const TwoPhaseModel& model, int i, const TwoPhaseState& state) {
  if (!model.is_counted(i)) return Filling::reservoir;
  if (!state.nonwetting.holds[to_size(i)]) return Filling::saturated;
  return state.wetting.holds[to_size(i)] ? Filling::mixed : Filling::empty;
}

void set_capacitor(Newton& n, int i) {
  const std::size_t p = to_size(i);
  const double unit = n.volume[p] / n.threshold(i);
  if (n.trial.filling[p] != Filling::mixed) {
    n.capacitance[p] = closed_capacitance * unit;
    return;
  }
  const double s = std::min(n.trial.wetting_volume[p] / n.volume[p], 1.0);
  n.law_pressure[p] = local_pressure(n.model, i, s);
  n.capacitance[p] = unit / std::max(-local_slope(n.model, i, s) / n.threshold(i), least_slope);
}

void start(Newton& n) {
  const auto& [network, model, state] = std::tie(n.network, n.model, n.state);
  TwoPhaseTrial& trial = n.trial;
  trial.wetting_volume = state.wetting_volume;
  trial.wetting = state.wetting_pressure;
  trial.nonwetting = state.nonwetting_pressure;
  trial.wetting_clusters = state.wetting;
  trial.nonwetting_clusters = state.nonwetting;
  trial.filling.resize(to_size(network.pores()));
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

/// By how much the gas of a pore has grown against the start, at its pressure so far (theory 6.3) [m3].
double expansion(const Newton& n, int i) {
  const double pressure = ideal_pressure(n, i);
  if (pressure == 0.0) return 0.0;
  return n.state.gas_amount[to_size(i)] / pressure - (n.old_volume[to_size(i)] - n.state.wetting_volume[to_size(i)]);
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
      n.solver.residual[to_size(solver.wetting[p])] += n.trial.wetting_outflow[p] + stored;
    if (solver.nonwetting[p] >= 0 && n.trial.filling[p] != Filling::saturated)
      n.solver.residual[to_size(solver.nonwetting[p])] +=
          n.trial.nonwetting_outflow[p] + grown - stored - expansion(n, i) / n.step;
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

/// New potentials from the equations made linear at the present point.
void solve(Newton& n) {
  const Clock assembling;
  find_residual(n);
  for (double& r : n.solver.residual) r = -r;
  assemble(n);
  n.trial.seconds_assemble += assembling.seconds();
  const Clock solving;
  n.solver.system->set(n.solver.conductance, n.solver.diagonal);
  std::ranges::fill(n.solver.increment, 0.0);
  n.solver.system->solve(n.solver.residual, n.solver.increment);
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

constexpr double not_yet = 1.0, never = std::numeric_limits<double>::infinity();

/// Fixes the volume of a pore that the linear model would fill or empty beyond its bounds.
double close(Newton& n, int i, Filling filling) {
  n.trial.filling[to_size(i)] = filling;
  n.trial.wetting_volume[to_size(i)] = filling == Filling::full ? n.volume[to_size(i)] : 0.0;
  n.law_pressure[to_size(i)] = n.difference(i);
  return not_yet;
}

/// A full or emptied pore: does its pressure let it stay so, and does the volume hold?
double keep_closed(Newton& n, int i) {
  const std::size_t p = to_size(i);
  Filling& filling = n.trial.filling[p];
  const double now = n.difference(i);
  const bool leaves = filling == Filling::full ? now > local_pressure(n.model, i, 1.0) : now < local_pressure(n.model, i, 0.0);
  const bool misses = std::abs(n.predicted[p] - n.trial.wetting_volume[p]) > overfill * n.volume[p];
  if (leaves) filling = Filling::mixed;
  n.law_pressure[p] = now;
  return leaves || misses ? not_yet : 0.0;
}

bool overfills(const Newton& n, int i) {
  const std::size_t p = to_size(i);
  const bool starts_full = n.state.wetting_volume[p] >= n.old_volume[p] * (1.0 - overfill);  // rounding is no event
  return n.predicted[p] > n.volume[p] * (starts_full ? 1.0 + overfill : 1.0);
}

/// Takes a mixed pore from the linear model back to its law. Returns by how much it misses it: the lesser of the
/// saturation and of the pressure over p_thr, since near S = 1 only the one, near 0 only the other is well conditioned.
double move_to_law(Newton& n, int i) {
  const std::size_t p = to_size(i);
  const double volume = n.volume[p], now = n.difference(i), scale = n.threshold(i), predicted = n.predicted[p];
  double& water = n.trial.wetting_volume[p];
  if (overfills(n, i)) return close(n, i, Filling::full);
  if (predicted <= 0.0 && !n.model.thresholds.keeps_water[p] && water < least_left * volume) return close(n, i, Filling::emptied);
  // Where the law is steep, the pressure knows the saturation better than the volume does.
  if (-local_slope(n.model, i, water / volume) > steep * scale && now > local_pressure(n.model, i, 1.0)) {
    water = volume * local_saturation(n.model, i, now);
    return std::abs(predicted - water) / volume;
  }
  const double least = least_left * water;
  water = std::clamp(predicted, least, volume);
  if (predicted < least) return not_yet;
  const double miss = std::abs(now - local_pressure(n.model, i, water / volume)) / scale;
  return miss / std::max(-local_slope(n.model, i, water / volume) / scale, 1.0);
}

/// The same for a step that is linear: the law stays where it was, and the step fails where it is left too far behind.
double check_explicit(Newton& n, int i) {
  const std::size_t p = to_size(i);
  if (overfills(n, i)) return close(n, i, Filling::full);
  const double water = n.trial.wetting_volume[p];
  if (n.predicted[p] >= least_left * water) return 0.0;
  return n.model.thresholds.keeps_water[p] || n.predicted[p] > 0.0 ? never : close(n, i, Filling::emptied);
}

/// Moves all pores after a solve. Returns the largest miss.
double move_all(Newton& n) {
  n.trial.mismatch = 0.0;
  const bool is_explicit = n.model.options.scheme == TwoPhaseScheme::impes;
  for (int i = 0; i < n.network.pores(); ++i) {
    if (!n.has_capacitor(i)) continue;
    const bool is_mixed = n.trial.filling[to_size(i)] == Filling::mixed;
    const double miss = !is_mixed ? keep_closed(n, i) : is_explicit ? check_explicit(n, i) : move_to_law(n, i);
    if (miss <= n.trial.mismatch) continue;
    n.trial.mismatch = miss;
    n.trial.worst_pore = i;
  }
  return n.trial.mismatch;
}

/// Solves the equations for the pores that hold gas so far. Volumes then go by what flowed, so that nothing is lost
/// between pores.
bool iterate(Newton& n, double tolerance) {
  bool converged = false;
  for (int k = 0; k < n.model.options.steps.newton_limit && !converged; ++k) {
    for (int i = 0; i < n.network.pores(); ++i)
      if (n.has_capacitor(i)) set_capacitor(n, i);
    solve(n);
    const double miss = move_all(n);
    if (miss == never) break;
    converged = miss <= tolerance && n.gas_misfit <= gas_accuracy;
  }
  net_outflow(n.network, n.throat.wetting, n.trial.wetting, n.trial.wetting_outflow);
  net_outflow(n.network, n.throat.nonwetting, n.trial.nonwetting, n.trial.nonwetting_outflow);
  for (int i = 0; i < n.network.pores(); ++i) {
    const std::size_t p = to_size(i);
    if (n.model.is_counted(i) && n.trial.filling[p] != Filling::empty)
      n.trial.wetting_volume[p] = n.state.wetting_volume[p] - n.step * n.trial.wetting_outflow[p];
  }
  return converged;
}

StepChange change_of(const Newton& n) {
  std::vector<std::uint8_t> at_front(n.volume.size());
  const auto& gas = n.state.nonwetting.holds;
  for (int t = 0; t < n.network.throats(); ++t) {
    const auto [i, j] = n.network.throat_pores[to_size(t)];
    if (gas[to_size(i)] != gas[to_size(j)] && n.model.thresholds.may_open[to_size(t)])
      at_front[to_size(i)] = at_front[to_size(j)] = 1;
  }
  StepChange change;
  double moved = 0.0, front = 0.0, all = 0.0;
  for (int i = 0; i < n.network.pores(); ++i) {
    const std::size_t p = to_size(i);
    if (!n.model.is_counted(i)) continue;
    if (at_front[p]) front += n.volume[p];
    if (n.trial.filling[p] == Filling::saturated) continue;
    const double water = std::abs(n.trial.wetting_volume[p] - n.state.wetting_volume[p]);
    change.largest = std::max(change.largest, water / n.volume[p]);
    moved += water;
    all += n.volume[p];
  }
  if (moved > 0.0) change.front = moved / (front > 0.0 ? front : all);
  return change;
}

/// Gas enters a pore within the step. All its throats to other gas that the pressure has passed open with the first.
void invade(Newton& n, const PoreInvasion& invasion) {
  TwoPhaseTrial& trial = n.trial;
  const std::size_t into = to_size(invasion.into);
  const auto pressure = [&](int i) {
    if (!n.model.is_counted(i)) return 0.0;
    return local_pressure(n.model, i, std::clamp(trial.wetting_volume[to_size(i)] / n.volume[to_size(i)], 0.0, 1.0));
  };
  const auto open = [&](int throat, int other) {
    set_open(n.network, n.model, throat, true, trial.wetting_clusters, trial.nonwetting_clusters);
    set_conductance(n.network, n.model, trial.wetting_clusters, trial.nonwetting_clusters,
                    0.5 * (pressure(other) + pressure(invasion.into)), throat, n.throat);
  };
  const double potential = trial.nonwetting[to_size(invasion.from)];
  if (!trial.nonwetting_clusters.holds[into]) {
    trial.nonwetting_clusters.holds[into] = 1;
    trial.filling[into] = Filling::mixed;
    trial.wetting_volume[into] = n.volume[into];
    for (const auto [neighbour, t] : n.model.links[invasion.into]) {
      const bool may =
          t != invasion.throat && trial.nonwetting_clusters.holds[to_size(neighbour)] && n.model.thresholds.may_open[to_size(t)];
      if (may && pressure_across(n.network, n.model, t, trial.nonwetting[to_size(neighbour)], trial.wetting[into]) >
                     n.model.thresholds.entry_pressure[to_size(t)])
        open(t, neighbour);
    }
    trial.nonwetting[into] = potential;
    trial.invasions.push_back(invasion);
  }
  if (!trial.nonwetting_clusters.passes[to_size(invasion.throat)]) open(invasion.throat, invasion.from);
}

}  // namespace

TwoPhaseTrial try_two_phase_step(const PoreNetwork& network, const TwoPhaseModel& model, double step, double most_change,
                                 std::span<const double> old_volume, std::span<const double> volume,
                                 const BoundaryValues& boundary, const TwoPhaseState& state) {
  TwoPhaseTrial trial;
  const Clock assembling;
  Newton n{network,
           model,
           state,
           *model.solver,
           step,
           old_volume,
           volume,
           boundary,
           two_phase_conductances(network, model, state),
           trial,
           {},
           {},
           {}};
  start(n);
  trial.seconds_assemble += assembling.seconds();
  const double tolerance = model.options.steps.tolerance;
  bool exact = false;
  for (;;) {
    trial.converged = iterate(n, exact ? tolerance : std::max(tolerance, rough));
    trial.change = change_of(n);
    if (!trial.converged || trial.change.front > most_change) return trial;
    const std::vector<PoreInvasion> invasions = next_invasions(network, model, state, trial);
    if (invasions.empty() && exact) break;
    exact = invasions.empty();
    for (const PoreInvasion& invasion : invasions) invade(n, invasion);
  }
  for (int i = 0; i < network.pores(); ++i) trial.expansion += expansion(n, i);
  return trial;
}

}  // namespace puadem
