#pragma once

#include <array>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/geometry/domain.hpp"

namespace puadem {

/// Grains placed one after the other where there is room. Each lies in a grid of cells about as wide as itself, one
/// grid for every factor of two in size, so that a look costs the same at any ratio of sizes. Cells are hashed.
struct PlacedGrains {
  struct Level {
    std::array<int, 3> cells{};  ///< along the axes
    double largest = 0.0;        ///< radius of the grains in it [m]; 0: none yet
  };
  Domain box;
  double widest = 0.0;         ///< cells of the first level [m]
  std::vector<double> radius;  ///< of all grains, placed or not [m]
  std::vector<Vec3> position;  ///< of those that are placed [m]
  std::vector<Level> levels;   ///< widest cells first
  std::vector<int> bucket;     ///< first grain of a hashed cell, -1: none
  std::vector<int> next;       ///< grain after this one in the bucket
};

/// None placed yet.
PlacedGrains empty_box(const Domain& box, const std::vector<double>& radius);

/// Would a grain of radius r at x touch none of those placed? Images across periodic faces count.
bool is_free(const PlacedGrains& placed, const Vec3& x, double r);

/// Puts a grain into the box. @param x  inside the box
void place(PlacedGrains& placed, int grain, const Vec3& x);

}  // namespace puadem
