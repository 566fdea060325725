#pragma once

namespace puadem {

struct Fluid {
  double viscosity = 1.0e-3;  ///< [Pa s]
  double density = 998.0;     ///< [kg/m3]
};

/// Two immiscible fluids and the solid. Defaults: water and air at 20 C on clean glass.
struct Fluids {
  double surface_tension = 72.8e-3;  ///< gamma [N/m]
  double contact_angle = 0.0;        ///< theta, through the wetting fluid [rad]
  Fluid wetting{};
  Fluid nonwetting{1.8e-5, 1.2};
};

}  // namespace puadem
