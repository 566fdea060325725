#include "puadem/coupling/ready_grains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem {

LoadingScale loading_scale(const Case& c, const GrainSystem& s, const Particles& particles, const GrainMeasures& m) {
  LoadingScale scale;
  double mass = 0.0, volume = 0.0;
  for (int k = 0; k < particles.size(); ++k) {
    const double r = particles.radius[to_size(k)];
    scale.diameter += 2.0 * r / particles.size();
    mass += particles.mass[to_size(k)];
    volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    scale.youngs_modulus = std::max(scale.youngs_modulus, c.materials[to_size(particles.material[to_size(k)])].youngs_modulus);
  }
  scale.density = mass / volume;
  scale.size = s.domain.size();
  scale.stress = axis_stress(s, m);
  scale.bridge_stress = -trace(m.bridge_stress) / 3.0;
  return scale;
}

void hold_stress(int face, double stress, const LoadingScale& scale, GrainSystem& grains) {
  constexpr double speed_share = 0.3;  // of the speed of a grain that the stress would set moving
  const int axis = axis_of(face);
  for (Wall& wall : grains.walls) {
    if (wall.face != face) continue;
    wall.target = stress;
    wall.area = scale.size[(axis + 1) % 3] * scale.size[(axis + 2) % 3];
    wall.servo_stress = ServoStress::total;
    wall.speed_limit = speed_share * std::sqrt(stress / scale.density);
  }
}

GrainSystem& ready_grains(const Case& c, State& state, const Observer& observer) {
  require(state.particles.size() > 0,
          "a stage that loads the grains needs some: put a stage \"compact\" before it or name a packing file in grains.file");
  if (!state.grains) {
    state.grains = make_grain_system(state.particles, state.domain, c.materials, c.contact, {});
    if (observer.message) observer.message("contacts begin without shear: the packing knows nothing of their history");
  }
  GrainSystem& s = *state.grains;
  s.pairs = material_pairs(c.materials, c.contact);
  set_box_rate(s, {});
  for (Wall& wall : s.walls) {
    wall.target.reset();
    wall.slide = wall.velocity = wall.last_velocity = {};
    wall.friction = c.contact.wall_friction;
  }
  s.motion.gravity = c.motion.gravity;
  s.motion.safety = c.motion.safety;
  evaluate_forces(s);
  return s;
}

}  // namespace puadem
