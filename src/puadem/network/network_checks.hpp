#pragma once

#include <span>
#include <string>
#include <vector>

#include "puadem/geometry/domain.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// What is wrong with a network, one sentence a fault with its grains and place; empty where it is sound:
/// - every pore has a positive volume and at least one throat,
/// - every throat has two ends and both pores list it,
/// - every pore can be reached from every other through throats that are not closed.
/// A network of any origin will do.
std::vector<std::string> find_network_faults(const PoreNetwork& network);

/// The same, and what a network of a packing must satisfy besides:
/// - pores and grains add to the box, to 1e-12,
/// - every facet is seen from both its cells,
/// - every grain is a vertex of the triangulation.
std::vector<std::string> find_network_faults(const PoreNetwork& network, std::span<const Vec3> centre,
                                             std::span<const double> radius, const Domain& domain);

}  // namespace puadem
