#include "puadem/flow/two_phase_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/flow/two_phase_newton.hpp"

namespace puadem {

namespace {

using Filling = PoreFilling;

/// Least share of a pore's wetting fluid that one iteration leaves.
constexpr double least_left = 0.2;
/// By how much of its volume a full pore may be too full, an emptied one too empty: the next step takes it back.
constexpr double overfill = 1e-9;
/// The same while gas still looks for pores to enter.
constexpr double rough_overfill = 1e-4;
/// Largest error of the volume of ideal gas, over its pore's.
constexpr double gas_accuracy = 1e-12;
/// Slope of the local law over p_thr above which an iteration goes along the pressure, below along the volume.
constexpr double steep = 2.0;
/// Tolerance of the iterations while gas still finds pores to enter; the last are exact.
constexpr double rough = 1e-2;
/// Tolerances of the linear solver in rough and in exact iterations. They are of all pressures together, in the norm of the
/// power they dissipate: corner films, which conduct less by many orders, need the more.
constexpr double rough_linear = 1e-7, exact_linear = 1e-14;

/// By how much more a step may move, over the most it may in the end, before gas has entered pores: what these give, the rest
/// need not. (Without it most attempts were taken back that would have ended well within the limit.)
constexpr double not_yet_entered = 2.0;

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
  const bool leaves = filling == Filling::full ? now > n.law(i, 1.0) : now < n.law(i, 0.0);
  const double miss = std::abs(n.predicted[p] - n.trial.wetting_volume[p]) / n.volume[p];
  const bool misses = miss > (n.is_rough ? rough_overfill : overfill);
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
  const double least = least_left * water;
  // Where the law is steep, the pressure knows the saturation better than the volume does.
  if (-n.law_slope(i, water / volume) > steep * scale && now > n.law(i, 1.0)) {
    const double by_law = volume * local_saturation(n.model, n.trial.nonwetting_clusters, i, now);
    water = std::max(by_law, least);
    return by_law < least ? not_yet : std::abs(predicted - water) / volume;
  }
  water = std::clamp(predicted, least, volume);
  if (predicted < least) return not_yet;
  const double miss = std::abs(now - n.law(i, water / volume)) / scale;
  return miss / std::max(-n.law_slope(i, water / volume) / scale, 1.0);
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

/// Solves the equations for the pores that hold gas so far.
bool iterate(Newton& n, double tolerance) {
  bool converged = false;
  n.is_rough = tolerance > n.model.options.steps.tolerance;
  for (int k = 0; k < n.model.options.steps.newton_limit && !converged; ++k) {
    for (int i = 0; i < n.network.pores(); ++i)
      if (n.has_capacitor(i)) set_capacitor(n, i);
    try {
      solve_newton(n, n.is_rough ? rough_linear : exact_linear);
    } catch (const NumericalError&) {
      break;  // a rate that the fluid within reach cannot meet has no solution: the step fails
    }
    const double miss = move_all(n);
    if (miss == never) break;
    converged = miss <= tolerance && n.gas_misfit <= gas_accuracy;
  }
  return converged;
}

/// Volumes by what flowed, so that nothing is lost between pores. False where a pore would have given more than it had.
bool go_by_flows(Newton& n) {
  net_outflow(n.network, n.throat.wetting, n.trial.wetting, n.trial.wetting_outflow);
  net_outflow(n.network, n.throat.nonwetting, n.trial.nonwetting, n.trial.nonwetting_outflow);
  bool has_enough = true;
  for (int i = 0; i < n.network.pores(); ++i) {
    const std::size_t p = to_size(i);
    if (n.model.is_counted(i) && n.trial.filling[p] != Filling::empty)
      n.trial.wetting_volume[p] = n.state.wetting_volume[p] - n.step * (n.trial.wetting_outflow[p] + n.taken(i));
    if (n.trial.filling[p] == Filling::mixed && n.trial.wetting_volume[p] <= 0.0) has_enough = false;
  }
  return has_enough;
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
    return n.law(i, std::clamp(trial.wetting_volume[to_size(i)] / n.volume[to_size(i)], 0.0, 1.0));
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
    trial.entered[into] = invasion.crossing;
    trial.invasions.push_back(invasion);
  }
  if (!trial.nonwetting_clusters.passes[to_size(invasion.throat)]) open(invasion.throat, invasion.from);
}

void close_throat(Newton& n, int throat) {
  set_open(n.network, n.model, throat, false, n.trial.wetting_clusters, n.trial.nonwetting_clusters);
  set_conductance(n.network, n.model, n.trial.wetting_clusters, n.trial.nonwetting_clusters, 0.0, throat, n.throat);
}

}  // namespace

TwoPhaseTrial try_two_phase_step(const PoreNetwork& network, const TwoPhaseModel& model, double step, double most_change,
                                 bool in_order, const StepPores& pores, const BoundaryValues& boundary,
                                 const TwoPhaseState& state) {
  TwoPhaseTrial trial;
  const Clock assembling;
  Newton n{network,
           model,
           state,
           *model.solver,
           step,
           !std::isfinite(most_change),
           pores.old_volume,
           pores.volume,
           pores.uptake,
           boundary,
           two_phase_conductances(network, model, state),
           trial,
           {},
           {},
           {}};
  start_newton(n);
  pressure_system(model, n.to_rest).forget();  // a step that is taken up from a checkpoint has no other solves before it
  trial.seconds_assemble += assembling.seconds();
  const double tolerance = model.options.steps.tolerance;
  bool exact = false;
  for (;;) {
    trial.converged = iterate(n, exact ? tolerance : std::max(tolerance, rough));
    if (exact) trial.converged = go_by_flows(n) && trial.converged;
    trial.change = change_of(n);
    if (!trial.converged || trial.change.front > (exact ? 1.0 : not_yet_entered) * most_change) return trial;
    const std::vector<PoreInvasion> invasions = next_invasions(network, model, state, trial);
    for (const PoreInvasion& invasion : invasions) invade(n, invasion);
    const bool was_exact = exact;
    exact = invasions.empty();
    if (!was_exact || !exact) continue;
    const FillingsWithinStep fillings = fillings_within_step(network, model, state, trial);
    trial.in_order = std::min(trial.in_order, fillings.in_order);
    if (in_order && trial.in_order < 1.0) return trial;
    if (fillings.closed_throats.empty()) break;
    for (const int t : fillings.closed_throats) close_throat(n, t);
  }
  for (int i = 0; i < network.pores(); ++i) trial.expansion += gas_expansion(n, i);
  return trial;
}

}  // namespace puadem
