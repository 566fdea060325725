#include "puadem/io/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "puadem/io/report_data.hpp"
#include "puadem/io/series_writer.hpp"
#include "support/temporary_folder.hpp"
#include "synthetic_run.hpp"

namespace puadem {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

std::string html_of(const SyntheticRun& run, ResultsFolder&& folder = {}, int exit_code = 0, const std::string& error = "") {
  folder.started_utc = "2026-01-02T03:04:05Z";
  return report_html(folder, run.c, run.state, exit_code == 0 ? &run.results : nullptr, exit_code, error);
}

/// The data as a browser sees them: the text of the script element.
json data_of(const std::string& html) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = html.find(open) + open.size();
  return json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

/// The page without its script and its data, which may name anything.
std::string markup_of(const std::string& html) { return html.substr(0, html.find("<script")); }

TEST(Report, AsksNoServer) {
  const std::string html = html_of(make_synthetic_run(3));
  EXPECT_FALSE(std::regex_search(markup_of(html), std::regex("https?:|url\\(|@import")));
  EXPECT_THAT(html, Not(HasSubstr("<script src")));
  EXPECT_THAT(html, Not(HasSubstr("<link rel=\"stylesheet\"")));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
}

TEST(Report, IsFilledIn) {
  const std::string html = html_of(make_synthetic_run(3));
  EXPECT_THAT(markup_of(html), Not(HasSubstr("{{")));
  EXPECT_THAT(html, HasSubstr("<title>Drainage and imbibition of a made-up lattice – puadem</title>"));
  const std::regex element("</script>");
  const auto ends = std::distance(std::sregex_iterator(html.begin(), html.end(), element), std::sregex_iterator());
  EXPECT_EQ(ends, 2);  // of the data and of the program: neither ends early
}

TEST(Report, TakesNoWordOfTheUserForMarkup) {
  SyntheticRun run = make_synthetic_run(2);
  const std::string evil = "</script><script>alert(1)</script><!-- {{data}} & \"quoted\" 'x' \xff";
  run.c.title = evil;
  ResultsFolder folder;
  folder.case_text = evil;
  folder.warnings = {evil};
  const std::string html = html_of(run, std::move(folder));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(
      html,
      HasSubstr(
          "<title>&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;&lt;!-- {{data}} &amp; &quot;quoted&quot; &#39;x&#39;"));
  const json data = data_of(html);
  EXPECT_THAT(data["title"].get<std::string>(), HasSubstr("</script><script>alert(1)</script><!-- {{data}} & \"quoted\" 'x' "));
  EXPECT_THAT(data["case_text"].get<std::string>(), HasSubstr("</script>"));
}

TEST(Report, CarriesCurvesFitsAndLoops) {
  const SyntheticRun run = make_synthetic_run(3);
  const json data = data_of(html_of(run));
  ASSERT_EQ(data["runs"].size(), 1U);
  const json& own = data["runs"][0];
  ASSERT_EQ(own["branches"].size(), 3U);
  EXPECT_EQ(own["branches"][1]["name"], "imbibition-1");
  EXPECT_EQ(own["branches"][1]["drainage"], false);
  EXPECT_EQ(own["branches"][0]["pc"].size(), 13U);
  EXPECT_EQ(own["branches"][0]["saturation"][3], run.state.retention[3].saturation);
  EXPECT_NEAR(own["branches"][0]["fit"]["n"].get<double>(), 11.0, 1e-3);  // the curve the rows were put on
  EXPECT_NEAR(own["branches"][0]["fit"]["alpha"].get<double>(), 1.0 / 750.0, 1e-6);
  ASSERT_EQ(own["loops"].size(), 2U);
  EXPECT_EQ(own["loops"][1]["upper"], "drainage-2");
  EXPECT_EQ(own["loops"][1]["lower"], "imbibition-1");
  EXPECT_GT(own["loops"][0]["area_Pa"].get<double>(), own["loops"][1]["area_Pa"].get<double>());
  const RetentionRow& row = run.state.retention[5];
  EXPECT_NEAR(own["star_per_Pa"].get<double>() * row.capillary_pressure, row.pc_star, 1e-12 * row.pc_star);
  EXPECT_FALSE(own["pore"]["pdf"].empty());
}

TEST(Report, CarriesTheStagesThatLoadedTheGrains) {
  const TemporaryFolder scratch;
  SyntheticRun run = make_synthetic_run(3, false);
  std::string csv = history_header(run.state.domain);
  for (int k = 0; k < 12; ++k) {
    HistoryRow row;
    row.stage = k < 8 ? "triaxial" : "triaxial-2";
    row.strain.z = 0.01 * k;
    row.volumetric = -0.001 * k;
    row.mean = 1e5 + 1e3 * k;
    row.deviator = 3e3 * k;
    row.energy.input = 0.5 * k;
    run.state.history.push_back(row);
    csv += history_line(row, run.state.domain);
  }
  std::ofstream(scratch.path / "history.csv") << csv;
  run.c.overlays = {{"other", scratch.path}};
  const json data = data_of(html_of(run));
  const json& stages = data["runs"][0]["loading"];
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_EQ(stages[1]["name"], "triaxial-2");
  EXPECT_EQ(stages[1]["kind"], "triaxial");
  EXPECT_EQ(stages[0]["q"].size(), 8U);
  EXPECT_EQ(stages[1]["axial_strain"][3], run.state.history[11].strain.z);
  EXPECT_EQ(stages[1]["energy"]["input"][0], 4.0);
  ASSERT_EQ(data["runs"].size(), 2U);  // an overlay without a retention curve
  EXPECT_EQ(data["runs"][1]["loading"][0]["p"], stages[0]["p"]);
  EXPECT_TRUE(data["manifest"]["warnings"].empty());
}

TEST(Report, OfAPackingHasNoCurves) {
  const json data = data_of(html_of(make_synthetic_run(3, false)));
  EXPECT_TRUE(data["runs"][0]["branches"].empty());
  EXPECT_TRUE(data["runs"][0]["loops"].empty());
}

TEST(Report, OfNothingStillSaysWhy) {
  SyntheticRun run;
  run.c.title = "nothing";
  const json data = data_of(html_of(run, {}, 2, "the packing flew apart"));
  EXPECT_EQ(data["manifest"]["error"], "the packing flew apart");
  EXPECT_EQ(data["manifest"]["exit_code"], 2);
  EXPECT_TRUE(data["facts"].empty());
}

TEST(Report, LaysOtherRunsOverAndTellsOfThoseItCannotRead) {
  const TemporaryFolder scratch;
  SyntheticRun run = make_synthetic_run(3);
  std::filesystem::create_directory(scratch.path / "series");  // as in a folder of results
  std::string csv(retention_header);
  for (const RetentionRow& row : run.state.retention) csv += retention_line(row);
  std::ofstream(scratch.path / "series" / "retention.csv") << csv;
  run.c.overlays = {{"beads", scratch.path}, {"absent", scratch.path / "absent"}};
  const json data = data_of(html_of(run));
  ASSERT_EQ(data["runs"].size(), 2U);
  EXPECT_EQ(data["runs"][1]["label"], "beads");
  EXPECT_EQ(data["runs"][1]["branches"], data["runs"][0]["branches"]);
  EXPECT_TRUE(data["runs"][1]["pore"]["pdf"].empty());
  ASSERT_EQ(data["manifest"]["warnings"].size(), 1U);
  EXPECT_THAT(data["manifest"]["warnings"][0].get<std::string>(), HasSubstr("overlay 'absent' is not drawn"));
}

TEST(Report, SummarisesTheCaseInUnitsOfAPerson) {
  const std::string summary = case_json(make_synthetic_run(2).c).dump();
  for (const char* part :
       {"72.8 mN/m", "10 kPa", "0.34 in the core", "mayer-stowe-princen", "400 Pa → 1.3 kPa → 0 Pa", "30°", "both fluids"})
    EXPECT_THAT(summary, HasSubstr(part));
}

// In a browser, where one is installed: every figure drawn, no error on the console, no request.
/// The pores of a made-up run without their grains, after a permeability stage.
SyntheticRun make_network_run() {
  SyntheticRun run = make_synthetic_run(3);
  run.c.network_file = "rock.csv";
  run.c.stages = {PermeabilityStage{}, run.c.stages.back()};
  run.state.particles = {};
  PermeabilityResult r;
  r.stage = "permeability";
  for (int axis = 0; axis < 3; ++axis) r.permeability.tensor[to_size(axis)][axis] = 2e-10;
  r.permeability.measured = {true, true, true};
  r.inlet = 5;
  r.pressure_drop = 1000.0;
  r.profile = {{1e-3, 320.0, 333.0, 9}, {2e-3, 680.0, 667.0, 9}};
  run.state.permeability = {r};
  return run;
}

TEST(Report, OfANetworkFromAFile) {
  const json data = data_of(html_of(make_network_run()));
  EXPECT_EQ(data["case"][0], json::parse(R"({"title": "Network", "rows": [["File", "rock.csv"]]})"));
  EXPECT_EQ(data["facts"].size(), 1U);
  const json& flow = data["permeability"].at(0);
  EXPECT_EQ(flow["axis"], "z");
  EXPECT_EQ(flow["profile"]["pressure"], json::parse("[320.0, 680.0]"));
  EXPECT_EQ(flow["rows"][0], json::parse(R"(["Mean permeability", "2e-10 m²"])"));
}

TEST(Report, OpensInABrowser) {
  if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "no chromium here";
  const TemporaryFolder scratch;
  std::ofstream(scratch.path / "full.html") << html_of(make_synthetic_run(4));
  std::ofstream(scratch.path / "packing.html") << html_of(make_synthetic_run(3, false));
  SyntheticRun loaded = make_synthetic_run(3, false);
  for (const char* stage : {"isotropic", "oedometer", "triaxial", "strain", "shear", "triaxial-2"})
    for (int k = 0; k < 5; ++k) {
      HistoryRow row;
      row.stage = stage;
      row.strain.z = 0.01 * k;
      row.stress.z = row.mean = row.normal_stress = 1e5 + 1e4 * k;
      row.unbalanced = 0.1 / (k + 1);
      row.energy.input = k;
      loaded.state.history.push_back(row);
    }
  std::ofstream(scratch.path / "loading.html") << html_of(loaded);
  std::ofstream(scratch.path / "network.html") << html_of(make_network_run());
  std::ofstream(scratch.path / "broken.html") << "<html data-rendered=\"yes\"><script>console.error('x')</script></html>";
  const std::string tool = PUADEM_TOOLS "/check_report";
  const auto check = [&](const char* page, const char* more = "") {
    return WEXITSTATUS(std::system((tool + " " + (scratch.path / page).string() + more).c_str()));
  };
  EXPECT_EQ(check("full.html"), 0);
  EXPECT_EQ(check("packing.html"), 0);
  EXPECT_EQ(check("loading.html"), 0);
  EXPECT_EQ(check("network.html"), 0);
  EXPECT_NE(check("broken.html", " 2>/dev/null"), 0);
}

}  // namespace
}  // namespace puadem
