#pragma once

#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/tensor.hpp"

namespace puadem {

/// Liquid bridges as a whole, at the forces last evaluated.
struct BridgeMeasures {
  int bridges = 0;            ///< those to walls included
  double water = 0.0;         ///< in bridges [m3]
  double film = 0.0;          ///< on grains, at given volume [m3]
  double water_error = 0.0;   ///< of the ledger: (put in - in bridges - on grains) / put in, at given volume [-]
  double mean_force = 0.0;    ///< of attraction [N]
  double coordination = 0.0;  ///< bridges of a grain, on average, those to walls included [-]
  long formed = 0, ruptured = 0;
};

/// @pre here and below: the system has bridges
BridgeMeasures measure_bridges(const GrainSystem& system);

/// Their stress, compression positive: theirs is tension [Pa], theory 2.13.
Tensor bridge_stress(const GrainSystem& system);

/// Work that it takes to rupture all bridges [J].
double bridge_energy(const GrainSystem& system);

/// A bridge as others see it.
struct GrainBridge {
  int first = -1;   ///< identity of a grain
  int second = -1;  ///< of a grain, -1 for a wall
  int wall = -1;
  Vec3 branch;                      ///< from the first centre to the second, or to the foot on the wall [m]
  double gap = 0.0;                 ///< negative in contact [m]
  double force = 0.0;               ///< of attraction [N]
  double volume = 0.0;              ///< [m3]
  double capillary_pressure = 0.0;  ///< [Pa]
};

/// What all its bridges pull each grain with, by identity [N].
std::vector<Vec3> bridge_pulls(const GrainSystem& system);

/// All bridges in the order of their ends.
std::vector<GrainBridge> bridges_of(const GrainSystem& system);

}  // namespace puadem
