// Both schemes beside each other over the capillary number; pore units beside single tetrahedra.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "puadem/base/error.hpp"
#include "two_phase_bed.hpp"

namespace puadem::verification {

namespace {

struct Outcome {
  TwoPhaseReport report;
  double seconds = 0.0;  ///< processor time
  bool is_complete = true;
};

/// One drainage until `watch.until` is left or time is up.
Outcome drain(const Bed& bed, const TwoPhaseModel& model, double duration, Watch& watch) {
  TwoPhaseState state = watch.start;
  Outcome outcome;
  const double begin = processor_seconds();
  try {
    outcome.report = advance_two_phase(bed.network, model, duration, {}, state, watch.callbacks());
  } catch (const NumericalError& error) {  // the limit of steps
    fmt::print(stderr, "{}\n", error.what());
    outcome.is_complete = false;
  }
  outcome.seconds = processor_seconds() - begin;
  return outcome;
}

/// Capillary number of the flow while the displaced volume goes from 40 to 60 % of what it is in the end (theory 5.6).
double capillary_number_of(const Watch& watch) {
  const double displaced = 1.0 - watch.saturation;
  const auto passing = [&](double share) {
    return *std::ranges::find_if(watch.curve, [&](const auto& point) { return 1.0 - point.second >= share * displaced; });
  };
  const auto [early, before] = passing(0.4);
  const auto [late, after] = passing(0.6);
  const Fluids& fluids = watch.bed.fluids;
  return fluids.wetting.viscosity / fluids.surface_tension * watch.model.void_volume * (before - after) / (late - early) /
         watch.bed.area();
}

void write_run(Csv& csv, Csv& curves, const char* drive, double value, const Watch& watch, const Outcome& outcome) {
  const char* scheme = name_of(watch.model.options.scheme);
  const char* gas = name_of(watch.model.options.gas);
  csv.row(drive, value, capillary_number_of(watch), scheme, gas, watch.bed.network.pores(), watch.steps, outcome.report.retries,
          outcome.report.solves, outcome.seconds, watch.saturation, outcome.is_complete ? 1 : 0);
  double last = 2.0;
  for (const auto& [time, s] : watch.curve) {
    if (std::abs(s - last) < 5e-4) continue;
    curves.row(drive, value, scheme, gas, time / watch.model.time_scale, s);
    last = s;
  }
}

struct Kind {
  TwoPhaseScheme scheme;
  GasKind gas;
};
constexpr std::array<Kind, 3> kinds{{{TwoPhaseScheme::implicit, GasKind::connected},
                                     {TwoPhaseScheme::implicit, GasKind::incompressible},
                                     {TwoPhaseScheme::impes, GasKind::connected}}};

double median(std::vector<double> values) {
  const auto middle = values.begin() + size_of(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Drainage through equilibria, nothing trapped: by the rules of the flow (see write_slow_limit), then without the water that the
/// local law leaves in entered units, then by the throats alone.
void write_equilibria(const Bed& bed, int seed, double merge_ratio, Csv& curves) {
  for (const auto& [name, corner_water, body_entry] :
       {std::tuple("at rest", true, true), std::tuple("dry", false, true), std::tuple("throats", false, false)}) {
    InvasionOptions rules;
    rules.corner_films = true;
    rules.trap_wetting = false;
    rules.corner_water = corner_water;
    rules.body_entry = body_entry;
    InvasionState still = start_invasion(bed.network, bed.fluids, rules);
    for (double p = 3.0; p <= 12.0; p += 0.5) {
      advance_to(bed.network, bed.pressure(p), still);
      curves.row(seed, merge_ratio, name, p, totals(bed.network, still).saturation);
    }
  }
}

}  // namespace

void write_schemes(const std::filesystem::path& folder) {
  LedgerFile ledger(folder, "schemes");
  Csv csv(folder / "schemes.csv",
          "drive,value,capillary_number,scheme,gas,pores,steps,retries,solves,seconds,saturation,complete");
  Csv curves(folder / "scheme_curves.csv", "drive,value,scheme,gas,time,saturation");
  const Bed bed = make_bed(500, 1);
  for (const Kind& kind : kinds) {
    TwoPhaseOptions options;
    options.scheme = kind.scheme;
    options.gas = kind.gas;
    options.steps.step_limit = 100'000;
    const auto run = [&](const char* drive, double value, const TwoPhaseModel& model, double until, double duration) {
      Watch watch{bed, model, start_two_phase(bed.network, model)};
      watch.until = until;
      watch.keeps_curve = true;
      const Outcome outcome = drain(bed, model, duration, watch);
      write_run(csv, curves, drive, value, watch, outcome);
      ledger.row(fmt::format("{} {}", drive, value), watch);
      fmt::print(stderr, "{} {} {} {}: {} steps, {:.1f} s, S = {:.4f}\n", drive, value, name_of(kind.scheme), name_of(kind.gas),
                 watch.steps, outcome.seconds, watch.saturation);
    };
    for (const double suction : {20.0, 10.0, 7.0, 5.5})
      run("suction", suction, driven_by_suction(bed, options, bed.pressure(suction)), suction > 6.0 ? 0.15 : 0.4, 1e9);
    for (const double capillary_number : {1e-3, 1e-4, 1e-5})
      run("rate", capillary_number, driven_by_rate(bed, options, capillary_number), 0.5, 1e9);
  }
}

void write_step_lengths(const std::filesystem::path& folder) {
  LedgerFile ledger(folder, "step_lengths");
  Csv csv(folder / "step_lengths.csv", "suction,scheme,front_change,pores,steps,retries,solves,seconds,saturation");
  Csv curves(folder / "step_length_curves.csv", "suction,scheme,front_change,time,saturation");
  const Bed bed = make_bed(2000, 1);
  for (const double suction : {20.0, 10.0}) {
    const auto run = [&](TwoPhaseScheme scheme, double front_change) {
      TwoPhaseOptions options;
      options.scheme = scheme;
      options.gas = GasKind::connected;
      options.steps.front_change = front_change;
      const TwoPhaseModel model = driven_by_suction(bed, options, bed.pressure(suction));
      Watch watch{bed, model, start_two_phase(bed.network, model)};
      watch.until = 0.15;
      watch.keeps_curve = true;
      const Outcome outcome = drain(bed, model, 1e9, watch);
      csv.row(suction, name_of(scheme), front_change, bed.network.pores(), watch.steps, outcome.report.retries,
              outcome.report.solves, outcome.seconds, watch.saturation);
      for (const auto& [time, s] : watch.curve) curves.row(suction, name_of(scheme), front_change, time / model.time_scale, s);
      ledger.row(fmt::format("suction {} front_change {}", suction, front_change), watch);
      fmt::print(stderr, "suction {} {} front_change {}: {} steps, {:.1f} s\n", suction, name_of(scheme), front_change,
                 watch.steps, outcome.seconds);
    };
    for (const double front_change : {0.005, 0.00125}) run(TwoPhaseScheme::impes, front_change);
    for (const double front_change : {0.02, 0.01, 0.005, 0.0025, 0.00125}) run(TwoPhaseScheme::implicit, front_change);
  }
}

void write_merging(const std::filesystem::path& folder) {
  LedgerFile ledger(folder, "merging");
  Csv csv(folder / "merging.csv", "seed,merge_ratio,pores,throats,steps,solves,seconds,body_pressure,entry_pressure");
  Csv curves(folder / "merging_curves.csv", "seed,merge_ratio,run,x,saturation");
  for (int seed = 1; seed <= 2; ++seed)
    for (const double ratio : {std::numeric_limits<double>::infinity(), 0.9, 0.8}) {
      NetworkOptions network_options;
      network_options.merge_ratio = ratio;
      const Bed bed = make_bed(250, seed, network_options);
      const TwoPhaseModel model = driven_by_suction(bed, {}, bed.pressure(10.0));
      Watch watch{bed, model, start_two_phase(bed.network, model)};
      watch.until = 0.15;
      watch.keeps_curve = true;
      const Outcome outcome = drain(bed, model, 1e9, watch);
      csv.row(seed, ratio, bed.network.pores(), bed.network.throats(), watch.steps, outcome.report.solves, outcome.seconds,
              median(model.thresholds.body_pressure) / bed.pressure(1.0),
              median(model.thresholds.entry_pressure) / bed.pressure(1.0));
      ledger.row(fmt::format("packing {}, merge ratio {}", seed, ratio), watch);
      for (const auto& [time, s] : watch.curve) curves.row(seed, ratio, "at once", time, s);
      write_equilibria(bed, seed, ratio, curves);
    }
}

}  // namespace puadem::verification
