#include "puadem/dem/grain_stress.hpp"

#include <cmath>

#include "puadem/dem/contacts.hpp"
#include "puadem/geometry/power_cells.hpp"

namespace puadem {

namespace {

/// Places by identity, moved into the box along periodic axes.
std::vector<Vec3> places_in_box(const GrainSystem& s) {
  std::vector<Vec3> place(to_size(s.owned));
  const Vec3 size = s.domain.size();
  for (int k = 0; k < s.owned; ++k) {
    Vec3 x = vec3(s.record[to_size(k)].place);
    for (int axis = 0; axis < 3; ++axis)
      if (s.domain.periodic[to_size(axis)]) x[axis] -= size[axis] * std::floor((x[axis] - s.domain.lower[axis]) / size[axis]);
    place[to_size(s.identity[to_size(k)])] = x;
  }
  return place;
}

}  // namespace

GrainStresses grain_stresses(const GrainSystem& s) {
  GrainStresses g;
  const std::size_t n = to_size(s.owned);
  const std::vector<Vec3> place = places_in_box(s);
  std::vector<double> radius(n);
  for (int k = 0; k < s.owned; ++k) radius[to_size(s.identity[to_size(k)])] = radius_of(s.record[to_size(k)]);
  g.volume = power_cell_volumes(triangulate(place, radius, s.domain), place, radius, s.domain);
  g.stress.assign(n, Tensor{});
  g.contacts.assign(n, 0);
  const auto add = [&](int record, const Vec3& force, const Vec3& branch) {
    const std::size_t id = to_size(s.identity[to_size(owner_of(s, record))]);
    add_outer(g.stress[id], force, branch);
    ++g.contacts[id];
  };
  for_each_grain_contact(s, [&](int i, int j, const Vec3& branch, int slot) {
    const Vec3 force = vec3(s.slot[to_size(slot)].force);
    const double ri = radius_of(s.record[to_size(i)]), rj = radius_of(s.record[to_size(j)]);
    const double length = norm(branch), share_i = (ri + 0.5 * (length - ri - rj)) / length;  // up to the middle of the overlap
    add(i, force, share_i * branch);
    add(j, force, (1.0 - share_i) * branch);
  });
  for_each_wall_contact(s, [&](int, int k, const Vec3& branch, int slot) { add(k, vec3(s.slot[to_size(slot)].force), branch); });
  for (std::size_t k = 0; k < n; ++k) {
    for (Vec3& row : g.stress[k]) row *= 1.0 / g.volume[k];
    g.mean.push_back(trace(g.stress[k]) / 3.0);
    g.deviatoric.push_back(deviatoric_invariant(g.stress[k]));
  }
  return g;
}

}  // namespace puadem
