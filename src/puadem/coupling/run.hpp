#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "puadem/coupling/case.hpp"
#include "puadem/coupling/state.hpp"

namespace puadem {

/// Where a run stands, for a progress line.
struct Progress {
  std::string_view stage;  ///< kind of the stage, or "network"
  double fraction = 0.0;   ///< of the stage, in [0, 1], as well as it is known
  long step = 0;
  double time = 0.0;                ///< [s] simulated
  double saturation = 1.0;          ///< S_r [-]
  double unbalanced = 0.0;          ///< unbalanced force ratio [-]
  double capillary_pressure = 0.0;  ///< [Pa]
  double stress = 0.0;              ///< mean stress of the grains [Pa]
  double porosity = 0.0;            ///< of the region a compaction aims at [-]
};

/// Fluid volumes that a stage moved, summed event by event, against what the state holds.
struct Ledger {
  double void_volume = 0;                                                                  ///< of the counted pores [m3]
  double wetting_start = 0, wetting_in = 0, wetting_out = 0, wetting_end = 0;              ///< [m3]
  double nonwetting_start = 0, nonwetting_in = 0, nonwetting_out = 0, nonwetting_end = 0;  ///< [m3]
  /// (start + in - out - end) / void [-].
  double wetting_error() const { return (wetting_start + wetting_in - wetting_out - wetting_end) / void_volume; }
  double nonwetting_error() const { return (nonwetting_start + nonwetting_in - nonwetting_out - nonwetting_end) / void_volume; }
};

/// What a run found, by name, for the report, the manifest and the bounds of `[expected]`.
struct RunResults {
  std::map<std::string, double> scalars;  ///< "porosity_core", "pc_star_half_drainage-1", ...
  Ledger ledger;
  bool interrupted = false;  ///< the observer asked to stop before the end
};

/// Watches a run. Every call gets the state as const: output cannot change physics. Empty functions
/// are skipped. `progress` returning false asks the run to stop.
struct Observer {
  std::function<bool(const Progress&)> progress;
  /// The run could go on from this state and these results. `is_last`: it is about to stop, because `progress` asked for it.
  std::function<void(const State&, const RunResults&, bool is_last)> safe_place;
  std::function<void(std::string_view)> message;
  std::function<void(const State&)>
      packed;  ///< a stage has moved the grains for good; where the next needs one, their network is made
  std::function<void(const State&, const HistoryRow&)> history;  ///< a row of a stage that loads the grains
  std::function<void(const State&, const DrivenFlow&, const PermeabilityResult&)> permeability;  ///< a stage has measured it
  std::function<void(const State&, const RetentionRow&)> equilibrium;                            ///< one retention row is reached
  std::function<void(const State&, const InvasionEvent&)> event;                           ///< one invasion event has happened
  std::function<void(const State&, const TwoPhaseModel&, const FlowRow&)> flow;            ///< a row of two fluids that move
  std::function<void(const State&, const TwoPhaseModel&, double saturation)> flow_fields;  ///< a state worth its fields
  std::function<void(const State&, const TwoPhaseEvent&)> flow_event;
  std::function<void(const State&, const SaturatedRow&)> saturated;  ///< a row of a stage "saturated-flow"
  std::function<void(const State&, const SaturatedRecord&)>
      saturated_fields;                                                  ///< a state worth its fields; its profile is the last
  std::function<void(const State&, const UnsaturatedRow&)> unsaturated;  ///< a row of a stage "unsaturated-flow", all at rest
};

/// The stages of a case from `state.position` on: all of them, or what is left of a run whose state and results at a
/// safe place are given. It then goes on as it would have, to the last bit.
/// @throws InputError, NumericalError
RunResults run(const Case& c, State& state, const Observer& observer, RunResults results = {});

}  // namespace puadem
