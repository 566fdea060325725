#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// A servo lags behind grains that keep receding: the targets of walls that hold a stress make up for what is missing, over
/// some steps of the grains.
/// @param stress  that they are to hold [Pa] @param steps  of the grains since the last call
/// @pre the forces on the walls are those of the present places, or of the step before
void correct_servo(double stress, long steps, GrainSystem& grains);

/// The areas over which walls hold their stress, of the present box.
void renew_wall_areas(GrainSystem& grains);

}  // namespace puadem
