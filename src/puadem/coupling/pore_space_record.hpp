#pragma once

#include <array>

#include "puadem/base/gaussian_mixture.hpp"
#include "puadem/base/vec3.hpp"

namespace puadem {

/// Values of one kind over the pore space at one row, by number, and the mixture of normal distributions that fits them.
struct PoreSizes {
  int samples = 0;
  double mean = 0.0, deviation = 0.0;                   ///< of the samples [-]
  int parts = 0;                                        ///< of the mixture
  std::array<NormalPart, most_normal_parts> part{};     ///< the first `parts` of them, by mean
  int first_class = 0, density_begin = 0, classes = 0;  ///< classes from there, in `UnsaturatedRecord::pore_density`
};

/// What the pore space looks like at a row (theory 7.10).
struct PoreSpaceRow {
  PoreSizes pore_radius;    ///< R_i / <r>, pore units
  PoreSizes throat_radius;  ///< r_in / <r>, throats with a gap
  PoreSizes porosity;       ///< void of each pore unit over the volume of its cells
};

/// Classes per unit of the value: of pore radii, throat radii, porosities.
inline constexpr std::array<int, 3> pore_space_classes{20, 50, 50};

/// A block of the box, which moves with it, at a row (theory 7.10).
struct LocalBlock {
  int grains = 0;           ///< with their centres in it
  double porosity = 0.0;    ///< [-]
  double saturation = 1.0;  ///< water over void [-]
  Vec3 displacement;        ///< mean of its grains since the first row, beyond the motion of the box [m]
};

}  // namespace puadem
