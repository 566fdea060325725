#pragma once

#include <array>
#include <cstdint>

#include "puadem/geometry/throat_entry.hpp"
#include "puadem/network/pore_shape.hpp"

namespace puadem {

/// When two neighbours become one pore unit (theory 3.7).
enum class MergeCriterion : std::uint8_t {
  entry_ratio,       ///< their throat is nearly as wide as the smaller body: `merge_ratio`
  insphere_overlap,  ///< the spheres that touch the four sites of either cell overlap
};

/// What the entry of a throat between merged units is taken from (theory 3.4).
enum class ThroatOutline : std::uint8_t {
  facet,   ///< each facet by itself
  window,  ///< all facets of one flat window between two units together
};

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
  MergeCriterion merge_criterion = MergeCriterion::entry_ratio;
  PoreShape pore_shape = PoreShape::faces;
  ThroatOutline throat_section = ThroatOutline::facet;
};

}  // namespace puadem
