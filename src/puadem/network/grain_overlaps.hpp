#pragma once

#include <span>
#include <string>

#include "puadem/geometry/domain.hpp"
#include "puadem/geometry/regular_triangulation.hpp"

namespace puadem {

/// Overlaps of grains. Where two grains overlap, what they share counts twice in the volumes of pores (theory 3.3).
struct GrainOverlaps {
  double volume = 0.0;          ///< shared by two grains, all pairs [m3]
  double deepest = 0.0;         ///< of the smaller radius [-]
  int first = -1, second = -1;  ///< the grains of the deepest one; -1: none overlaps
  Vec3 place;                   ///< between them [m]
};

/// Of all grains that share a cell, images across periodic faces included.
GrainOverlaps find_overlaps(const Triangulation& triangulation, std::span<const Vec3> centre, std::span<const double> radius,
                            const Domain& domain);

/// "the deepest is that of grains 3 and 8 at (0.001, 0.002, 0.003) m, 31 % of the smaller radius".
std::string deepest_in_words(const GrainOverlaps& overlaps);

}  // namespace puadem
