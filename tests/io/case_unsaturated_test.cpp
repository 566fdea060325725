#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bed_case.hpp"

namespace puadem {
namespace {

using ::testing::ElementsAre;

const std::string bed = testing::bed_case("unsaturated-flow", testing::between_plates);

const std::string everything = bed + R"(path = ["0 Pa", "2 kPa", "0 Pa"]
step = "50 Pa"
air = "bottom"
water = ["top"]
initial_air_fraction = 1e-5
loaded = ["bottom", "top"]
stress = "12 kPa"
strain = -0.05
strain_rate = "2 1/s"
strain_step = 2e-4
damping = 0.1
unbalanced = 1e-4
saturation_change = 2e-3
strain_change = 3e-5
rounds = 30
remesh_displacement = 0.03
corner_films = false
snap_off = true
)";

UnsaturatedStage stage_of(const std::string& text) {
  return std::get<UnsaturatedStage>(parse_case(text, "case.toml", "/study").c.stages[1]);
}

void expect_error(const std::string& keys, const std::string& message) { testing::expect_case_error(bed + keys, message); }

TEST(UnsaturatedKeys, FillEveryFieldAndAreWrittenBack) {
  const Case c = parse_case(everything, "case.toml", "/study").c;
  for (const UnsaturatedStage& s : {std::get<UnsaturatedStage>(c.stages[1]), stage_of(resolved_case(c))}) {
    EXPECT_THAT(s.path, ElementsAre(0.0, 2000.0, 0.0));
    EXPECT_THAT(s.step, ElementsAre(50.0));
    EXPECT_EQ(s.start, UnsaturatedStage::Start::saturated);
    EXPECT_EQ(s.air, 4);
    EXPECT_EQ(s.water, (std::array<bool, 6>{false, false, false, false, false, true}));
    EXPECT_EQ(s.initial_air_fraction, 1e-5);
    EXPECT_EQ(s.loaded, (std::array<bool, 6>{false, false, false, false, true, true}));
    EXPECT_EQ(s.stress, 12e3);
    EXPECT_EQ(s.strain, -0.05);
    EXPECT_EQ(s.strain_rate, 2.0);
    EXPECT_EQ(s.strain_step, 2e-4);
    EXPECT_EQ(s.damping, 0.1);
    EXPECT_EQ(s.unbalanced, 1e-4);
    EXPECT_EQ(s.saturation_change, 2e-3);
    EXPECT_EQ(s.strain_change, 3e-5);
    EXPECT_EQ(s.rounds, 30);
    EXPECT_EQ(s.remesh_displacement, 0.03);
    EXPECT_FALSE(s.corner_films);
    EXPECT_TRUE(s.snap_off);
  }
}

TEST(UnsaturatedKeys, TimesTakeThePlaceOfSteps) {
  const Case c = parse_case(bed + R"(path = ["0 Pa", "2 kPa"]
times = ["0 s", "50 ms"]
coupling_interval = "20 us"
)",
                            "case.toml", "/study")
                     .c;
  for (const UnsaturatedStage& s : {std::get<UnsaturatedStage>(c.stages[1]), stage_of(resolved_case(c))}) {
    EXPECT_THAT(s.times, ElementsAre(0.0, 0.05));
    EXPECT_EQ(s.coupling_interval, 2e-5);
  }
  const std::string path = "path = [\"0 Pa\", \"1 kPa\"]\n";
  expect_error(path + "times = [\"0 s\"]\n", "one time for each pressure of the path: 2, not 1");
  expect_error(path + "times = [\"1 s\", \"2 s\"]\n", "begins at 0");
  expect_error(path + "times = [\"0 s\", \"0 s\"]\n", "must rise");
  expect_error(path + "times = [\"0 s\", \"1 s\"]\nstep = \"1 Pa\"\n", "not used with times");
  expect_error(path + "times = [\"0 s\", \"1 s\"]\nloaded = [\"top\"]\nstress = \"1 kPa\"\nstrain = 0.1\n", "exclude each other");
  expect_error(path + "coupling_interval = \"1 s\"\n", "used with times only");
}

TEST(UnsaturatedKeys, BeginDryWithAStepForEachLeg) {
  const Case c = parse_case(bed + R"(start = "dry"
path = ["50 kPa", "2 kPa", "0 Pa"]
step = ["48 kPa", "100 Pa"]
[bridges]
control = "suction"
capillary_pressure = "50 kPa"
coalescence_saturation = 0.1
)",
                            "case.toml", "/study")
                     .c;
  for (const Case& one : {c, parse_case(resolved_case(c), "case.toml", "/study").c}) {
    const auto& s = std::get<UnsaturatedStage>(one.stages[1]);
    EXPECT_EQ(s.start, UnsaturatedStage::Start::dry);
    EXPECT_THAT(s.step, ElementsAre(48e3, 100.0));
    EXPECT_EQ(one.bridges->coalescence_saturation, 0.1);
  }
  EXPECT_EQ(parse_case(bed + "path = [\"0 Pa\"]\n[bridges]\ncontrol = \"suction\"\ncapillary_pressure = \"1 kPa\"\n"
                             "coalescence_saturation = \"threshold\"\n",
                       "case.toml", "/study")
                .c.bridges->coalescence_saturation,
            std::numeric_limits<double>::infinity());
  // Where no stage loads the grains before, the fluids say it all.
  EXPECT_FALSE(parse_case(bed + "path = [\"0 Pa\"]\n[bridges]\ncontrol = \"suction\"\n", "case.toml", "/study")
                   .c.bridges->capillary_pressure);
  const std::string path = "path = [\"0 Pa\", \"1 kPa\", \"0 Pa\"]\n";
  expect_error(path + "step = [\"1 Pa\", \"2 Pa\", \"3 Pa\"]\n", "one for each leg of the path: 2, not 3");
  expect_error(path + "step = [\"1 kPa\", \"1e-3 Pa\"]\n", "steps along the path; at most 1e5");
  expect_error(path + "start = \"dry\"\n", "needs a path that begins above 0 Pa");
  expect_error("path = [\"1 kPa\"]\nstart = \"dry\"\ninitial_air_fraction = 1e-3\n", "not used with start");
  expect_error(
      "path = [\"1 kPa\", \"2 kPa\"]\ntimes = [\"0 s\", \"1 s\"]\n[bridges]\ncontrol = \"suction\"\n"
      "capillary_pressure = \"1 kPa\"\n",
      "exclude each other: bridges follow fluids at rest");
}

TEST(SwellingKeys, AreReadAndWrittenBack) {
  const std::string text = R"([grains]
count = 500
material = "glass"
grading = { by = "number", classes = [{ diameter = "0.3 mm", fraction = 1.0 }] }
[[grains.added]]
diameter = "0.5 mm"
material = "gel"
at = [0.5, 0.25, 0.75]
[[grains.added]]
diameter = "0.4 mm"
material = "gel"
count = 9
[materials.glass]
density = "2650 kg/m3"
[materials.gel]
density = "1200 kg/m3"
swelling = { diffusivity = "5e-8 m2/s", largest_ratio = 3.6, largest_stress = "2 kPa" }
[[stage]]
kind = "compact"
stress = "10 kPa"
)";
  const Case first = parse_case(text, "case.toml", "/study").c;
  for (const Case& c : {first, parse_case(resolved_case(first), "case.toml", "/study").c}) {
    ASSERT_EQ(c.grains.added.size(), 2u);
    EXPECT_EQ(c.grains.added[0].diameter, 0.5e-3);
    EXPECT_EQ(c.grains.added[0].at->z, 0.75);
    EXPECT_EQ(c.grains.added[1].count, 9);
    EXPECT_FALSE(c.grains.added[1].at);
    EXPECT_FALSE(c.materials[0].swelling);
    const SwellingLaw law = c.materials[1].swelling.value();
    EXPECT_EQ(law.diffusivity, 5e-8);
    EXPECT_EQ(law.largest_ratio, 3.6);
    EXPECT_EQ(law.largest_stress, 2e3);
  }
  const auto warnings = parse_case(text, "case.toml", "/study").warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], ::testing::HasSubstr("materials.gel: nothing swells"));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  };
  testing::expect_case_error(with("material = \"gel\"", "material = \"gell\""), "materials.gell");
  testing::expect_case_error(with("at = [0.5, 0.25, 0.75]", "at = [0.5, 0.25, 0.75]\ncount = 2"), "the place of one grain");
  testing::expect_case_error(with("largest_ratio = 3.6", "largest_ratio = 0.6"), "largest_ratio");
}

TEST(UnsaturatedKeys, WhatCannotRunIsRefusedWithTheReason) {
  const std::string path = "path = [\"0 Pa\", \"1 kPa\"]\n";
  expect_error("", "path");
  expect_error(path + "[motion]\ngravity = [\"0 m/s2\", \"0 m/s2\", \"-9.81 m/s2\"]\n", "knows no weight of the fluids");
  expect_error(path + "loaded = [\"top\"]\n", "go together");
  expect_error(path + "stress = \"1 kPa\"\n", "go together");
  expect_error(path + "water = [\"top\"]\n", "air and water must lie at different faces");
  expect_error(path + "water = [\"left\"]\n", "the direction x is periodic");
  expect_error(path + "loaded = [\"left\"]\nstress = \"1 kPa\"\n", "the direction x is periodic");
  expect_error(path + "air = \"left\"\n", "the direction x is periodic");
  expect_error(path + "strain_rate = \"1 1/s\"\n", "is used with strain only");
  expect_error(path + "strain = 0.1\n", "strain needs loaded faces");
  expect_error("path = [\"0 Pa\", \"0 Pa\"]\n", "must differ");
  expect_error("path = [\"0 Pa\", \"1 MPa\"]\nstep = \"1 Pa\"\n", "at most 1e5");
}

}  // namespace
}  // namespace puadem
