#include "puadem/dem/bridge_measures.hpp"

#include <algorithm>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/dem/bridge_forces.hpp"

namespace puadem {

namespace {

/// Bridges with gaps, forces and contents of the present places.
Bridges bridges_now(const GrainSystem& s) {
  Bridges bridges = s.bridges->bridges;
  PresentBridges now = present_bridges(s);
  bridges.pairs.gap = std::move(now.gap);
  bridges.force = std::move(now.force);
  update_contents(s.bridges->model, bridges);
  return bridges;
}

}  // namespace

BridgeMeasures measure_bridges(const GrainSystem& s) {
  const GrainBridges& g = *s.bridges;
  const Bridges now = bridges_now(s);
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
  const PresentBridges now = present_bridges(s);
  Tensor stress{};
  const auto add = [&](int bridge, const Vec3& branch) {
    add_outer(stress, -now.force[to_size(bridge)] * normalized(branch), branch);
  };
  for_each_bridge(
      s, [&](int first, int second, int bridge) { add(bridge, branch_between(s, first, second)); },
      [&](int wall, int record, int bridge) { add(bridge, height_over(s, wall, record)); });
  for (Vec3& row : stress) row *= 1.0 / s.domain.volume();
  return stress;
}

double bridge_energy(const GrainSystem& s) { return rupture_work(s.bridges->model, bridges_now(s)); }

std::vector<Vec3> bridge_pulls(const GrainSystem& s) {
  std::vector<Vec3> pull(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) pull[to_size(s.identity[to_size(k)])] = bridge_pull_on(s, k);
  return pull;
}

std::vector<GrainBridge> bridges_of(const GrainSystem& s) {
  const Bridges now = bridges_now(s);
  std::vector<GrainBridge> list(to_size(now.size()));
  const auto fill = [&](int bridge, const Vec3& branch) {
    const std::size_t k = to_size(bridge);
    const auto [first, second] = now.pairs.ends[k];
    const bool is_wall = second >= s.owned;
    list[k] = {first,        is_wall ? -1 : second, is_wall ? second - s.owned : -1, branch, now.pairs.gap[k],
               now.force[k], now.volume[k],         now.capillary_pressure[k]};
  };
  for_each_bridge(
      s, [&](int first, int second, int bridge) { fill(bridge, branch_between(s, first, second)); },
      [&](int wall, int record, int bridge) { fill(bridge, -height_over(s, wall, record)); });
  return list;
}

}  // namespace puadem
