#include "puadem/io/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "puadem/base/random.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

constexpr double pi = std::numbers::pi;

TEST(Units, ReadsQuantitiesToTheLastBit) {
  EXPECT_EQ(parse_quantity("0.35 mm").value, 0.35e-3);
  EXPECT_EQ(parse_quantity("72.8 mN/m").value, 72.8e-3);
  EXPECT_EQ(parse_quantity("10 kPa").value, 10e3);
  EXPECT_EQ(parse_quantity("2500 kg/m3").value, 2500.0);
  EXPECT_EQ(parse_quantity("2.5 g/cm3").value, 2500.0);
  EXPECT_EQ(parse_quantity("18 uPa s").value, 18e-6);
  EXPECT_EQ(parse_quantity("1 cP").value, 1e-3);
  EXPECT_EQ(parse_quantity("150 MPa").value, 150e6);
  EXPECT_EQ(parse_quantity("1e-3m").value, 1e-3);
  EXPECT_EQ(parse_quantity("+.5 cm").value, 0.5e-2);
  EXPECT_EQ(parse_quantity("3 L").value, 3e-3);
  EXPECT_EQ(parse_quantity("2 min").value, 120.0);
  EXPECT_DOUBLE_EQ(parse_quantity("30 deg").value, pi / 6.0);
  EXPECT_DOUBLE_EQ(parse_quantity("30\xC2\xB0").value, pi / 6.0);
}

TEST(Units, WritesOfOneUnitAgree) {
  const Quantity pressure = parse_quantity("3 N/m2");
  for (const char* same : {"3 Pa", "3 N m-2", "3 N/m^2", "3 N*m**-2", "3 kg/(m s2)", "3 kg m-1 s-2", "3 J/m3", "3 N/m\xC2\xB2",
                           "3 N\xC2\xB7m\xE2\x81\xBB\xC2\xB2", "0.003 kPa", "3e6 \xC2\xB5Pa", "3e6 \xCE\xBCPa", "3e6 uPa"}) {
    EXPECT_DOUBLE_EQ(parse_quantity(same).value, pressure.value) << same;
    EXPECT_EQ(parse_quantity(same).dimension, pressure.dimension) << same;
  }
}

TEST(Units, BareNumbersHaveNoUnit) {
  EXPECT_FALSE(parse_quantity("12").has_unit);
  EXPECT_TRUE(parse_quantity("12 %").has_unit);
  EXPECT_EQ(parse_quantity("35 %").value, 0.35);
  EXPECT_EQ(parse_quantity("35 %").dimension, Dimension{});
}

TEST(Units, DegreesAreNoPureNumber) { EXPECT_NE(dimension_of("deg"), dimension_of("")); }

// Powers of ten commute with prefixes: n 10^-3 kX = n X, for any number and unit.
TEST(Units, PrefixesShiftTheDecimalPoint) {
  Random random(1);
  constexpr std::array<std::pair<const char*, int>, 10> prefixes{
      {{"n", -9}, {"u", -6}, {"m", -3}, {"c", -2}, {"d", -1}, {"h", 2}, {"k", 3}, {"M", 6}, {"G", 9}, {"T", 12}}};
  for (int trial = 0; trial < 2000; ++trial) {
    const auto mantissa = random.below(1'000'000);
    const auto& [prefix, exponent] = prefixes[static_cast<std::size_t>(random.below(prefixes.size()))];
    for (const char* unit : {"m", "g", "s", "N", "Pa", "J", "W", "bar"}) {
      const Quantity with = parse_quantity(fmt::format("{} {}{}", mantissa, prefix, unit));
      const Quantity without = parse_quantity(fmt::format("{}e{} {}", mantissa, exponent, unit));
      EXPECT_EQ(with.value, without.value) << mantissa << prefix << unit;
      EXPECT_EQ(with.dimension, without.dimension);
    }
  }
}

TEST(Units, ShownQuantitiesReadBack) {
  Random random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    const double value = std::pow(10.0, random.uniform(-8, 9)) * (random.below(2) == 0 ? 1.0 : -1.0);
    for (const char* unit : {"m", "s", "N", "N/m", "Pa", "Pa s", "kg/m3", "rad", "m/s"}) {
      const Quantity back = parse_quantity(show(value, unit, 12));
      EXPECT_NEAR(back.value, value, 1e-11 * std::abs(value)) << show(value, unit, 12);
      EXPECT_EQ(back.dimension, dimension_of(unit));
    }
  }
  EXPECT_EQ(show(3.5e-4, "m"), "0.35 mm");
  EXPECT_EQ(show(10e3, "Pa"), "10 kPa");
  EXPECT_EQ(show(0.0728, "N/m"), "72.8 mN/m");
  EXPECT_EQ(show(pi / 6, "rad"), "30 deg");
  EXPECT_EQ(show(0.0, "Pa"), "0 Pa");
  EXPECT_EQ(show(0.99999999e-3, "Pa"), "1 mPa");
}

struct Wrong {
  const char* text;
  const char* message;
  std::size_t offset;
};

TEST(Units, SayWhatIsWrongAndWhere) {
  const std::vector<Wrong> wrongs{
      {"", "empty", 0},
      {"kPa", "a number with a unit was expected", 0},
      {"nan", "a number with a unit was expected", 0},
      {"inf Pa", "a number with a unit was expected", 0},
      {"0,35 mm", "write a decimal point", 1},
      {"10 Mpa", "unknown unit \"Mpa\"; did you mean \"MPa\"?", 3},
      {"10 kPaa", "did you mean \"kPa\"", 3},
      {"10 parsec", "unknown unit \"parsec\"", 3},
      {"2 kg/m/s", "write parentheses", 6},
      {"2 kg/m s", "write parentheses", 7},
      {"2 kg/", "a unit is missing at the end", 5},
      {"2 m^", "a whole power is missing", 3},
      {"2 m^12", "a power beyond 9", 4},
      {"2 kg/(m s", "'(' without ')'", 5},
      {"2 m)", "')' without '('", 3},
      {"2 m?", "a unit was expected here", 3},
      {"1e999 m", "out of range", 0},
      {"1e99999999999 m", "out of range", 0},
  };
  for (const Wrong& wrong : wrongs) {
    try {
      parse_quantity(wrong.text);
      ADD_FAILURE() << wrong.text << " was accepted";
    } catch (const UnitError& error) {
      EXPECT_THAT(error.what(), HasSubstr(wrong.message)) << wrong.text;
      EXPECT_EQ(error.offset, wrong.offset) << wrong.text;
    }
  }
}

TEST(Units, NamesDimensions) {
  EXPECT_EQ(describe(dimension_of("Pa")), "a pressure or stress");
  EXPECT_EQ(describe(dimension_of("m/s2")), "an acceleration");
  EXPECT_EQ(si_unit(dimension_of("W/(m2 K)")), "kg s-3 K-1");
}

}  // namespace
}  // namespace puadem
