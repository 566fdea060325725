#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "puadem/dem/particles.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/network/pore_units.hpp"

namespace puadem {

/// Where the grains stood when their pore network was made: what tells how far it has been deformed since (theory 7.2).
struct NetworkPlace {
  std::vector<Vec3> centre;                ///< of the grains, within the box [m]
  Domain domain;                           ///< then
  std::vector<std::int8_t> orientation{};  ///< of the cells, see `cell_orientations`
};

/// The place of a network just made.
NetworkPlace place_of(const PoreNetwork& network, const Particles& particles, const Domain& domain);

/// Grains as the network knows them: not moved back into a periodic box since it was made [m].
std::vector<Vec3> followed_centres(const NetworkPlace& place, const Particles& particles, const Domain& domain);

/// Voids of a network whose grains have moved.
struct MovedVoids {
  std::vector<double> pore;  ///< volume of each pore [m3]
  std::vector<double> cell;  ///< of each cell [m3]
  int inverted = -1;         ///< lowest cell that has turned inside out, or -1
};

/// Cells that have turned inside out count negative, so that all of them add to the void of the box wherever its grains
/// are; a pore of one such cell has less than nothing until a new network is made.
/// @param centre  see `followed_centres`
MovedVoids moved_voids(const PoreNetwork& network, const NetworkPlace& place, std::span<const Vec3> centre,
                       std::span<const double> radius, const Domain& domain);

/// Largest distance of a grain from where it stood [m].
double largest_displacement(const NetworkPlace& place, std::span<const Vec3> centre);

/// A new network at the present places and its place, see `rebuild_pore_network`.
RebuiltNetwork remesh(const PoreNetwork& network, std::span<const int> kind, std::span<const Vec3> centre,
                      const Particles& particles, const Domain& domain, const NetworkOptions& options, NetworkPlace& place);

}  // namespace puadem
