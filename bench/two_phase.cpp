// Cost of dynamic two-phase flow: 2 kPa of suction applied at once to a saturated bed, corner films on, until 12.6 % of the
// water is left, on one thread. Prints steps, linear solves and processor seconds for beds of growing size.
// Usage: bench_two_phase [implicit | impes] [connected | incompressible] [largest number of grains]

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "puadem/flow/two_phase_flow.hpp"
#include "puadem/network/pore_units.hpp"
#include "shaken_bed.hpp"

using namespace puadem;

namespace {

struct Cost {
  double grains, seconds, steps;
};

/// One run.
Cost run(const ShakenBed& bed, const TwoPhaseOptions& options) {
  constexpr double suction = 2000.0, left = 0.126;
  const PoreNetwork network = build_pore_network(bed.centre, bed.radius, bed.box, {});
  const double begin = processor_seconds();
  const PackingSites sites(bed.centre, bed.radius, bed.box);
  std::vector<FlowBoundary> boundaries(2);
  boundaries[0] = {"top", face_pores(network, 5), FluidPhase::nonwetting, FlowBoundary::Kind::pressure, Schedule::constant(0.0),
                   {}};
  boundaries[1] = {
      "bottom", face_pores(network, 4), FluidPhase::wetting, FlowBoundary::Kind::pressure, Schedule::constant(-suction), {}};
  const TwoPhaseModel model =
      make_two_phase_model(network, Fluids{}, options, std::move(boundaries), throat_films(network, sites, 0.0));
  TwoPhaseState state = start_two_phase(network, model);
  const double started = processor_seconds();
  long invasions = 0;
  TwoPhaseCallbacks callbacks;
  callbacks.on_event = [&](const TwoPhaseEvent& event) { invasions += event.kind == InvasionEventKind::drain; };
  callbacks.on_step = [&](const TwoPhaseState& now) { return totals(network, model, now).saturation > left; };
  const TwoPhaseReport report = advance_two_phase(network, model, 1e6 * model.time_scale, {}, state, callbacks);
  const double seconds = processor_seconds() - started;
  const double wall = report.seconds_assemble + report.seconds_solve + report.seconds_events;
  const auto n = static_cast<double>(report.steps);
  std::printf("%7d %7d %6.3f %6.3f %6ld %5ld %7ld %8ld %6.2f %8.2f %7.1f %7.1f   %3.0f %3.0f %3.0f\n", size_of(bed.radius),
              network.pores(), started - begin, totals(network, model, state).saturation, report.steps, report.retries,
              report.solves, invasions, n / static_cast<double>(invasions), seconds, 1e3 * seconds / n,
              1e3 * seconds / static_cast<double>(report.solves), 100 * report.seconds_assemble / wall,
              100 * report.seconds_solve / wall, 100 * report.seconds_events / wall);
  std::fflush(stdout);
  return {static_cast<double>(bed.radius.size()), seconds, n};
}

}  // namespace

int main(int argc, char** argv) {
  set_threads(1);
  TwoPhaseOptions options;
  options.scheme = argc > 1 && std::strcmp(argv[1], "impes") == 0 ? TwoPhaseScheme::impes : TwoPhaseScheme::implicit;
  options.gas = argc > 2 && std::strcmp(argv[2], "incompressible") == 0 ? GasKind::incompressible : GasKind::connected;
  std::printf(
      " grains   pores  start      S  steps retry  solves invasions st/inv       s ms/step ms/solve  assemble/solve/events %%\n");
  const int most = argc > 3 ? std::atoi(argv[3]) : 10000;
  std::optional<Cost> last;
  for (const int grains : {1000, 2000, 4000, 10000}) {
    if (grains > most) break;
    const Cost cost = run(make_shaken_bed(grains, false), options);
    const auto exponent = [&](double ratio) { return std::log(ratio) / std::log(cost.grains / last->grains); };
    if (last)
      std::printf("        grows with the grains to the power of %.2f: steps %.2f, cost per step %.2f\n",
                  exponent(cost.seconds / last->seconds), exponent(cost.steps / last->steps),
                  exponent(cost.seconds / last->seconds * last->steps / cost.steps));
    last = cost;
  }
}
