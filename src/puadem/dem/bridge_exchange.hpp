#pragma once

#include "puadem/dem/grain_system.hpp"

namespace puadem {

/// Liquid to begin with: a suction, or a volume.
struct BridgeSupply {
  double suction = 0.0;  ///< of all bridges, where the model is of given suction [Pa]
  double each = 0.0;     ///< of every bridge [m3]
  double total = 0.0;    ///< in place of `each`: of all, shared as small bridges of one suction share it (theory 8.7) [m3]
};

/// Puts the first bridges between grains, and between grains and walls.
/// @pre the forces are those of the present places
/// @throws InputError  no pair that could carry a bridge, more liquid than bridges hold, a periodic box too narrow for them
void wet_grains(GrainSystem& system, const BridgeModel& model, const BridgeRules& rules, const BridgeSupply& supply);

/// The bridges of these pairs and no others, at given suction; that is where the fluids in the pores say where they stand.
/// @param amount  per pair: the suction, or 0 for none [Pa]
/// @pre as `wet_grains`
void place_bridges(GrainSystem& system, const BridgeModel& model, const BridgeRules& rules, double suction,
                   const BridgePairs& pairs, std::span<const double> amount);

/// What a step does with the bridges once contacts are evaluated: forces; and from time to time rupture, and new bridges
/// where ends have touched since.
void follow_bridges(GrainSystem& system);

/// Bridges of a system that was read: what follows from the case and from what stands in it already.
void restore_bridges(GrainSystem& system, const BridgeModel& model, const BridgeRules& rules);

}  // namespace puadem
