#pragma once

#include "puadem/coupling/run.hpp"

namespace puadem {

/// Volumes of both fluids in the counted pores.
FlowVolumes flow_volumes(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state);

/// What the last stage of the state found, by names that begin with the stage's, and its ledger, into the results.
/// @param initial_area  A_0 of theory 5.6 [m2]
void describe_two_phase(const TwoPhaseModel& model, const State& state, const FlowVolumes& start, double initial_area,
                        RunResults& results);

}  // namespace puadem
