#include "two_phase_bed.hpp"

#include <sys/resource.h>

#include <algorithm>

#include "dense_packing.hpp"
#include "flow/two_phase_samples.hpp"
#include "puadem/dem/grain_statistics.hpp"

namespace puadem::verification {

namespace {

FlowBoundary gas_on_top(const Bed& bed) {
  return {"top", face_pores(bed.network, 5), FluidPhase::nonwetting, FlowBoundary::Kind::pressure, Schedule::constant(0.0), {}};
}

FlowBoundary water_below(const Bed& bed, FlowBoundary::Kind kind, double value) {
  return {"bottom", face_pores(bed.network, 4), FluidPhase::wetting, kind, Schedule::constant(value), {}};
}

}  // namespace

double Bed::pressure(double dimensionless) const {
  return dimensionless * fluids.surface_tension / statistics_of(spheres.radius).mean_radius;
}

Bed bed_of(testing::Spheres spheres, const NetworkOptions& options) {
  Bed bed;
  bed.network = build_pore_network(spheres.centre, spheres.radius, spheres.domain, options);
  bed.films = throat_films(bed.network, PackingSites(spheres.centre, spheres.radius, spheres.domain), bed.fluids.contact_angle);
  bed.spheres = std::move(spheres);
  return bed;
}

Bed make_bed(int grains, int seed, const NetworkOptions& options) {
  return bed_of(dense_packing(grains, {1, 1, 1}, {true, true, false}, seed), options);
}

TwoPhaseModel driven_by_suction(const Bed& bed, const TwoPhaseOptions& options, double suction) {
  return make_two_phase_model(bed.network, bed.fluids, options,
                              {gas_on_top(bed), water_below(bed, FlowBoundary::Kind::pressure, -suction)}, bed.films);
}

TwoPhaseModel driven_by_rate(const Bed& bed, const TwoPhaseOptions& options, double capillary_number) {
  const double rate = capillary_number * bed.fluids.surface_tension / bed.fluids.wetting.viscosity * bed.area();
  FlowBoundary gas = gas_on_top(bed);
  gas.initial_gas_fraction = 0.5;
  return make_two_phase_model(bed.network, bed.fluids, options, {gas, water_below(bed, FlowBoundary::Kind::flow_rate, -rate)},
                              bed.films);
}

const char* name_of(TwoPhaseScheme scheme) { return scheme == TwoPhaseScheme::impes ? "impes" : "implicit"; }

const char* name_of(GasKind gas) {
  return gas == GasKind::connected ? "connected" : gas == GasKind::ideal ? "ideal" : "incompressible";
}

bool Watch::look(const TwoPhaseState& state) {
  ++steps;
  ledger = std::max(ledger, testing::ledger_error(bed.network, model, start, state));
  for (int i = 0; i < bed.network.pores(); ++i) {
    if (!model.is_counted(i)) continue;
    const double s = state.wetting_volume[to_size(i)] / bed.network.pore_volume[to_size(i)];
    least = std::min(least, s);
    most = std::max(most, s);
  }
  saturation = totals(bed.network, model, state).saturation;
  if (keeps_curve) curve.emplace_back(state.time, saturation);
  return saturation > until;
}

TwoPhaseCallbacks Watch::callbacks() {
  TwoPhaseCallbacks callbacks;
  callbacks.on_step = [this](const TwoPhaseState& state) { return look(state); };
  return callbacks;
}

void LedgerFile::row(const std::string& run, const Watch& watch) {
  csv.row('"' + run + '"', name_of(watch.model.options.scheme), name_of(watch.model.options.gas), watch.steps, watch.ledger,
          watch.least, watch.most);
}

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace puadem::verification
