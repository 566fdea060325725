#pragma once

#include "puadem/dem/energy.hpp"

namespace puadem {

/// Bounds that a sane run never meets.
struct GuardLimits {
  double overlap = 0.3;       ///< of two grains, as a share of the smaller radius [-]
  double displacement = 0.1;  ///< of a grain relative to the box in one step, as a share of its radius [-]
  double energy = 0.1;        ///< that nothing accounts for, as a share of the largest term of the balance [-]
};

/// Stops a run that has lost its way, naming grain, place, neighbours and forces. Looks at overlaps, at
/// displacements in a step and at grains whose centre is behind a wall.
/// @pre the forces are those of the present places
/// @throws NumericalError
void guard_grains(const GrainSystem& system, const GuardLimits& limits = {});

/// Stops a run whose grains have more energy than the work done on them explains, as an unstable time step
/// makes it; names the grain that moves most.
/// @param start  energies when the book was opened
/// @pre the energy book is kept, the forces are those of the present places
/// @return the energies now
/// @throws NumericalError
Energies guard_energy(const GrainSystem& system, const Energies& start, const GuardLimits& limits = {});

}  // namespace puadem
