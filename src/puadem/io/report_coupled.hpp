#pragma once

#include <nlohmann/json_fwd.hpp>

#include "puadem/coupling/run.hpp"

namespace puadem {

/// Stages "saturated-flow": their curves and pressure profiles.
nlohmann::json saturated_json(const State& state);

/// What such a stage does, as [what, value].
nlohmann::json saturated_rows(const SaturatedStage& stage);

}  // namespace puadem
