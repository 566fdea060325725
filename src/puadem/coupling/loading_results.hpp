#pragma once

#include <span>
#include <string>

#include "puadem/coupling/loading_program.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/dem/motion.hpp"

namespace puadem {

/// Angle [rad] whose sine is (a - l) / (a + l), of axial stress a and mean lateral stress l: the mobilised
/// friction of grains without cohesion.
double mobilised_friction(const HistoryRow& row);

/// Steepest fall of volumetric strain against axial strain, over windows of a twentieth of the rows [-].
double largest_dilatancy(std::span<const HistoryRow> rows);

/// Dilation angle of triaxial compression from -d(volumetric) / d(axial), sin psi = D / (2 + D) (Vermeer and
/// de Borst 1984, Heron 29(3)) [rad].
double dilation_angle(double dilatancy);

/// How well a leg holds its stresses, relative to their targets [-].
struct HeldStress {
  double error = 0.0;        ///< largest departure of an axis, mean of the rows; of a leg that ends at rest, in its last row
  double fluctuation = 0.0;  ///< root mean square of the departures of single rows
};

HeldStress held_stress(const LoadingLeg& leg, std::span<const HistoryRow> rows);

/// What the rows of a stage say, by names that begin with the stage's, into the results.
void describe_loading(const Stage& stage, const std::string& name, const LoadingProgram& program,
                      std::span<const HistoryRow> rows, RunResults& results);

}  // namespace puadem
