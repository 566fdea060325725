#pragma once

#include <span>
#include <vector>

#include "puadem/flow/two_phase_flow.hpp"
#include "puadem/network/pore_units.hpp"

namespace puadem {

/// What fluids make of pores that must not merge: 1 where a pore holds gas, 0 where it is full of water.
std::vector<int> fluid_kinds(const TwoPhaseState& state);

/// Reservoirs are full of their fluid, whatever volume their pores have now [m3].
void fill_reservoirs(const TwoPhaseModel& model, std::span<const double> volume, TwoPhaseState& state);

/// Brings two fluids into a network made anew for the same places of the grains (theory 7.6): water goes with its cells, and
/// within a cavity in equal shares of the void, so that nothing is lost and no pore is fuller than full. Throats that stand
/// stay open or closed, new ones between gas are open. What cells take along that join or leave a reservoir is booked.
///
/// @pre reservoirs of `state` are full
/// @param cell_void  per cell before, at the present places [m3]
/// @param model      of the network made anew
/// @param changed    if not null, counts the pores whose saturation has changed by more than 0.01 by merging
TwoPhaseState carry_fluids(const PoreNetwork& before, std::span<const double> cell_void, const TwoPhaseModel& former_model,
                           const RebuiltNetwork& now, const TwoPhaseModel& model, const TwoPhaseState& state,
                           long* changed = nullptr);

}  // namespace puadem
