// Two fluids that move so slowly that they are always at rest, beside the quasi-static invasion.
#include <algorithm>
#include <cmath>

#include "two_phase_bed.hpp"

namespace puadem::verification {

namespace {

/// A run of both through the same pressures, from one equilibrium to the next.
struct Pair {
  const Bed& bed;
  TwoPhaseModel model;
  TwoPhaseState state;
  InvasionState invasion;
};

Pair start_pair(const Bed& bed, GasKind gas, bool corner_films) {
  TwoPhaseOptions options;
  options.gas = gas;
  options.corner_films = corner_films;
  TwoPhaseModel model = driven_by_suction(bed, options, 0.0);
  TwoPhaseState state = start_two_phase(bed.network, model);
  InvasionOptions rules;
  rules.corner_films = corner_films;
  rules.trap_nonwetting = gas != GasKind::connected;
  return {bed, std::move(model), std::move(state), start_invasion(bed.network, bed.fluids, rules)};
}

void compare_at(Pair& pair, double dimensionless, Watch& watch, Csv& csv, int seed, const char* branch) {
  const double pressure = pair.bed.pressure(dimensionless);
  const long steps = watch.steps;
  pair.model.boundaries[1].schedule = Schedule::constant(-pressure);
  equilibrate_two_phase(pair.bed.network, pair.model, {}, pair.state, watch.callbacks());
  advance_to(pair.bed.network, pressure, pair.invasion);
  const std::vector<double> ours = saturation(pair.bed.network, pair.state),
                            expected = saturation(pair.bed.network, pair.invasion);
  int other_pores = 0, counted = 0;
  double largest = 0.0;
  for (int i = 0; i < pair.bed.network.pores(); ++i) {
    if (!pair.model.is_counted(i)) continue;
    ++counted;
    other_pores += pair.state.nonwetting.holds[to_size(i)] != pair.invasion.nonwetting.holds[to_size(i)];
    largest = std::max(largest, std::abs(ours[to_size(i)] - expected[to_size(i)]));
  }
  const InvasionTotals moving = totals(pair.bed.network, pair.model, pair.state), still = totals(pair.bed.network, pair.invasion);
  csv.row(seed, name_of(pair.model.options.gas), pair.model.options.corner_films ? "on" : "off", branch, dimensionless,
          moving.saturation, still.saturation, moving.trapped_wetting, still.trapped_wetting, moving.trapped_nonwetting,
          still.trapped_nonwetting, counted, other_pores, largest, watch.steps - steps);
}

}  // namespace

void write_slow_limit(const std::filesystem::path& folder) {
  LedgerFile ledger(folder, "slow_limit");
  constexpr double lowest = 3.0, highest = 12.0, step = 0.5;
  Csv csv(folder / "slow_limit.csv",
          "seed,gas,films,branch,pressure,saturation,saturation_still,trapped_wetting,trapped_wetting_still,trapped_nonwetting,"
          "trapped_nonwetting_still,pores,other_pores,largest_difference,steps");
  for (int seed = 1; seed <= 10; ++seed) {
    const Bed bed = make_bed(1000, seed);
    for (const bool corner_films : {true, false})
      for (const GasKind gas : {GasKind::connected, GasKind::incompressible}) {
        Pair pair = start_pair(bed, gas, corner_films);
        Watch watch{bed, pair.model, pair.state};
        for (double p = lowest; p <= highest; p += step) compare_at(pair, p, watch, csv, seed, "drainage");
        for (double p = highest - step; p >= 0.0; p -= step) compare_at(pair, p, watch, csv, seed, "imbibition");
        ledger.row(fmt::format("packing {}, films {}", seed, corner_films ? "on" : "off"), watch);
      }
  }
}

}  // namespace puadem::verification
