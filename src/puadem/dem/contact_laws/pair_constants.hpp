#pragma once

namespace puadem {

/// What two touching bodies of given materials have in common, theory 2.5 and 2.6. T is double, or Lanes
/// for four contacts at once.
template <class T>
struct PairConstants {
  T youngs;           ///< E* of the Hertz law [Pa]
  T shear;            ///< G* of the Mindlin law [Pa]
  T spring_i;         ///< modulus E_i of the linear law [Pa]
  T spring_j;         ///< modulus E_j of the linear law [Pa]
  T stiffness_ratio;  ///< k_s / k_n of the linear law [-]
  T friction;         ///< mu = tan(min(phi_i, phi_j)) [-]
  T damping;          ///< beta = -ln e / sqrt(pi^2 + ln^2 e) [-]; 0 without viscous part
};

/// Normal force and tangent stiffnesses at one overlap.
template <class T>
struct ContactResponse {
  T force;   ///< F_n >= 0 [N]
  T normal;  ///< dF_n / d overlap [N/m]
  T shear;   ///< dF_s / d slip [N/m]
};

}  // namespace puadem
