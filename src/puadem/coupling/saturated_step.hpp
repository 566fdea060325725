#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/coupling/fluid_forces.hpp"
#include "puadem/coupling/moving_pores.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/flow/single_phase_flow.hpp"

// Grains and one fluid that fills their pores move each other (theory 7.2):
//   start_saturated -> saturated_step, again and again.

namespace puadem {

struct SaturatedOptions {
  double viscosity = 1.0e-3;             ///< [Pa s]
  double density = 998.0;                ///< of the fluid, for buoyancy [kg/m3]
  std::optional<double> bulk_modulus;    ///< of the fluid; none: incompressible [Pa]
  std::array<FaceCondition, 6> faces{};  ///< of the piezometric pressure
  double remesh_displacement = 0.0;      ///< of a grain, at which a new network is made [m]
  double remesh_strain = 0.05;           ///< change of the void over the void, at which one is made [-]
  NetworkOptions network;                ///< of pores that are not merged: units have no resistance inside
  std::optional<ConductanceLimits> limits;
};

/// Everything a restart needs besides network, grains and their frozen forces.
struct SaturatedState {
  NetworkPlace place;
  std::vector<double> pore_volume;          ///< of the network's pores, now [m3]
  std::vector<double> pressure;             ///< piezometric, of the last step [Pa]
  std::array<CompensatedSum, 6> inflow;     ///< through the faces since the start [m3]
  CompensatedSum stored;                    ///< taken up by compression since the start [m3]
  double void_start = 0.0, void_now = 0.0;  ///< [m3]
  FluidForces forces;                       ///< that act until the next step
  long steps = 0, remeshes = 0;
  long cells_renewed = 0;  ///< that remeshes did not find again

  /// Fluid that came in and the void's growth must agree; over the void [-].
  double ledger_error() const;
};

/// What follows from network and place and is kept while they stand: nothing of it needs saving.
struct SaturatedCache {
  PushedAreas areas;
  SinglePhaseMemory memory;
};

/// One fluid at rest in the pores of a network just made. Sets its forces on grains and walls: buoyancy, and the
/// pressures of `pressure` or none.
SaturatedState start_saturated(const SaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                               GrainSystem& grains, SaturatedCache& cache);

/// What a restart keeps no copy of, made again from the places at which the network was: to the last bit what it was.
void renew_cache(const SaturatedOptions& options, const PoreNetwork& network, std::span<const double> radius,
                 const NetworkPlace& place, SaturatedCache& cache);

/// One coupled step: grains first, `substeps` of their own under the forces of the fluid that were found last; then the
/// fluid over the same time, driven by the exact change of every pore; a new network where the grains ask for one; new
/// forces. `network` and the places of `particles` are kept in step.
/// @throws NumericalError  from grains, network and flow
void saturated_step(const SaturatedOptions& options, long substeps, GrainSystem& grains, Particles& particles,
                    PoreNetwork& network, SaturatedState& state, SaturatedCache& cache);

/// Longest time over which forces may stay frozen: 2 over the largest rate at which the fluid brings grains to rest,
/// theory 7.3 [s]. Grains and fluid as they stand.
double coupling_limit(const SaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                      const Domain& domain, SaturatedCache& cache);

/// @throws InputError  where forces would stay frozen for an interval that reaches the limit
void require_below_limit(std::string_view stage, double interval, double limit);

}  // namespace puadem
