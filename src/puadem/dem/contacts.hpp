#pragma once

#include <vector>

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// A contact in force, as others see it. Between grains `first` < `second`; against a wall `first` is -1.
struct Contact {
  int first = -1;   ///< identity of a grain, -1 for a wall
  int second = -1;  ///< identity of a grain
  int wall = -1;
  Vec3 branch;                    ///< from the first centre, or the foot on the wall, to the second centre [m]
  Vec3 force;                     ///< on the second grain [N]
  Vec3 shear;                     ///< history: generalised shear force [N]
  double normal_force = 0.0;      ///< [N]
  double normal_stiffness = 0.0;  ///< tangent k_n [N/m]
};

/// All contacts in force, ordered by first, second, then wall contacts by wall and grain.
std::vector<Contact> contacts_of(const GrainSystem& system);

/// Calls `visit(first, second, branch, slot, block, lane)` for every contact in force between grains, in
/// the order of the list: records (an image among them stands for its owner, see `owner_of`), branch [m].
template <class Visit>
void for_each_grain_contact(const GrainSystem& s, const Visit& visit) {
  const ContactBlocks& blocks = s.grain_contacts;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.live[to_size(b)] == 0) continue;
    for (int l = 0; l < lane_count; ++l) {
      const int slot = lane_count * b + l;
      if (!(s.slot[to_size(slot)].moment[3] > 0.0)) continue;
      const int first = blocks.first[to_size(b)][to_size(l)], second = blocks.second[to_size(b)][to_size(l)];
      const Lanes d = s.record[to_size(second)].place - s.record[to_size(first)].place;
      visit(first, second, vec3(d), slot);
    }
  }
}

/// The same for contacts with walls: `visit(wall, record, foot to centre, slot)`.
template <class Visit>
void for_each_wall_contact(const GrainSystem& s, const Visit& visit) {
  const ContactBlocks& blocks = s.wall_contacts;
  const int offset = lane_count * s.grain_contacts.size();
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.live[to_size(b)] == 0) continue;
    for (int l = 0; l < lane_count; ++l) {
      const int slot = offset + lane_count * b + l;
      if (!(s.slot[to_size(slot)].moment[3] > 0.0)) continue;
      const int w = blocks.first[to_size(b)][to_size(l)], k = blocks.second[to_size(b)][to_size(l)];
      const Wall& wall = s.walls[to_size(w)];
      visit(w, k, dot(vec3(s.record[to_size(k)].place) - wall.point, wall.normal) * wall.normal, slot);
    }
  }
}

/// Record of the grain that a record, perhaps an image, stands for.
inline int owner_of(const GrainSystem& s, int record) {
  return record < s.owned ? record : s.image_owner[to_size(record - s.owned)];
}

inline int material_of(const GrainRecord& r) { return static_cast<int>(r.turn[3]); }

}  // namespace puadem
