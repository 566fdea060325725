#pragma once

#include <span>
#include <vector>

#include "puadem/flow/two_phase_flow.hpp"

namespace puadem {

/// What the equations of a pore are at the end of a step (theory 6.3).
enum class PoreFilling : std::uint8_t {
  reservoir,  ///< no equation of its own
  saturated,  ///< wetting fluid alone
  mixed,      ///< both, along the local law
  full,       ///< gas was there, and the wetting fluid has just filled the pore
  emptied,    ///< a dry pore that has just lost its wetting fluid
  empty,      ///< gas alone
};

/// The end of a step that was tried. Potentials are pressures less their hydrostatic part.
struct TwoPhaseTrial {
  bool converged = false;
  int solves = 0;
  int worst_pore = -1;                      ///< the one that misses its local law most [-]
  double mismatch = 0.0;                    ///< by this share
  std::vector<double> wetting_volume;       ///< [m3]
  std::vector<double> wetting, nonwetting;  ///< potentials per pore [Pa]
  std::vector<PoreFilling> filling;
  std::vector<double> wetting_outflow, nonwetting_outflow;  ///< per pore, net [m3/s]
  double seconds_assemble = 0.0, seconds_solve = 0.0;
};

/// Values of the boundaries' schedules for a step: pressures [Pa] or flow rates [m3/s].
using BoundaryValues = std::vector<double>;

/// Tries a step: pressures and saturations at its end, conductances those of its start. The state stays as it is.
/// @param volume  of each pore at the step's end [m3]; @param old_volume  at its start
TwoPhaseTrial try_two_phase_step(const PoreNetwork& network, const TwoPhaseModel& model, double step,
                                 std::span<const double> old_volume, std::span<const double> volume,
                                 const BoundaryValues& boundary, const TwoPhaseState& state);

}  // namespace puadem
