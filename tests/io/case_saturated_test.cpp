#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bed_case.hpp"

namespace puadem {
namespace {

using ::testing::ElementsAre;

const std::string bed = testing::bed_case("saturated-flow", testing::between_plates);

const std::string everything = bed + R"(duration = "20 ms"
drained = ["top"]
inlet = "bottom"
inlet_pressure = ["0 Pa", "2 kPa"]
inlet_times = ["0 s", "5 ms"]
loaded = "top"
stress = "12 kPa"
seat_loose_grains = "top"
damping = 0.1
coupling_interval = "1 us"
coupling_safety = 0.4
remesh_displacement = 0.03
bulk_modulus = "2 GPa"
layers = 12
)";

SaturatedStage stage_of(const std::string& text) {
  return std::get<SaturatedStage>(parse_case(text, "case.toml", "/study").c.stages[1]);
}

void expect_error(const std::string& keys, const std::string& message) { testing::expect_case_error(bed + keys, message); }

TEST(SaturatedKeys, FillEveryFieldAndAreWrittenBack) {
  const Case c = parse_case(everything, "case.toml", "/study").c;
  for (const SaturatedStage& s : {std::get<SaturatedStage>(c.stages[1]), stage_of(resolved_case(c))}) {
    EXPECT_EQ(s.duration, 0.02);
    EXPECT_FALSE(s.time_factor);
    EXPECT_EQ(s.drained, (std::array<bool, 6>{false, false, false, false, false, true}));
    EXPECT_EQ(s.inlet, 4);
    EXPECT_THAT(s.inlet_pressure, ElementsAre(0.0, 2000.0));
    EXPECT_THAT(s.inlet_times, ElementsAre(0.0, 5e-3));
    EXPECT_EQ(s.loaded, 5);
    EXPECT_EQ(s.stress, 12e3);
    EXPECT_EQ(s.seat_loose_grains, 5);
    EXPECT_EQ(s.damping, 0.1);
    EXPECT_EQ(s.coupling_interval, 1e-6);
    EXPECT_EQ(s.coupling_safety, 0.4);
    EXPECT_EQ(s.remesh_displacement, 0.03);
    EXPECT_EQ(s.bulk_modulus, 2e9);
    EXPECT_EQ(s.layers, 12);
  }
}

TEST(SaturatedKeys, WhatCannotRunIsRefusedWithTheReason) {
  expect_error("", "needs either duration or time_factor");
  expect_error("duration = \"1 s\"\ntime_factor = 1.0\nloaded = \"top\"\nstress = \"1 kPa\"\n",
               "needs either duration or time_factor");
  expect_error("time_factor = 1.0\n", "needs a loaded face");
  expect_error("duration = \"1 s\"\nloaded = \"top\"\n", "go together");
  expect_error("duration = \"1 s\"\ninlet = \"bottom\"\n", "go together");
  expect_error("duration = \"1 s\"\ndrained = [\"left\"]\n", "the direction x is periodic");
  expect_error("duration = \"1 s\"\nloaded = \"top\"\nstress = \"1 kPa\"\ndrained = []\n", "no fluid can leave the box");
  expect_error("duration = \"1 s\"\nloaded = \"top\"\nstress = \"1 kPa\"\ndrained = [\"bottom\"]\n", "porous plate");
  expect_error("duration = \"1 s\"\ninlet = \"top\"\ninlet_pressure = \"1 kPa\"\n", "drained too");
  expect_error("duration = \"1 s\"\ninlet = \"bottom\"\ninlet_pressure = [\"1 kPa\", \"2 kPa\"]\n", "there must be as many");
}

}  // namespace
}  // namespace puadem
