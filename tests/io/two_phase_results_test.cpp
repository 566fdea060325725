#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "puadem/io/case_file.hpp"
#include "puadem/io/manifest.hpp"
#include "puadem/io/report_two_phase.hpp"
#include "puadem/io/results_folder.hpp"
#include "puadem/io/series_two_phase.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic_run.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string bed = R"(title = "bed"
[domain]
shape = [10, 10, 4]
[grains]
count = 500
material = "glass"
grading = { by = "number", classes = [{ diameter = ["0.24 mm", "0.36 mm"], fraction = 1.0 }] }
[materials.glass]
density = "2650 kg/m3"
[[stage]]
kind = "compact"
stress = "10 kPa"
unbalanced = 0.02
[[stage]]
kind = "two-phase-flow"
air = "disc"
disc_radius = "0.3 mm"
water = ["left", "right", "front", "back"]
water_pressure = "-6 kPa"
duration = "0.5 s"
until_saturation = 0.9
record_jump = 0.99
[output]
fields_at = { saturation = [0.95] }
)";

/// The run with its files, made once.
struct Recorded {
  TemporaryFolder temporary;
  CaseFile file = parse_case(bed, "case.toml", "/study");
  ResultsFolder folder = open_results(file.c, bed, resolved_case(file.c), temporary.path / "run");
  State state;
  RunResults results = run(file.c, state, recording_observer(folder, file.c));
};

TEST(TwoPhaseResults, AreWritten) {
  Recorded r;
  finish_results(r.folder, r.file.c, r.state, &r.results, 0, "");
  const auto path = r.folder.path;
  const std::string rows = slurp(path / "series" / "flow.csv");
  EXPECT_THAT(rows, StartsWith(std::string(flow_header)));
  EXPECT_EQ(std::ranges::count(rows, '\n'), size_of(r.state.flows[0].rows) + 1);
  EXPECT_THAT(slurp(path / "series" / "flow_events.csv"), HasSubstr(",drain,"));
  EXPECT_THAT(slurp(path / "series" / "boxes.csv"), HasSubstr("mostly,"));
  EXPECT_THAT(slurp(path / "series" / "haines_jump.csv"), HasSubstr("time_s,pc_invaded_Pa,pc_retracting_Pa"));
  EXPECT_THAT(slurp(path / "fields" / "throats_00001.vtp"), HasSubstr("nonwetting_flux"));
  EXPECT_THAT(slurp(path / "fields" / "pores_00001.vtp"), HasSubstr("gas_cluster"));
  const auto manifest = nlohmann::json::parse(slurp(path / "manifest.json"));
  EXPECT_LT(std::abs(manifest["ledger"]["wetting_error"].get<double>()), 1e-9);
  EXPECT_GT(manifest["results"]["two-phase-flow_capillary_number"].get<double>(), 0.0);
  for (const auto& check : manifest["checks"]) {
    if (check["name"].get<std::string>().find("fluid") == std::string::npos) continue;
    EXPECT_TRUE(check["passed"].get<bool>()) << check;
  }
}

TEST(TwoPhaseResults, OfThePage) {
  Recorded r;
  const auto flows = flows_json(r.folder, r.state);
  ASSERT_EQ(flows.size(), 1u);
  const auto& flow = flows[0];
  EXPECT_EQ(flow["time"].size(), r.state.flows[0].rows.size());
  ASSERT_EQ(flow["snapshots"].size(), 2u);
  const std::size_t pixels = flow["section"]["columns"].get<std::size_t>() * flow["section"]["rows"].get<std::size_t>();
  EXPECT_EQ(flow["snapshots"][0]["picture"].get<std::string>().size(), (pixels + 2) / 3 * 4);
  EXPECT_FALSE(flow["jump"].is_null());
  EXPECT_THAT(two_phase_rows(std::get<TwoPhaseStage>(r.file.c.stages[1])).dump(), HasSubstr("a disc of radius 0.3 mm"));
  EXPECT_FALSE(two_phase_highlights(r.state, &r.results).empty());
}

}  // namespace
}  // namespace puadem
