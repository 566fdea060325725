#include "puadem/dem/grain_system.hpp"

#include <algorithm>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/dem/bridge_forces.hpp"
#include "puadem/dem/contact_forces.hpp"

namespace puadem {

GrainSystem make_grain_system(const Particles& particles, const Domain& domain, std::span<const Material> materials,
                              const ContactOptions& contact, const MotionOptions& motion) {
  require(particles.size() > 0, "the grain engine needs at least one grain");
  const double largest = *std::max_element(particles.radius.begin(), particles.radius.end());
  for (int axis = 0; axis < 3; ++axis) {
    const double width = domain.size()[axis];
    require(width > 0.0, "the box is {} m wide along axis {}: it must be positive", width, axis);
    require(!domain.periodic[static_cast<unsigned>(axis)] || width > 5.0 * largest,
            "the periodic box is {:.4g} m wide along axis {}: it must exceed 2.5 diameters of the largest grain, {:.4g} m", width,
            axis, 5.0 * largest);
  }
  for (int k = 0; k < particles.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const double x = particles.position[to_size(k)][axis];
      require(x >= domain.lower[axis] && x <= domain.upper[axis],
              "grain {}: its centre lies outside the box, {} m along axis {} is not in [{}, {}] m", k, x, axis,
              domain.lower[axis], domain.upper[axis]);
    }
  GrainSystem s;
  s.domain = domain;
  s.walls = box_walls(domain, contact.wall_friction);
  s.pairs = material_pairs(materials, contact);
  s.contact = contact;
  s.law = contact_law(contact.law);
  s.motion = motion;
  s.owned = particles.size();
  s.identity.resize(to_size(s.owned));
  std::iota(s.identity.begin(), s.identity.end(), 0);
  for (int k = 0; k < s.owned; ++k) {
    const std::size_t i = to_size(k);
    require(particles.material[i] >= 0 && particles.material[i] < s.pairs.materials, "grain {}: material {} of {} materials", k,
            particles.material[i], s.pairs.materials);
    const Vec3 &x = particles.position[i], &v = particles.velocity[i], &w = particles.angular_velocity[i];
    s.record.push_back({Lanes{x.x, x.y, x.z, particles.radius[i]}, Lanes{v.x, v.y, v.z, particles.mass[i]},
                        Lanes{0.0, 0.0, 0.0, static_cast<double>(particles.material[i])},
                        Lanes{w.x, w.y, w.z, particles.inertia[i]}});
  }
  return s;
}

void collect_places(const GrainSystem& s, Particles& particles) {
  const Vec3 size = s.domain.size();
  for (int k = 0; k < s.owned; ++k) {
    Vec3& x = particles.position[to_size(s.identity[to_size(k)])];
    x = vec3(s.record[to_size(k)].place);
    for (int axis = 0; axis < 3; ++axis)
      if (s.domain.periodic[static_cast<unsigned>(axis)])
        x[axis] -= size[axis] * std::floor((x[axis] - s.domain.lower[axis]) / size[axis]);
  }
}

void collect(const GrainSystem& s, Particles& particles) {
  collect_places(s, particles);
  for (int k = 0; k < s.owned; ++k) {
    const std::size_t i = to_size(s.identity[to_size(k)]);
    const GrainRecord& r = s.record[to_size(k)];
    particles.velocity[i] = vec3(r.drift);
    particles.angular_velocity[i] = vec3(r.spin);
    if (s.row_start.empty()) continue;
    const SlotSum sum = sum_slots(s.slot.data(), s.row.data(), s.row_start[to_size(k)], s.row_start[to_size(k) + 1]);
    particles.force[i] = vec3(sum.force) + bridge_pull_on(s, k);
    particles.torque[i] = -radius_of(r) * vec3(sum.moment);
    for (int e = s.row_start[to_size(k)]; e < s.row_start[to_size(k) + 1] && !s.roll_slot.empty(); ++e) {
      const int place = s.row[to_size(e)];
      particles.torque[i] += (place % 2 == 1 ? 1.0 : -1.0) * vec3(s.roll_slot[to_size(place / 2)].moment);
    }
    if (!s.external_force.empty()) particles.force[i] += s.external_force[i];
    particles.force[i] += mass_of(r) * s.motion.gravity;
  }
}

}  // namespace puadem
