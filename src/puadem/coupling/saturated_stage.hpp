#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "puadem/coupling/permeability_result.hpp"

namespace puadem {

/// Stage "saturated-flow": one fluid fills all pores; it and the grains move each other (theory 7.2).
struct SaturatedStage {
  static constexpr std::string_view kind = "saturated-flow";

  std::optional<double> duration;     ///< [s]
  std::optional<double> time_factor;  ///< in its place: Terzaghi's T_v, from stiffness and permeability measured first [-]
  std::array<bool, 6> drained{false, false, false, false, false, true};  ///< faces at piezometric pressure 0
  std::optional<int> inlet;                                              ///< face at a pressure of its own
  std::vector<double> inlet_pressure;       ///< piezometric: one, or one for each of `inlet_times` [Pa]
  std::vector<double> inlet_times;          ///< with straight lines between [s]
  std::optional<int> loaded;                ///< face whose wall moves to hold `stress`
  std::optional<double> stress;             ///< of grains and fluid together [Pa]
  std::optional<int> seat_loose_grains;     ///< face towards which grains that nothing holds are laid against others first
  double damping = 0.2;                     ///< Cundall damping [-]
  std::optional<double> coupling_interval;  ///< over which the fluid's forces are frozen; none: from the limit of theory 7.3 [s]
  double coupling_safety = 0.5;             ///< share of that limit [-]
  double remesh_displacement = 0.02;        ///< of a grain, over the mean radius, at which a new network is made [-]
  std::optional<double> bulk_modulus;       ///< of the fluid; none: incompressible [Pa]
  int layers = 20;                          ///< of the pressure profile
};

/// Grains and fluid at one time of such a stage: a row of series/saturated.csv.
struct SaturatedRow {
  std::string stage;
  long step = 0;                  ///< coupled steps
  double time = 0.0;              ///< since the start of the stage [s]
  double settlement = 0.0;        ///< shortening of the box along the axis of the loaded face since then, or along z [m]
  double pressure_mean = 0.0;     ///< piezometric, by volume of the pores [Pa]
  double pressure_largest = 0.0;  ///< [Pa]
  double inlet_pressure = 0.0;    ///< [Pa]
  double gradient = 0.0;  ///< hydraulic: fall of pressure head from the inlet to the opposite face over their distance [-]
  double contact_stress_lower = 0.0, contact_stress_upper = 0.0;  ///< of the grains on the two walls of that axis [Pa]
  double fluid_in = 0.0;                                          ///< through all faces since the start, less what went out [m3]
  double void_volume = 0.0;                                       ///< [m3]
  double ledger_error = 0.0;                                      ///< over the void [-]
  double porosity = 0.0;                                          ///< [-]
  double unbalanced = 0.0;                                        ///< [-]
  long remeshes = 0;
  std::optional<double> time_factor, degree, degree_pressure, degree_terzaghi;  ///< of consolidation [-]
};

/// What a consolidation is judged by, measured on the packing before it (theory 7.4).
struct ConsolidationReference {
  double load = 0.0;             ///< stress put on [Pa]
  double settlement = 0.0;       ///< of the same grains without fluid under it [m]
  double stiffness = 0.0;        ///< E_oed [Pa]
  double permeability = 0.0;     ///< [m2]
  double drainage_length = 0.0;  ///< H [m]
  double coefficient = 0.0;      ///< c_v [m2/s]
};

/// Pressures in the layers of the box at one time; `linear` of a layer is Terzaghi's pressure there in a consolidation.
struct PressureProfile {
  double time = 0.0;  ///< [s]
  std::optional<double> time_factor;
  std::vector<PressureLayer> layers;
};

/// What a stage leaves behind.
struct SaturatedRecord {
  std::string stage;
  int axis = 2;  ///< of settlement, gradient and profiles
  std::optional<ConsolidationReference> reference;
  std::vector<SaturatedRow> rows;
  std::vector<PressureProfile> profiles;
  double coupling_limit = 0.0;     ///< [s]
  double coupling_interval = 0.0;  ///< longest used [s]
};

/// Terzaghi's degree of consolidation after a time factor T_v: mean share of a uniform excess pressure that has gone
/// from a layer drained on one side (Terzaghi 1925).
double terzaghi_degree(double time_factor);

/// Excess pressure over the initial one at a depth below the drained side, as a share of the drainage length.
double terzaghi_pressure(double time_factor, double depth);

}  // namespace puadem
