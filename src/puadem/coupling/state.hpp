#pragma once

#include <optional>
#include <vector>

#include "puadem/coupling/flow_record.hpp"
#include "puadem/coupling/history.hpp"
#include "puadem/coupling/permeability_result.hpp"
#include "puadem/coupling/run_position.hpp"
#include "puadem/coupling/saturated_stage.hpp"
#include "puadem/coupling/saturated_step.hpp"
#include "puadem/coupling/unsaturated_stage.hpp"
#include "puadem/coupling/unsaturated_step.hpp"
#include "puadem/dem/grain_system.hpp"
#include "puadem/dem/particles.hpp"
#include "puadem/flow/invasion.hpp"
#include "puadem/flow/retention_curve.hpp"
#include "puadem/geometry/domain.hpp"
#include "puadem/network/pore_network.hpp"

namespace puadem {

/// A simulation: plain values, so that saving, copying and comparing it is saving, copying and
/// comparing a value.
struct State {
  RunPosition position;
  double time = 0.0;  ///< [s]
  Domain domain;
  Particles particles;
  std::optional<GrainSystem> grains;             ///< what the engine holds between stages; `particles` is kept in step with it
  std::vector<HistoryRow> history;               ///< of the stages that loaded the grains
  PoreNetwork network;                           ///< of the grains as they lie, or from a file; empty until a stage needs it
  int reservoir_pores = 0;                       ///< last pores of a network from a file that stand for its inlet and outlet
  std::vector<PermeabilityResult> permeability;  ///< of the stages so far
  std::optional<InvasionState> invasion;         ///< both fluids in the network, once a retention stage has begun
  std::optional<TwoPhaseState> flow;             ///< both fluids as they move, once such a stage has begun
  std::vector<FlowRecord> flows;                 ///< of these stages
  std::optional<SaturatedState> saturated;       ///< one fluid and grains that move, once such a stage has begun
  std::vector<SaturatedRecord> saturated_flows;  ///< of these stages
  std::optional<UnsaturatedState> unsaturated;   ///< two fluids and grains that move, once such a stage has begun
  std::vector<UnsaturatedRecord> unsaturated_flows;  ///< of these stages
  std::vector<double> saturation;                    ///< per pore, wetting fluid [-]
  std::vector<RetentionRow> retention;               ///< equilibria so far
};

/// Has the present stage begun?
inline bool has_begun(const State& state) { return state.position.progress.index() != 0; }

}  // namespace puadem
