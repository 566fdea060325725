#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Makes the list of candidate contacts anew if one may have been missed since it was made: two grains, or
/// a grain and a wall, may have come closer by more than the skin. Carries the shear history over. The
/// forces do not depend on when this happens.
/// @throws NumericalError  a grain that left the box
void renew_neighbour_list(GrainSystem& system);

/// Makes the list whatever has moved.
void build_neighbour_list(GrainSystem& system);

/// Repeats place and motion of the owners in their periodic images.
void update_images(GrainSystem& system);

}  // namespace puadem
