#pragma once

#include <span>
#include <vector>

#include "puadem/base/random.hpp"
#include "puadem/base/vec3.hpp"

namespace puadem {

/// Places of grains that lie close together around the origin, all but touching, none overlapping: the first at
/// the origin, every other beside one of those before it, on the nearest to the origin of a few random places [m].
/// @param radius  [m], in the order of placing
std::vector<Vec3> make_clump(std::span<const double> radius, Random& random);

}  // namespace puadem
