#pragma once

#include "puadem/coupling/case.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/coupling/state.hpp"

namespace puadem {

/// The pore network of the grains of a state, after the options of the case. It is sound: `find_network_faults` finds
/// none. Where overlaps of grains take more than a hundredth of the void, the observer gets a warning that names the deepest.
/// @param merged  cells joined to pore units (theory 3.7); else only those that share one power centre or have no void
/// @throws InputError  where there are no grains; InputError that lists the first faults with their grains and places; and as
///                     `build_pore_network`
PoreNetwork checked_network(const Case& c, const State& state, const Observer& observer, bool merged = true);

}  // namespace puadem
