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
};

/// Bridges of four pairs of grains, all that the loop over them needs while the ends touch.
struct alignas(64) BridgeBlock {
  std::array<int, 4> first, second;  ///< records of grains, no images; an empty lane names the dummy twice
  std::array<int, 4> bridge;         ///< number; -1: empty lane
  Lanes at_contact;                  ///< force there [N]
  Lanes reach;                       ///< [m]
  Lanes gap, force;                  ///< at the last evaluation [m], [N]
};

/// And what it needs where they stand apart: F = (sum of terms in sqrt(1 - D / D_max)) (1 - D / D_0), theory 8.3, 8.4.
struct alignas(32) BridgeSeries {
  Lanes constant;  ///< A of D_0^2 = A + B D^2 [m2]
  std::array<Lanes, bridge_terms> term;
};

/// The bridges as the force loop goes through them, by place; made with the neighbour list.
struct BridgeList {
  LargeArray<BridgeBlock> block;
  LargeArray<BridgeSeries> series;
  std::vector<int> at_wall;                         ///< numbers of the bridges to walls
  std::vector<int> record_at_wall;                  ///< of their grains
  std::vector<int> start;                           ///< bridges whose first end is grain i: start[i] .. start[i + 1]
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
