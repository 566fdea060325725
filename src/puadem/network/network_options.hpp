#pragma once

#include <array>

#include "puadem/geometry/throat_entry.hpp"

namespace puadem {

/// How a packing becomes pores and throats. Defaults are the paper's, as far as it says.
struct NetworkOptions {
  EntryLaw entry_law = MayerStowePrincen{};
  double contact_angle = 0.0;  ///< theta [rad], in the entry and snap-off radii
  /// Neighbours merge where R_ij / min(R_i, R_j) exceeds this (theory 3.7); infinity: no merging.
  double merge_ratio = 0.9;
  int merge_limit = 20;  ///< most tetrahedra in one unit
  /// Faces of the box whose walls hold the fluid as grains do. Elsewhere it slips along them: a wall is then
  /// a plane of symmetry, the packing goes on behind it as its mirror image (theory 3.8).
  std::array<bool, 6> no_slip{};
};

}  // namespace puadem
