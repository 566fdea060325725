#pragma once

#include <limits>
#include <span>

#include "puadem/geometry/domain.hpp"
#include "puadem/geometry/throat_entry.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// How a packing becomes pores and throats. Defaults are the paper's, as far as it says.
struct NetworkOptions {
  EntryLaw entry_law = MayerStowePrincen{};
  double contact_angle = 0.0;  ///< theta [rad], in the entry and snap-off radii
  /// Neighbours merge where R_ij / min(R_i, R_j) exceeds this (theory 3.7); infinity: no merging.
  double merge_ratio = 0.9;
  int merge_limit = 20;  ///< most tetrahedra in one unit
};

/// Pore network of a packing: triangulation, throat sections, merging, pore units.
///
/// @param centre  grain centres [m]
/// @param radius  grain radii [m]
/// @throws InputError as `triangulate`
PoreNetwork build_pore_network(std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                               const NetworkOptions& options);

}  // namespace puadem
