#pragma once

#include <array>

#include "puadem/dem/boundary_program.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/packing.hpp"

namespace puadem::verification {

/// A small packing compressed along z while the lateral stress is held.
struct TriaxialSetUp {
  ContactOptions::Law law = ContactOptions::Law::linear_spring;
  bool is_periodic = true;
  bool grains_follow_box = true;  ///< else the walls alone drive them
  int count = 1000;
  double stress = 100e3;             ///< [Pa]
  double axial_strain = 0.05;        ///< logarithmic [-]
  double compaction_friction = 0.1;  ///< between grains while they are packed; afterwards it is 0.5 [-]
  double inertial_number = 1e-3;     ///< d rate sqrt(density / stress) [-]
  double step_share = 0.25;          ///< of the critical time step [-]
};

struct TriaxialBalance {
  Energies start, end;
  std::vector<ProgramRow> rows;
  double void_ratio = 0.0;  ///< at the start [-]
  double time_step = 0.0;   ///< [s]
  long steps = 0;
  /// Input that is neither stored, kinetic nor taken up, as a share of the input.
  double residual() const { return (end.stored() + end.taken() - start.stored() - start.taken() - end.input) / end.input; }
};

TriaxialBalance run_triaxial(const TriaxialSetUp& set_up);

}  // namespace puadem::verification
