// What liquid bridges cost in the grain engine: the same packing dry and wet, in turns.
// Usage: bench_bridges PACKING.csv [steps=50] [threads=1] [oedometer speed in heights a second=0] [V/R^3=1e-2]
// Materials and time step of bench_dem_throughput; bridges of that volume at all contacts, then wherever one can stand.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "puadem/dem/bridge_exchange.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/io/packing_file.hpp"

using namespace puadem;

namespace {

constexpr int rounds = 30;
constexpr long steps_to_rest = 3000;

double seconds_for(GrainSystem& system, long steps) {
  const auto start = std::chrono::steady_clock::now();
  advance_grains(system, steps);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Best of many short rounds: what other work on the machine disturbs least.
double best(const std::vector<double>& values) { return std::ranges::min(values); }

void compare(const GrainSystem& packing, long steps, double volume, BridgeFormation formation) {
  GrainSystem dry = packing, wet = packing;
  wet_grains(wet, bridge_model(0.0728, 0.0, BridgeControl::volume), {.formation = formation}, {.each = volume});
  for (GrainSystem* system : {&dry, &wet}) {  // to rest under what the bridges add
    system->motion.damping = 0.4;
    advance_grains(*system, steps_to_rest);
  }
  const BridgeMeasures start = measure_bridges(wet);
  std::vector<double> dry_time, wet_time;
  for (int round = 0; round < rounds; ++round) {
    dry_time.push_back(seconds_for(dry, steps));
    wet_time.push_back(seconds_for(wet, steps));
  }
  const BridgeMeasures end = measure_bridges(wet);
  const double particle_steps = 1e-6 * static_cast<double>(dry.owned) * static_cast<double>(steps);
  fmt::print(
      "{:<15} {:.2f} bridges a grain, {} formed and {} ruptured: dry {:.2f} Mps/s, wet {:.2f} Mps/s, wet / dry time {:.2f}\n",
      formation == BridgeFormation::at_contact ? "at contacts" : "at any distance",
      static_cast<double>(start.bridges) / dry.owned, end.formed - start.formed, end.ruptured - start.ruptured,
      particle_steps / best(dry_time), particle_steps / best(wet_time), best(wet_time) / best(dry_time));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_bridges PACKING.csv [steps] [threads] [oedometer speed] [V/R^3]\n");
    return 1;
  }
  const long steps = argc > 2 ? std::atol(argv[2]) : 50;
  set_threads(argc > 3 ? std::atoi(argv[3]) : 1);
  const double oedometer = argc > 4 ? std::atof(argv[4]) : 0.0, amount = argc > 5 ? std::atof(argv[5]) : 1e-2;

  const PackingFile packing = read_packing(argv[1]);
  Material material;
  material.youngs_modulus = 100e6;
  const Particles particles = make_particles(packing.centre, packing.radius, material);
  GrainSystem dry = make_grain_system(particles, packing.box, std::span(&material, 1), {}, {});
  dry.time_step = 1e-6;
  if (oedometer > 0.0) set_box_rate(dry, {0, 0, -oedometer * packing.box.size().z});
  evaluate_forces(dry);
  double radius = 0.0;
  for (const double r : packing.radius) radius += r / dry.owned;
  fmt::print("{} grains, {} threads, best of {} rounds of {} steps\n", dry.owned, threads(), rounds, steps);
  for (const auto formation : {BridgeFormation::at_contact, BridgeFormation::at_any_distance})
    compare(dry, steps, amount * radius * radius * radius, formation);
  return 0;
}
