#pragma once

#include <nlohmann/json_fwd.hpp>

#include "puadem/io/results_folder.hpp"

namespace puadem {

/// Stages "unsaturated-flow": their rows and spreads of forces.
nlohmann::json unsaturated_json(const ResultsFolder& folder, const State& state);

/// The options of such a stage, for the table of the case.
nlohmann::json unsaturated_rows(const UnsaturatedStage& stage);

}  // namespace puadem
