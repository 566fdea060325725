#pragma once

#include <span>
#include <vector>

namespace puadem {

/// Share of a material in the solid volume of the grains.
struct MaterialShare {
  int material = 0;       ///< index into the materials of the case
  double fraction = 1.0;  ///< by volume [-]; the shares add to 1
};

/// Gives every grain a material, without chance: from the largest grain to the smallest each takes the material that
/// lacks most of its share so far. So every size holds the mixture, and the shares are met within one small grain.
/// @param radius  [m]
/// @return index of the material of every grain
/// @throws InputError  no share, a share out of range, shares that do not add to 1
std::vector<int> assign_materials(std::span<const double> radius, std::span<const MaterialShare> shares);

}  // namespace puadem
