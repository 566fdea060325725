#pragma once

#include <span>
#include <string>
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

/// Gas that entered a pore within a step.
struct PoreInvasion {
  int throat, from, into;
  double pressure;  ///< difference across the throat at the step's end, just before [Pa]
  double crossing;  ///< share of the step at which it passed the threshold [-]
};

/// How much a step moved: the volume exchanged over that of the front, which is all pores beside a throat with gas on one
/// side only (or, where there is none, all pores with gas); and the largest change of a pore's saturation.
struct StepChange {
  double front = 0.0, largest = 0.0;
};

/// The end of a step that was tried. Potentials are pressures less their hydrostatic part.
struct TwoPhaseTrial {
  bool converged = false;
  int solves = 0;
  int worst_pore = -1;    ///< the one that misses its local law most
  double mismatch = 0.0;  ///< by this share [-]
  StepChange change;
  double in_order = 1.0;   ///< share of the step after which its end says too little of its order [-]
  double expansion = 0.0;  ///< of cut-off ideal gas in the step [m3]
  FluidClusters wetting_clusters, nonwetting_clusters;  ///< where the fluids stand, invasions of the step included
  std::vector<PoreInvasion> invasions;                  ///< in their order
  std::vector<double> entered;                          ///< per pore: share of the step at which gas entered, or 0 [-]
  std::vector<double> wetting_volume;                   ///< [m3]
  std::vector<double> wetting, nonwetting;              ///< potentials per pore [Pa]
  std::vector<PoreFilling> filling;
  std::vector<double> wetting_outflow, nonwetting_outflow;  ///< per pore, net [m3/s]
  double seconds_assemble = 0.0, seconds_solve = 0.0;
};

/// Values of the boundaries' schedules for a step: pressures [Pa] or flow rates [m3/s].
using BoundaryValues = std::vector<double>;

/// Pores within a step.
struct StepPores {
  std::span<const double> old_volume, volume;  ///< at its start and end [m3]
  std::span<const double> uptake{};            ///< see `PoreRates`
};

/// Tries a step: pressures, saturations and invaded pores at its end, conductances else those of its start. The state
/// stays as it is. Where the change exceeds `most_change` the trial is left as soon as that is seen, and where `in_order` is
/// asked for, as soon as its end is seen to say too little of its order.
TwoPhaseTrial try_two_phase_step(const PoreNetwork& network, const TwoPhaseModel& model, double step, double most_change,
                                 bool in_order, const StepPores& pores, const BoundaryValues& boundary,
                                 const TwoPhaseState& state);

/// Amounts of cut-off ideal gas after a step: within each cluster they spread to one pressure...
void spread_cut_off_gas(const PoreNetwork& network, const TwoPhaseModel& model, TwoPhaseState& state);
/// ... and after its events: gas just cut off has the amount it has, gas reached again has none of its own.
/// @param was_connected  per pore: gas that reached a boundary before the events
void note_cut_off_gas(const PoreNetwork& network, const TwoPhaseModel& model, std::span<const std::uint8_t> was_connected,
                      TwoPhaseState& state);

/// Pores that gas enters next in a step whose end is known so far: of all that are due, those whose threshold was passed
/// first, together with whatever was passed at nearly the same time (theory 6.4).
std::vector<PoreInvasion> next_invasions(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                                         const TwoPhaseTrial& trial);

/// Pores fill in the order in which their pressures fell below the lowest they can have with gas (theory 6.4).
struct FillingsWithinStep {
  /// What a filling cuts off loses its ways to the rest, also those through pores that had filled before. The gas of a filled
  /// pore keeps its ways out to the step's end.
  std::vector<int> closed_throats;
  /// Share of the step after which gas is cut off that would have lost a good part of its volume before [-].
  double in_order = 1.0;
};
FillingsWithinStep fillings_within_step(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                                        const TwoPhaseTrial& trial);

/// What cannot follow the change of its volume or give what is taken: parts from which no fluid reaches a boundary with a
/// pressure and whose fluids do not yield, unless their rates sum to nothing. @return which and why; empty where all can
std::string closed_off_parts(const PoreNetwork& network, const TwoPhaseModel& model, const PoreRates& rates,
                             const TwoPhaseState& state);

/// Boundaries with a flow rate when no step succeeds: what each asks for, and what limits it. Empty where there is none.
std::string unmet_rates(const PoreNetwork& network, const TwoPhaseModel& model, const BoundaryValues& values,
                        const TwoPhaseState& state);

}  // namespace puadem
