#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace puadem {

/// One equilibrium of a retention path: a row of series/retention.csv.
struct RetentionRow {
  int step = 0;                   ///< counts the equilibria of the stage from 0
  std::string branch;             ///< "drainage-1", "imbibition-1", "drainage-2", ...
  double capillary_pressure = 0;  ///< [Pa]
  double pc_star = 0;             ///< p_c <r> / gamma [-]
  double saturation = 1;          ///< of the counted pores [-]
  double trapped_wetting = 0;     ///< trapped wetting volume / void [-]
  double trapped_nonwetting = 0;  ///< trapped non-wetting volume / void [-]
};

/// van Genuchten (1980) curve S = S_r + (S_s - S_r) [1 + (alpha p_c)^n]^-(1 - 1/n)  (paper Eq. 1).
struct VanGenuchten {
  double alpha = 0;                ///< [1/Pa]
  double n = 0;                    ///< [-], > 1
  double residual_saturation = 0;  ///< S_r [-]
  double maximal_saturation = 1;   ///< S_s [-]: below 1 where gas stays trapped
  double rms_error = 0;            ///< root mean square distance in S over the fitted points [-]

  double saturation(double capillary_pressure) const;
};

/// Least-squares van Genuchten curve through the rows of one branch; none for fewer than five rows or
/// rows without a spread in saturation.
std::optional<VanGenuchten> fit_van_genuchten(std::span<const RetentionRow> branch);

/// Area between two branches over the saturations both cover [Pa]: the work lost in a loop per void volume.
double loop_area(std::span<const RetentionRow> upper, std::span<const RetentionRow> lower);

/// Capillary pressure of a branch at a saturation by linear interpolation; none outside its range [Pa].
std::optional<double> capillary_pressure_at(std::span<const RetentionRow> branch, double saturation);

}  // namespace puadem
