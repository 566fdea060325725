#include "puadem/io/case_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/dem/grain_statistics.hpp"
#include "puadem/io/case_file.hpp"
#include "puadem/io/case_templates.hpp"
#include "puadem/io/initial_state.hpp"
#include "puadem/io/inspect.hpp"
#include "puadem/io/packing_file.hpp"
#include "puadem/io/progress_line.hpp"
#include "puadem/io/run_summary.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

template <class Function>
std::string error_of(const Function& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Moments of the same grading by adding up thin slices of every class.
GrainStatistics by_slices(const Grading& grading) {
  double m0 = 0, m1 = 0, m2 = 0, m3 = 0;
  constexpr int slices = 20000;
  for (const GradingClass& g : grading.classes)
    for (int i = 0; i < slices; ++i) {
      const double r = 0.5 * (g.diameter_min + (g.diameter_max - g.diameter_min) * (i + 0.5) / slices);
      const double number = g.fraction / slices / (grading.by == Grading::By::mass ? r * r * r : 1.0);
      m0 += number;
      m1 += number * r;
      m2 += number * r * r;
      m3 += number * r * r * r;
    }
  return {m1 / m0, m3 / m2, 4.0 / 3.0 * std::numbers::pi * m3 / m0, 0, 0};
}

TEST(GradingStatistics, AreTheSumsOverThinSlices) {
  for (const auto by : {Grading::By::mass, Grading::By::number}) {
    const Grading grading{by, {{0.6e-3, 0.6e-3, 0.35}, {0.85e-3, 0.85e-3, 0.35}, {1.0e-3, 1.4e-3, 0.30}}};
    const GrainStatistics s = statistics_of(grading), slow = by_slices(grading);
    EXPECT_NEAR(s.mean_radius, slow.mean_radius, 1e-8 * s.mean_radius);
    EXPECT_NEAR(s.sauter_radius, slow.sauter_radius, 1e-8 * s.sauter_radius);
    EXPECT_NEAR(s.mean_volume, slow.mean_volume, 1e-8 * s.mean_volume);
    EXPECT_EQ(s.smallest, 0.3e-3);
    EXPECT_EQ(s.largest, 0.7e-3);
  }
}

// A table straight over d is a list of classes; a log-normal curve has its moments in closed form when it is not cut.
TEST(GradingStatistics, OfATableAndALogNormalCurve) {
  for (const auto by : {Grading::By::mass, Grading::By::number}) {
    Grading table, classes, lognormal;
    table.by = classes.by = lognormal.by = by;
    table.table = {{1e-3, 2e-3, 4e-3}, {0.0, 0.4, 1.0}, GradingTable::Interpolation::linear};
    classes.classes = {{1e-3, 2e-3, 0.4}, {2e-3, 4e-3, 0.6}};
    EXPECT_DOUBLE_EQ(statistics_of(table).sauter_radius, statistics_of(classes).sauter_radius);
    EXPECT_DOUBLE_EQ(statistics_of(table).mean_volume, statistics_of(classes).mean_volume);
    lognormal.lognormal = {.median = 1e-3, .deviation = 1.4, .smallest = 1e-5, .largest = 1e-1};
    const double width = std::log(1.4), median = by == Grading::By::mass ? std::exp(-3 * width * width) : 1.0;
    const GrainStatistics s = statistics_of(lognormal);
    EXPECT_NEAR(s.mean_radius, 0.5e-3 * median * std::exp(0.5 * width * width), 1e-12 * s.mean_radius);
    EXPECT_NEAR(s.sauter_radius, 0.5e-3 * median * std::exp(2.5 * width * width), 1e-12 * s.sauter_radius);
    EXPECT_EQ(s.largest, 0.05);
  }
}

TEST(GradingStatistics, OfAPacking) {
  const std::vector<double> radius{1.0, 2.0, 3.0};
  const GrainStatistics s = statistics_of(radius);
  EXPECT_DOUBLE_EQ(s.mean_radius, 2.0);
  EXPECT_DOUBLE_EQ(s.sauter_radius, 36.0 / 14.0);
  EXPECT_DOUBLE_EQ(s.mean_volume, 4.0 / 3.0 * std::numbers::pi * 12.0);
}

TEST(CaseTemplates, AreValidAndCheckedWithoutWarning) {
  for (const std::string& name : case_templates())
    for (const char* file : {"case.toml", "tiny.toml"}) {
      const CaseFile read = read_case(cases_folder() / name / file);
      const CaseSummary summary = summarise_case(read.c);
      const char* word = read.c.network_file  ? "pores at the faces"
                         : read.c.grains.file ? "porosity"
                                              : "critical time step about";
      EXPECT_THAT(summary.text, HasSubstr(word)) << name;
      if (std::string(file) == "case.toml") {
        EXPECT_THAT(summary.warnings, IsEmpty()) << name;
      }
    }
}

TEST(CaseTemplates, MakeANewCaseOnce) {
  const TemporaryFolder folder;
  EXPECT_EQ(new_case("drainage-beads", folder.path / "a" / "mine"), folder.path / "a" / "mine");
  EXPECT_TRUE(fs::exists(folder.path / "a" / "mine" / "case.toml"));
  EXPECT_NO_THROW(read_case(folder.path / "a" / "mine" / "case.toml"));
  EXPECT_THAT(error_of([&] { new_case("drainage-beads", folder.path / "a" / "mine"); }), HasSubstr("exists already"));
  EXPECT_THAT(error_of([&] { new_case("drainage-bead", folder.path / "b"); }), HasSubstr("did you mean \"drainage-beads\"?"));
  std::ofstream(folder.path / "file") << "x";
  EXPECT_THAT(error_of([&] { new_case("drainage-beads", folder.path / "file" / "b"); }), HasSubstr("cannot be written"));
  EXPECT_FALSE(fs::exists(folder.path / "b"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path / "a"), fs::directory_iterator()), 1);  // nothing half-made
}

const std::string with_packing = R"(
[domain]
periodic = ["x"]
[grains]
file = "p.csv"
[fluids]
surface_tension = "70 mN/m"
[[stage]]
kind = "retention"
path = ["1 kPa", "10 kPa"]
step = "1 kPa"
)";

TEST(InitialState, HoldsTheGrainsOfThePackingFile) {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "case.toml") << with_packing;
  std::ofstream(folder.path / "p.csv") << "# box 1e-3 2e-3 3e-3\n5e-4,5e-4,5e-4,1e-4\n5e-4,5e-4,15e-4,2e-4\n";
  const CaseFile file = read_case(folder.path / "case.toml");
  std::vector<std::string> warnings;
  const State state = initial_state(file.c, warnings);
  EXPECT_EQ(state.particles.radius, (std::vector<double>{1e-4, 2e-4}));
  EXPECT_EQ(state.particles.position[1], (Vec3{5e-4, 5e-4, 15e-4}));
  EXPECT_EQ(state.domain, (Domain{{0, 0, 0}, {1e-3, 2e-3, 3e-3}, {true, false, false}}));
  EXPECT_NEAR(state.particles.mass[0], 2650 * 4.0 / 3.0 * std::numbers::pi * 1e-12, 1e-20);

  const std::string summary = summarise_case(file.c).text;
  EXPECT_THAT(summary, HasSubstr("2 of glass"));
  EXPECT_THAT(summary, HasSubstr("periodic in x, walls elsewhere"));
  EXPECT_THAT(summary, HasSubstr("10 equilibria"));
  EXPECT_THAT(inspect(folder.path / "p.csv"), HasSubstr("grains  2"));
  EXPECT_THAT(inspect(folder.path / "case.toml"), HasSubstr("1 kPa -> 10 kPa"));
  EXPECT_THAT(error_of([&] { inspect(folder.path); }), HasSubstr("no run of puadem"));

  std::ofstream(folder.path / "p.csv") << "# box 1 1 1\n0.5,0.5,nan,0.1\n";
  EXPECT_THAT(error_of([&] { initial_state(file.c, warnings); }), HasSubstr("is not a finite number"));
}

TEST(ProgressLine, ShowsBarNumbersAndTimeToGo) {
  Progress p;
  p.stage = "retention";
  p.fraction = 0.25;
  p.saturation = 0.5;
  p.capillary_pressure = 900;
  EXPECT_EQ(progress_text(p, 10.0, 200), "[#####...............]  25 %  retention  p_c 900 Pa  S_r 0.500  30 s to go");
  EXPECT_EQ(progress_text(p, 10.0, 30).size(), 29U);
  p.stage = "compact";
  p.fraction = 2.0;
  p.step = 5000;
  EXPECT_THAT(progress_text(p, 10.0, 200), HasSubstr("[####################] 100 %  compact  unbalanced 0.0e+00  500 steps/s"));
  EXPECT_THAT(progress_text(p, 10.0, 200), Not(HasSubstr("to go")));
}

TEST(ProgressLine, ShowsDurations) {
  EXPECT_EQ(show_duration(0.44), "0.4 s");
  EXPECT_EQ(show_duration(59.4), "59 s");
  EXPECT_EQ(show_duration(59.6), "1 min 00 s");
  EXPECT_EQ(show_duration(3599.6), "1 h 00 min");
  EXPECT_EQ(show_duration(7620), "2 h 07 min");
}

TEST(RunSummary, NamesMissedBounds) {
  Case c;
  c.expected["a"] = {1, 2};
  c.expected["b"].low = 5;
  c.expected["porosty_core"] = {0, 1};
  RunResults results;
  results.scalars = {{"a", 1.5}, {"b", 4}, {"porosity_core", 0.3}};
  EXPECT_THAT(missed_bounds(c, results),
              ElementsAre("b = 4, expected >= 5", "porosty_core: the run has no such result; did you mean \"porosity_core\"?"));
  results.scalars["a"] = std::nan("");
  EXPECT_THAT(missed_bounds(c, results), ::testing::SizeIs(3));
  EXPECT_THAT(run_json(c, {}, results, {}), HasSubstr("\"a\": null"));
}

}  // namespace
}  // namespace puadem
