#include "puadem/dem/energy.hpp"

#include <cassert>

#include "puadem/dem/bridge_forces.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/contact_forces.hpp"
#include "puadem/dem/contacts.hpp"

namespace puadem {

namespace {

double shear_energy(const LaneVec3& h, int lane, double stiffness) {
  if (stiffness == 0.0) return 0.0;
  return (h.x[lane] * h.x[lane] + h.y[lane] * h.y[lane] + h.z[lane] * h.z[lane]) / (2.0 * stiffness);
}

/// Velocities stand half a step behind the places; half a step of the present force brings them up.
double kinetic_energy(const GrainSystem& s) {
  double energy = 0.0;
  const double half = 0.5 * s.time_step;
  const Vec3 size = s.domain.size();
  for (int k = 0; k < s.owned; ++k) {
    const GrainRecord& r = s.record[to_size(k)];
    const int begin = s.row_start[to_size(k)], end = s.row_start[to_size(k) + 1];
    const SlotSum sum = sum_slots(s.slot.data(), s.row.data(), begin, end);
    Vec3 force = vec3(sum.force) + bridge_pull_on(s, k) + mass_of(r) * s.motion.gravity,
         torque = -radius_of(r) * vec3(sum.moment);
    if (!s.external_force.empty()) force += s.external_force[to_size(s.identity[to_size(k)])];
    if (!s.roll_slot.empty())
      for (int e = begin; e < end; ++e) {
        const int place = s.row[to_size(e)];
        torque += (place % 2 == 1 ? 1.0 : -1.0) * vec3(s.roll_slot[to_size(place / 2)].moment);
      }
    Vec3 velocity = vec3(r.drift) + (half / mass_of(r)) * force;
    if (s.motion.strain_with_box)
      for (int axis = 0; axis < 3; ++axis)
        velocity[axis] -= s.box_rate[axis] * (r.place[axis] - s.domain.lower[axis]) / size[axis];
    const Vec3 spin = vec3(r.spin) + (half / inertia_of(r)) * torque;
    energy += 0.5 * mass_of(r) * squared_norm(velocity) + 0.5 * inertia_of(r) * squared_norm(spin);
  }
  return energy;
}

}  // namespace

void open_energy_book(GrainSystem& system) {
  system.energy = {};
  system.energy.is_kept = true;
  system.energy.last_box_rate = system.box_rate;
  for (Wall& wall : system.walls) wall.last_velocity = wall.velocity;
  system.energy.shear = energies(system).shear;  // what shear springs hold already counts as taken up
}

double image_power(const GrainSystem& s, const Vec3& box_rate) {
  double power = 0.0;
  const auto shift = [&](int record, int axis) {
    return record < s.owned ? 0 : s.image_shift[to_size(record - s.owned)][to_size(axis)];
  };
  for_each_grain_contact(s, [&](int i, int j, const Vec3&, int slot) {
    if (i < s.owned && j < s.owned) return;
    const Vec3 force = vec3(s.slot[to_size(slot)].force);
    for (int axis = 0; axis < 3; ++axis) power -= force[axis] * box_rate[axis] * (shift(j, axis) - shift(i, axis));
  });
  if (!s.bridges) return power;
  const PresentBridges now = present_bridges(s);
  for_each_bridge(
      s,
      [&](int i, int j, int bridge) {
        const auto image = nearest_image(s, i, j);
        const Vec3 force = -now.force[to_size(bridge)] * normalized(branch_between(s, i, j));
        for (int axis = 0; axis < 3; ++axis) power -= force[axis] * box_rate[axis] * image[to_size(axis)];
      },
      [](int, int, int) {});
  return power;
}

Energies energies(const GrainSystem& s) {
  assert(s.is_evaluated);
  Energies e;
  e.kinetic = kinetic_energy(s);
  e.shear_work = s.energy.shear;
  e.roll_work = s.energy.roll;
  e.viscous = s.energy.viscous;
  e.damping = s.energy.damping;
  e.wetting = s.energy.wetting;
  if (s.bridges) e.bridges = -bridge_energy(s);
  e.input = s.energy.walls + s.energy.box + s.energy.body;
  // A wall's work is booked with the velocities before and after a place: of the last displacement half is still to come.
  for (const Wall& wall : s.walls) e.input -= 0.5 * s.time_step * dot(wall.force, wall.velocity);
  std::visit(
      [&]<ContactLaw Law>(const Law&) {
        // The overlap follows from force and stiffness of the slot only without a viscous part; the places know it.
        for_each_grain_contact(s, [&](int i, int j, const Vec3& branch, int slot) {
          const GrainRecord &a = s.record[to_size(i)], &b = s.record[to_size(j)];
          const double kn = s.slot[to_size(slot)].moment[3], overlap = radius_of(a) + radius_of(b) - norm(branch);
          e.normal += Law::energy_share * kn * overlap * overlap;
          if constexpr (Law::stores_shear) {
            const auto& pair = s.pairs.grains[to_size(material_of(a) * s.pairs.materials + material_of(b))];
            e.shear += shear_energy(s.grain_contacts.shear[to_size(slot / lane_count)], slot % lane_count,
                                    Law::stiffness_ratio(pair) * kn);
          }
        });
        const int offset = s.grain_contacts.size();
        for_each_wall_contact(s, [&](int, int k, const Vec3& branch, int slot) {
          const GrainRecord& a = s.record[to_size(k)];
          const double kn = s.slot[to_size(slot)].moment[3], overlap = radius_of(a) - norm(branch);
          e.normal += Law::energy_share * kn * overlap * overlap;
          if constexpr (Law::stores_shear) {
            const auto& pair = s.pairs.walls[to_size(material_of(a))];
            e.shear += shear_energy(s.wall_contacts.shear[to_size(slot / lane_count - offset)], slot % lane_count,
                                    Law::stiffness_ratio(pair) * kn);
          }
        });
        if constexpr (Law::stores_shear) e.friction = e.shear_work - e.shear;
      },
      s.law);
  return e;
}

}  // namespace puadem
