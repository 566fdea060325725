#include "puadem/coupling/moving_pores.hpp"

#include <algorithm>
#include <cmath>

#include "puadem/geometry/cell_match.hpp"
#include "puadem/geometry/cell_voids.hpp"

namespace puadem {

NetworkPlace place_of(const PoreNetwork& network, const Particles& particles, const Domain& domain) {
  return {particles.position, domain,
          cell_orientations(network.triangulation, PackingSites(particles.position, particles.radius, domain))};
}

std::vector<Vec3> followed_centres(const NetworkPlace& place, const Particles& particles, const Domain& domain) {
  std::vector<Vec3> centre = particles.position;
  const Vec3 period = domain.size();
  for (int axis = 0; axis < 3; ++axis) {
    if (!domain.periodic[to_size(axis)]) continue;
    for (std::size_t k = 0; k < centre.size(); ++k) {
      double& x = centre[k][axis];
      x -= period[axis] * std::nearbyint((x - place.centre[k][axis]) / period[axis]);
    }
  }
  return centre;
}

MovedVoids moved_voids(const PoreNetwork& network, const NetworkPlace& place, std::span<const Vec3> centre,
                       std::span<const double> radius, const Domain& domain) {
  CellVoids now = cell_voids(network.triangulation, PackingSites(centre, radius, domain));
  MovedVoids voids;
  for (int c = network.triangulation.cells() - 1; c >= 0; --c) {
    if (now.orientation[to_size(c)] * place.orientation[to_size(c)] >= 0) continue;
    now.space[to_size(c)] = -now.space[to_size(c)];
    voids.inverted = c;
  }
  voids.cell = std::move(now.space);
  voids.pore.resize(to_size(network.pores()));
  parallel_for(network.pores(), [&](int p) {
    double space = 0.0;
    for (const int c : network.pore_tetrahedra[p]) space += voids.cell[to_size(c)];
    voids.pore[to_size(p)] = space;
  });
  return voids;
}

double largest_displacement(const NetworkPlace& place, std::span<const Vec3> centre) {
  double squared = 0.0;
  for (std::size_t k = 0; k < centre.size(); ++k) squared = std::max(squared, squared_norm(centre[k] - place.centre[k]));
  return std::sqrt(squared);
}

RebuiltNetwork remesh(const PoreNetwork& network, std::span<const int> kind, std::span<const Vec3> centre,
                      const Particles& particles, const Domain& domain, const NetworkOptions& options, NetworkPlace& place) {
  const Vec3 period = domain.size();
  std::vector<std::array<std::int8_t, 3>> wraps(centre.size());
  for (std::size_t k = 0; k < centre.size(); ++k)
    for (int axis = 0; axis < 3; ++axis)
      if (domain.periodic[to_size(axis)])
        wraps[k][to_size(axis)] =
            static_cast<std::int8_t>(std::nearbyint((centre[k][axis] - particles.position[k][axis]) / period[axis]));
  const std::vector<std::int8_t> now = cell_orientations(network.triangulation, PackingSites(centre, particles.radius, domain));
  std::vector<std::uint8_t> turned(now.size());
  for (std::size_t c = 0; c < now.size(); ++c) turned[c] = now[c] * place.orientation[c] < 0;
  RebuiltNetwork rebuilt =
      rebuild_pore_network(network, kind, wraps, particles.position, particles.radius, domain, options, turned);
  place = place_of(rebuilt.network, particles, domain);
  return rebuilt;
}

}  // namespace puadem
