#pragma once

#include <optional>
#include <vector>

#include "puadem/coupling/bridge_pores.hpp"
#include "puadem/coupling/capillary_forces.hpp"
#include "puadem/coupling/moving_pores.hpp"
#include "puadem/coupling/swelling.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/flow/two_phase_flow.hpp"

// Grains and two fluids near rest move each other (theory 7.6): one round is
//   rest_grains -> follow_grains -> rest_fluids, again until neither moves.
// In time (theory 7.9) see unsaturated_motion.hpp.

namespace puadem {

struct UnsaturatedOptions {
  Fluids fluids;
  TwoPhaseOptions flow;
  NetworkOptions network;
  int air = 5;                                                         ///< face of its reservoir
  std::array<bool, 6> water{false, false, false, false, true, false};  ///< faces of the water's
  double initial_air_fraction = 1e-6;                                  ///< of the pores at the air's face
  double remesh_displacement = 0.0;                                    ///< of a grain, at which a new network is made [m]
  double unbalanced = 1e-3;                                            ///< force ratio at which grains are at rest [-]
  double stress_tolerance = 1e-3;                                      ///< of a wall that holds a stress [-]
  long most_steps = 500'000;                                           ///< of the grains at one capillary pressure
  std::optional<double> dry_at;                                        ///< capillary pressure of a start from dry [Pa]
  std::optional<PendularOptions> bridges;                              ///< between dry pores; none: no bridges
};

/// Everything a restart needs besides network, grains and their frozen forces.
struct UnsaturatedState {
  NetworkPlace place;
  TwoPhaseState flow;
  FluidForces forces;                         ///< that act until the next round
  std::vector<Vec3> tension;                  ///< what menisci in throats make of those on grains [N]
  double capillary_pressure = 0.0;            ///< of the reservoirs [Pa]
  double void_listed = 0.0;                   ///< when the network was made [m3]
  double water_start = 0.0, gas_start = 0.0;  ///< of the counted pores and, water, of bridges [m3]
  double bridge_water = 0.0;                  ///< in bridges, as booked last [m3]
  long remeshes = 0, cells_renewed = 0, pores_changed = 0;
  long grain_steps = 0, fluid_steps = 0;
  double grain_time = 0.0;  ///< that the grains took [s]
  long settling_steps = 0;  ///< of the grains at the present capillary pressure
  SwellingState swelling;
};

/// What follows from network and place.
struct UnsaturatedCache {
  PushedAreas areas;
  std::optional<TwoPhaseModel> model;
};

/// The cache of a state that is gone on from.
void renew_cache(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles, const Domain& domain,
                 const UnsaturatedState& state, UnsaturatedCache& cache);

/// Water everywhere but for a trace of air at its face, at no capillary pressure, or dry at a given one; the fluids' forces on
/// grains and walls. Water that stands in bridges already is counted in.
UnsaturatedState start_unsaturated(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                                   GrainSystem& grains, UnsaturatedCache& cache);

/// Grains move under the forces that were found last until they are at rest, or one has gone as far as calls for a new network.
/// @return whether they rest
/// @throws NumericalError  where they do not come to rest at one capillary pressure
bool rest_grains(const UnsaturatedOptions& options, GrainSystem& grains, Particles& particles, UnsaturatedState& state);

/// Grains move under the same forces while walls do, for a time [s] or until one has gone as far as calls for a new network.
void move_grains(const UnsaturatedOptions& options, double duration, GrainSystem& grains, Particles& particles,
                 UnsaturatedState& state);

/// The fluids follow the grains: every pore's change of volume is passed on, then the network has its new geometry, or is
/// made anew where grains went too far. So slowly that no viscous pressure arises.
void follow_grains(const UnsaturatedOptions& options, GrainSystem& grains, Particles& particles, PoreNetwork& network,
                   UnsaturatedState& state, UnsaturatedCache& cache);

/// The same in a time [s], from which viscous pressures arise, and while grains take water out of pores [m3/s].
void follow_grains(const UnsaturatedOptions& options, double time, std::span<const double> uptake, GrainSystem& grains,
                   Particles& particles, PoreNetwork& network, UnsaturatedState& state, UnsaturatedCache& cache);

/// Pressure of the water's reservoirs from here on, below that of the air [Pa].
void set_water_pressure(const Schedule& pressure, UnsaturatedCache& cache);

/// The forces of the fluids on grains and walls as they stand; they act until the next call.
void set_fluid_forces(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles,
                      GrainSystem& grains, UnsaturatedState& state, const UnsaturatedCache& cache);

/// The fluids come to rest at the capillary pressure of the state, and bridges follow; then their forces are set.
void rest_fluids(const UnsaturatedOptions& options, const PoreNetwork& network, const Particles& particles, GrainSystem& grains,
                 UnsaturatedState& state, UnsaturatedCache& cache, const TwoPhaseCallbacks& callbacks = {});

/// What the books and the pores disagree by, over the void: water, gas [-].
std::array<double, 2> ledger_errors(const PoreNetwork& network, const UnsaturatedState& state, const UnsaturatedCache& cache);

}  // namespace puadem
