#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "puadem/coupling/run.hpp"
#include "puadem/io/results_folder.hpp"

namespace puadem {

/// One check of a finished run, for the manifest and the report.
struct Check {
  std::string name;
  std::string bound;  ///< what was asked for, in words
  double value;
  bool passed;
};

/// Bounds of `[expected]`, volume ledger, saturations in [0, 1], pores and grains filling the box, and
/// what the compaction was asked for (rest, stress, porosity, grading), each where the run has the numbers.
std::vector<Check> run_checks(const Case& c, const State& state, const RunResults* results);

/// Everything that says where results came from: program, machine, case, state, ledger, scalars, checks.
nlohmann::json make_manifest(const ResultsFolder& folder, const Case& c, const State& state, const RunResults* results,
                             int exit_code, const std::string& error_message);

/// Largest resident memory of this process so far [bytes].
long peak_memory();

/// Model name of the processor, "unknown" where the system does not say.
std::string processor_name();

}  // namespace puadem
