#pragma once

#include <cmath>
#include <limits>
#include <string_view>

namespace puadem {

/// What a local retention law needs to know of a pore unit.
struct CapillaryUnit {
  double threshold = 0.0;  ///< p_thr = 2 gamma cos(theta) / R_i [Pa], > 0
  int faces = 4;           ///< n_f [-]; fewer than 4 count as 4
};

/// p_c(S) = p_thr / (1 - exp(-kappa S)) with kappa rising with the number of faces
/// (Sweijen et al. 2018, Water Resour. Res.; Joekar-Niasar and Hassanizadeh 2010 for cubes; theory 4.2).
/// Retains too much at high suction: S falls as 1 / p_c, not as 1 / p_c^2.
struct ExponentialRetention {
  static constexpr std::string_view name = "exponential";
  double kappa_slope = 1.2591;    ///< kappa = slope n_f + offset [-]
  double kappa_offset = -1.1041;  ///< [-]

  double kappa(int faces) const { return kappa_slope * faces + kappa_offset; }

  double capillary_pressure(const CapillaryUnit& unit, double saturation) const {
    return unit.threshold / -std::expm1(-kappa(unit.faces) * saturation);
  }
  /// The difference p_c - p_thr is exact where it is small, so S keeps its digits up to 1.
  double saturation(const CapillaryUnit& unit, double pressure) const {
    return std::log(pressure / (pressure - unit.threshold)) / kappa(unit.faces);
  }
  double slope(const CapillaryUnit& unit, double saturation) const {
    const double k = kappa(unit.faces), rise = -std::expm1(-k * saturation);
    return -unit.threshold * k * std::exp(-k * saturation) / (rise * rise);
  }
  /// p_c(S = 1), rounded to the first double at which S does not exceed 1.
  double saturated_pressure(const CapillaryUnit& unit) const {
    double pressure = capillary_pressure(unit, 1.0);
    while (!(saturation(unit, pressure) <= 1.0)) pressure = std::nextafter(pressure, std::numeric_limits<double>::infinity());
    return pressure;
  }
  double largest_saturation(const CapillaryUnit&) const { return 1.0; }
};

/// Menisci in the edges and corners of a regular polyhedron, S = a x^2 + (S_thr - a) x^3 with
/// x = p_thr / p_c and a = c_2 chi_g^2 (theory 4.3). Ends at S_thr, where the bubble leaves the faces:
/// a unit whose pressure falls below p_thr jumps from S_thr to 1.
struct PolyhedronRetention {
  static constexpr std::string_view name = "polyhedron";

  double capillary_pressure(const CapillaryUnit& unit, double saturation) const;
  double saturation(const CapillaryUnit& unit, double pressure) const;
  double slope(const CapillaryUnit& unit, double saturation) const;
  double saturated_pressure(const CapillaryUnit& unit) const { return unit.threshold; }
  double largest_saturation(const CapillaryUnit& unit) const;
};

}  // namespace puadem
