#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Pushes grains that nothing holds gently along `direction` (a unit vector) until they lie against their neighbours, then
/// lets go. Where a fluid comes they are no longer carried along by it (theory 7.4). Leaves the forces evaluated.
/// @return how many grains were loose; 0 where grains bear nothing, so that there is nothing to lean on
/// @throws NumericalError  where they do not come to rest
int seat_loose_grains(const Vec3& direction, GrainSystem& grains);

}  // namespace puadem
