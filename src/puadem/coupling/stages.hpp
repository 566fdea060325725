#pragma once

#include "puadem/coupling/run.hpp"

namespace puadem {

/// The stages of a case, one function each. They change the state, tell the observer and add to the
/// results; `run` calls them in order.

/// Grains and box of the case, brought to a stress and a porosity.
/// @throws InputError, NumericalError as `make_packing`
void run_compact_stage(const Case& c, const CompactStage& stage, State& state, const Observer& observer, RunResults& results);

/// Pore network of the grains as they lie, then the capillary pressures of the path.
/// @throws InputError, NumericalError as `build_pore_network`, `start_invasion` and `follow_path`
void run_retention_stage(const Case& c, const RetentionStage& stage, State& state, const Observer& observer, RunResults& results);

/// Facts of the packing as it lies, into the results: numbers, radii, porosities.
void describe_packing(const State& state, RunResults& results);

/// Thrown where the observer asks to stop; `run` turns it into a result marked as interrupted.
struct Interrupted {};

}  // namespace puadem
