#pragma once

#include <span>
#include <vector>

#include "puadem/base/compensated_sum.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/flow/two_phase_flow.hpp"

// Grains that take up the wetting fluid of the pores around them and grow (theory 7.9):
//   start_swelling; then for every interval: set_wetting -> swell_grains at every step of the grains -> take_up.

namespace puadem {

/// Grains that swell. Everything a restart needs; empty where no material swells.
struct SwellingState {
  std::vector<int> grain;            ///< identities, ascending
  std::vector<double> start_radius;  ///< R_0 [m]
  std::vector<double> start_mass;    ///< [kg]
  std::vector<double> wetted;        ///< share of the surface that is, in the present interval [-]
  CompensatedSum from_pores;         ///< water taken from counted pores so far [m3]
  CompensatedSum from_reservoirs;    ///< and from pores of the reservoirs [m3]
  double grown = 0.0;                ///< largest growth of a radius since the network was made [m]

  int size() const { return static_cast<int>(grain.size()); }
};

/// Where the water of an interval comes from: pores around each swelling grain and their shares of what it takes.
struct SwellingShares {
  struct Share {
    int pore;
    double part;  ///< of the grain's uptake [-]
  };
  std::vector<std::vector<Share>> of_grain;
};

SwellingState start_swelling(const Particles& particles, std::span<const Material> materials);

/// Wetted share of every swelling grain's surface, and its pores in proportion to the surface they wet: of a pore with both
/// fluids the share of theory 7.7, of all others all or nothing.
/// @param centre  see `followed_centres`
SwellingShares set_wetting(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& flow,
                           std::span<const Vec3> centre, std::span<const double> radius, const Domain& domain,
                           SwellingState& state);

/// Radii and masses after a step of the grains [s]. Mass grows by the water taken up.
/// @pre between two steps, forces not yet evaluated
void swell_grains(std::span<const Material> materials, double density, double duration, GrainSystem& grains, Particles& particles,
                  SwellingState& state);

/// Rates at which the grains took water out of the pores in an interval [m3/s]; books it.
/// @param before  radii of the swelling grains when the interval began [m]
std::vector<double> take_up(const TwoPhaseModel& model, const SwellingShares& shares, std::span<const double> before,
                            double duration, const Particles& particles, SwellingState& state);

/// Radii of the swelling grains now [m].
std::vector<double> swelling_radii(const Particles& particles, const SwellingState& state);

/// Volume by which the swelling grains have grown since the start [m3].
double grown_volume(const Particles& particles, const SwellingState& state);

}  // namespace puadem
