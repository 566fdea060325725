#pragma once

#include <array>
#include <span>
#include <vector>

#include "puadem/bridges/stable_bridge.hpp"

namespace puadem {

constexpr int bridge_terms = 10;  ///< of polynomials in sqrt(1 - D / D_max)

/// Stable bridges of one contact angle between spheres of any two radii or a sphere and a plane, at given suction or of
/// given volume: exact solutions at nodes, made once, as ratios to small bridges (theory 8.4).
struct BridgeTable {
  BridgeControl control;
  double contact_angle;      ///< [rad]
  double least, most;        ///< range of the amounts: p_c R* / gamma, or V / R*^3 [-]
  int amounts;               ///< nodes along that range
  std::vector<double> node;  ///< per ratio of radii and amount: reach, share, then the terms of pull, content and work
};

/// Solves for the nodes on all threads, in less than a second.
/// @param contact_angle  in [0, 80 deg] [rad]
/// @throws InputError  where the contact angle lies outside
BridgeTable make_bridge_table(BridgeControl control, double contact_angle);

/// The bridges between two ends at one suction or of one volume, as functions of the gap alone: what a loop over bridges
/// needs, and keeps until radii or amount change.
struct BridgeCurve {
  double reach;                                          ///< D_max, the rupture distance [m]
  SmallBridge small;                                     ///< what the terms are ratios to
  std::array<double, bridge_terms> pull, content, work;  ///< in powers of 2 sqrt(1 - D / D_max) - 1
  double share;                                          ///< of the liquid on the first end's side of the neck at rupture [-]
  BridgeControl control;
};

/// @param radius  of both ends [m], in any order; infinite: a plane
/// @param amount  p_c / gamma [1/m] or V [m^3], as the table is
/// @throws InputError  where the amount lies outside the table
BridgeCurve bridge_curve(const BridgeTable& table, const std::array<double, 2>& radius, double amount);

/// F / (2 pi gamma) [m] at a gap [m]. Here and below a negative gap is contact, and none may exceed the reach.
double bridge_pull(const BridgeCurve& curve, double gap);

/// Forces of many bridges at once [N], on all threads; 0 beyond the reach.
/// @param surface_tension  gamma [N/m] @param gap  [m]
void bridge_forces(double surface_tension, std::span<const BridgeCurve> curve, std::span<const double> gap,
                   std::span<double> force);

/// Change of F / (2 pi gamma) with the gap, < 0; grows without bound towards rupture [-].
double bridge_pull_slope(const BridgeCurve& curve, double gap);

/// V [m^3] of a bridge at given suction, p_c / gamma [1/m] of one of given volume.
double bridge_content(const BridgeCurve& curve, double gap);

/// Work over gamma that it takes to pull the ends apart from this gap to rupture [m^2].
double bridge_work(const BridgeCurve& curve, double gap);

}  // namespace puadem
