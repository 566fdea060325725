#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "puadem/flow/flow_graph.hpp"
#include "puadem/flow/flow_tree.hpp"
#include "puadem/flow/pressure_system.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// What holds at a face of the box, on all pores that touch it.
struct FaceCondition {
  enum class Kind : std::uint8_t {
    closed,    ///< nothing passes
    pressure,  ///< `value` [Pa]
    inflow,    ///< `value` [m3/s] comes in through a reservoir of one pressure, which the solve finds
  };
  Kind kind = Kind::closed;
  double value = 0.0;
};

/// The fluid's volume yields: bulk modulus K_f, over one implicit step in time (theory 3.9).
struct SlightCompressibility {
  double bulk_modulus = 2.2e9;              ///< [Pa]
  double time_step = 0.0;                   ///< [s]
  std::span<const double> pressure_before;  ///< per pore [Pa]
};

/// Bounds of throat conductances as multiples of their median (their mean is that of the few shortest throats).
/// Off by default: lattices and random packings need none. Throats that pass nothing stay closed.
struct ConductanceLimits {
  double low = 1e-4, high = 1e2;
};

/// Flow of one fluid that fills all pores (theory 3.9).
struct SinglePhaseProblem {
  std::array<FaceCondition, 6> faces{};
  Vec3 pressure_gradient{};             ///< mean gradient along periodic axes [Pa/m]
  double viscosity = 1.0e-3;            ///< [Pa s]
  std::span<const double> volume_rate;  ///< dV_i/dt per pore [m3/s]; empty: grains at rest
  std::optional<SlightCompressibility> compressibility;
  std::optional<ConductanceLimits> conductance_limits;
  std::span<const double> guess;  ///< per pore, where iterations start; empty: the last pressures of the memory [Pa]
};

struct SinglePhaseFlow {
  std::vector<double> pressure;       ///< per pore [Pa]; where no pressure is given anywhere, relative to pore 0
  std::vector<double> throat_flow;    ///< from pore i to j [m3/s]; 0 inside a pore of several parts, where it is not defined
  std::array<double, 6> face_inflow;  ///< into the box; a pore at two faces of one pressure counts for the first [m3/s]
  double imbalance = 0.0;             ///< largest net flow of a pore, over the largest flow through one [-]
  double carried = 0.0;  ///< the same as the pressures left it, before it was carried to where pressures are given [-]
  int joined = 0;        ///< throats without resistance
  int limited_low = 0, limited_high = 0;  ///< conductances that the limits raised and lowered
  PressureSolveReport solve;
};

/// What one solve leaves for the next: as long as topology, kinds of conditions and conductances stand, only
/// the right-hand side is made anew, and the last pressures are where iterations start. Begin with an empty one.
struct SinglePhaseMemory {
  PressureSolverOptions solver;
  std::vector<double> conductance, diagonal;      ///< the numbers in the matrix
  unsigned pressure_faces = 0, joined_faces = 0;  ///< bit f: face f
  bool compressible = false;
  int pinned = -1;  ///< node whose pressure is 0 where none is given
  FlowGraph graph;
  std::vector<int> unknown;  ///< of each node; -1 where its pressure is prescribed
  std::optional<PressureSystem> system;
  std::vector<double> solution;
  FlowTree tree;  ///< by which flows are balanced
};

/// @throws InputError      for a condition on a face that is no wall or has no pore, a gradient along an axis with
///                         walls, two pressures on one pore, more fluid going in than can leave
/// @throws NumericalError  where a part of the network is cut off from every given pressure, or the solve fails
SinglePhaseFlow solve_single_phase(const PoreNetwork& network, const Domain& domain, const SinglePhaseProblem& problem,
                                   SinglePhaseMemory& memory);

}  // namespace puadem
