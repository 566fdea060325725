#include "puadem/dem/stress.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/dem/bridge_forces.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/contact_forces.hpp"
#include "puadem/dem/contacts.hpp"
#include "puadem/dem/fabric.hpp"

namespace puadem {

GrainMeasures measure(const GrainSystem& s) {
  GrainMeasures m;
  const double volume = s.domain.volume();
  Tensor walls{};
  double contact_force = 0.0;
  const auto stiffen = [&](const Vec3& d, double kn) {
    const double d2 = squared_norm(d);
    for (int a = 0; a < 3; ++a) m.affine_modulus[a] += kn * d[a] * d[a] * d[a] * d[a] / d2 / volume;
  };
  for_each_grain_contact(s, [&](int i, int j, const Vec3& branch, int slot) {
    const ContactSlot& c = s.slot[to_size(slot)];
    add_outer(m.pair_stress, vec3(c.force), branch);
    stiffen(branch, c.moment[3]);
    contact_force += norm(vec3(c.force));
    const double ri = radius_of(s.record[to_size(i)]), rj = radius_of(s.record[to_size(j)]);
    m.largest_overlap = std::max(m.largest_overlap, (ri + rj - norm(branch)) / std::min(ri, rj));
    ++m.contacts;
  });
  for_each_wall_contact(s, [&](int, int k, const Vec3& branch, int slot) {
    const ContactSlot& c = s.slot[to_size(slot)];
    add_outer(walls, vec3(c.force), branch);
    stiffen(branch, c.moment[3]);
    contact_force += norm(vec3(c.force));
    const double r = radius_of(s.record[to_size(k)]);
    m.largest_overlap = std::max(m.largest_overlap, (r - norm(branch)) / r);
    ++m.contacts;
  });
  if (s.bridges) m.bridge_stress = bridge_stress(s);
  for (unsigned a = 0; a < 3; ++a) {
    m.pair_stress[a] *= 1.0 / volume;
    m.stress[a] = m.pair_stress[a] + walls[a] * (1.0 / volume) + m.bridge_stress[a];
  }
  m.mean_stress = trace(m.stress) / 3.0;
  m.deviatoric_stress = deviatoric_invariant(m.stress);
  for (const Wall& wall : s.walls)
    if (wall.face >= 0) {
      const int axis = axis_of(wall.face);
      m.wall_stress[static_cast<unsigned>(wall.face)] = -dot(wall.force, wall.normal) * s.domain.size()[axis] / volume;
    }

  double net_force = 0.0;
  for (int k = 0; k < s.owned; ++k) {
    const SlotSum sum = sum_slots(s.slot.data(), s.row.data(), s.row_start[to_size(k)], s.row_start[to_size(k) + 1]);
    Vec3 force = vec3(sum.force) + bridge_pull_on(s, k) + mass_of(s.record[to_size(k)]) * s.motion.gravity;
    if (!s.external_force.empty()) force += s.external_force[to_size(s.identity[to_size(k)])];
    net_force += norm(force);
  }
  const GrainContacts contacts = count_contacts(s);
  m.coordination = std::accumulate(contacts.count.begin(), contacts.count.end(), 0.0) / s.owned;
  const int held = s.owned - contacts.rattlers;
  m.coordination_inner = held > 0 ? static_cast<double>(contacts.backbone_ends) / held : 0.0;
  if (m.contacts > 0 && contact_force > 0.0) m.unbalanced = (net_force / s.owned) / (contact_force / m.contacts);
  return m;
}

}  // namespace puadem
