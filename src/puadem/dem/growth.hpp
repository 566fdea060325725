#pragma once

#include <span>

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Gives every grain a new radius at its own density: mass and moment of inertia follow. The neighbour list
/// learns of the growth and is renewed in time.
/// @param radius  by identity [m]
/// @pre   between two steps, the forces of the present places not yet evaluated
/// @throws InputError  a radius that is not positive, or not one radius a grain
void set_radii(GrainSystem& system, std::span<const double> radius);

/// The same with new masses, by identity too [kg]; the moments of inertia are those of even density. Velocities stay: what
/// is taken up comes with the velocity of its grain.
void set_radii(GrainSystem& system, std::span<const double> radius, std::span<const double> mass);

}  // namespace puadem
