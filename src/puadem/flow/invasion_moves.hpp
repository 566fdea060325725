#pragma once

#include "puadem/flow/invasion.hpp"

namespace puadem {

/// Carries out one candidate at the state's capillary pressure: the fluids of the pore or throat
/// itself first, then what is cut off by it, then what is reached again (theory 4.5). Volumes, ledger,
/// clusters and queues follow; every event is reported.
void carry_out(const PoreNetwork& network, const InvasionCandidate& candidate, InvasionState& state,
               const InvasionEventCallback& on_event);

/// Looks at once at all that the moves since the last stop have cut off, for `TrapCheck::step`.
void trap_at_stop(const PoreNetwork& network, InvasionState& state, const InvasionEventCallback& on_event);

/// Gives a pore in equilibrium the wetting volume of its local law and books the exchange.
/// A pore below its body pressure, about to be refilled, is left as it is.
/// @return change of the wetting volume [m3]
double settle(const PoreNetwork& network, int pore, InvasionState& state);

}  // namespace puadem
