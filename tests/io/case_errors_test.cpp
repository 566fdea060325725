#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/io/case_file.hpp"
#include "support/temporary_folder.hpp"

namespace puadem {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string good = R"(title = "beads"
[grains]
count = 5000
material = "glass"
grading = { by = "mass", classes = [{ diameter = "0.60 mm", fraction = 0.35 }, { diameter = "1 mm", fraction = 0.65 }] }
[materials.glass]
density = "2500 kg/m3"
[fluids]
surface_tension = "72.8 mN/m"
[[stage]]
kind = "compact"
stress = "10 kPa"
[[stage]]
kind = "retention"
air = "top"
water = "bottom"
path = ["400 Pa", "1300 Pa", "0 Pa"]
)";

std::string error_of(const std::string& text, std::vector<std::string> overrides = {}) {
  try {
    parse_case(text, "case.toml", "/study", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The good case with one text replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = good;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(CaseErrors, TheGoodCaseHasNone) { EXPECT_EQ(error_of(good), "no error"); }

struct Wrong {
  const char* from;
  const char* to;
  const char* message;
};

TEST(CaseErrors, OfSingleValues) {
  const std::vector<Wrong> wrongs{
      {"\"10 kPa\"", "\"10 kN\"",
       "case.toml:12:10: stage.0.stress = \"10 kN\" is a force; a pressure or stress is needed, such as \"10 kPa\""},
      {"\"10 kPa\"", "\"10 kpa\"", "case.toml:12:14: stage.0.stress = \"10 kpa\": unknown unit \"kpa\"; did you mean \"kPa\"?"},
      {"\"10 kPa\"", "\"-10 kPa\"", "is out of range; allowed: > 0 Pa"},
      {"\"10 kPa\"", "0", "stage.0.stress = 0 is out of range"},
      {"\"10 kPa\"", "nan", "stage.0.stress = nan is not a finite number"},
      {"\"10 kPa\"", "inf", "stage.0.stress = inf is not a finite number"},
      {"\"10 kPa\"", "true", "stage.0.stress must be a pressure or stress, such as \"10 kPa\", not true"},
      {"\"10 kPa\"", "2026-01-01", "not a date or time"},
      {"\"0.60 mm\"", "\"0 mm\"", "grains.grading.classes.0.diameter = \"0 mm\" is out of range"},
      {"\"0.60 mm\"", "[\"2 mm\", \"1 mm\"]", "the smaller first"},
      {"\"0.60 mm\"", "\"0,60 mm\"", "a comma in a number"},
      {"count = 5000", "count = 0", "grains.count = 0 is out of range; allowed: 1 to 100000000"},
      {"count = 5000", "count = 5000.5", "must be a whole number, such as 5000, not 5000.5"},
      {"count = 5000", "count = \"many\"", "must be a whole number, such as 5000, not \"many\""},
      {"count = 5000", "count = 99999999999999999999", "not valid TOML"},
      {"surface_tension", "surface_tensoin",
       "case.toml:9:1: unknown key fluids.surface_tensoin; did you mean \"surface_tension\"?"},
      {"[fluids]", "[fluid]", "unknown key fluid; did you mean \"fluids\"?"},
      {"\"compact\"", "\"compct\"",
       "stage.0.kind = \"compct\" is not known; allowed: compact, isotropic, oedometer, triaxial, shear, settle, strain, "
       "permeability, retention, two-phase-flow, saturated-flow, unsaturated-flow; did you mean \"compact\"?"},
      {"kind = \"compact\"", "", "case.toml:10:1: missing key stage.0.kind"},
      {"stress = \"10 kPa\"", "",
       "missing key stage.0.stress: target mean stress, compression positive; write stress = \"10 kPa\""},
      {"path = [\"400 Pa\", \"1300 Pa\", \"0 Pa\"]", "", "missing key stage.1.path"},
      {"count = 5000", "", "missing key grains.count"},
      {"by = \"mass\"", "by = \"volume\"", "grains.grading.by = \"volume\" is not known; allowed: mass, number"},
      {"\"top\"", "\"topp\"", "allowed: left, right, front, back, bottom, top; did you mean \"top\"?"},
      {"\"top\"", "5", "stage.1.air must be one of left"},
      {"[[stage]]\nkind = \"compact\"", "[stage]\nkind = \"compact\"", "not valid TOML"},
      {"title = \"beads\"", "title = \"beads", "not valid TOML"},
      {"[fluids]", "[fluids]\ncontact_angle = 30", "a bare number is in radians, write \"30 deg\""},
      {"[fluids]", "[fluids]\ncontact_angle = \"60 deg\"", "out of range; allowed: 0 deg to 60 deg, the upper excluded"},
      {"path = [", "grains = \"moving\"\npath = [", "not available in this version; write grains = \"fixed\""},
      {"[fluids]", "[contact]\nlaw = \"hertz\"\n[fluids]", "did you mean \"hertz-mindlin\"?"},
      {"[fluids]", "[pores]\nmerge_ratio = \"never\"\n[fluids]", "or write \"none\""},
      {"[fluids]", "[pores]\nmerge_criterion = \"insphere_overlap\"\n[fluids]", "did you mean \"insphere-overlap\"?"},
      {"[fluids]", "[pores]\nno_slip = [\"botom\"]\n[fluids]", "did you mean \"bottom\"?"},
      {"[fluids]", "[pores]\nno_slip = \"bottom\"\n[fluids]", "pores.no_slip must be a list of faces"},
      {"[fluids]", "[pores]\nconductance_limits = [2, 3]\n[fluids]", "must be [low, high] with low <= 1 <= high"},
      {"[fluids]", "[pores]\nconductance_limits = [0, 3]\n[fluids]", "pores.conductance_limits = 0 is out of range"},
      {"[fluids]", "[expected]\nx = [2, 1]\n[fluids]", "expected.x must be [low, high] with low <= high"},
      {"[fluids]", "[expected]\nx = { value = 1 }\n[fluids]", "{ value = , tolerance = }"},
      {"[fluids]", "[expected]\nx = 3\n[fluids]", "not 3"},
      {"[fluids]", "[[overlay]]\nlabel = \"a\"\n[fluids]", "missing key overlay.0.folder"},
      {"[fluids]", "[domain]\nshape = [1, 1]\n[fluids]", "domain.shape must have three values (x, y, z), not 2"},
      {"[fluids]", "[domain]\nperiodic = \"x\"\n[fluids]",
       "domain.periodic must be a list of choices, such as [\"x\", \"y\"], not \"x\""},
      {"[fluids]", "[domain]\nsize = [\"1 mm\", \"1 mm\", \"-1 mm\"]\n[fluids]", "domain.size = \"-1 mm\" is out of range"},
  };
  for (const Wrong& wrong : wrongs)
    EXPECT_THAT(error_of(with(wrong.from, wrong.to)), HasSubstr(wrong.message)) << wrong.from << " -> " << wrong.to;
}

TEST(CaseErrors, OfValuesThatDoNotFitEachOther) {
  const std::vector<Wrong> wrongs{
      {"fraction = 0.65", "fraction = 0.5",
       "case.toml:5:26: the fractions of grains.grading.classes add to 0.85; they must add to 1"},
      {"classes = [{", "lognormal = { median = \"1 mm\", deviation = 1.5 }, classes = [{",
       "classes, table and lognormal exclude each other; give one of them"},
      {"material = \"glass\"", "materials = [{ name = \"glass\", fraction = 0.8 }]",
       "the fractions of grains.materials add to 0.8; they must add to 1"},
      {"material = \"glass\"", "materials = [{ name = \"glas\" }]",
       "no table [materials.glas] for a share of grains.materials; defined: glass; did you mean \"glass\"?"},
      {"material = \"glass\"", "material = \"glass\"\nmaterials = [{ name = \"glass\" }]",
       "grains.material and grains.materials exclude each other"},
      {"[fluids]", "[[contact.pair]]\nmaterials = [\"glass\", \"gum\"]\n[fluids]", "no table [materials.gum] for contact.pair"},
      {"[fluids]", "[[contact.pair]]\nmaterials = [\"glass\"]\n[fluids]", "contact.pair.0.materials must be a list of two names"},
      {"material = \"glass\"", "material = \"glas\"",
       "no table [materials.glas] for the material of the grains; defined: glass; did you mean \"glass\"?"},
      {"[materials.glass]\ndensity = \"2500 kg/m3\"\n", "", "no table [materials.glass]"},
      {"\"bottom\"", "\"top\"", "air and water must lie at different faces, not both at top"},
      {"[fluids]", "[domain]\nperiodic = [\"z\"]\n[fluids]", "stage.1.air = \"top\" is no wall: the direction z is periodic"},
      {"[fluids]", "[pores]\nmerge_criterion = \"insphere-overlap\"\nmerge_ratio = 0.9\n[fluids]",
       "pores.merge_ratio is not used with pores.merge_criterion = \"insphere-overlap\""},
      {"[fluids]", "[domain]\nperiodic = [\"x\"]\n[pores]\nno_slip = [\"bottom\", \"left\"]\n[fluids]",
       "pores.no_slip: \"left\" is no wall: the direction x is periodic"},
      {"[fluids]", "[domain]\nsize = [1, 1, 1]\nshape = [1, 1, 1]\n[fluids]", "domain.size and domain.shape exclude each other"},
      {"[\"400 Pa\", \"1300 Pa\", \"0 Pa\"]", "[\"400 Pa\"]", "stage.1.path needs at least two pressures"},
      {"[\"400 Pa\", \"1300 Pa\", \"0 Pa\"]", "[\"400 Pa\", 400]",
       "case.toml:17:19: stage.1.path: a pressure must differ from the one before it"},
      {"[\"400 Pa\", \"1300 Pa\", \"0 Pa\"]", "[\"400 Pa\", \"-1 Pa\"]",
       "stage.1.path = \"-1 Pa\" is out of range; allowed: >= 0 Pa"},
      {"path = [", "step = \"1 nPa\"\npath = [", "steps along the path; at most 1e6"},
      {"stress = \"10 kPa\"", "stress = \"10 kPa\"\nporosity = 0.37\nfriction_angle = \"0 deg\"",
       "case.toml:14:1: stage.0.porosity and stage.0.friction_angle exclude each other"},
      {"count = 5000", "count = 5000\nfile = \"p.csv\"", "grains.file and grains.count exclude each other"},
      {"count = 5000", "count = 5000\nfile = \"p.csv\"", "no such file: /study/p.csv"},
      {"count = 5000", "count = 5000\nfile = \"p.csv\"", "with grains.file remove the stage"},
      {"[[stage]]\nkind = \"compact\"\nstress = \"10 kPa\"\n", "", "grains from a grading need a stage \"compact\" first"},
  };
  for (const Wrong& wrong : wrongs)
    EXPECT_THAT(error_of(with(wrong.from, wrong.to)), HasSubstr(wrong.message)) << wrong.from << " -> " << wrong.to;
  EXPECT_THAT(error_of(good + "[[stage]]\nkind = \"compact\"\nstress = 3\n"), HasSubstr("a stage \"compact\" must come first"));
}

TEST(CaseErrors, OfOtherFormsOfTheGrading) {
  const std::vector<Wrong> wrongs{
      {"", "table = { diameter = [\"1 mm\", \"2 mm\"], passing = [\"0 %\", \"90 %\"] }",
       "case.toml:5:26: grains.grading.table: passing ends with 90 %"},
      {"", "table = { diameter = [\"1 mm\", \"2 mm\"], passing = [0, 100] }",
       "grains.grading.table.passing = 100 is out of range; allowed: 0 to 1"},
      {"", "table = { diameter = [\"1 mm\", \"2 mm\"] }", "missing key grains.grading.table.passing"},
      {"", "table = { diameter = [\"2 mm\", \"1 mm\"], passing = [0, 1] }", "the diameters must ascend"},
      {"", "table = { diameter = [\"1 mm\", \"2 mm\"], passing = [0, 1], interpolation = \"log\" }",
       "allowed: logarithmic, linear"},
      {"", "lognormal = { median = \"1 mm\", deviation = 0.5 }", "lognormal.deviation = 0.5 is out of range; allowed: > 1"},
      {"", "lognormal = { median = \"1 mm\", deviation = 1.5, smallest = \"5 mm\" }", "must be positive and ascending"},
      {"", "", "grains.grading has no class; give classes, a table or lognormal"},
  };
  const std::string classes = R"(classes = [{ diameter = "0.60 mm", fraction = 0.35 }, { diameter = "1 mm", fraction = 0.65 }])";
  for (const Wrong& wrong : wrongs) {
    std::string text = with(", " + classes, *wrong.to != 0 ? std::string(", ") + wrong.to : std::string());
    EXPECT_THAT(error_of(text), HasSubstr(wrong.message)) << wrong.to;
  }
}

TEST(CaseErrors, ComeAllAtOnceInTheOrderOfTheFile) {
  std::string text = with("\"10 kPa\"", "\"10 mm\"");
  text.replace(text.find("count = 5000"), 12, "cuont = 5000");
  text.replace(text.find("\"72.8 mN/m\""), 11, "\"72.8 mN\"");
  const std::string error = error_of(text);
  EXPECT_THAT(error, HasSubstr("case.toml: 4 errors"));
  const std::size_t a = error.find("cuont"), b = error.find("surface_tension"), c = error.find("stage.0.stress");
  EXPECT_NE(c, std::string::npos);
  EXPECT_LT(a, b);
  EXPECT_LT(b, c);
}

TEST(CaseErrors, OfWholeFiles) {
  EXPECT_THAT(error_of(" \n\t\n"), HasSubstr("case.toml: the file is empty"));
  EXPECT_THAT(error_of("a = 1\na = 2\n"), HasSubstr("case.toml:2:"));
  EXPECT_THAT(error_of("# nothing\n"), AllOf(HasSubstr("missing key stage"), HasSubstr("missing key grains")));
  // A file cut in the middle of a value, a list and a table.
  for (const char* end : {"\"0.60", "classes = [{ diam", "kind = \"comp"}) {
    const std::string cut = good.substr(0, good.find(end) + std::string(end).size());
    EXPECT_THAT(error_of(cut), HasSubstr("not valid TOML")) << end;
  }
  const TemporaryFolder folder;
  std::ofstream(folder.path / "case.toml") << good;
  try {
    read_case(folder.path / "cse.toml");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean \"case.toml\"?"));
  }
}

TEST(CaseErrors, OfOverridesShowTheOverride) {
  EXPECT_THAT(error_of(good, {"stage.0.stress=5 kPaa"}),
              HasSubstr("--set:1:18: stage.0.stress = \"5 kPaa\": unknown unit \"kPaa\"; did you mean \"kPa\"?\n  1 | "
                        "stage.0.stress=5 kPaa\n    |                  ^"));
  EXPECT_THAT(error_of(good, {"grains.cuont=5"}), HasSubstr("did you mean \"count\"?"));
  EXPECT_THAT(error_of(good, {"stage.2.stress=5"}), HasSubstr("\"2\" is no index of this list of 2"));
  EXPECT_THAT(error_of(good, {"stage.x.stress=5"}), HasSubstr("\"x\" is no index"));
  EXPECT_THAT(error_of(good, {"title.a=5"}), HasSubstr("lies inside a text, which has no keys"));
  EXPECT_THAT(error_of(good, {"grains"}), HasSubstr("write --set key=value"));
  EXPECT_THAT(error_of(good, {"=3"}), HasSubstr("write --set key=value"));
  EXPECT_THAT(error_of(good, {"grains..count=3"}), HasSubstr("an empty part in a dotted key"));
  EXPECT_THAT(error_of(good, {"stage=[]"}), HasSubstr("no stage"));
}

// Whatever a file holds: a case, or one InputError that names the file.
TEST(CaseErrors, MutatedFilesNeverCrash) {
  Random random(11);
  const std::string alphabet = "[]{}=\",.#\n\\-+eEnaif0123456789 \t\xC2\xB5\x01\x7f_mPk";
  int accepted = 0, refused = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::string text = good;
    const auto edits = 1 + random.below(3);
    for (std::uint64_t edit = 0; edit < edits && !text.empty(); ++edit) {
      const auto at = static_cast<std::size_t>(random.below(text.size()));
      const auto length = static_cast<std::size_t>(random.below(12));
      const char letter = alphabet[static_cast<std::size_t>(random.below(alphabet.size()))];
      switch (random.below(5)) {
        case 0:
          text[at] = letter;
          break;
        case 1:
          text.insert(at, 1, letter);
          break;
        case 2:
          text.erase(at, length);
          break;
        case 3:
          text.insert(at, text.substr(static_cast<std::size_t>(random.below(text.size())), length));
          break;
        default:
          text.resize(at + 1);
          break;
      }
    }
    try {
      const CaseFile file = parse_case(text, "case.toml", "/study");
      ++accepted;
      // What was accepted is a case that can be written and read.
      EXPECT_NO_THROW(parse_case(resolved_case(file.c), "resolved", "/study")) << text << resolved_case(file.c);
    } catch (const InputError& error) {
      ++refused;
      EXPECT_THAT(error.what(), HasSubstr("case.toml"));
    }
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 1000);
}

TEST(CaseErrors, DeepNestingIsRefused) {
  EXPECT_THAT(error_of("a = " + std::string(100000, '[')), HasSubstr("not valid TOML"));
  EXPECT_THAT(error_of(good, {"title=" + std::string(100000, '[')}), HasSubstr("no error"));
}

/// Errors of a case with one stage after the compaction.
std::string error_of_stage(const std::string& stage, std::vector<std::string> overrides = {}) {
  const std::string text =
      "[grains]\ncount = 100\ngrading.classes = [{ diameter = \"1 mm\" }]\n[materials.glass]\n[[stage]]\nkind = "
      "\"compact\"\nstress = \"50 kPa\"\n[[stage]]\n";
  return error_of(text + stage, std::move(overrides));
}

TEST(CaseErrors, OfStagesThatLoadGrains) {
  EXPECT_EQ(error_of_stage("kind = \"triaxial\"\nstress = \"1 kPa\""), "no error");
  EXPECT_THAT(error_of_stage("kind = \"triaxail\"\nstress = \"1 kPa\""), HasSubstr("did you mean \"triaxial\"?"));
  EXPECT_THAT(error_of_stage("kind = \"triaxial\""), HasSubstr("missing key stage.1.stress"));
  EXPECT_THAT(error_of_stage("kind = \"triaxial\"\nstress = 1e3\nstrain_rate = \"1 m/s\""),
              HasSubstr("is a velocity; a rate is needed, such as \"1.0 1/s\""));
  EXPECT_THAT(error_of_stage("kind = \"triaxial\"\nstress = 1e3\nstrain = 1.5"), HasSubstr("allowed: -1 to 1"));
  EXPECT_THAT(error_of_stage("kind = \"triaxial\"\nstress = 1e3\nstrain = 0"), HasSubstr("leaves nothing to do"));
  EXPECT_THAT(error_of_stage("kind = \"triaxial\"\nstress = 1e3\nstress_path = \"constant-volum\""),
              HasSubstr("did you mean \"constant-volume\"?"));
  EXPECT_THAT(error_of_stage("kind = \"oedometer\""), HasSubstr("needs either stage.1.path"));
  EXPECT_THAT(error_of_stage("kind = \"oedometer\"\nstrain = 0.1\npath = [1e3]"), HasSubstr("needs either stage.1.path"));
  EXPECT_THAT(error_of_stage("kind = \"oedometer\"\npath = [1e3, 1e3]"), HasSubstr("must differ from the one before it"));
  EXPECT_THAT(error_of_stage("kind = \"settle\"\ntime = 1"), HasSubstr("set motion.gravity"));
  EXPECT_THAT(error_of_stage("kind = \"settle\"\ntime = 1", {"motion.gravity=[0, 0, -9.81]", "domain.periodic=[\"z\"]"}),
              HasSubstr("grains would fall for ever"));
  EXPECT_THAT(error_of_stage("kind = \"settle\"\ntime = 1", {"motion.gravity=[0, -9.81]"}), HasSubstr("must have three values"));
  EXPECT_THAT(error_of_stage("kind = \"settle\"\ntime = 1", {"motion.gravity=[0, 0, \"9.81 m/s\"]"}),
              HasSubstr("an acceleration is needed"));
  EXPECT_THAT(error_of_stage("kind = \"strain\"\ntime = 1\nstress_x = 1e3\nstrain_rate_x = 1"), HasSubstr("exclude each other"));
  EXPECT_THAT(error_of_stage("kind = \"strain\"\ntime = 1"), HasSubstr("nothing would happen"));
  EXPECT_THAT(error_of_stage("kind = \"isotropic\"\nstress = 1e3", {"motion.safety=1.5"}),
              HasSubstr("motion.safety = 1.5 is out of range"));
}

TEST(CaseErrors, OfAShearThatTheBoxCannotDo) {
  const std::string stage = "kind = \"shear\"\nnormal_stress = 1e3";
  const std::vector<std::string> layer{"domain.periodic=[\"x\", \"y\"]", "contact.wall_friction=0.3"};
  EXPECT_EQ(error_of_stage(stage, layer), "no error");
  EXPECT_THAT(error_of_stage(stage, {layer[0]}),
              HasSubstr("walls without friction cannot shear grains; set contact.wall_friction"));
  EXPECT_THAT(error_of_stage(stage, {layer[1]}), HasSubstr("would pile up at its walls"));
  EXPECT_THAT(error_of_stage(stage, {"domain.periodic=[\"x\", \"z\"]", layer[1]}),
              HasSubstr("the axis z is periodic and has no walls"));
  EXPECT_THAT(error_of_stage(stage + "\ndirection = \"z\"", layer), HasSubstr("must lie in the walls"));
}

}  // namespace
}  // namespace puadem
