#pragma once

#include <optional>

#include "puadem/flow/invasion.hpp"

namespace puadem {

/// What may happen next, read from the state; the queues hold such candidates until their turn.
std::optional<InvasionCandidate> drainage_candidate(const PoreNetwork& network, const InvasionState& state, int throat);
std::optional<InvasionCandidate> snap_off_candidate(const PoreNetwork& network, const InvasionState& state, int throat);
std::optional<InvasionCandidate> fill_candidate(const InvasionState& state, int pore);

/// Queues what a throat may do now.
void queue_throat(const PoreNetwork& network, int throat, InvasionState& state);

/// Queues what a pore and its throats may do now. To be called for every pore that changed fluid or was
/// connected again; what becomes impossible is found out when its turn comes.
void queue_pore(const PoreNetwork& network, int pore, InvasionState& state);

/// First candidate of a queue that is still possible and, for drainage, lies below `limit`, for
/// imbibition above it. Drops those in front that are not.
std::optional<InvasionCandidate> next_drainage(const PoreNetwork& network, double limit, InvasionState& state);
std::optional<InvasionCandidate> next_imbibition(const PoreNetwork& network, double limit, InvasionState& state);

}  // namespace puadem
