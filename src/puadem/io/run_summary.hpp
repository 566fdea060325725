#pragma once

#include <filesystem>
#include <string>

#include "puadem/coupling/run.hpp"

namespace puadem {

/// What a run says at its end.
struct RunOutcome {
  int exit_code = 0;
  std::string error;             ///< empty for exit code 0
  std::filesystem::path folder;  ///< of the results; empty where none is left
  double wall_time = 0.0;        ///< [s]
};

/// The retention table, the main numbers, the bounds of `[expected]`, and where the report is.
std::string run_text(const Case& c, const State& state, const RunResults& results, const RunOutcome& outcome);

/// The same for a program: one JSON object.
std::string run_json(const Case& c, const State& state, const RunResults& results, const RunOutcome& outcome);

/// "within [0.338, 0.342]" for each bound of `[expected]` that does not hold; empty where all hold.
std::vector<std::string> missed_bounds(const Case& c, const RunResults& results);

}  // namespace puadem
