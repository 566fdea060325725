#pragma once

#include <array>
#include <functional>
#include <optional>

#include "puadem/flow/single_phase_flow.hpp"

namespace puadem {

/// Permeability of a box of pores [m2] (theory 3.9).
struct Permeability {
  /// Row a, column b: mean flux along a for a pressure gradient along b. Between walls the gradient is held by
  /// pressures on the two faces; along periodic axes it is a mean gradient, and the tensor of a fully periodic
  /// box is symmetric. Between walls what flows across is taken where pores have their centres.
  std::array<Vec3, 3> tensor{};
  std::array<bool, 3> measured{};  ///< axes along which fluid can be driven: periodic, or with pores at both faces
  double imbalance = 0.0;          ///< largest net flow of a pore over the largest flow through one, of the three solves [-]
  double carried = 0.0;    ///< what the pressures alone leave of it (theory 3.9) [-]
  int joined = 0;                  ///< throats without resistance: halves of one pore
  int limited_low = 0, limited_high = 0;
  int iterations = 0;          ///< of all solves
  int unknowns = 0;            ///< of the largest solve
  bool is_factorised = false;  ///< solved by Cholesky factors, else with multigrid

  bool is_complete() const { return measured[0] && measured[1] && measured[2]; }
  /// Of the axes that were measured.
  double mean() const {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) sum += tensor[static_cast<std::size_t>(axis)][axis];
    return sum / (int{measured[0]} + int{measured[1]} + int{measured[2]});
  }
};

/// The flow along an axis: one pascal a metre, falling with the axis, of a fluid of viscosity 1 Pa s. Between walls the
/// pressure is 0 at the upper one.
using AxisFlowCallback = std::function<void(int axis, const SinglePhaseFlow&)>;

/// @param on_axis  called after each solve; may be empty
/// @throws InputError  where fluid can be driven along no axis; else InputError, NumericalError as `solve_single_phase`
Permeability measure_permeability(const PoreNetwork& network, const Domain& domain, const PressureSolverOptions& solver = {},
                                  const std::optional<ConductanceLimits>& limits = {}, const AxisFlowCallback& on_axis = {});

/// Permeability of a bed of spheres after Kozeny and Carman, n^3 (2 R_32)^2 / (180 (1 - n)^2) [m2].
/// @param sauter_radius  R_32 = sum R^3 / sum R^2 [m]
double kozeny_carman(double porosity, double sauter_radius);

}  // namespace puadem
