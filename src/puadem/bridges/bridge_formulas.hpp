#pragma once

#include <array>

namespace puadem {

// Closed forms from the literature for bridges of given volume between two spheres, beside the exact solution
// (docs/validation.md, chapter 12, says how far they are off). A negative gap is contact. Equations: theory 8.5.

/// F / (2 pi gamma) by the fit of Willett et al. (2000), for unequal spheres with R* in place of R. Meant for
/// V / R*^3 from 1e-5 to 0.1 and contact angles below 50 degrees.
/// @param contact_angle [rad] @param volume [m^3] @param gap [m] @return [m]
double willett_pull(const std::array<double, 2>& radius, double contact_angle, double volume, double gap);

/// Rupture distance by the fit of the same paper, whose terms depend on the ratio of the radii [m].
double willett_reach(const std::array<double, 2>& radius, double contact_angle, double volume);

/// F / (2 pi gamma) by the fit of Soulie et al. (2006) to unequal spheres [m].
double soulie_pull(const std::array<double, 2>& radius, double contact_angle, double volume, double gap);

/// Rupture distance (1 + theta / 2) V^(1/3) of Lian, Thornton and Adams (1993) [m].
double lian_reach(double contact_angle, double volume);

}  // namespace puadem
