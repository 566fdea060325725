#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "puadem/base/error.hpp"
#include "puadem/dem/packing.hpp"

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
