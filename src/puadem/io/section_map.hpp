#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/state.hpp"

namespace puadem {

/// A plane through the middle of the box, pixel by pixel, for pictures of what the pores hold: across the thinnest
/// direction of a thin bed, else upright.
struct SectionMap {
  int axis = 2;  ///< normal of the plane; columns follow the next axis, rows the one after it, cyclically
  int columns = 0, rows = 0;
  double pixel = 0.0;     ///< side [m]
  std::vector<int> pore;  ///< row by row; -1 in a grain
};

/// Void belongs to the pore whose sphere it has the least power to, |x - x_i|^2 - R_i^2.
/// @param columns  pixels along the longer side
SectionMap cut_section(const State& state, int columns);

/// One byte a pixel in Base64: 255 in a grain, else 254 times the saturation of its pore, rounded.
std::string section_picture(const SectionMap& map, const std::vector<double>& saturation);

}  // namespace puadem
