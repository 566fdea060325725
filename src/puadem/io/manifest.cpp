#include "puadem/io/manifest.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/utsname.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "puadem/base/parallel.hpp"
#include "puadem/build_info.hpp"
#include "puadem/flow/cholesky_factor.hpp"
#include "puadem/flow/multigrid.hpp"
#include "puadem/io/state_hash.hpp"

namespace puadem {
namespace {

using nlohmann::json;

std::string version_of(int packed, int major_step, int minor_step) {
  return fmt::format("{}.{}.{}", packed / major_step, packed % major_step / minor_step, packed % minor_step);
}

json libraries() {
  return {{"fmt", version_of(FMT_VERSION, 10000, 100)},
          {"CGAL", build_info::cgal},
          {"CHOLMOD", cholesky_version()},
          {"hypre", multigrid_version()},
          {"nlohmann-json",
           fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

json ledger_of(const RunResults* results) {
  if (!results || !(results->ledger.void_volume > 0.0)) return {{"wetting_error", nullptr}, {"nonwetting_error", nullptr}};
  const Ledger& l = results->ledger;
  return {{"void_volume_m3", l.void_volume},
          {"wetting_start_m3", l.wetting_start},
          {"wetting_in_m3", l.wetting_in},
          {"wetting_out_m3", l.wetting_out},
          {"wetting_end_m3", l.wetting_end},
          {"wetting_error", l.wetting_error()},
          {"nonwetting_start_m3", l.nonwetting_start},
          {"nonwetting_in_m3", l.nonwetting_in},
          {"nonwetting_out_m3", l.nonwetting_out},
          {"nonwetting_end_m3", l.nonwetting_end},
          {"nonwetting_error", l.nonwetting_error()}};
}

}  // namespace

long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024L;  // Linux counts in KiB
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  utsname system{};
  return uname(&system) == 0 ? system.machine : "unknown";
}

json make_manifest(const ResultsFolder& folder, const Case& c, const State& state, const RunResults* results, int exit_code,
                   const std::string& error_message) {
  json checks = json::array();
  for (const Check& check : run_checks(c, state, results))
    checks.push_back({{"name", check.name}, {"bound", check.bound}, {"value", check.value}, {"passed", check.passed}});
  return {{"program", "puadem"},
          {"version", build_info::version},
          {"commit", build_info::commit},
          {"compiler", build_info::compiler},
          {"build_type", build_info::build_type},
          {"flags", build_info::flags},
          {"libraries", libraries()},
          {"cpu", processor_name()},
          {"threads", threads()},
          {"title", c.title},
          {"seed", c.seed},
          {"case_hash", hex(fingerprint(folder.resolved_text))},
          {"started_utc", folder.started_utc},
          {"wall_time_s", wall_seconds(folder)},
          {"peak_memory_bytes", peak_memory()},
          {"grains", state.particles.size()},
          {"pores", state.network.pores()},
          {"throats", state.network.throats()},
          {"equilibria", state.retention.size()},
          {"state_hash", hex(state_hash(state))},
          {"exit_code", exit_code},
          {"error", error_message},
          {"ledger", ledger_of(results)},
          {"results", results ? json(results->scalars) : json::object()},
          {"warnings", folder.warnings},
          {"checks", checks}};
}

}  // namespace puadem
