// A larger packing from a smaller one: copies side by side, every other one mirrored so that grains at a
// joint meet as they met the wall, then relaxed under local damping.
// Usage: bench_replicate_packing PACKING.csv NX NY NZ OUT.csv [steps=2000]

#include <fmt/format.h>

#include <cstdlib>

#include "puadem/dem/motion.hpp"
#include "puadem/dem/stress.hpp"
#include "puadem/io/packing_file.hpp"

using namespace puadem;

int main(int argc, char** argv) {
  if (argc < 6) {
    fmt::print(stderr, "usage: bench_replicate_packing PACKING.csv NX NY NZ OUT.csv [steps]\n");
    return 1;
  }
  const PackingFile packing = read_packing(argv[1]);
  const std::array<int, 3> copies{std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4])};
  const long steps = argc > 6 ? std::atol(argv[6]) : 2000;
  const Vec3 size = packing.box.size();

  Domain box = packing.box;
  for (int axis = 0; axis < 3; ++axis) box.upper[axis] = copies[static_cast<unsigned>(axis)] * size[axis];
  std::vector<Vec3> centre;
  std::vector<double> radius;
  for (int a = 0; a < copies[0]; ++a)
    for (int b = 0; b < copies[1]; ++b)
      for (int c = 0; c < copies[2]; ++c)
        for (std::size_t k = 0; k < packing.centre.size(); ++k) {
          const std::array<int, 3> copy{a, b, c};
          Vec3 x = packing.centre[k];
          for (int axis = 0; axis < 3; ++axis) {
            const int number = copy[static_cast<unsigned>(axis)];
            x[axis] = number * size[axis] + (number % 2 == 1 ? size[axis] - x[axis] : x[axis]);
          }
          centre.push_back(x);
          radius.push_back(packing.radius[k]);
        }
  Material material;
  material.youngs_modulus = 100e6;
  Particles particles = make_particles(centre, radius, material);
  GrainSystem system = make_grain_system(particles, box, std::span(&material, 1), {}, {.damping = 0.4});
  system.time_step = 1e-6;
  advance_grains(system, steps);
  evaluate_forces(system);
  const GrainMeasures m = measure(system);
  collect(system, particles);
  write_packing(argv[5], particles.position, particles.radius, box);
  fmt::print("{}: {} grains, pair stress {:.1f} Pa, coordination {:.3f}, unbalanced {:.2e}\n", argv[5], particles.size(),
             (m.pair_stress[0].x + m.pair_stress[1].y + m.pair_stress[2].z) / 3.0, m.coordination, m.unbalanced);
  return 0;
}
