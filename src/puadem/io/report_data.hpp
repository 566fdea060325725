#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "puadem/coupling/run.hpp"
#include "puadem/io/distributions.hpp"
#include "puadem/io/results_folder.hpp"

namespace puadem {

/// `show` of io/units with the signs of print: "74.24 µm", "30°".
std::string in_print(double value, std::string_view unit, int digits = 4);

/// One run's curves as the page draws them: branches with their van Genuchten fits, loops with their
/// areas, radius distributions, stages that loaded the grains.
nlohmann::json curves_json(const std::string& label, std::span<const RetentionRow> rows, const RadiusDistributions& radii,
                           std::span<const HistoryRow> history);

/// The stages of a history, each with its columns.
nlohmann::json loading_json(std::span<const HistoryRow> rows);

/// Permeability stages: what they found, and the pressure through the box.
nlohmann::json permeability_json(const State& state);

/// The curves of every overlay of the case; what cannot be read is told in `warnings`.
nlohmann::json overlays_json(const Case& c, std::vector<std::string>& warnings);

/// The few numbers that stand on top of the page.
nlohmann::json highlights_json(const State& state, const RunResults* results);

/// Tables of plain facts: packing, pore network; each {title, rows: [[what, value]]}.
nlohmann::json facts_json(const State& state);

/// Every result by name, as [[name, value with unit]].
nlohmann::json scalars_json(const RunResults* results);

/// The case in the units a person would use; the same form.
nlohmann::json case_json(const Case& c);

/// All data of the page.
nlohmann::json report_json(const ResultsFolder& folder, const Case& c, const State& state, const RunResults* results,
                           int exit_code, const std::string& error_message);

}  // namespace puadem
