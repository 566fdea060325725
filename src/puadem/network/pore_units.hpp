#pragma once

#include <span>

#include "puadem/geometry/domain.hpp"
#include "puadem/network/network_options.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// Pore network of a packing: triangulation, throat sections, merging, pore units.
///
/// @param centre  grain centres [m]
/// @param radius  grain radii [m]
/// @throws InputError      as `triangulate`
/// @throws NumericalError  where overlapping grains leave no void
PoreNetwork build_pore_network(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                               const NetworkOptions& options);

}  // namespace puadem
