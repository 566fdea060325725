// Particle-steps a second of the grain engine on a packing at rest, and under slow oedometric compression.
// Usage: bench_dem_throughput PACKING.csv [steps=2000] [threads=1] [oedometer speed in heights a second=0]
// Hertz-Mindlin, E = 100 MPa, nu = 0.3, 2650 kg/m3, 30 degrees between grains, smooth walls, dt = 1 us.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numbers>

#include "puadem/dem/motion.hpp"
#include "puadem/dem/neighbour_list.hpp"
#include "puadem/dem/stress.hpp"
#include "puadem/io/packing_file.hpp"

using namespace puadem;

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: bench_dem_throughput PACKING.csv [steps] [threads] [oedometer speed]\n");
    return 1;
  }
  const long steps = argc > 2 ? std::atol(argv[2]) : 2000;
  set_threads(argc > 3 ? std::atoi(argv[3]) : 1);
  const double oedometer = argc > 4 ? std::atof(argv[4]) : 0.0;

  PackingFile packing = read_packing(argv[1]);
  Material material;
  material.youngs_modulus = 100e6;
  const Particles particles = make_particles(packing.centre, packing.radius, material);
  GrainSystem system = make_grain_system(particles, packing.box, std::span(&material, 1), {}, {});
  system.time_step = 1e-6;
  const double height = packing.box.size().z;
  packing = {};
  if (oedometer > 0.0) set_box_rate(system, {0, 0, -oedometer * height});
  const auto print_state = [&](const char* when) {
    evaluate_forces(system);
    const GrainMeasures m = measure(system);
    double walls = 0.0;
    for (const double stress : m.wall_stress) walls += stress / 6.0;
    fmt::print("{}: pair stress {:.4f} Pa, wall stress {:.4f} Pa, unbalanced {:.3e}, coordination {:.3f}, {} contacts\n", when,
               (m.pair_stress[0].x + m.pair_stress[1].y + m.pair_stress[2].z) / 3.0, walls, m.unbalanced, m.coordination,
               m.contacts);
    return m.contacts;
  };
  print_state("step 0");
  advance_grains(system, steps / 10);  // warms the caches and settles the list
  const std::clock_t cpu_start = std::clock();
  const auto start = std::chrono::steady_clock::now();
  advance_grains(system, steps);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double cpu = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  const int contacts = print_state("end");
  constexpr int builds = 5;
  const int built = system.list_builds;
  const auto build_start = std::chrono::steady_clock::now();
  for (int k = 0; k < builds; ++k) build_neighbour_list(system);
  const double build = std::chrono::duration<double>(std::chrono::steady_clock::now() - build_start).count() / builds;
  const double particle_steps = static_cast<double>(system.owned) * static_cast<double>(steps);
  fmt::print(
      "{} grains, {} steps, {} threads: {:.3f} s, {:.3f} CPU s, {:.2f} Mps/s, {:.2f} ns a contact, {} list builds worth {:.1f} "
      "steps each\n",
      system.owned, steps, threads(), seconds, cpu, 1e-6 * particle_steps / seconds,
      1e9 * seconds / (static_cast<double>(contacts) * static_cast<double>(steps)), built,
      build * static_cast<double>(steps) / seconds);
  return 0;
}
