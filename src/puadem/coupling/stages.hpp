#pragma once

#include "puadem/coupling/run.hpp"

namespace puadem {

/// The stages of a case, one function each. They change the state, tell the observer and add to the
/// results; `run` calls them in order.

/// Grains and box of the case, brought to a stress and a porosity.
/// @throws InputError, NumericalError as `make_packing`
void run_compact_stage(const Case& c, const CompactStage& stage, State& state, const Observer& observer, RunResults& results);

/// Any stage that loads the grains of the state: its program, a history row from time to time, and what the
/// rows say (theory 2.18). `index` of the stage in the case.
/// @throws InputError      no grains, walls that a stage needs and the box does not have
/// @throws NumericalError  from the grain engine, or where a stage does not come to its end
void run_loading_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results);

/// Permeability of the box, and fluid driven through it along one axis. `index` of the stage in the case.
/// @throws InputError, NumericalError as `build_pore_network` and `measure_permeability`
void run_permeability_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results);

/// Pore network of the grains as they lie, then the capillary pressures of the path.
/// @throws InputError, NumericalError as `checked_network`, `start_invasion` and `follow_path`
void run_retention_stage(const Case& c, const RetentionStage& stage, State& state, const Observer& observer, RunResults& results);

/// Pore network of the grains as they lie, then two fluids that move in it (theory 6). `index` of the stage in the case.
/// @throws InputError, NumericalError as `build_pore_network`, `make_two_phase_model` and `advance_two_phase`
void run_two_phase_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results);

/// One fluid in all pores; it and the grains move each other (theory 7.2). `index` of the stage in the case.
/// @throws InputError      as `run_loading_stage` and `checked_network`, a coupling interval above the limit
/// @throws NumericalError  from grains, network and flow
void run_saturated_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results);

/// Two fluids in the pores; they and the grains move each other and rest at every capillary pressure of a path (theory 7.6).
/// `index` of the stage in the case.
/// @throws InputError      as `run_loading_stage`, `checked_network` and `make_two_phase_model`
/// @throws NumericalError  from grains, network and flow, or where they do not come to rest
void run_unsaturated_stage(const Case& c, int index, State& state, const Observer& observer, RunResults& results);

/// Facts of the packing as it lies, into the results: numbers, radii, porosities.
void describe_packing(const State& state, RunResults& results);

/// Thrown where the observer asks to stop; `run` turns it into a result marked as interrupted.
struct Interrupted {};

/// Tells the progress at a place the run can go on from.
/// @throws Interrupted  where the observer asks to stop
void tell_at_safe_place(const Observer& observer, const Progress& progress, const State& state, const RunResults& results);

}  // namespace puadem
