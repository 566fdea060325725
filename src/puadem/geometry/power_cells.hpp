#pragma once

#include <span>
#include <vector>

#include "puadem/geometry/regular_triangulation.hpp"

namespace puadem {

/// Volume of the power cell of every grain [m3]: all points of the box whose power to this grain is the
/// least, bounded by the walls (theory 2.17). The cells tile the box: their volumes add to its volume to
/// rounding, also where the box is periodic.
/// @param triangulation  of the same spheres in the same box
std::vector<double> power_cell_volumes(const Triangulation& triangulation, std::span<const Vec3> centre,
                                       std::span<const double> radius, const Domain& domain);

}  // namespace puadem
