#pragma once

#include <array>
#include <span>
#include <vector>

#include "puadem/bridges/bridge_table.hpp"

namespace puadem {

/// Liquid, and what stays in a bridge as its ends move: the suction or the volume, by the table.
struct BridgeModel {
  /// Force and rupture distance: of the table, or at given volume of a published fit (theory 8.5).
  enum class Law { table, willett, soulie };
  double surface_tension;  ///< gamma [N/m]
  BridgeTable table;
  Law law = Law::table;
};

/// @throws InputError  where surface tension or contact angle make no sense, or a fit is asked for at given suction
BridgeModel bridge_model(double surface_tension, double contact_angle, BridgeControl control,
                         BridgeModel::Law law = BridgeModel::Law::table);

/// R* = 2 R_1 R_2 / (R_1 + R_2) [m]; of an infinite radius, a plane, twice the other.
inline double reduced_radius(const std::array<double, 2>& radius) { return 2.0 / (1.0 / radius[0] + 1.0 / radius[1]); }

/// Pairs of neighbours that may carry a bridge. What the ends are the caller knows: names here.
struct BridgePairs {
  std::vector<std::array<int, 2>> ends;       ///< strictly ascending
  std::vector<std::array<double, 2>> radius;  ///< infinite: a plane [m]
  std::vector<double> gap;                    ///< between the surfaces, negative where they overlap [m]
};

/// Bridges, in the order of their ends. Ends, radii and gap are the caller's to keep up to date, and so is the suction or
/// the volume, whichever the model prescribes; the rest follows.
struct Bridges {
  BridgePairs pairs;
  std::vector<double> capillary_pressure;  ///< p_n - p_w [Pa]
  std::vector<double> volume;              ///< of the liquid [m^3]
  std::vector<double> force;               ///< of attraction, along the line of centres [N]
  std::vector<BridgeCurve> curve;          ///< of the radii and the prescribed amount

  int size() const { return static_cast<int>(curve.size()); }
};

/// Where new bridges form: where ends touch, as when they get wet, or wherever one can stand, as when they dry.
enum class BridgeFormation { at_contact, at_any_distance };

/// Adds bridges on pairs that have none: those whose ends touch, or all that are no farther apart than rupture. Their
/// forces and contents are up to date.
/// @param amount  per pair: the capillary pressure [Pa] or the volume [m^3] of a bridge there; 0: none
/// @return how many were added
/// @throws InputError  where an amount lies outside the table or the fit
int form_bridges(const BridgeModel& model, const BridgePairs& pairs, std::span<const double> amount, BridgeFormation formation,
                 Bridges& bridges);

/// Least and most that a bridge of given volume may hold between two ends, by the table or the fit [m3].
std::array<double, 2> volume_range(const BridgeModel& model, const std::array<double, 2>& radius);

/// Curve of bridge k; due when its radii or its prescribed amount have changed.
/// @throws InputError  where the amount lies outside the table or the fit
void update_curve(const BridgeModel& model, Bridges& bridges, int k);

/// Curves of all bridges; due when radii or prescribed amounts have changed.
/// @throws InputError  where an amount lies outside the table or the fit
void update_curves(const BridgeModel& model, Bridges& bridges);

/// Forces for the present gaps; none beyond the rupture distance.
void update_forces(const BridgeModel& model, Bridges& bridges);

/// Volumes at given suction, or capillary pressures at given volume, for the present gaps; beyond the rupture distance
/// those of rupture.
void update_contents(const BridgeModel& model, Bridges& bridges);

/// Rupture distance of bridge k [m].
double rupture_distance(const BridgeModel& model, const Bridges& bridges, int k);

/// How a ruptured bridge leaves its liquid to its ends: in halves, or divided at the neck of the last stable shape.
enum class RuptureSplit { halves, neck };

struct RupturedBridge {
  std::array<int, 2> ends;
  std::array<double, 2> volume;  ///< left at each end; their sum is that of the bridge [m^3]
};

/// Takes away all bridges whose gap exceeds the rupture distance; their liquid is the caller's.
std::vector<RupturedBridge> rupture_bridges(const BridgeModel& model, RuptureSplit split, Bridges& bridges);

/// Gives liquid that lies on the ends to their bridges of given volume, to all bridges of an end alike, as far as the
/// model reaches; the rest stays. Renews the curves of those that get some.
/// @param film  per end: volume on it [m^3]; ends outside the span hold none
void share_films(const BridgeModel& model, std::span<double> film, Bridges& bridges);

/// Work that it takes to rupture all bridges by pulling their ends apart [J]: what they lower the energy by. Ends
/// that overlap are pulled with the force of contact on the way to it.
double rupture_work(const BridgeModel& model, const Bridges& bridges);

}  // namespace puadem
