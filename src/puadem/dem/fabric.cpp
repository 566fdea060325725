#include "puadem/dem/fabric.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/dem/contacts.hpp"

namespace puadem {

namespace {

bool has_friction(const GrainSystem& s) {
  return resists_rolling(s.contact) ||
         std::any_of(s.pairs.grains.begin(), s.pairs.grains.end(), [](const auto& pair) { return pair.friction > 0.0; });
}

/// Calls `visit(neighbour record)` for every grain that touches grain `k`.
template <class Visit>
void for_each_neighbour(const GrainSystem& s, int k, const Visit& visit) {
  const int grain_slots = lane_count * s.grain_contacts.size();
  for (int e = s.row_start[to_size(k)]; e < s.row_start[to_size(k) + 1]; ++e) {
    const int slot = s.row[to_size(e)] / 2;
    const bool is_second = s.row[to_size(e)] % 2 == 1;
    if (slot >= grain_slots || !(s.slot[to_size(slot)].moment[3] > 0.0)) continue;
    const auto& ends = is_second ? s.grain_contacts.first : s.grain_contacts.second;
    visit(owner_of(s, ends[to_size(slot / lane_count)][to_size(slot % lane_count)]));
  }
}

/// Is a contact at its Coulomb limit? @param friction  mu
bool slides(const ContactSlot& c, const Vec3& normal, double friction) {
  const Vec3 force = vec3(c.force);
  const double limit = friction * c.force[3];
  return limit > 0.0 && norm(force - dot(force, normal) * normal) >= (1.0 - 1e-9) * limit;
}

}  // namespace

GrainContacts count_contacts(const GrainSystem& s) {
  GrainContacts c;
  c.count.assign(to_size(s.owned), 0);
  c.is_rattler.assign(to_size(s.owned), 0);
  for_each_grain_contact(s, [&](int i, int j, const Vec3&, int) {
    ++c.count[to_size(owner_of(s, i))];
    ++c.count[to_size(owner_of(s, j))];
  });
  for_each_wall_contact(s, [&](int, int k, const Vec3&, int) { ++c.count[to_size(k)]; });
  const int needed = has_friction(s) ? 2 : 4;
  std::vector<int> left = c.count, loose;
  for (int k = 0; k < s.owned; ++k)
    if (left[to_size(k)] < needed) loose.push_back(k);
  while (!loose.empty()) {
    const int k = loose.back();
    loose.pop_back();
    c.is_rattler[to_size(k)] = 1;
    ++c.rattlers;
    for_each_neighbour(s, k, [&](int other) {
      if (left[to_size(other)]-- == needed) loose.push_back(other);
    });
  }
  for (int k = 0; k < s.owned; ++k)
    if (c.is_rattler[to_size(k)] == 0) c.backbone_ends += left[to_size(k)];
  return c;
}

FabricMeasures measure_fabric(const GrainSystem& s) {
  FabricMeasures m;
  int grain_contacts = 0, wall_contacts = 0, sliding = 0;
  double sums[4] = {0, 0, 0, 0};  // of F_n to the power 1 to 4
  Tensor walls{};
  for_each_grain_contact(s, [&](int i, int j, const Vec3& branch, int slot) {
    const ContactSlot& c = s.slot[to_size(slot)];
    const Vec3 normal = normalized(branch);
    add_outer(m.fabric, normal, normal);
    const auto& pair =
        s.pairs.grains[to_size(material_of(s.record[to_size(i)]) * s.pairs.materials + material_of(s.record[to_size(j)]))];
    if (slides(c, normal, pair.friction)) ++sliding;
    double power = 1.0;
    for (double& sum : sums) sum += power *= c.force[3];
    ++grain_contacts;
  });
  for_each_wall_contact(s, [&](int w, int, const Vec3&, int slot) {
    const Wall& wall = s.walls[to_size(w)];
    add_outer(walls, wall.normal, wall.normal);
    if (slides(s.slot[to_size(slot)], wall.normal, wall.friction)) ++sliding;
    ++wall_contacts;
  });
  const int contacts = grain_contacts + wall_contacts;
  for (unsigned a = 0; a < 3; ++a) {
    if (contacts > 0) m.fabric_all[a] = (m.fabric[a] + walls[a]) / contacts;
    if (grain_contacts > 0) m.fabric[a] *= 1.0 / grain_contacts;
  }
  m.anisotropy = deviator(m.fabric);
  for (Vec3& row : m.anisotropy) row *= 7.5;
  m.deviatoric = deviatoric_invariant(m.anisotropy);
  if (contacts > 0) m.sliding = static_cast<double>(sliding) / contacts;

  const GrainContacts c = count_contacts(s);
  const double ends = 2.0 * grain_contacts + wall_contacts;
  const auto with = [&](int n) { return static_cast<double>(std::count(c.count.begin(), c.count.end(), n)); };
  const double held = s.owned - with(0) - with(1);
  m.coordination = ends / s.owned;
  if (held > 0.0) m.coordination_mechanical = (ends - with(1)) / held;
  if (s.owned > c.rattlers) m.coordination_backbone = static_cast<double>(c.backbone_ends) / (s.owned - c.rattlers);
  m.rattlers = static_cast<double>(c.rattlers) / s.owned;
  if (grain_contacts > 0) {
    m.mean_force = sums[0] / grain_contacts;
    for (int k = 0; k < 3; ++k) m.force_moment[k] = sums[k + 1] / grain_contacts / std::pow(m.mean_force, k + 2);
  }
  return m;
}

}  // namespace puadem
