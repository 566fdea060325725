#pragma once

#include <optional>

namespace puadem {

/// How grains take up wetting fluid and grow (theory 7.9): dR/dt = 3 D R / R_0^3 f (R_max - R), with the share f of the
/// surface that is wetted.
struct SwellingLaw {
  double diffusivity = 0.0;              ///< D [m2/s]
  double largest_ratio = 1.0;            ///< R_max / R_0 > 1 [-]
  std::optional<double> largest_stress;  ///< mean stress in a grain at which it takes up nothing more [Pa]; none: it ever does
};

/// Radius after the growth at a share f that stays for a time: the logistic curve, exactly [m].
/// @param start    R_0, of the dry grain [m]
/// @param exposure f times the time [s]
double swollen_radius(const SwellingLaw& law, double start, double radius, double exposure);

/// Share of the growth that a mean stress in the grain leaves: 1 - stress / largest_stress, not below 0 [-].
double unhindered_share(const SwellingLaw& law, double stress);

}  // namespace puadem
