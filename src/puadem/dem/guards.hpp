#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Bounds that a sane run never meets.
struct GuardLimits {
  double overlap = 0.3;       ///< of two grains, as a share of the smaller radius [-]
  double displacement = 0.1;  ///< of a grain relative to the box in one step, as a share of its radius [-]
};

/// Stops a run that has lost its way, naming grain, place, neighbours and forces. Looks at overlaps, at
/// displacements in a step and at grains whose centre is behind a wall.
/// @pre the forces are those of the present places
/// @throws NumericalError
void guard_grains(const GrainSystem& system, const GuardLimits& limits = {});

}  // namespace puadem
