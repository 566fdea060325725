#pragma once

#include <string>
#include <vector>

#include "puadem/coupling/case.hpp"
#include "puadem/coupling/state.hpp"
#include "puadem/dem/boundary_program.hpp"

namespace puadem {

/// Inertial number at which a stage strains the grains that names no rate of its own: quasi-static.
inline constexpr double default_inertial_number = 5e-4;
/// Above it a test is no longer quasi-static.
inline constexpr double quasi_static_inertial_number = 1e-3;

/// One part of a stage: what is done to the box, and when it ends.
struct LoadingLeg {
  enum class End { strain, axial_stress, shear_strain, time, rest };
  BoxProgram box;
  End end = End::time;
  double target = 0.0;  ///< logarithmic axial strain from the start of the stage, axial stress [Pa], shear strain or time [s]
};

/// Two walls that slide against each other.
struct WallSlide {
  int axis = 2, direction = 0;
  double speed = 0.0;          ///< of the one relative to the other [m/s]
  double normal_stress = 0.0;  ///< [Pa]
  double speed_limit = 0.0;    ///< of the wall that holds it [m/s]
};

/// A stage that loads grains, as one loop can run it.
struct LoadingProgram {
  std::vector<LoadingLeg> legs;
  std::optional<WallSlide> slide;
  bool box_strains = true;  ///< and the grains with it; false: only walls move
  double damping = 0.2;
  double unbalanced = 1e-3;        ///< at rest below this [-]
  double stress_tolerance = 1e-3;  ///< and with every held stress this near [-]
  double pressure = 0.0;           ///< that the stage works at, as far as it is known beforehand [Pa]
  double strain_rate = 0.0;        ///< largest that the stage imposes [1/s]
  double inertial_number = 0.0;    ///< at that rate and pressure
};

/// What to say of a program whose inertial number is too large.
std::string inertia_warning(const LoadingProgram& program);

LoadingProgram loading_program(const IsotropicStage& stage, const Case& c, const LoadingScale& scale);
LoadingProgram loading_program(const OedometerStage& stage, const Case& c, const LoadingScale& scale);
LoadingProgram loading_program(const TriaxialStage& stage, const Case& c, const LoadingScale& scale);
LoadingProgram loading_program(const ShearStage& stage, const Case& c, const LoadingScale& scale);
LoadingProgram loading_program(const SettleStage& stage, const Case& c, const LoadingScale& scale);
LoadingProgram loading_program(const StrainStage& stage, const Case& c, const LoadingScale& scale);

}  // namespace puadem
