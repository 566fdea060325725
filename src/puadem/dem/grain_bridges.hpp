#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "puadem/base/large_array.hpp"
#include "puadem/base/vec3.hpp"
#include "puadem/bridges/bridges.hpp"
#include "puadem/dem/lanes.hpp"

namespace puadem {

/// What becomes of liquid where grains meet and part.
struct BridgeRules {
  /// Where the liquid of a ruptured bridge goes, at given volume: to the other bridges of its grains, which also give each
  /// new one its share; or it stays on the two grains until they touch something.
  enum class Exchange { neighbours, films };
  BridgeFormation formation = BridgeFormation::at_contact;  ///< of the first bridges; later ones form at contact
  RuptureSplit split = RuptureSplit::neck;
  Exchange exchange = Exchange::neighbours;
  bool by_pores = false;  ///< bridges come and go with the fluids in the pores around them, not with contacts
};

/// Bridges of one grain to four partners: all that the force loop needs while they touch.
struct alignas(64) BridgeBlock {
  std::array<int, 4> partner;  ///< records, no images; an empty lane names the grain itself
  std::array<int, 4> bridge;   ///< number; -1: empty lane
  Lanes at_contact;            ///< force there [N]
};

/// And what it needs where they stand apart: F = (sum of terms in sqrt(1 - D / D_max)) (1 - D / D_0), theory 8.3, 8.4.
struct alignas(32) BridgeSeries {
  Lanes reach, inverse_reach;  ///< D_max [m], [1/m]
  Lanes constant;              ///< A of D_0^2 = A + B D^2 [m2]
  std::array<Lanes, bridge_terms> term;
};

/// What all bridges of a grain pull it with.
struct alignas(32) BridgePull {
  Lanes force;  ///< [N]
};

/// The bridges as the force loop goes through them, grain by grain: each stands with both of its grains, so that neither has
/// to be told by the other. Made with the neighbour list.
struct BridgeList {
  LargeArray<int> start;  ///< blocks of record k: start[k] .. start[k + 1]
  LargeArray<BridgeBlock> block;
  LargeArray<BridgeSeries> series;
  LargeArray<BridgePull> pull;                      ///< on record k
  std::vector<std::array<int, 2>> record;           ///< of the ends of every bridge; a wall as -1 - wall
  std::vector<int> at_wall;                         ///< numbers of the bridges to walls
  std::vector<int> first;                           ///< bridges whose first end is grain i: first[i] .. first[i + 1]
  std::vector<std::uint8_t> met_grains, met_walls;  ///< like `live`: touching lanes that have been looked at
};

/// Liquid between the grains of a system (theory 8.6, 8.7). Ends are named by the identity of grains, walls follow after them.
struct GrainBridges {
  BridgeModel model;
  BridgeRules rules;
  double suction = 0.0;  ///< of all bridges, at given suction [Pa]
  Bridges bridges;
  std::vector<double> film;                 ///< liquid on every grain that is in no bridge, at given volume [m3]
  double water_start = 0.0;                 ///< that was put in, at given volume [m3]
  std::vector<std::array<int, 2>> touched;  ///< ends that have touched since the last exchange and have no bridge
  long formed = 0, ruptured = 0;
  BridgeList list;
};

}  // namespace puadem
