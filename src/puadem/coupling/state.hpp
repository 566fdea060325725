#pragma once

#include <optional>
#include <vector>

#include "puadem/coupling/history.hpp"
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
  double time = 0.0;  ///< [s]
  Domain domain;
  Particles particles;
  std::optional<GrainSystem> grains;      ///< what the engine holds between stages; `particles` is kept in step with it
  std::vector<HistoryRow> history;        ///< of the stages that loaded the grains
  PoreNetwork network;                    ///< empty until a stage needs it
  std::optional<InvasionState> invasion;  ///< both fluids in the network, once a retention stage has begun
  std::vector<double> saturation;         ///< per pore, wetting fluid [-]
  std::vector<RetentionRow> retention;    ///< equilibria so far
};

}  // namespace puadem
