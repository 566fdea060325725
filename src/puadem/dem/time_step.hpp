#pragma once

#include <limits>

#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem {

/// Critical step [s] as if the smallest grain carried `stress` [Pa] through six contacts of the stiffest pair of
/// materials: for grains of which few touch yet.
double critical_time_step_at(const GrainSystem& system, double stress);

/// Sets the step to the share `motion.safety` of the critical one, growing by a twentieth at most, and to no
/// more than `longest` [s]. Only right after the forces were evaluated: the shear history takes the last
/// displacement from the step that made it.
/// @return what binds; a step of 0 (none yet) becomes the full share at once
/// @throws NumericalError  no contact and no `longest`
TimeStepLimit renew_time_step(GrainSystem& system, double longest = std::numeric_limits<double>::infinity());

}  // namespace puadem
