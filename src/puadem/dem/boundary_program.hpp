#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/stress.hpp"

namespace puadem {

/// What happens to the box: along every axis either a stress is held or a rate of strain is imposed.
/// Walls and periodic faces alike.
struct BoxProgram {
  std::array<std::optional<double>, 3> stress;  ///< [Pa], compression positive
  std::optional<double> mean_stress{};          ///< in place of `stress`: held by x and y, which bear the same [Pa]
  Vec3 strain_rate;                             ///< where no stress is held, shortening positive [1/s]
  double rate_limit = 1.0;                      ///< of the strain that holds a stress [1/s]
  double relaxation_steps = 60;                 ///< in which a missing stress is made up for
  int interval = 10;                            ///< steps between two settings
};

/// Lateral walls stand, the box is shortened along z.
BoxProgram oedometer(double strain_rate);

/// Lateral stress is held, the box is shortened along z.
BoxProgram triaxial(double lateral_stress, double strain_rate, double rate_limit);

/// What the control of a box remembers between two settings.
struct BoxServo {
  Vec3 steady_rate;  ///< rates of strain found so far that hold the stresses [1/s]
};

/// Sets the rates of strain of the box from the stresses measured (theory 2.18).
void steer_box(GrainSystem& system, const BoxProgram& program, const GrainMeasures& measures, BoxServo& servo);

/// The same without memory: a stress lags where the packing keeps straining.
void steer_box(GrainSystem& system, const BoxProgram& program, const GrainMeasures& measures);

/// Normal stress along every axis: mean of the two walls, or of the contacts along a periodic axis [Pa].
Vec3 axis_stress(const GrainSystem& system, const GrainMeasures& measures);

/// One line of a program's record.
struct ProgramRow {
  double time = 0.0;        ///< [s]
  Vec3 strain;              ///< logarithmic, shortening positive [-]
  Vec3 stress;              ///< see axis_stress [Pa]
  double mean = 0.0;        ///< p, third of the sum of `stress` [Pa]
  double deviator = 0.0;    ///< q = stress_z - (stress_x + stress_y) / 2 [Pa]
  double volumetric = 0.0;  ///< sum of the strains [-]
  double unbalanced = 0.0;
  double coordination = 0.0;
};

/// The row of a system as it stands. @param start_size  of the box where strains are counted from [m]
ProgramRow program_row(const GrainSystem& system, const GrainMeasures& measures, const Vec3& start_size, double time);

/// Runs a program for `steps`, recording a row at the start and every `row_interval` steps (a multiple of
/// the program's interval). `watch` returning false ends it early.
std::vector<ProgramRow> run_program(GrainSystem& system, const BoxProgram& program, long steps, long row_interval,
                                    const std::function<bool(const ProgramRow&)>& watch = {});

/// d eps sqrt(rho / p), small where the straining is quasi-static.
/// @param diameter  mean of the grains [m]
/// @param density   of the grains [kg/m3]
/// @param pressure  mean stress [Pa]
double inertial_number(double strain_rate, double diameter, double density, double pressure);

/// Shears a layer between the two walls of an axis: they move against each other along `direction` at
/// half of `speed` each, and the upper one holds the normal stress.
/// @throws InputError  an axis without walls, a direction across them
void shear_by_walls(GrainSystem& system, int axis, const Vec3& direction, double speed, double normal_stress,
                    double servo_speed_limit);

}  // namespace puadem
