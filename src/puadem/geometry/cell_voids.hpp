#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "puadem/geometry/packing_sites.hpp"

namespace puadem {

/// Angles of the vectors (x, y) with y >= 0 from the x axis, in [0, pi], to four units in the last place; 0 for none [rad].
/// Several at once: with the library's function one after the other would take most of the time of `cell_voids`.
void vector_angles(std::span<const double> y, std::span<const double> x, std::span<double> angle);

/// Voids of all cells at once.
struct CellVoids {
  std::vector<double> space;             ///< as `cell_void_volume`, to rounding [m3]
  std::vector<std::int8_t> orientation;  ///< as `cell_orientations`
};
CellVoids cell_voids(const Triangulation& triangulation, const PackingSites& sites);

}  // namespace puadem
