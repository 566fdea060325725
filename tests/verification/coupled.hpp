#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/saturated_step.hpp"
#include "support/packings.hpp"

// Grains and one fluid, measured for tests and for docs/validation.md.

namespace puadem::verification {

/// Grains and one fluid, not yet moved: no friction, no damping.
struct CoupledBed {
  std::vector<Material> materials;
  Particles particles;
  GrainSystem grains;
  PoreNetwork network;
  SaturatedOptions options;
  SaturatedCache cache;
  SaturatedState state;

  /// @param is_drained  at the top
  CoupledBed(testing::Spheres spheres, double viscosity, bool is_drained = false);
  void shake(double speed);
  void step(long substeps) { saturated_step(options, substeps, grains, particles, network, state, cache); }
};

/// A quantity that should be nothing, over its scale.
struct Identity {
  std::string what;
  double found = 0.0;
};

/// What must hold for the fluid's forces whatever the packing (theory 7.1).
std::vector<Identity> force_identities();

/// A bed at rest under water.
struct RestingBed {
  double weight = 0.0;  ///< of the grains less that of their water [N]
  double force = 0.0;   ///< of the contacts on the bottom [N]
  double unbalanced = 0.0;
};
RestingBed rest_in_water(int count);

/// Energy of shaken grains in a closed box of fluid, with what the fluid took; as shares of the first kinetic energy.
struct EnergyGain {
  double interval = 0.0;  ///< over the limit of theory 7.3 [-]
  double taken = 0.0;     ///< by the fluid
  double gained = 0.0;    ///< that nothing explains, the largest
};
EnergyGain gain_of_energy(long substeps);

/// The step of the grains of a column under load with a new network every step, over that without any new one, less one.
double time_step_change_by_remeshing();

}  // namespace puadem::verification
