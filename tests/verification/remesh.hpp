#pragma once

#include <array>
#include <vector>

#include "puadem/coupling/unsaturated_step.hpp"

// Two fluids through many new networks, measured for tests and for docs/validation.md (theory 7.6).

namespace puadem::verification {

/// A layer of grains at rest under 10 kPa, water and air in its pores: air above, water below, sides periodic.
struct TwoFluidLayer {
  static constexpr double stress = 10e3;  ///< on the upper wall [Pa]

  Domain domain;
  Particles particles;
  GrainSystem grains;
  PoreNetwork network;
  UnsaturatedOptions options;
  UnsaturatedCache cache;
  UnsaturatedState fluids;

  /// @param height  of the box, over its width
  TwoFluidLayer(int count, double height);
  double saturation_now() const { return totals(network, *cache.model, fluids.flow).saturation; }
  void rest_fluids();
  /// Air enters at rising capillary pressure, between grains that stand.
  void drain_to(double saturation);
};

/// A layer whose lower wall stands while the upper one slides, with a new network every 200 steps of the grains.
struct ShearedLayer {
  int remeshes = 0;
  long cells_renewed = 0;
  double shear = 0.0;     ///< way of the wall over the height
  double ledger = 0.0;    ///< the largest error of water or gas, over the void
  double overfull = 0.0;  ///< what the fullest pore held more than its volume after a new network, over that volume
  double saturation = 0.0, saturation_last = 0.0;
};
ShearedLayer shear_under_suction(int count, int remeshes);

/// How many numbers of network and fluids differ after new networks at the same places.
int bits_changed_at_rest(int count, int remeshes);

/// A column, its lower half full of water and its upper half of air, whose grains are put somewhere else around their places
/// for every new network. No fluid flows: what moves the front are the new networks alone.
struct RemeshedFront {
  int remeshes = 0;
  long cells_renewed = 0;
  double passed = 0.0;    ///< water above the front, as a height of its pores, over the mean diameter of a grain
  double farthest = 0.0;  ///< pore on the wrong side that is more than half of the wrong fluid: from the front, the same
  double water = 0.0;     ///< change of the water, over all
};
RemeshedFront front_through(int count, int remeshes, double displacement);

/// Equilibria of a drainage, `stops` by half of gamma / <r>, with a new network every so many coupled steps, each of 50
/// steps of the grains.
struct RemeshedDrainage {
  std::vector<double> capillary_pressure, saturation, strain;
  long remeshes = 0;
};
RemeshedDrainage drain_with_remeshes(int count, int every, int stops = 12);

}  // namespace puadem::verification
