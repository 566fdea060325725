#include "triaxial.hpp"

#include <cmath>

#include "puadem/dem/motion.hpp"

namespace puadem::verification {

TriaxialBalance run_triaxial(const TriaxialSetUp& set_up) {
  const double diameter = 1e-3;
  const Material grains{
      .name = "grains", .density = 2650, .youngs_modulus = 2e8, .poisson_ratio = 0.2, .friction_angle = std::atan(0.5)};
  ContactOptions contact;
  contact.law = set_up.law;
  contact.wall_friction = 0.2;
  PackingSource source;
  source.grading.classes = {{0.8 * diameter, 1.2 * diameter, 1.0}};
  source.count = set_up.count;
  source.periodic = {set_up.is_periodic, set_up.is_periodic, set_up.is_periodic};
  CompactionOptions compaction;
  compaction.stress = set_up.stress;
  compaction.friction_angle = std::atan(set_up.compaction_friction);
  compaction.unbalanced = 5e-3;
  GrainSystem s = *make_packing(source, std::span(&grains, 1), contact, compaction).system;
  const double rate = set_up.inertial_number * std::sqrt(set_up.stress / grains.density) / diameter;
  set_box_rate(s, {});
  s.motion.strain_with_box = set_up.grains_follow_box;
  s.motion.damping = 0.1;
  evaluate_forces(s);
  s.time_step = set_up.step_share * critical_time_step(s).critical;

  TriaxialBalance balance;
  open_energy_book(s);
  balance.start = energies(s);
  balance.time_step = s.time_step;
  double solid = 0.0;
  for (int k = 0; k < s.owned; ++k) solid += mass_of(s.record[to_size(k)]) / grains.density;
  balance.void_ratio = s.domain.volume() / solid - 1.0;
  const long interval = 100;
  balance.steps = interval * std::lround(set_up.axial_strain / rate / s.time_step / static_cast<double>(interval));
  BoxProgram program = triaxial(set_up.stress, rate, 2 * rate);
  program.relaxation_steps = 15;
  balance.rows = run_program(s, program, balance.steps, interval);
  balance.end = energies(s);
  return balance;
}

}  // namespace puadem::verification
