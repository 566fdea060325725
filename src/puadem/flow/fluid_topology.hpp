#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "puadem/network/pore_network.hpp"

namespace puadem {

/// One fluid as a graph: the pores that hold it are the nodes, the throats that pass it between two such pores the
/// links, each of several parallel throats by itself.
struct FluidTopology {
  int pores = 0, throats = 0;
  int clusters = 0;                                         ///< connected parts
  int euler() const { return pores - throats; }             ///< Euler number: clusters - loops
  int loops() const { return throats - pores + clusters; }  ///< independent closed ways
};

/// @param holds   per pore: the fluid is in it
/// @param passes  per throat: the fluid may pass; throats with an end that does not hold the fluid do not count
FluidTopology fluid_topology(const PoreNetwork& network, std::span<const std::uint8_t> holds,
                             std::span<const std::uint8_t> passes);

struct FluidCluster {
  int first = 0;  ///< lowest of its pores
  int pores = 0;
  double volume = 0.0;  ///< of the fluid in it [m3]
};

/// Connected parts of a fluid, the largest volume first; equal ones by their first pore.
/// @param holds, passes  as above
/// @param volume         per pore: of the fluid [m3]
std::vector<FluidCluster> fluid_cluster_sizes(const PoreNetwork& network, std::span<const std::uint8_t> holds,
                                              std::span<const std::uint8_t> passes, std::span<const double> volume);

/// Number of each pore's cluster in the order of the list above; -1 where the fluid is not.
std::vector<int> fluid_cluster_numbers(const PoreNetwork& network, std::span<const std::uint8_t> holds,
                                       std::span<const std::uint8_t> passes, std::span<const double> volume);

}  // namespace puadem
