// The eight impact tests of Chung and Ooi 2011, Granular Matter 13, 643.
#include "chung_ooi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

namespace puadem::verification {
namespace {

constexpr int steps = 2000;

void expect_hertz(const Impact& impact) {
  const Rebound got = collide(impact, steps), exact = hertz_impact(impact);
  EXPECT_NEAR(got.deepest, exact.deepest, 1e-4 * exact.deepest) << impact.solid.name;
  EXPECT_NEAR(got.largest, exact.largest, 1e-4 * exact.largest) << impact.solid.name;
  EXPECT_NEAR(got.duration, exact.duration, 1e-4 * exact.duration) << impact.solid.name;
  EXPECT_NEAR(got.ball.up, exact.ball.up, 1e-4 * exact.ball.up) << impact.solid.name;
}

TEST(ChungOoi1, ElasticSpheresMeetAsHertzSays) {
  for (const Impact& impact : test_1()) expect_hertz(impact);
}

TEST(ChungOoi2, SphereMeetsARigidPlaneAsHertzSays) {
  for (const Impact& impact : test_2()) expect_hertz(impact);
}

TEST(ChungOoi3, RestitutionIsTheOneAskedFor) {
  for (const Solid& solid : solids_of_test_3()) {
    expect_hertz(test_3(solid, 1.0));
    for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      const Rebound got = collide(test_3(solid, e), steps);
      EXPECT_NEAR(got.ball.up / 3.9, e, 1e-4) << solid.name;
    }
  }
}

// The contact may begin and end anywhere within a step.
TEST(Restitution, IsTheOneAskedForAtAHundredStepsAContact) {
  const Solid soft{"soft", 1e8, 0.3, 2500};
  for (const auto law : {ContactOptions::Law::linear_spring, ContactOptions::Law::hertz_mindlin})
    for (const bool on_plane : {true, false})
      for (const double e : {0.95, 0.9, 0.7, 0.5, 0.3}) {
        Impact impact{.solid = soft, .radius = 1e-3, .ball = {.up = -1}, .restitution = e, .partner = {}};
        if (!on_plane) impact.partner = Impact::Partner{soft, 1e-3, {}};
        const RestitutionError coarse = restitution_error(impact, 50, law), middle = restitution_error(impact, 100, law),
                               fine = restitution_error(impact, 200, law);
        EXPECT_LT(middle.median, 1e-4) << e;
        EXPECT_LT(fine.median, std::max(coarse.median / 4, 1e-5)) << e;
        EXPECT_LT(middle.worst, 2e-4) << e;
      }
}

/// Against the equations integrated on their own; velocities as a share of the speed of approach.
void expect_integrated(const Impact& impact, double tolerance) {
  const Rebound got = collide(impact, steps), expected = integrate(impact);
  const double speed = approach_speed(impact);
  EXPECT_NEAR(got.ball.up, expected.ball.up, tolerance * speed);
  EXPECT_NEAR(got.ball.along, expected.ball.along, tolerance * speed);
  EXPECT_NEAR(impact.radius * got.ball.spin, impact.radius * expected.ball.spin, tolerance * speed);
}

void expect_sliding(const Impact& impact, double tolerance) {
  const Rebound got = collide(impact, steps), expected = slide_throughout(impact);
  const double speed = approach_speed(impact);
  EXPECT_NEAR(got.ball.along, expected.ball.along, tolerance * speed);
  EXPECT_NEAR(impact.radius * got.ball.spin, impact.radius * expected.ball.spin, tolerance * speed);
}

TEST(ChungOoi4, ObliqueImpactAtAllAngles) {
  for (int degrees = 5; degrees <= 85; degrees += 5) {
    expect_integrated(test_4(degrees), 2e-4);
    if (degrees >= 45) expect_sliding(test_4(degrees), 2e-4);
  }
}

TEST(ChungOoi5, ObliqueImpactAtOneNormalSpeed) {
  for (const Solid& solid : solids_of_test_5())
    for (const double along : {0.5, 2.0, 5.0, 8.0, 12.0, 20.0}) {
      expect_integrated(test_5(solid, along), 2e-4);
      if (along > 11) expect_sliding(test_5(solid, along), 2e-4);
    }
}

TEST(ChungOoi6, SpinningSphereMeetsAPlane) {
  for (const Solid& solid : solids_of_test_6())
    for (const double spin : {0.2, 0.7, 2.0, 5.0, 12.0, 22.0}) {
      expect_integrated(test_6(solid, spin), 4e-4);
      if (spin > 6) expect_sliding(test_6(solid, spin), 2e-4);
    }
}

// Opposite spins: the surfaces run together, nothing slips, the spins stay.
TEST(ChungOoi7, SpheresThatSpinOppositelyKeepTheirSpins) {
  for (const Solid& solid : solids_of_test_7())
    for (const double spin : {0.175, 2.0, 22.0}) {
      const Rebound got = collide(test_7(solid, spin), steps);
      EXPECT_NEAR(got.ball.spin, spin, 1e-4 * spin);
      EXPECT_NEAR(got.partner.spin, -spin, 1e-4 * spin);
      EXPECT_NEAR(got.ball.along, 0.0, 1e-4 * 0.2);
      EXPECT_NEAR(got.ball.up, 0.1, 1e-4 * 0.2);
    }
}

// Equal spins instead: the same spheres slide throughout.
TEST(ChungOoi7, SpheresThatSpinAlikeSlide) {
  for (const Solid& solid : solids_of_test_7())
    for (const double spin : {12.0, 22.0}) {
      Impact impact = test_7(solid, spin);
      impact.partner->ball.spin = spin;
      expect_sliding(impact, 1e-3);  // the normal turns by about the overlap over the radius
    }
}

TEST(ChungOoi8, SpheresOfTwoSizes) {
  for (const bool is_stiff : {true, false})
    for (const double spin : {0.2, 0.7, 2.0, 5.0, 12.0, 22.0}) {
      const Impact impact = test_8(spin, is_stiff);
      expect_integrated(impact, 1e-3);
      if (spin > 6) expect_sliding(impact, 1e-3);
    }
}

using Curves = std::map<std::string, std::vector<std::pair<double, double>>>;

/// Rows `curve,x,y` of a file of digitised curves; empty where it is not there.
Curves digitised(const std::string& name) {
  Curves curves;
  std::ifstream file(std::filesystem::path(PUADEM_DIGITISED) / name);
  for (std::string line; std::getline(file, line);) {
    std::istringstream row(line);
    std::string curve, x, y;
    if (line.starts_with('#') || !std::getline(row, curve, ',') || !std::getline(row, x, ',') || !std::getline(row, y)) continue;
    if (x.find_first_not_of("0123456789.-") != std::string::npos) continue;
    curves[curve].emplace_back(std::stod(x), std::stod(y));
  }
  return curves;
}

/// Force at a time, or at an overlap of the loading.
double at(const std::vector<Rebound::Moment>& course, double x, double Rebound::Moment::*axis) {
  const auto later = [&](const Rebound::Moment& a, const Rebound::Moment& b) { return a.*axis < b.*axis; };
  const auto end = std::max_element(course.begin(), course.end(), later);
  return std::lower_bound(course.begin(), end, Rebound::Moment{x, x, 0.0}, later)->force;
}

// The published curves of tests 1, 2 and 4 as others have digitised them: 1 to 2 % of the axis.
TEST(ChungOoi, FollowsTheDigitisedForceCurves) {
  const Curves curves = digitised("chung_ooi_test1_test2_digitised.csv");
  if (curves.empty()) GTEST_SKIP() << "no digitised curves in " << PUADEM_DIGITISED;
  const Rebound spheres = collide(test_1()[0], steps), plane = collide(test_2()[0], steps);
  const auto compare = [&](const char* name, const Rebound& r, double Rebound::Moment::*axis) {
    ASSERT_TRUE(curves.contains(name));
    for (const auto& [x, kilonewton] : curves.at(name))
      EXPECT_NEAR(at(r.course, 1e-6 * x, axis), 1e3 * kilonewton, 0.02 * r.largest) << name << " at " << x;
  };
  compare("test1_F_vs_overlap_um", spheres, &Rebound::Moment::overlap);
  compare("test1_F_vs_time_us", spheres, &Rebound::Moment::time);
  compare("test2_F_vs_overlap_um", plane, &Rebound::Moment::overlap);
}

// Nearer to the normal than 12 degrees the contact sticks to its end, and the answer depends on how the shear
// force follows an overlap that shrinks: the published code seems to scale it with the stiffness, the
// incremental law keeps it. There the curves lie farther apart than they can be misread.
TEST(ChungOoi, FollowsTheDigitisedReboundCurves) {
  const Curves curves = digitised("chung_ooi_test4_oblique_impact.csv");
  if (curves.empty()) GTEST_SKIP() << "no digitised curves in " << PUADEM_DIGITISED;
  const auto compare = [&](const char* name, double tolerance, const auto& quantity) {
    ASSERT_TRUE(curves.contains(name));
    for (const auto& [degrees, value] : curves.at(name)) {
      const Impact impact = test_4(degrees);
      EXPECT_NEAR(quantity(impact, collide(impact, steps)), value, (degrees > 12 ? 1 : 3) * tolerance)
          << name << " at " << degrees;
    }
  };
  const auto rebound_angle = [](const Impact& i, const Rebound& r) {
    return std::atan(slip_speed(i, r.ball, {}) / r.ball.up) * 180 / std::numbers::pi;
  };
  compare("tangential_restitution_DEM", 0.02, [](const Impact& i, const Rebound& r) { return r.ball.along / i.ball.along; });
  compare("final_angular_velocity_DEM", 15, [](const Impact&, const Rebound& r) { return -r.ball.spin; });
  compare("rebound_angle_DEM", 1.0, rebound_angle);
  compare("rebound_angle_experiment", 2.5, rebound_angle);
}

}  // namespace
}  // namespace puadem::verification
