#pragma once

#include <span>
#include <vector>

#include "puadem/base/random.hpp"
#include "puadem/dem/grain_system.hpp"

namespace puadem::test {

/// A material with the constants under test, everything else plain.
inline Material material(double youngs, double poisson, double density, double friction = 0.0) {
  return {.name = "test",
          .density = density,
          .youngs_modulus = youngs,
          .poisson_ratio = poisson,
          .friction_angle = std::atan(friction)};
}

/// Grains in an empty space: a wide box whose walls are taken away.
inline GrainSystem free_grains(const Particles& particles, const Material& m, const ContactOptions& contact, double width,
                               MotionOptions motion = {}) {
  Domain box;
  box.lower = {-width, -width, -width};
  box.upper = {width, width, width};
  GrainSystem s = make_grain_system(particles, box, std::span(&m, 1), contact, motion);
  s.walls.clear();
  return s;
}

/// Grains on a jittered lattice that overlap a little, with random velocities and spins.
inline Particles shaken_lattice(int n, double spacing, const Material& m, std::uint64_t seed, double speed = 0.1) {
  Random random(seed);
  std::vector<Vec3> position;
  std::vector<double> radius;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const auto jitter = [&] { return 0.03 * spacing * random.uniform(-1, 1); };
        position.push_back({(i + 0.5) * spacing + jitter(), (j + 0.5) * spacing + jitter(), (k + 0.5) * spacing + jitter()});
        radius.push_back(spacing * random.uniform(0.46, 0.54));
      }
  Particles p = make_particles(position, radius, m);
  for (int k = 0; k < p.size(); ++k) {
    const auto any = [&] { return random.uniform(-1, 1); };
    p.velocity[to_size(k)] = speed * Vec3{any(), any(), any()};
    p.angular_velocity[to_size(k)] = speed / spacing * Vec3{any(), any(), any()};
  }
  return p;
}

}  // namespace puadem::test
