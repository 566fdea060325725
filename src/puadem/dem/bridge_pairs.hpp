#pragma once

#include <span>

#include "puadem/dem/bridge_exchange.hpp"
#include "puadem/dem/grain_system.hpp"

namespace puadem {

// Pairs of ends that may carry a bridge: two grains, or a grain and a wall, named as in GrainBridges.

/// Ends that touch, ascending. @pre the forces are those of the present places
std::vector<std::array<int, 2>> touching_ends(const GrainSystem& system);

/// The pairs of given ends, ascending, with their radii and the gaps of the present places.
BridgePairs pairs_between(const GrainSystem& system, const std::vector<std::array<int, 2>>& ends);

/// All pairs whose gap is less than `reach` [m].
BridgePairs pairs_within(const GrainSystem& system, double reach);

/// A gap that no bridge of the supply reaches across [m].
double farthest_bridge(const GrainSystem& system, const BridgeModel& model, const BridgeSupply& supply);

/// A volume of liquid shared by pairs as small bridges of one suction share it; 0 for pairs too far apart (theory 8.7) [m3].
std::vector<double> shared_volume(const BridgeModel& model, const BridgePairs& pairs, double total);

/// Notes ends that touch and have no bridge in `touched`, each once until the lists are made anew.
void note_touches(GrainSystem& system);

/// @throws InputError  a periodic box in which a bridge might reach two images of one grain
void guard_images(const GrainSystem& system);

}  // namespace puadem
