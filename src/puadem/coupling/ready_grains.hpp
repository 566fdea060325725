#pragma once

#include "puadem/coupling/loading_program.hpp"
#include "puadem/coupling/run.hpp"

namespace puadem {

/// The engine with the options of the case, box and walls at rest, forces evaluated; started from the particles where no
/// stage has left one.
/// @throws InputError  for a state without grains
GrainSystem& ready_grains(const Case& c, State& state, const Observer& observer);

/// What a stage's rates are judged by. @pre the forces are those of the present places, `m` belongs to them
LoadingScale loading_scale(const Case& c, const GrainSystem& s, const Particles& particles, const GrainMeasures& m);

/// The wall of a face moves so that grains and fluids together bear `stress` on it [Pa], no faster than grains that
/// `speed_stress` sets moving [Pa].
void hold_stress(int face, double stress, const LoadingScale& scale, GrainSystem& grains);

}  // namespace puadem
