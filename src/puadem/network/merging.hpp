#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "puadem/geometry/facets.hpp"
#include "puadem/network/pore_shape.hpp"

namespace puadem {

struct MergeOptions {
  double ratio = 0.9;  ///< merge where R_ij / min(R_i, R_j) exceeds it; infinity: only what must merge
  int limit = 20;      ///< most cells in one unit
  PoreShape shape = PoreShape::faces;
  std::span<const double> rank;  ///< per facet, in place of R_ij / min(R_i, R_j); empty: that ratio
  /// Per cell, bit f where it touches wall face f: no unit comes to reach from one wall to the opposite one; empty: no walls.
  std::span<const std::uint8_t> walls{};
};

/// Units that merging begins with, in place of single cells (theory 3.11).
struct StartingUnits {
  std::span<const int> unit;                               ///< per cell: cells of one unit begin together; -1: alone
  std::span<const std::array<std::int8_t, 3>> cell_shift;  ///< per cell: where it lies in the frame of its unit, in periods
  /// A starting unit falls apart at facets where 2 r* over the lesser radius of the two single cells, or the rank, has come
  /// below this.
  double keep = 0.8;
  /// Per cell: units of different kinds stay apart, but for cells that have no void and must join, and for those of less than a
  /// twentieth of the mean cell's void, which may join a higher kind.
  std::span<const int> kind;
};

/// Partition of the cells into pore units.
struct MergedCells {
  std::vector<int> unit;                               ///< of each cell; units are numbered by their lowest cell
  std::vector<std::array<std::int8_t, 3>> cell_shift;  ///< where a cell lies in the frame of its unit, in periods
  int units = 0;
  int forced = 0;  ///< cells without void of their own that had to join a neighbour
};

/// Joins cells to pore units, worst throat first (theory 3.7). In each round every facet that is the
/// worst of both its units merges them; worst is the largest R_ij / min(R_i, R_j), then the largest
/// void area (facets around one wide gap tie exactly), then the lowest facet. So the order is local: it does not depend on
/// threads or on how the cells are spread. A cell whose void volume is nil to rounding always joins a neighbour.
///
/// @param cell_void   void volume per cell [m3]
/// @param cell_faces  facets and wall faces per cell
/// @param wide        R_ij = 2 gamma / p_e = 2 r* per facet [m]
/// @param void_area   per facet [m2]
/// @param start       empty: every cell begins alone
MergedCells merge_cells(int cells, std::span<const Facet> facets, std::span<const double> cell_void,
                        std::span<const int> cell_faces, std::span<const double> wide, std::span<const double> void_area,
                        const MergeOptions& options, const StartingUnits& start = {});

}  // namespace puadem
