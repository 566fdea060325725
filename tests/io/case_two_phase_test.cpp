#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/bed_case.hpp"

namespace puadem {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string bed = testing::bed_case("two-phase-flow");

const std::string everything = bed + R"(air = "disc"
disc_radius = "1 mm"
water = ["left", "y+"]
initial_air_fraction = 1e-6
air_pressure = "100 Pa"
water_pressure = ["-1 kPa", "-2 kPa"]
water_times = ["0 s", "5 ms"]
duration = "20 ms"
until_saturation = 0.4
until_breakthrough = true
record_jump = 0.9
scheme = "impes"
gas = "connected"
reference_pressure = "90 kPa"
snap_off = true
corner_films = false
touching_first = true
wall_throats = false
gravity = [0, 0, "-9.81 m/s2"]
retention_law = "polyhedron"
front_change = 0.05
longest_step = "1 us"
[output]
fields_at = { saturation = [0.9, 0.6] }
)";

TwoPhaseStage stage_of(const std::string& text) {
  return std::get<TwoPhaseStage>(parse_case(text, "case.toml", "/study").c.stages[1]);
}

TEST(TwoPhaseKeys, FillEveryField) {
  const Case c = parse_case(everything, "case.toml", "/study").c;
  const auto& s = std::get<TwoPhaseStage>(c.stages[1]);
  EXPECT_EQ(s.air, TwoPhaseStage::disc);
  EXPECT_EQ(s.disc_radius, 1e-3);
  EXPECT_EQ(s.water, (std::array<bool, 6>{true, false, false, true, false, false}));
  EXPECT_EQ(s.initial_air_fraction, 1e-6);
  EXPECT_EQ(s.air_pressure, 100.0);
  EXPECT_THAT(s.water_pressure, ElementsAre(-1000.0, -2000.0));
  EXPECT_THAT(s.water_times, ElementsAre(0.0, 5e-3));
  EXPECT_EQ(s.duration, 0.02);
  EXPECT_EQ(s.until_saturation, 0.4);
  EXPECT_TRUE(s.until_breakthrough);
  EXPECT_EQ(s.record_jump, 0.9);
  const TwoPhaseOptions& o = s.options;
  EXPECT_EQ(o.scheme, TwoPhaseScheme::impes);
  EXPECT_EQ(o.gas, GasKind::connected);
  EXPECT_EQ(o.reference_pressure, 90e3);
  EXPECT_TRUE(o.snap_off && o.touching_first);
  EXPECT_FALSE(o.corner_films || o.wall_throats);
  EXPECT_EQ(o.gravity, (Vec3{0, 0, -9.81}));
  EXPECT_EQ(o.retention_law.index(), 1u);
  EXPECT_EQ(o.steps.front_change, 0.05);
  EXPECT_EQ(o.steps.longest, 1e-6);
  EXPECT_THAT(c.output.fields_at.saturation, ElementsAre(0.9, 0.6));
}

TEST(TwoPhaseKeys, ComeBackFromTheResolvedCase) {
  for (const std::string& text : {everything, bed + "path = [400, 1300]\nstep = 50\nhold = \"10 ms\"\n",
                                  bed + "withdrawal = \"2 mm3/s\"\nduration = 1\ninitial_air_fraction = 0.5\n",
                                  bed + "capillary_number = 1e-4\nduration = 1\ninitial_air_fraction = 0.5\n",
                                  bed + "water_pressure = \"-3 kPa\"\nduration = \"1 s\"\n"}) {
    const std::string resolved = resolved_case(parse_case(text, "case.toml", "/study").c);
    EXPECT_EQ(resolved_case(parse_case(resolved, "resolved", "/elsewhere").c), resolved);
  }
  EXPECT_THAT(stage_of(bed + "water_pressure = \"-3 kPa\"\nduration = 1\n").water_pressure, ElementsAre(-3000.0));
  EXPECT_EQ(
      stage_of(bed + "water_pressure = []\ncapillary_number = 1e-4\nduration = 1\ninitial_air_fraction = 0.5\n").capillary_number,
      1e-4);
  EXPECT_EQ(stage_of(bed + "withdrawal = \"2 mm3/s\"\nduration = 1\ninitial_air_fraction = 0.5\n").withdrawal, 2e-9);
}

std::string error_of(const std::string& keys) {
  try {
    parse_case(bed + keys, "case.toml", "/study");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

struct Wrong {
  const char* keys;
  const char* message;
};

TEST(TwoPhaseKeys, WhatCannotBeIsRefused) {
  for (const Wrong& w : {
           Wrong{"duration = 1\n", "needs one of path, water_pressure, withdrawal, capillary_number to drive the flow, not none"},
           Wrong{"path = [400]\nwithdrawal = 1e-9\n", "to drive the flow, not several"},
           Wrong{"water_pressure = -3000\n", "needs a duration"},
           Wrong{"withdrawal = 1e-9\nduration = 1\n", "withdrawal needs initial_air_fraction"},
           Wrong{"path = [400, 800]\nduration = 1\n", "duration is not used with a path"},
           Wrong{"path = [400, 400]\n", "must differ from the one before"},
           Wrong{"withdrawal = 1e-9\nduration = 1\nhold = 1\n", "hold is used with a path only"},
           Wrong{"path = [400]\nair = \"disc\"\n", "needs disc_radius"},
           Wrong{"path = [400]\ndisc_radius = 1e-3\n", "used with air = \"disc\" only"},
           Wrong{"path = [400]\nwater = [\"top\"]\n", "must lie at different faces, not both at top"},
           Wrong{"path = [400]\nwater = []\n", "water names no face"},
           Wrong{"path = [400]\nair = \"tpo\"\n", "did you mean \"top\""},
           Wrong{"path = [400]\nscheme = \"impes\"\n", "knows gas of one pressure only"},
           Wrong{"water_pressure = [1, 2]\nwater_times = [0]\nduration = 1\n", "there must be as many"},
           Wrong{"water_pressure = [1, 2]\nwater_times = [1, 0]\nduration = 1\n", "must rise"},
       })
    EXPECT_THAT(error_of(w.keys), HasSubstr(w.message)) << w.keys;
}

}  // namespace
}  // namespace puadem
