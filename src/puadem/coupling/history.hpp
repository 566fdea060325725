#pragma once

#include <array>
#include <optional>
#include <string>

#include "puadem/dem/boundary_program.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/stress.hpp"

namespace puadem {

/// Liquid bridges beside the contacts of the same moment.
struct BridgeRow : BridgeMeasures {
  double mean_contact_force = 0.0;  ///< normal, of all contacts [N]
  double mean_stress = 0.0;         ///< p of the bridges alone, negative: tension [Pa]
  Vec3 stress;                      ///< along x, y, z [Pa]
  double rumpf_strength = 0.0;      ///< tensile strength of a random packing by Rumpf's rule, theory 8.7 [Pa]
};

/// Grains and box at one time of a stage that loads them. Strains are logarithmic, from the start of the
/// stage; compression and shortening are positive (theory 2.18).
struct HistoryRow : ProgramRow {
  std::string stage;                      ///< see stage_name
  double fraction = 0.0;                  ///< of the stage, in [0, 1]
  long step = 0;                          ///< of the grain engine
  double time_step = 0.0;                 ///< [s]
  double porosity = 0.0;                  ///< 1 - volume of the grains / volume of the box [-]
  double shear_strain = 0.0;              ///< relative displacement of two walls / their distance [-]
  double normal_stress = 0.0;             ///< on the two walls that slide [Pa]
  double shear_stress = 0.0;              ///< mean tangential force on them / area [Pa]
  double coordination_inner = 0.0;        ///< without rattlers, see count_contacts [-]
  double coordination_mechanical = 0.0;   ///< Z_m of Thornton 2000 [-]
  double rattlers = 0.0;                  ///< share of the grains [-]
  double sliding = 0.0;                   ///< share of contacts at their Coulomb limit [-]
  double fabric_anisotropy = 0.0;         ///< of the normals of contacts between grains, theory 2.17 [-]
  double largest_overlap = 0.0;           ///< share of the smaller radius [-]
  std::array<Vec3, 6> wall_force{};       ///< of the grains on each face; zero on periodic ones [N]
  std::array<double, 6> wall_position{};  ///< of each face along its axis [m]
  Energies energy;                        ///< since the start of the stage
  double energy_residual = 0.0;           ///< energy not accounted for since then [J]
  std::optional<BridgeRow> bridges;       ///< of wet grains

  double void_ratio() const { return porosity / (1.0 - porosity); }
  double stress_ratio() const { return mean > 0.0 ? deviator / mean : 0.0; }
};

/// Where a stage began: what strains, displacements and energies are counted from.
struct HistoryStart {
  Vec3 size;                  ///< of the box [m]
  double solid_volume = 0.0;  ///< of the grains [m3]
  Energies energies;          ///< when the book was opened
  int shear_axis = -1;        ///< whose walls slide; -1: none
  int shear_direction = 0;
  double wall_offset = 0.0;  ///< of the sliding walls from each other [m]
};

/// Opens the energy book and notes where the system stands. Forces must be those of the present places.
HistoryStart begin_history(GrainSystem& system, int shear_axis = -1, int shear_direction = 0);

/// The row of the system as it stands, without fabric and energies; stage and fraction are the caller's.
/// @param time  of the run [s]
/// @pre the forces are those of the present places, `measures` belongs to them
HistoryRow history_row(const GrainSystem& system, const GrainMeasures& measures, const HistoryStart& start, double time);

/// Adds what costs more to measure: fabric and energies. @pre as history_row
/// @throws NumericalError  the grains have energy that no work explains
void complete_row(const GrainSystem& system, const HistoryStart& start, HistoryRow& row);

}  // namespace puadem
