#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "puadem/coupling/local_porosity.hpp"
#include "puadem/coupling/run.hpp"

// What a stage of grains and two fluids makes of the pore space (theory 7.10).

namespace puadem {

/// The cells of the network a stage "unsaturated-flow" has, at the present places of the grains.
CellGeometry present_cells(const State& state);

/// Void of each pore unit over the volume of its cells [-].
std::vector<double> unit_porosities(const PoreNetwork& network, const CellGeometry& cells);

/// Adds sizes of pores and throats, porosities of pore units and blocks of the box at the last row to the last record.
/// @pre the stage is under way and its row stands
void record_pore_space(const TwoPhaseModel& model, State& state);

/// How far each grain has gone since the first row of the stage under way; none where no such stage is.
std::optional<Displacements> displacements_of(const State& state);

/// The first row, the one half-way between the least and the greatest saturation where they are a tenth apart, and the last.
std::vector<int> telling_rows(const UnsaturatedRecord& record);

/// Blocks of one row beside those of the first.
struct LocalChange {
  std::vector<double> saturation, porosity_change;  ///< of each block [-]
  std::optional<double> wet, dry;                   ///< mean change of blocks of S > 0.5, and of the others [-]
  std::optional<double> correlation;                ///< of the ranks of both
};
LocalChange local_change(const UnsaturatedRecord& record, int row);

/// The blocks of a row.
std::span<const LocalBlock> blocks_of(const UnsaturatedRecord& record, int row);

/// What a stage made of its pore space, by name.
void describe_pore_space(const UnsaturatedRecord& record, RunResults& results);

}  // namespace puadem
