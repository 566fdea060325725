#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "puadem/base/csr.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "puadem/geometry/regular_triangulation.hpp"

namespace puadem {

/// How the cells of two triangulations of the same grains correspond. Most cells stand in both; the others fill small
/// cavities, each with the same outer surface in both: after small motion nearly always two cells in place of three or
/// three in place of two.
struct CellMatch {
  std::vector<int> before;  ///< per cell now: the cell of the same vertices before, or -1
  /// Per cell that stays: how far, in periods, its listed image before lies from the one listed now.
  std::vector<std::array<std::int8_t, 3>> shift;
  Csr vanished, appeared;  ///< per cavity, by its lowest new cell: cells before and cells now, ascending
};

/// Cells are the same where their vertices are, unless they have turned inside out.
/// @param wraps  per grain: periods by which it was moved back into the box since `before`, which knows it where it would
///               stand without; empty: none was
/// @param turned  per cell before: 1 where it has turned inside out since; empty: none has
CellMatch match_cells(const Triangulation& before, const Triangulation& now,
                      std::span<const std::array<std::int8_t, 3>> wraps = {}, std::span<const std::uint8_t> turned = {});

/// Brings an amount that cells hold from one triangulation to the next: a cell that stays keeps its own to the last bit, a
/// cavity shares its sum by void volume, so that the sum of all stays and in a cavity no cell is fuller than another.
///
/// @param amount  per cell before
/// @param space   void per cell now [m3]
std::vector<double> carry_over(const CellMatch& match, std::span<const double> amount, std::span<const double> space);

/// Which way round each cell is, +1 or -1; 0 where it is flat. A cell whose sign has changed since it was made has turned
/// inside out: the cells no longer tile the box.
std::int8_t cell_orientation(const std::array<Site, 4>& sites);
std::vector<std::int8_t> cell_orientations(const Triangulation& triangulation, const PackingSites& sites);

}  // namespace puadem
