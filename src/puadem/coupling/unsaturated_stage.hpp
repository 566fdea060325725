#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "puadem/base/vec3.hpp"
#include "puadem/coupling/pore_space_record.hpp"
#include "puadem/flow/retention_law.hpp"

namespace puadem {

/// Stage "unsaturated-flow": steps of the capillary pressure, at each of which grains and two fluids move each other until all
/// rest (theory 7.6). It begins with water everywhere, or dry at the first pressure (theory 8.8).
struct UnsaturatedStage {
  static constexpr std::string_view kind = "unsaturated-flow";
  enum class Start { saturated, dry };

  std::vector<double> path;  ///< turning points of the capillary pressure [Pa]
  /// When the reservoirs reach each of them, straight lines between: grains and fluids then move in time, from rest at the
  /// first, and swelling grains grow (theory 7.9) [s]; empty: rest at every step of the path
  std::vector<double> times;
  std::optional<double> coupling_interval;  ///< with `times`: fluids' forces stay that long [s]
  std::vector<double> step{100.0};          ///< along the path, or one for each of its legs [Pa]
  Start start = Start::saturated;
  int air = 5;                                                         ///< face of its reservoir, at pressure 0
  std::array<bool, 6> water{false, false, false, false, true, false};  ///< faces of the water's reservoir
  double initial_air_fraction = 1e-6;                                  ///< of the pores at the air's face [-]
  std::array<bool, 6> loaded{};  ///< faces whose walls move to hold `stress`; all others stand
  std::optional<double> stress;  ///< of grains and fluids together, over the air's pressure [Pa]
  // After the path the box may be shortened along z under the last pressure, as in a triaxial test.
  std::optional<double> strain;       ///< logarithmic, negative: lengthened [-]
  std::optional<double> strain_rate;  ///< its magnitude [1/s]; none: at the quasi-static inertial number
  double strain_step = 5e-4;          ///< strain after which the fluids follow and come to rest [-]
  double damping = 0.3;               ///< Cundall damping [-]
  double unbalanced = 1e-3;           ///< force ratio at which the grains are at rest [-]
  double saturation_change = 1e-3;    ///< of a round below which a step is at its end [-]
  double strain_change = 1e-5;        ///< and change of the strain [-]
  int rounds = 50;                    ///< most of a step, those not counted that end with a new network
  double remesh_displacement = 0.1;   ///< of a grain, over the mean radius, at which a new network is made [-]
  bool corner_films = true;           ///< water flows through the corners of open throats
  bool snap_off = false;              ///< see `InvasionOptions::snap_off`
  AnyRetentionLaw retention_law = ExponentialRetention{};

  bool is_loaded() const {
    for (const bool l : loaded)
      if (l) return true;
    return false;
  }
};

/// Grains and fluids at rest at one capillary pressure: a row of series/unsaturated.csv. Compression and shortening positive.
struct UnsaturatedRow {
  std::string stage, branch;
  std::optional<double> time;                              ///< since motion in time began [s]; none at rest
  double capillary_pressure = 0.0;                         ///< [Pa]
  double pc_star = 0.0;                                    ///< p_c <r> / gamma [-]
  double saturation = 1.0;                                 ///< water of bridges included [-]
  double strain = 0.0;                                     ///< logarithmic, along the axis, since rest at the first pressure [-]
  double volume_strain = 0.0;                              ///< the same of the box's volume [-]
  double porosity = 0.0;                                   ///< [-]
  double total_stress = 0.0;                               ///< along the axis, over the air's pressure [Pa]
  Vec3 contact_stress;                                     ///< sigma' along x, y, z [Pa]
  Vec3 bridge_stress;                                      ///< of liquid bridges, negative: tension [Pa]
  Vec3 fluid_stress;                                       ///< of the fluids' forces on grains and walls, theory 7.8 [Pa]
  std::optional<double> chi_contact;                       ///< Bishop's, from the contacts; none without capillary pressure [-]
  std::optional<double> chi_fluid;                         ///< and from the forces of fluids and bridges [-]
  double mean_force = 0.0;                                 ///< normal, of the contacts between grains [N]
  double mean_force_ratio = 1.0;                           ///< over that at the first pressure [-]
  double strong_share = 0.0;                               ///< of these contacts, those of more than the mean force [-]
  std::array<bool, 3> chains_span{};                       ///< do they join opposite sides of the box along x, y, z?
  double coordination = 0.0;                               ///< contacts of a grain, walls included [-]
  double contact_anisotropy = 0.0;                         ///< of contact normals, theory 2.17 [-]
  std::optional<double> capillary_anisotropy;              ///< of the fluids' forces on the grains, theory 7.8 [-]
  double capillary_force = 0.0;                            ///< their mean magnitude [N]
  double pressure_force = 0.0;                             ///< of the part that pressures on the solid make [N]
  double tension_force = 0.0;                              ///< of the part that menisci in throats make [N]
  int bridges = 0;                                         ///< between grains, and grains and walls
  double bridge_force = 0.0;                               ///< mean attraction of one [N]
  double bridge_saturation = 0.0;                          ///< their water over the void [-]
  double trapped_wetting = 0.0, trapped_nonwetting = 0.0;  ///< shares of the void [-]
  double wetting_error = 0.0, nonwetting_error = 0.0;      ///< of the ledger, over the void [-]
  int rounds = 0;                                          ///< until all rested
  long remeshes = 0;                                       ///< since the start of the stage
  long pores_changed = 0;  ///< whose saturation a new network changed by more than 0.01, by merging
};

/// Contact forces and the fluids' forces at one row, each over its mean: densities in classes of equal width.
struct ForceSpread {
  static constexpr double width = 0.2;     ///< of a class, in units of the mean [-]
  std::vector<double> contact, capillary;  ///< probability density by number; a class after the last is none [-]
};

/// Swelling grains and what they do to the others, at one row: a row of series/swelling.csv.
struct SwellingRow {
  double radius_mean = 0.0, radius_least = 0.0, radius_most = 0.0;  ///< of the swelling grains [m]
  double wetted = 0.0;                                              ///< mean share of their surface [-]
  double grown = 0.0;                                               ///< volume since the start [m3]
  double from_pores = 0.0;                                          ///< water taken out of counted pores [m3]
  double from_reservoirs = 0.0;                                     ///< and out of pores of the reservoirs [m3]
  double water_error = 0.0;                                         ///< grown less taken, over the void [-]
  double mean_stress = 0.0, deviatoric_stress = 0.0;                ///< p, q of all contacts [Pa]
  double grain_deviator_mean = 0.0;                                 ///< of the grains' own q on their power cells [Pa]
  double grain_deviator_deviation = 0.0;                            ///< and its standard deviation [Pa]
};

/// What a stage leaves behind.
struct UnsaturatedRecord {
  std::string stage;
  int axis = 2;  ///< of the strain: that of the first loaded face, else z
  std::vector<UnsaturatedRow> rows;
  std::vector<ForceSpread> spreads;      ///< one for each row
  std::vector<SwellingRow> swelling;     ///< the same, where grains swell; else empty
  std::vector<PoreSpaceRow> pore_space;  ///< one for each row
  std::vector<double> pore_density;      ///< probability densities of all classes of those
  std::array<int, 3> blocks{};           ///< along x, y, z; x runs fastest
  std::vector<LocalBlock> local;         ///< all blocks of the first row, of the second, ...
};

}  // namespace puadem
