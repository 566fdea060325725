#pragma once

#include <array>
#include <optional>

#include "puadem/flow/single_phase_flow.hpp"

namespace puadem {

/// Permeability of a box of pores [m2] (theory 3.9).
struct Permeability {
  /// Row a, column b: mean flux along a for a pressure gradient along b. Between walls the gradient is held by
  /// pressures on the two faces; along periodic axes it is a mean gradient, and the tensor of a fully periodic
  /// box is symmetric. Between walls what flows across is taken where pores have their centres.
  std::array<Vec3, 3> tensor{};
  double imbalance = 0.0;  ///< largest net flow of a pore over the largest flow through one, of the three solves [-]
  int joined = 0;          ///< throats without resistance: halves of one pore
  int limited_low = 0, limited_high = 0;
  int iterations = 0;  ///< of all solves

  double mean() const { return (tensor[0].x + tensor[1].y + tensor[2].z) / 3.0; }
};

/// @throws InputError, NumericalError as `solve_single_phase`
Permeability measure_permeability(const PoreNetwork& network, const Domain& domain, const PressureSolverOptions& solver = {},
                                  const std::optional<ConductanceLimits>& limits = {});

/// Permeability of a bed of spheres after Kozeny and Carman, n^3 (2 R_32)^2 / (180 (1 - n)^2) [m2].
/// @param sauter_radius  R_32 = sum R^3 / sum R^2 [m]
double kozeny_carman(double porosity, double sauter_radius);

}  // namespace puadem
