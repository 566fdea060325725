#pragma once

#include <numbers>
#include <string>

namespace puadem {

/// What a grain is made of. SI units.
struct Material {
  std::string name = "glass";
  double density = 2650.0;                                ///< [kg/m3]
  double youngs_modulus = 150e6;                          ///< E [Pa]
  double poisson_ratio = 0.3;                             ///< nu [-]
  double friction_angle = 30.0 / 180.0 * std::numbers::pi;  ///< phi [rad], mu = tan(phi)
};

}  // namespace puadem
