#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "puadem/io/results_folder.hpp"

namespace puadem {

/// Every stage "two-phase-flow" as the page draws it: curves, pictures, box counts, a Haines jump.
nlohmann::json flows_json(const ResultsFolder& folder, const State& state);

/// What the case says of such a stage, as [[what, value]].
nlohmann::json two_phase_rows(const TwoPhaseStage& stage);

/// Its numbers on top of the page.
std::vector<nlohmann::json> two_phase_highlights(const State& state, const RunResults* results);

}  // namespace puadem
