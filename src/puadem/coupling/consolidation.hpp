#pragma once

#include "puadem/coupling/saturated_stage.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// Loads a copy of the grains without fluid under the wall `loaded`, whose target stress is set, until they are at rest:
/// what the consolidation will end at. Permeability from the network (theory 7.4).
/// @throws NumericalError  grains that do not come to rest, or do not settle
ConsolidationReference measure_consolidation(GrainSystem grains, const PoreNetwork& network, int loaded, double drainage_length,
                                             double viscosity);

}  // namespace puadem
