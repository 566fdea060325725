#pragma once

#include "puadem/flow/two_phase_step.hpp"

namespace puadem {

/// Carries out all moves of gas that the pressures at the end of an accepted step ask for (theory 6.4), each decided
/// by these pressures alone, so that their order does not matter; then finds what is cut off or reached again.
/// @return the number of moves
long carry_out_events(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseTrial& trial, TwoPhaseState& state,
                      const TwoPhaseCallbacks& callbacks);

/// Sets which pores of both fluids reach a boundary of theirs; reports what changed.
void find_clusters(const TwoPhaseModel& model, TwoPhaseState& state, const TwoPhaseCallbacks& callbacks);

}  // namespace puadem
