#include "puadem/dem/bridge_measures.hpp"

#include <algorithm>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/dem/bridge_forces.hpp"

namespace puadem {

namespace {

/// Line from the centre of the first grain to that of the second.
Vec3 branch_of(const GrainSystem& s, int first, int second) {
  Vec3 branch = vec3(s.record[to_size(second)].place - s.record[to_size(first)].place);
  const auto image = nearest_image(s, first, second);
  const Vec3 size = s.domain.size();
  for (int axis = 0; axis < 3; ++axis) branch[axis] += image[to_size(axis)] * size[axis];
  return branch;
}

/// The same from the foot on a wall to the centre.
Vec3 height_over(const GrainSystem& s, int wall, int record) {
  const Wall& w = s.walls[to_size(wall)];
  return dot(vec3(s.record[to_size(record)].place) - w.point, w.normal) * w.normal;
}

/// Bridges with gaps, forces and contents of the present places.
Bridges present_bridges(const GrainSystem& s) {
  GrainBridges g;
  g.model = s.bridges->model;
  g.bridges = s.bridges->bridges;
  g.list.block = s.bridges->list.block;
  collect_bridges(g);
  update_contents(g.model, g.bridges);
  return std::move(g.bridges);
}

}  // namespace

BridgeMeasures measure_bridges(const GrainSystem& s) {
  const GrainBridges& g = *s.bridges;
  const Bridges now = present_bridges(s);
  BridgeMeasures m;
  CompensatedSum water, film, left;
  double force = 0.0;
  left.add(g.water_start);
  int ends = 0;
  for (int k = 0; k < now.size(); ++k) {
    water.add(now.volume[to_size(k)]);
    left.add(-now.volume[to_size(k)]);
    force += now.force[to_size(k)];
    ends += now.pairs.ends[to_size(k)][1] < s.owned ? 2 : 1;
  }
  for (const double f : g.film) {
    film.add(f);
    left.add(-f);
  }
  m.bridges = now.size();
  m.water = water.value();
  m.film = film.value();
  if (g.water_start > 0.0) m.water_error = left.value() / g.water_start;
  if (m.bridges > 0) m.mean_force = force / m.bridges;
  m.coordination = static_cast<double>(ends) / s.owned;
  m.formed = g.formed;
  m.ruptured = g.ruptured;
  return m;
}

Tensor bridge_stress(const GrainSystem& s) {
  Tensor stress{};
  for_each_bridge(
      s,
      [&](int first, int second, int, int slot) {
        add_outer(stress, vec3(s.slot[to_size(slot)].force), branch_of(s, first, second));
      },
      [&](int wall, int record, int, int slot) {
        add_outer(stress, vec3(s.slot[to_size(slot)].force), height_over(s, wall, record));
      });
  for (Vec3& row : stress) row *= 1.0 / s.domain.volume();
  return stress;
}

double bridge_energy(const GrainSystem& s) { return rupture_work(s.bridges->model, present_bridges(s)); }

std::vector<GrainBridge> bridges_of(const GrainSystem& s) {
  const Bridges now = present_bridges(s);
  std::vector<GrainBridge> list(to_size(now.size()));
  const auto fill = [&](int bridge, const Vec3& branch) {
    const std::size_t k = to_size(bridge);
    const auto [first, second] = now.pairs.ends[k];
    const bool is_wall = second >= s.owned;
    list[k] = {first,        is_wall ? -1 : second, is_wall ? second - s.owned : -1, branch, now.pairs.gap[k],
               now.force[k], now.volume[k],         now.capillary_pressure[k]};
  };
  for_each_bridge(
      s, [&](int first, int second, int bridge, int) { fill(bridge, branch_of(s, first, second)); },
      [&](int wall, int record, int bridge, int) { fill(bridge, -height_over(s, wall, record)); });
  return list;
}

}  // namespace puadem
