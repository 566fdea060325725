#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "puadem/base/random.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/network/pore_shape.hpp"

namespace puadem::testing {

inline constexpr std::uint8_t at_bottom = 1 << 4, at_top = 1 << 5;

inline int add_pore(PoreNetwork& network, double volume, int faces, std::uint8_t walls = 0, Vec3 centre = {}) {
  network.pore_centre.push_back(centre);
  network.pore_volume.push_back(volume);
  network.pore_radius.push_back(inscribed_radius_coefficient(faces) * std::cbrt(volume));
  network.pore_faces.push_back(faces);
  network.pore_walls.push_back(walls);
  return network.pores() - 1;
}

/// A throat by its radii of curvature at entry and at snap-off [m].
inline int add_throat(PoreNetwork& network, int i, int j, double entry_radius, double snap_off_radius, bool at_wall = false) {
  network.throat_pores.push_back({std::min(i, j), std::max(i, j)});
  network.throat_entry_radius.push_back(entry_radius);
  network.throat_snap_off_radius.push_back(snap_off_radius);
  network.throat_at_wall.push_back(at_wall);
  return network.throats() - 1;
}

/// Fluids with a surface tension of 1, so that a throat of radius of curvature r opens at 1 / r.
inline Fluids unit_fluids() {
  Fluids fluids;
  fluids.surface_tension = 1.0;
  return fluids;
}

/// All kinds of events.
inline InvasionOptions with_snap_off() {
  InvasionOptions options;
  options.snap_off = true;
  return options;
}

/// Pores in a row from the top reservoir (first) to the bottom one (last). Throat k joins pores k and
/// k + 1, opens at entry[k] and snaps off at half of that (surface tension 1).
inline PoreNetwork chain(const std::vector<double>& entry, double volume = 1e3) {
  PoreNetwork network;
  const int pores = size_of(entry) + 1;
  for (int i = 0; i < pores; ++i)
    add_pore(network, volume, 6, static_cast<std::uint8_t>(i == 0 ? at_top : i == pores - 1 ? at_bottom : 0));
  for (int k = 0; k + 1 < pores; ++k) add_throat(network, k, k + 1, 1.0 / entry[to_size(k)], 2.0 / entry[to_size(k)]);
  return network;
}

/// Random pores in a unit box, each joined to its nearest neighbours; with parallel throats, throats to
/// themselves, closed throats, wall throats, and throats wider than their bodies.
inline PoreNetwork random_network(int pores, std::uint64_t seed, int neighbours = 4) {
  Random random(seed);
  PoreNetwork network;
  const double scale = std::cbrt(1.0 / pores);
  for (int i = 0; i < pores; ++i) {
    const Vec3 centre{random.uniform(), random.uniform(), random.uniform()};
    const int faces = 4 + 2 * static_cast<int>(random.below(6));
    std::uint8_t walls = centre.z > 1.0 - 0.5 * scale ? at_top : centre.z < 0.5 * scale ? at_bottom : std::uint8_t{0};
    const std::array<double, 4> from_sides{centre.x, 1.0 - centre.x, centre.y, 1.0 - centre.y};
    for (int face = 0; face < 4; ++face)
      if (from_sides[to_size(face)] < 0.3 * scale) walls = static_cast<std::uint8_t>(walls | (1 << face));
    add_pore(network, random.uniform(0.2, 1.0) / pores, faces, walls, centre);
  }
  const auto add = [&](int i, int j) {
    const double body = std::min(network.pore_radius[to_size(i)], network.pore_radius[to_size(j)]);
    const double entry = random.uniform() < 0.03 ? 0.0 : 0.5 * body * random.uniform(0.2, 1.3);
    const double snap_off = entry * (random.uniform() < 0.2 ? 1.0 : random.uniform(1.0, 2.5));
    add_throat(network, i, j, entry, snap_off, random.uniform() < 0.1);
  };
  std::vector<int> order(to_size(pores));
  std::iota(order.begin(), order.end(), 0);
  for (int i = 0; i < pores; ++i) {
    std::vector<int> near = order;
    const auto distance = [&](int j) { return squared_norm(network.pore_centre[to_size(j)] - network.pore_centre[to_size(i)]); };
    std::ranges::partial_sort(near, near.begin() + neighbours + 1, {}, distance);
    for (int k = 1; k <= neighbours; ++k) add(i, near[to_size(k)]);
    if (random.uniform() < 0.05) add(i, i);
  }
  return network;
}

/// The same network with pores and throats in another order: new index of pore i is pore_to[i].
inline PoreNetwork renumbered(const PoreNetwork& network, std::uint64_t seed, std::vector<int>& pore_to) {
  Random random(seed);
  const auto shuffled = [&](int n) {
    std::vector<int> v(to_size(n));
    std::iota(v.begin(), v.end(), 0);
    for (int k = n - 1; k > 0; --k) std::swap(v[to_size(k)], v[to_size(static_cast<int>(random.below(to_size(k + 1))))]);
    return v;
  };
  pore_to = shuffled(network.pores());
  PoreNetwork other;
  std::vector<int> pore_from(pore_to.size());
  for (int i = 0; i < network.pores(); ++i) pore_from[to_size(pore_to[to_size(i)])] = i;
  for (const int i : pore_from)
    add_pore(other, network.pore_volume[to_size(i)], network.pore_faces[to_size(i)], network.pore_walls[to_size(i)]);
  for (const int t : shuffled(network.throats()))
    add_throat(other, pore_to[to_size(network.throat_pores[to_size(t)][0])],
               pore_to[to_size(network.throat_pores[to_size(t)][1])], network.throat_entry_radius[to_size(t)],
               network.throat_snap_off_radius[to_size(t)], network.throat_at_wall[to_size(t)]);
  return other;
}

/// Capillary pressure that empties a network but for what is trapped: above all entry pressures.
inline double high_pressure(const PoreNetwork& network, const Fluids& fluids) {
  double highest = 0.0;
  for (const double r : network.throat_entry_radius)
    if (r > 0.0) highest = std::max(highest, fluids.surface_tension / r);
  return 1.1 * highest;
}

}  // namespace puadem::testing
