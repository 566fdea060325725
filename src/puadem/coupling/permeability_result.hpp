#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "puadem/flow/permeability.hpp"

namespace puadem {

/// The pores of a layer of the box, all of one thickness.
struct PressureLayer {
  double place = 0.0;     ///< its middle, from the lower corner of the box [m]
  double pressure = 0.0;  ///< mean by volume [Pa]
  double linear = 0.0;    ///< straight from inlet to outlet, at the mean place of the same pores [Pa]
  int pores = 0;
};

/// What a permeability stage finds (theory 3.9).
struct PermeabilityResult {
  std::string stage;  ///< its name
  Permeability permeability;
  int pores = 0, throats = 0, closed_throats = 0;
  double porosity = 0.0;                ///< pores over box [-]
  std::optional<double> sauter_radius;  ///< of the grains [m]
  double viscosity = 0.0;               ///< [Pa s]

  // Fluid driven through the box.
  int inlet = 0;                ///< face of the high pressure
  double pressure_drop = 0.0;   ///< over the box [Pa]
  double darcy_velocity = 0.0;  ///< mean over the section [m/s]
  double linear_error = 0.0;  ///< of the pores' pressures against the straight line: root mean square by volume over the drop [-]
  std::vector<PressureLayer> profile;

  /// Largest k_ab - k_ba over the mean; it is rounding where all axes are periodic [-].
  double asymmetry() const;
  std::optional<double> kozeny_carman() const;  ///< [m2]
};

/// Fluid in the pores of one solve, for fields.
struct DrivenFlow {
  const PoreNetwork& network;
  std::span<const double> pressure;     ///< per pore [Pa]
  std::span<const double> throat_flow;  ///< from pore i to j [m3/s]
};

/// Layers between the lower and the upper face of an axis; those without a pore are left out.
/// @param linear  straight profile at the place of each pore [Pa]
std::vector<PressureLayer> pressure_layers(const PoreNetwork& network, const Domain& domain, int axis, int layers,
                                           std::span<const double> pressure, std::span<const double> linear);

}  // namespace puadem
