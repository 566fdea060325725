#include "gas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem/support.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem::verification {

GasRun run_gas(const GasSetUp& set_up) {
  const double spacing = 1.25e-3, speed = 0.2;
  const Material m = test::material(1e7, 0.3, 2650);
  Particles p = test::shaken_lattice(set_up.grains_across, spacing, m, 3, speed);
  std::vector<double> radius = p.radius;
  for (double& r : radius) r *= 0.8;  // room between them
  const std::vector<Vec3> velocity = p.velocity;
  p = make_particles(p.position, radius, m);
  p.velocity = velocity;
  Domain box;
  box.upper = set_up.grains_across * spacing * Vec3{1, 1, 1};
  box.periodic = {true, true, false};
  ContactOptions contact;
  contact.law = set_up.law;
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), contact, {});

  const double mean_radius = 0.4 * spacing, mass = 4.0 / 3.0 * std::numbers::pi * std::pow(mean_radius, 3) * m.density / 2;
  const double stiffness = 4.0 / 3.0 * m.youngs_modulus / 1.82 * std::sqrt(mean_radius / 2);
  const double hertz_time = 2.943275 / speed * std::pow(5 * mass * speed * speed / (4 * stiffness), 0.4);
  const double linear_time = std::numbers::pi * std::sqrt(mass / (m.youngs_modulus * mean_radius));
  s.time_step = (set_up.law == ContactOptions::Law::hertz_mindlin ? hertz_time : linear_time) / set_up.steps_per_contact;

  evaluate_forces(s);
  const double start = energies(s).stored();
  GasRun run;
  constexpr long interval = 25;
  for (long step = 0; step < set_up.steps; step += interval) {
    advance_grains(s, interval);
    evaluate_forces(s);
    const Energies now = energies(s);
    run.end_error = std::abs(now.stored() / start - 1.0);
    run.largest_error = std::max(run.largest_error, run.end_error);
    run.largest_stored = std::max(run.largest_stored, now.normal / start);
  }
  return run;
}

}  // namespace puadem::verification
