#include <gtest/gtest.h>

#include "support/bed_case.hpp"

namespace puadem {
namespace {

const std::string bed = testing::bed_case("isotropic", "") + "stress = \"1 kPa\"\n";

void expect_error(const std::string& keys, const std::string& message) {
  testing::expect_case_error(bed + "[bridges]\n" + keys, message);
}

TEST(BridgeKeys, FillEveryFieldAndAreWrittenBack) {
  const Case c = parse_case(bed + R"([bridges]
control = "volume"
volume = "2e-12 m3"
law = "soulie"
formation = "at-any-distance"
rupture = "halves"
exchange = "films"
)",
                            "case.toml", "/study")
                     .c;
  for (const BridgeCase& b : {*c.bridges, *parse_case(resolved_case(c), "case.toml", "/study").c.bridges}) {
    EXPECT_EQ(b.control, BridgeControl::volume);
    EXPECT_EQ(b.volume, 2e-12);
    EXPECT_FALSE(b.water_content || b.saturation || b.capillary_pressure);
    EXPECT_EQ(b.law, BridgeModel::Law::soulie);
    EXPECT_EQ(b.formation, BridgeFormation::at_any_distance);
    EXPECT_EQ(b.split, RuptureSplit::halves);
    EXPECT_EQ(b.exchange, BridgeRules::Exchange::films);
  }
  EXPECT_FALSE(parse_case(bed, "case.toml", "/study").c.bridges);
}

TEST(BridgeKeys, SayWhatCannotBeTogether) {
  expect_error("", "needs the amount of water: write water_content");
  expect_error("water_content = 0.01\nsaturation = 0.1\n", "exclude each other");
  expect_error("control = \"suction\"\n", "missing key bridges.capillary_pressure");
  expect_error("control = \"suction\"\ncapillary_pressure = \"1 kPa\"\nsaturation = 0.1\n",
               "bridges.saturation is not used with bridges.control = \"suction\"");
  expect_error("control = \"suction\"\ncapillary_pressure = \"1 kPa\"\nlaw = \"willett\"\n",
               "fits are for bridges of given volume");
  expect_error("control = \"suction\"\ncapillary_pressure = \"1 kPa\"\nexchange = \"films\"\n", "joins the rest");
  expect_error("water_content = 0.01\ncapillary_pressure = \"1 kPa\"\n", "not used with bridges.control = \"volume\"");
  expect_error("water_content = 2\n", "water_content");
  testing::expect_case_error(testing::bed_case("saturated-flow", testing::between_plates) +
                                 "loaded = \"top\"\nstress = \"12 kPa\"\nduration = \"1 ms\"\n[bridges]\nwater_content = 0.01\n",
                             "cannot be together with a stage \"saturated-flow\"");
  const std::string coupled = testing::bed_case("unsaturated-flow", testing::between_plates) + "path = [\"0 Pa\", \"1 kPa\"]\n";
  testing::expect_case_error(coupled + "[bridges]\nwater_content = 0.01\n", "the suction of the fluids around them");
  expect_error("water_content = 0.01\ncoalescence_saturation = 0.2\n",
               "bridges.coalescence_saturation is used in a stage \"unsaturated-flow\" only");
  testing::expect_case_error(testing::bed_case("permeability", "") + "[bridges]\nwater_content = 0.01\n",
                             "acts in stages that load the grains");
}

}  // namespace
}  // namespace puadem
