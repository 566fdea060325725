#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "puadem/geometry/domain.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

// The shape of an invaded region in a thin bed, seen through its thin direction (theory 5.7).

/// A picture of square pixels, row by row; 1 where it is invaded.
struct PatternImage {
  int columns = 0, rows = 0;
  double pixel = 0.0;  ///< side [m]
  std::vector<std::uint8_t> invaded;

  bool at(int column, int row) const { return invaded[to_size(row * columns + column)] != 0; }
};

/// Mean distance of neighbouring pores, (box / number of pores)^(1/3) [m].
double pore_spacing(const PoreNetwork& network, const Domain& domain);

/// Projects pores along an axis. A pixel counts as invaded where more than `share` of the void of the pores whose
/// centres lie over it is in invaded pores; with share = 0 one invaded pore is enough.
/// @param axis   the direction looked along; columns follow the next axis, rows the one after it, cyclically
/// @param pixel  wanted side [m]; rounded so that whole pixels fit the first of the two
/// @throws InputError  for a pixel that is not positive
PatternImage project_pattern(const PoreNetwork& network, const Domain& domain, int axis, std::span<const std::uint8_t> invaded,
                             double pixel, double share);

/// Boxes of growing size that are needed to cover a pattern, and the slope of their number.
struct BoxCount {
  std::vector<double> size;   ///< side of the boxes [m]
  std::vector<double> boxes;  ///< how many hold at least one invaded pixel: the least over shifts of the grid
  double dimension = 0.0;     ///< -d ln(boxes) / d ln(size), by least squares; 0 where there are less than two sizes
};

/// Sizes double from one pixel to a quarter of the shorter side of the picture.
BoxCount count_boxes(const PatternImage& image);

/// Width of fingers, 2 A / P from area and perimeter of the invaded pixels: the width of a long strip, the radius of
/// a disc [m]. The perimeter follows from Crofton's formula with lines in four directions; where the pattern leaves
/// the picture there is none. 0 where nothing, or all, is invaded.
double finger_width(const PatternImage& image);

}  // namespace puadem
