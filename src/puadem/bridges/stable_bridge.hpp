#pragma once

#include "puadem/bridges/bridge_shape.hpp"

namespace puadem {

/// What stays as the ends move apart: the suction, where the liquid is joined to much more of it, or the volume.
enum class BridgeControl { suction, volume };

/// The stable bridges between two ends at one suction or of one volume, from contact to rupture (theory 8.2).
struct StableBranch {
  std::array<BridgeEnd, 2> ends;
  BridgeControl control;
  double amount;        ///< p_c / gamma [1/m], or V [m^3]
  BridgeShape rupture;  ///< the last one, whose gap is the rupture distance
};

/// @param amount  p_c / gamma > 0 [1/m], or V > 0 [m^3]
/// @throws InputError  where the ends or the amount make no sense, or the volume is too large for a bridge
StableBranch stable_branch(const std::array<BridgeEnd, 2>& ends, BridgeControl control, double amount);

/// The stable bridge at a gap [m]; a negative gap is taken as contact. None beyond the rupture distance.
/// @throws NumericalError  where so much liquid would wet an end past its widest circle
std::optional<BridgeShape> bridge_on(const StableBranch& branch, double gap);

/// What the stable bridge has least of among its neighbours, over gamma: the energy of its surfaces, at one suction with
/// p V added. Its change is the work that moving the ends apart takes (theory 8.2) [m^2].
double free_energy(const StableBranch& branch, const BridgeShape& shape);

/// Bridges much smaller than the ends (theory 8.3). Their pull would vanish at a gap D_0, with D_0^2 = A + B D^2.
struct SmallBridge {
  double pull;      ///< at contact, R* c [m]
  double constant;  ///< A [m^2]
  double linear;    ///< [-]
  double cosine;    ///< c, the mean of both ends [-]

  double zero_gap(double gap) const;  ///< D_0 [m]
  double pull_at(double gap) const;   ///< [m]
};
SmallBridge small_bridge(const std::array<BridgeEnd, 2>& ends, BridgeControl control, double amount);

}  // namespace puadem
