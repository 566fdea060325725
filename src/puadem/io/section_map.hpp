#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/state.hpp"

namespace puadem {

/// The box pixel by pixel, for pictures of what the pores hold: seen through its thinnest direction where it is thin, else
/// the upright plane through its middle.
struct SectionMap {
  int axis = 2;  ///< looked along; columns follow the next axis, rows the one after it, cyclically
  int columns = 0, rows = 0;
  int planes = 1;         ///< evenly spread over a thin box
  double pixel = 0.0;     ///< side [m]
  std::vector<int> pore;  ///< plane by plane, row by row; -1 in a grain
};

/// Void belongs to the pore whose sphere it has the least power to, |x - x_i|^2 - R_i^2.
/// @param columns  pixels along the longer side
SectionMap cut_section(const State& state, int columns);

/// One byte a pixel in Base64: 255 where all planes are in grains, else 254 times the mean saturation of the others, rounded.
std::string section_picture(const SectionMap& map, const std::vector<double>& saturation);

/// A grain that the picture's plane cuts, the force of the fluids on it and how far it has gone, in the picture's directions.
struct CutGrain {
  double across = 0.0, up = 0.0;              ///< from the lower corner [m]
  double radius = 0.0;                        ///< of the cut [m]
  double force_across = 0.0, force_up = 0.0;  ///< [N]
  double moved_across = 0.0, moved_up = 0.0;  ///< [m]
};

/// The grains in the plane of a map of one plane, with forces [N] and displacements [m] by identity.
std::vector<CutGrain> cut_grains(const State& state, const SectionMap& map, const std::vector<Vec3>& force,
                                 const std::vector<Vec3>& displacement);

}  // namespace puadem
