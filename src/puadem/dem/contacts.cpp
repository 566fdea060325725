#include "puadem/dem/contacts.hpp"

#include <algorithm>
#include <tuple>

namespace puadem {

namespace {

Vec3 lane(const LaneVec3& v, int l) { return {v.x[l], v.y[l], v.z[l]}; }

}  // namespace

std::vector<Contact> contacts_of(const GrainSystem& s) {
  std::vector<Contact> contacts;
  for_each_grain_contact(s, [&](int first, int second, const Vec3& branch, int k) {
    const ContactSlot& slot = s.slot[to_size(k)];
    contacts.push_back({.first = s.identity[to_size(first)],
                        .second = s.identity[to_size(second)],
                        .branch = branch,
                        .force = vec3(slot.force),
                        .shear = lane(s.grain_contacts.shear[to_size(k / lane_count)], k % lane_count),
                        .normal_force = slot.force[3],
                        .normal_stiffness = slot.moment[3]});
  });
  const int grain_contacts = size_of(contacts);
  const int offset = s.grain_contacts.size();
  for_each_wall_contact(s, [&](int wall, int record, const Vec3& branch, int k) {
    const ContactSlot& slot = s.slot[to_size(k)];
    contacts.push_back({.second = s.identity[to_size(record)],
                        .wall = wall,
                        .branch = branch,
                        .force = vec3(slot.force),
                        .shear = lane(s.wall_contacts.shear[to_size(k / lane_count - offset)], k % lane_count),
                        .normal_force = slot.force[3],
                        .normal_stiffness = slot.moment[3]});
  });
  const auto by_name = [](const Contact& a, const Contact& b) {
    return std::tie(a.wall, a.first, a.second) < std::tie(b.wall, b.first, b.second);
  };
  std::sort(contacts.begin(), contacts.begin() + grain_contacts, by_name);
  std::sort(contacts.begin() + grain_contacts, contacts.end(), by_name);
  return contacts;
}

}  // namespace puadem
