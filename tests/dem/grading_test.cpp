#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "puadem/base/error.hpp"
#include "puadem/dem/size_distribution.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

const Grading beads{Grading::By::mass, {{0.60e-3, 0.60e-3, 0.35}, {0.85e-3, 0.85e-3, 0.35}, {1.0e-3, 1.4e-3, 0.30}}};

double mass_between(const std::vector<double>& radii, double low, double high) {
  double part = 0.0, total = 0.0;
  for (const double r : radii) {
    total += r * r * r;
    if (2 * r >= low && 2 * r <= high) part += r * r * r;
  }
  return part / total;
}

TEST(Grading, MassSharesOfAThousandGrainsAreMetWithinOnePercent) {
  const auto radii = grain_radii(beads, 1000, 3);
  ASSERT_EQ(radii.size(), 1000u);
  EXPECT_NEAR(mass_between(radii, 0.59e-3, 0.61e-3), 0.35, 0.0035);
  EXPECT_NEAR(mass_between(radii, 0.84e-3, 0.86e-3), 0.35, 0.0035);
  EXPECT_NEAR(mass_between(radii, 0.99e-3, 1.41e-3), 0.30, 0.0030);
  EXPECT_LT(grading_error(beads, radii), 0.01);
}

// Mass uniform over diameter inside the class: the curve is a straight line from 1.0 to 1.4 mm.
TEST(Grading, MassRisesLinearlyInsideAClass) {
  const Grading one{Grading::By::mass, {{1.0e-3, 1.4e-3, 1.0}}};
  const auto radii = grain_radii(one, 4000, 1);
  for (const double d : {1.1e-3, 1.2e-3, 1.3e-3}) EXPECT_NEAR(mass_between(radii, 0.0, d), (d - 1.0e-3) / 0.4e-3, 2e-3);
}

TEST(Grading, NumberRisesLinearlyInsideAClassGivenByNumber) {
  const Grading one{Grading::By::number, {{1.0e-3, 1.4e-3, 1.0}}};
  const auto radii = grain_radii(one, 1000, 1);
  const auto below = std::count_if(radii.begin(), radii.end(), [](double r) { return 2 * r < 1.1e-3; });
  EXPECT_NEAR(static_cast<double>(below) / 1000.0, 0.25, 2e-3);
}

TEST(Grading, NumberSharesOfSingleSizes) {
  const Grading two{Grading::By::number, {{1e-3, 1e-3, 0.25}, {2e-3, 2e-3, 0.75}}};
  const auto radii = grain_radii(two, 400, 1);
  EXPECT_EQ(std::count(radii.begin(), radii.end(), 0.5e-3), 100);
}

TEST(Grading, SeedSetsTheOrderAndNothingElse) {
  auto a = grain_radii(beads, 500, 1), again = grain_radii(beads, 500, 1), b = grain_radii(beads, 500, 2);
  EXPECT_EQ(a, again);
  EXPECT_NE(a, b);
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  EXPECT_EQ(a, b);
}

/// Share by mass, or by number, of the grains smaller than d.
double passing(const std::vector<double>& radii, double d, Grading::By by) {
  double part = 0.0, total = 0.0;
  for (const double r : radii) {
    const double weight = by == Grading::By::mass ? r * r * r : 1.0;
    total += weight;
    if (2 * r < d) part += weight;
  }
  return part / total;
}

Grading sieves(Grading::By by, GradingTable::Interpolation interpolation) {
  Grading grading;
  grading.by = by;
  grading.table = {{0.2e-3, 0.3e-3, 0.4e-3, 0.7e-3}, {0.0, 0.3, 0.3, 1.0}, interpolation};
  return grading;
}

// The curve of a table is met at its own points and between them, where it is straight over d or ln d; a flat part stays empty.
TEST(Grading, OfATableIsMetAtItsSievesAndBetweenThem) {
  for (const auto by : {Grading::By::mass, Grading::By::number})
    for (const auto interpolation : {GradingTable::Interpolation::linear, GradingTable::Interpolation::logarithmic}) {
      const Grading grading = sieves(by, interpolation);
      const auto radii = grain_radii(grading, 20000, 5);
      ASSERT_EQ(radii.size(), 20000u);
      EXPECT_NEAR(passing(radii, 0.2e-3, by), 0.0, 1e-12);
      EXPECT_NEAR(passing(radii, 0.35e-3, by), 0.3, 3e-4);
      EXPECT_NEAR(passing(radii, 0.7e-3, by), 1.0, 1e-12);
      EXPECT_EQ(passing(radii, 0.3e-3, by), passing(radii, 0.4e-3, by));
      const bool is_linear = interpolation == GradingTable::Interpolation::linear;
      for (const double d : {0.45e-3, 0.5e-3, 0.6e-3}) {
        const double share = is_linear ? (d - 0.4e-3) / 0.3e-3 : std::log(d / 0.4e-3) / std::log(0.7 / 0.4);
        EXPECT_NEAR(passing(radii, d, by), 0.3 + 0.7 * share, 1e-3) << d;
      }
      EXPECT_LT(grading_error(grading, radii), 2e-3);
    }
}

// Share of a log-normal curve below d between its cut-offs, by the error function.
TEST(Grading, OfALogNormalCurveFollowsTheErrorFunction) {
  Grading grading;
  grading.lognormal = {.median = 0.4e-3, .deviation = 1.5, .smallest = 0.2e-3, .largest = 0.9e-3};
  const auto below = [](double d) { return 0.5 * std::erfc(-std::log(d / 0.4e-3) / std::log(1.5) / std::sqrt(2.0)); };
  for (const auto by : {Grading::By::mass, Grading::By::number}) {
    grading.by = by;
    const auto radii = grain_radii(grading, 5000, 1);
    for (const double d : {0.25e-3, 0.3e-3, 0.4e-3, 0.5e-3, 0.7e-3})
      EXPECT_NEAR(passing(radii, d, by), (below(d) - below(0.2e-3)) / (below(0.9e-3) - below(0.2e-3)), 2e-3) << d;
    const auto [least, most] = std::minmax_element(radii.begin(), radii.end());
    EXPECT_GE(2 * *least, 0.2e-3);
    EXPECT_LE(2 * *most, 0.9e-3);
    EXPECT_LT(grading_error(grading, radii), 0.01);
  }
}

// Far from the median of the numbers: by mass with a wide curve nearly all grains are of the small end.
TEST(Grading, OfAWideLogNormalCurveByMass) {
  Grading grading;
  grading.lognormal = {.median = 0.4e-3, .deviation = 4.0, .smallest = 0.1e-3, .largest = 0.8e-3};
  const auto radii = grain_radii(grading, 20000, 1);
  EXPECT_LT(grading_error(grading, radii), 0.01);
  const auto below = [](double d) { return 0.5 * std::erfc(-std::log(d / 0.4e-3) / std::log(4.0) / std::sqrt(2.0)); };
  EXPECT_NEAR(passing(radii, 0.4e-3, Grading::By::mass), (below(0.4e-3) - below(0.1e-3)) / (below(0.8e-3) - below(0.1e-3)), 2e-3);
}

// Forty grains in one piece have the volume of the curve to rounding: the spread is shifted until they do.
TEST(Grading, OfAnyFormHasItsMassMet) {
  Grading uniform, lognormal, table;
  uniform.classes = {{1e-3, 3e-3, 1.0}};
  lognormal.lognormal = {.median = 0.4e-3, .deviation = 1.5, .smallest = {}, .largest = {}};
  table.table = {{1e-3, 3e-3}, {0.0, 1.0}};
  for (const Grading& grading : {uniform, lognormal, table}) {
    double cubes = 0.0;
    for (const double r : grain_radii(grading, 40, 1)) cubes += 8 * r * r * r / 40.0;
    const double wanted = mean_power(size_classes(grading)[0].sizes, 3);
    EXPECT_NEAR(cubes, wanted, 1e-11 * wanted);
  }
}

TEST(Grading, FormsThatMakeNoSenseAreNamed) {
  const auto refusal = [](auto change) -> std::string {
    Grading grading = sieves(Grading::By::mass, GradingTable::Interpolation::linear);
    change(grading);
    try {
      grain_radii(grading, 1000, 1);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(refusal([](auto& g) { g.table->passing[1] = 0.8, g.table->passing[2] = 0.7; }), HasSubstr("must not fall"));
  EXPECT_THAT(refusal([](auto& g) { g.table->passing[3] = 0.98; }), HasSubstr("ends with 98 %; it must end with 100 %"));
  EXPECT_THAT(refusal([](auto& g) { g.table->passing[0] = 0.05; }), HasSubstr("begins with 5 %"));
  EXPECT_THAT(refusal([](auto& g) { g.table->diameter[1] = 0.2e-3; }), HasSubstr("diameters must ascend"));
  EXPECT_THAT(refusal([](auto& g) { g.table->diameter[0] = -1; }), HasSubstr("must be positive"));
  EXPECT_THAT(refusal([](auto& g) { g.table->diameter.pop_back(); }), HasSubstr("3 diameters but 4 values of passing"));
  EXPECT_THAT(refusal([](auto& g) { g.table = {{1e-3}, {0.0}}; }), HasSubstr("at least two"));
  EXPECT_THAT(refusal([](auto& g) { g.classes = {{1e-3, 1e-3, 1.0}}; }), HasSubstr("exclude each other"));
  const auto lognormal = [&](double median, double deviation, std::optional<double> smallest, std::optional<double> largest) {
    return refusal([=](auto& g) {
      g.table.reset();
      g.lognormal = {median, deviation, smallest, largest};
    });
  };
  EXPECT_THAT(lognormal(-1, 1.5, {}, {}), HasSubstr("median -1 m"));
  EXPECT_THAT(lognormal(1e-3, 0.7, {}, {}), HasSubstr("deviation 0.7 must exceed 1"));
  EXPECT_THAT(lognormal(1e-3, 1.5, 3e-3, 2e-3), HasSubstr("ascending"));
  EXPECT_THAT(lognormal(1e-3, 1.1, 8e-3, 9e-3), HasSubstr("leave nothing"));
}

std::string message(const Grading& grading, int count = 100) {
  try {
    grain_radii(grading, count, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Grading, BadInputIsNamed) {
  EXPECT_THAT(message({Grading::By::mass, {{1e-3, 1e-3, 0.5}, {2e-3, 2e-3, 0.4}}}), HasSubstr("add to 0.9"));
  EXPECT_THAT(message({Grading::By::mass, {{-1e-3, 1e-3, 1.0}}}), HasSubstr("class 1"));
  EXPECT_THAT(message({Grading::By::mass, {{2e-3, 1e-3, 1.0}}}), HasSubstr("ascending"));
  EXPECT_THAT(message({Grading::By::mass, {{std::nan(""), 1e-3, 1.0}}}), HasSubstr("positive"));
  EXPECT_THAT(message({}), HasSubstr("no class"));
  EXPECT_THAT(message(beads, 5), HasSubstr("gets no grain"));
  EXPECT_THAT(message(beads, 0), HasSubstr("at least 1"));
}

}  // namespace
}  // namespace puadem
