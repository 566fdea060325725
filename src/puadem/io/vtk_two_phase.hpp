#pragma once

#include "puadem/coupling/state.hpp"
#include "puadem/io/vtk_writer.hpp"

namespace puadem {

/// Pores as in vtk_fields, with `wetting_pressure` and `nonwetting_pressure` [Pa] (not a number where the fluid is not),
/// `gas_cluster` (0 for the largest, -1 without gas) and `reservoir`.
VtkPolyData two_phase_pore_fields(const State& state, const TwoPhaseModel& model);

/// Throats as in vtk_fields, with `open`, and `wetting_flux` and `nonwetting_flux` [m/s]: vectors along the line, the
/// flow over the void section.
VtkPolyData two_phase_throat_fields(const State& state, const TwoPhaseModel& model);

}  // namespace puadem
