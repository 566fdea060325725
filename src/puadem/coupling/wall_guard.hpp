#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Stops a run in which a grain has escaped, or a wall that holds a stress has run away from the grains.
/// @throws NumericalError  a grain's centre is behind a wall; or such a wall touches no grain, and the nearest is more than a
///                         grain away
void guard_walls(const GrainSystem& grains);

}  // namespace puadem
