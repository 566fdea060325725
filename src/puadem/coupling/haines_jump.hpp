#pragma once

#include <optional>
#include <vector>

#include "puadem/flow/two_phase_flow.hpp"

namespace puadem {

/// Capillary pressures while air enters a pore in one jump.
struct HainesJump {
  int throat = -1, invaded = -1, retracting = -1;  ///< the pore air comes into, and the one beside it that it comes from
  std::vector<double> time;                        ///< [s]
  std::vector<double> invaded_pressure;            ///< p_c, not a number before the invasion [Pa]
  std::vector<double> retracting_pressure;         ///< [Pa]
};

/// Runs a copy of the state on in fine steps, through its next invasion. None where air enters no pore that has a
/// counted neighbour with air before `duration` [s] is over.
/// @throws InputError, NumericalError  as `make_two_phase_model` and `advance_two_phase`
std::optional<HainesJump> record_haines_jump(const PoreNetwork& network, const TwoPhaseModel& model, const TwoPhaseState& state,
                                             double duration);

}  // namespace puadem
