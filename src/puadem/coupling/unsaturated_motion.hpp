#pragma once

#include <span>

#include "puadem/coupling/unsaturated_step.hpp"
#include "puadem/dem/material.hpp"

// Grains and two fluids move each other in time (theory 7.9): frozen_limit once, then move_in_time again and again.

namespace puadem {

/// Longest time over which the fluids' forces may stay frozen [s]: that of pores full of the wetting fluid, whose drag no
/// other filling exceeds (theory 7.3).
double frozen_limit(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                    const Domain& domain);

/// One interval: grains move, and swell, under the forces that were found last; the fluids follow over the same time while
/// the pressure of the water's reservoirs goes straight to a new one; new forces.
/// @param longest   of the interval [s]; shorter where the fastest grain would go a hundredth of the mean radius
/// @param pressure  capillary pressure of the reservoirs as it is in time, [Pa]
/// @param time      at which the interval begins [s]
/// @return its length, whole steps of the grains [s]
/// @throws NumericalError  from grains, network and flow
double move_in_time(const UnsaturatedOptions& options, std::span<const Material> materials, double longest,
                    const Schedule& pressure, double time, GrainSystem& grains, Particles& particles, PoreNetwork& network,
                    UnsaturatedState& state, UnsaturatedCache& cache);

}  // namespace puadem
