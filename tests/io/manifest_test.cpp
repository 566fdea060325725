#include "puadem/io/manifest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "puadem/io/state_hash.hpp"
#include "synthetic_run.hpp"

namespace puadem {
namespace {

using nlohmann::json;

json manifest_of(const SyntheticRun& run) {
  ResultsFolder folder;
  folder.resolved_text = "resolved";
  return make_manifest(folder, run.c, run.state, &run.results, 0, "");
}

TEST(Manifest, HasTheKeysThatScriptsRelyOn) {
  const SyntheticRun run = make_synthetic_run(3);
  const json m = manifest_of(run);
  for (const char* key :
       {"version", "commit", "compiler", "flags", "libraries", "cpu", "threads", "seed", "case_hash", "wall_time_s",
        "peak_memory_bytes", "state_hash", "exit_code", "ledger", "results", "warnings", "checks"})
    EXPECT_TRUE(m.contains(key)) << key;
  EXPECT_EQ(m["exit_code"], 0);
  EXPECT_EQ(m["seed"], 7);
  EXPECT_EQ(m["ledger"]["wetting_error"], run.results.ledger.wetting_error());
  EXPECT_EQ(m["ledger"]["nonwetting_error"], run.results.ledger.nonwetting_error());
  EXPECT_EQ(m["results"]["porosity_core"], 0.3402);
  EXPECT_GT(m["peak_memory_bytes"].get<long>(), 1000000);
  EXPECT_FALSE(m["cpu"].get<std::string>().empty());
}

TEST(Manifest, OfAPackingHasNoLedger) {
  const json m = manifest_of(make_synthetic_run(3, false));
  EXPECT_TRUE(m["ledger"]["wetting_error"].is_null());
  EXPECT_EQ(m["equilibria"], 0);
}

const Check& check_named(const std::vector<Check>& checks, const std::string& part) {
  for (const Check& check : checks)
    if (check.name.find(part) != std::string::npos) return check;
  throw std::runtime_error("no check of " + part);
}

TEST(Checks, HoldForASoundRun) {
  const SyntheticRun run = make_synthetic_run(4);
  const std::vector<Check> checks = run_checks(run.c, run.state, &run.results);
  EXPECT_EQ(checks.size(), 8U);
  for (const Check& check : checks) EXPECT_TRUE(check.passed) << check.name << " " << check.value;
}

TEST(Checks, SeeWhatIsWrong) {
  SyntheticRun run = make_synthetic_run(4);
  run.state.network.pore_volume[0] *= 1.0 + 1e-8;
  run.state.saturation[3] = 1.0 + 1e-9;
  run.results.ledger.wetting_out *= 1.0 + 1e-9;
  run.c.expected["porosity_core"] = {0.35, 0.36};
  run.c.expected["no_such_result"] = {};
  run.c.stages.clear();
  const std::vector<Check> checks = run_checks(run.c, run.state, &run.results);
  for (const char* name : {"box volume", "saturation of every pore", "wetting fluid", "porosity_core", "no_such_result"})
    EXPECT_FALSE(check_named(checks, name).passed) << name;
  EXPECT_TRUE(check_named(checks, "non-wetting fluid").passed);
  EXPECT_EQ(check_named(checks, "saturation of every pore").value, 1.0 + 1e-9);
  EXPECT_TRUE(std::isnan(check_named(checks, "no_such_result").value));
  EXPECT_FALSE(expected_bounds_hold(run.c, run.results));
}

TEST(Checks, HoldThePackingToWhatItsStageAskedFor) {
  SyntheticRun run = make_synthetic_run(2);
  run.c.expected.clear();
  run.results.scalars = {
      {"unbalanced_force", 1.1e-3}, {"stress_mean_Pa", 9890.0}, {"porosity_core", 0.3421}, {"grading_error", 0.011}};
  for (const char* name : {"unbalanced_force", "stress_mean_Pa", "porosity_core", "grading_error"})
    EXPECT_FALSE(check_named(run_checks(run.c, run.state, &run.results), name).passed) << name;
  run.results.scalars = {
      {"unbalanced_force", 0.9e-3}, {"stress_mean_Pa", 9910.0}, {"porosity_core", 0.3419}, {"grading_error", 0.009}};
  for (const Check& check : run_checks(run.c, run.state, &run.results)) EXPECT_TRUE(check.passed) << check.name;
}

TEST(Checks, BoundsIncludeTheirEndsAndMayBeOpen) {
  SyntheticRun run = make_synthetic_run(2);
  run.c.expected = {{"porosity_core", {0.3402, 0.3402}}, {"stress_mean_Pa", {0.0, std::numeric_limits<double>::infinity()}}};
  EXPECT_TRUE(expected_bounds_hold(run.c, run.results));
  run.c.expected["porosity_core"].low = 0.34021;
  EXPECT_FALSE(expected_bounds_hold(run.c, run.results));
}

TEST(StateHash, IsTheFowlerNollVoHash) {  // published test vectors of FNV-1a 64
  EXPECT_EQ(fingerprint(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(fingerprint("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(fingerprint("foobar"), 0x85944171f73967e8ULL);
  EXPECT_EQ(hex(0xabcULL), "0000000000000abc");
}

TEST(StateHash, IsEqualForEqualStatesAndSeesOneBit) {
  const SyntheticRun run = make_synthetic_run(3);
  const std::uint64_t hash = state_hash(run.state);
  EXPECT_EQ(state_hash(make_synthetic_run(3).state), hash);
  const auto changed = [&](const auto& change) {
    State state = run.state;
    change(state);
    return state_hash(state) != hash;
  };
  const auto nudge = [](double& x) { x = std::nextafter(x, 2.0 * x + 1.0); };
  EXPECT_TRUE(changed([&](State& s) { nudge(s.time); }));
  EXPECT_TRUE(changed([&](State& s) { nudge(s.particles.position.back().z); }));
  EXPECT_TRUE(changed([&](State& s) { nudge(s.particles.radius[1]); }));
  EXPECT_TRUE(changed([&](State& s) { nudge(s.saturation[2]); }));
  EXPECT_TRUE(changed([&](State& s) { nudge(s.network.pore_volume[2]); }));
  EXPECT_TRUE(changed([&](State& s) { nudge(s.network.throat_entry_radius[0]); }));
  EXPECT_TRUE(changed([&](State& s) { nudge(s.retention[0].saturation); }));
  EXPECT_TRUE(changed([&](State& s) { s.retention[0].branch = "drainage-9"; }));
  EXPECT_TRUE(changed([&](State& s) { s.particles.radius.push_back(1.0); }));
}

}  // namespace
}  // namespace puadem
