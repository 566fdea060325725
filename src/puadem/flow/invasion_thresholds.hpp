#pragma once

#include "puadem/flow/invasion.hpp"

namespace puadem {

/// Entry, body and snap-off pressures of a network (theory 4.4).
/// @throws InputError  as `start_invasion`, for everything but the reservoirs
InvasionThresholds invasion_thresholds(const PoreNetwork& network, const Fluids& fluids, const InvasionOptions& options);

}  // namespace puadem
