#pragma once

#include <array>

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Chains of force: what is joined by contacts that carry more than the mean normal force.
struct ForceChains {
  double mean_force = 0.0;     ///< of a contact between grains [N]
  double strong_share = 0.0;   ///< of these contacts, those above the mean [-]
  double largest_share = 0.0;  ///< of the grains, those in the largest chain [-]
  /// Does a chain join the two walls along x, y, z? Along a periodic axis: does one reach its own image?
  std::array<bool, 3> spans{};
};

/// @pre the forces are those of the present places
ForceChains find_force_chains(const GrainSystem& system);

}  // namespace puadem
