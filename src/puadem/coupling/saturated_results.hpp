#pragma once

#include "puadem/coupling/run.hpp"

namespace puadem {

/// The row of a state; times, gradient and degrees are the caller's.
/// @param height  of the box along the record's axis at the start [m]
/// @pre `measures` belong to the present places
SaturatedRow saturated_row(const PoreNetwork& network, const SaturatedState& fluid, const GrainSystem& grains,
                           const GrainMeasures& measures, const SaturatedRecord& record, double height);

/// Degrees of consolidation of a row (theory 7.4).
void set_degrees(const ConsolidationReference& reference, SaturatedRow& row);

/// What a stage found, by name.
void describe_saturated(const Case& c, const SaturatedStage& stage, const SaturatedRecord& record, const SaturatedState& fluid,
                        const GrainSystem& grains, RunResults& results);

}  // namespace puadem
