#include "puadem/dem/boundary_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/dem/guards.hpp"
#include "puadem/dem/motion.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

constexpr double diameter = 1e-3, youngs = 1e8, poisson = 0.3;

/// Equal spheres on a simple cubic lattice, just touching: every axis is a set of columns on its own.
GrainSystem cubic(std::array<bool, 3> periodic, int n = 4) {
  const Material m = test::material(youngs, poisson, 2650, 0.5);
  std::vector<Vec3> position;
  for (int k = 0; k < n * n * n; ++k) position.push_back(diameter * Vec3{k % n + 0.5, k / n % n + 0.5, k / (n * n) + 0.5});
  Domain box;
  box.upper = n * diameter * Vec3{1, 1, 1};
  box.periodic = periodic;
  MotionOptions motion;
  motion.damping = 0.3;
  motion.strain_with_box = true;
  const Particles p = make_particles(position, std::vector<double>(position.size(), diameter / 2), m);
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), {}, motion);
  s.time_step = 1e-6;
  return s;
}

/// One column of spheres a square of side d carries F / d^2.
double column_stress(double overlap) {
  return 4.0 / 3.0 * youngs / (2 * (1 - poisson * poisson)) * std::sqrt(diameter / 4) * std::pow(overlap, 1.5);
}

TEST(Oedometer, OfACubicLatticeFollowsHertz) {
  GrainSystem s = cubic({true, true, true});
  const double rate = 1.0;
  const auto rows = run_program(s, oedometer(rate), 4000, 1000);
  ASSERT_EQ(rows.size(), 5u);
  for (const ProgramRow& row : rows) {
    const double height = diameter * std::exp(-row.strain.z), overlap = diameter - height;
    EXPECT_NEAR(row.stress.z, column_stress(overlap) * height / (height * diameter * diameter), 1e-6 * rows.back().stress.z);
    EXPECT_EQ(row.strain.x, 0.0);
    EXPECT_NEAR(row.deviator, row.stress.z, 1e-9 * rows.back().stress.z);
  }
  EXPECT_NEAR(rows.back().strain.z, 4e-3, 1e-6);  // rate times time, to the interval of the control
}

TEST(Triaxial, HoldsTheLateralStressOfACubicLattice) {
  for (const bool periodic : {true, false}) {
    GrainSystem s = cubic({periodic, periodic, periodic});
    const auto rows = run_program(s, triaxial(20e3, 2.0, 5.0), 8000, 1000);
    EXPECT_NEAR(rows.back().stress.x, 20e3, 100);
    EXPECT_NEAR(rows.back().stress.y, 20e3, 100);
    EXPECT_GT(rows.back().deviator, 0.0);
    EXPECT_NEAR(rows.back().deviator, rows.back().stress.z - 20e3, 100);
    EXPECT_NEAR(rows.back().volumetric, rows.back().strain.x + rows.back().strain.y + rows.back().strain.z, 1e-15);
    if (periodic) {
      // F / d_y d_z = 20 kPa with the box's present widths
      const Vec3 spacing = s.domain.size() / 4.0;
      EXPECT_NEAR(column_stress(diameter - spacing.x) / (spacing.y * spacing.z), 20e3, 100);
    }
  }
}

TEST(ServoWall, HoldsItsStressWhileTheOtherWallsStand) {
  GrainSystem s = cubic({false, false, false});
  s.motion.strain_with_box = false;
  s.walls[5].target = 30e3;
  s.walls[5].speed_limit = 0.02;
  advance_grains(s, 20000);
  evaluate_forces(s);
  const GrainMeasures m = measure(s);
  EXPECT_NEAR(m.wall_stress[5], 30e3, 150);
  EXPECT_NEAR(m.wall_stress[4], 30e3, 300);
  EXPECT_EQ(s.domain.upper.z, s.walls[5].point.z);
}

// A fluid that pushes with 10 kPa leaves 20 kPa of a total stress of 30 kPa to the grains, and takes nothing of a net stress.
TEST(ServoWall, HoldsATotalOrANetStress) {
  for (const auto& [held, left] : {std::pair{ServoStress::total, 20e3}, std::pair{ServoStress::net, 30e3}}) {
    GrainSystem s = cubic({false, false, false});
    s.motion.strain_with_box = false;
    Wall& wall = s.walls[5];
    wall.target = 30e3;
    wall.speed_limit = 0.02;
    wall.servo_stress = held;
    wall.fluid_force = -10e3 * wall.area * wall.normal;
    advance_grains(s, 20000);
    evaluate_forces(s);
    EXPECT_NEAR(measure(s).wall_stress[5], left, 150);
  }
}

// One layer of grains that cannot turn, between two walls that slide.
TEST(WallShear, ResistsWithFrictionTimesNormalForce) {
  const Material m = test::material(youngs, poisson, 2650, 0.5);
  std::vector<Vec3> position;
  for (int k = 0; k < 16; ++k) position.push_back(diameter * Vec3{k % 4 + 0.5, k / 4 + 0.5, 0.5});
  Domain box;
  box.upper = diameter * Vec3{4, 4, 1};
  box.periodic = {true, true, false};
  ContactOptions contact;
  contact.wall_friction = 0.2;
  MotionOptions motion;
  motion.damping = 0.3;
  GrainSystem s = make_grain_system(make_particles(position, std::vector<double>(16, diameter / 2), m), box, std::span(&m, 1),
                                    contact, motion);
  for (GrainRecord& r : s.record) r.spin[3] *= 1e9;
  s.time_step = 1e-6;
  shear_by_walls(s, 2, {1, 0, 0}, 0.02, 30e3, 0.02);
  advance_grains(s, 20000);
  evaluate_forces(s);
  EXPECT_NEAR(-s.walls[1].force.z / (16 * diameter * diameter), -30e3, 30);
  EXPECT_NEAR(s.walls[1].force.x / s.walls[1].force.z, -0.2, 1e-6);
  EXPECT_NEAR(s.walls[0].force.x / s.walls[0].force.z, -0.2, 1e-6);
  EXPECT_THROW(shear_by_walls(s, 0, {0, 1, 0}, 0.1, 1e3, 0.1), InputError);
  EXPECT_THROW(shear_by_walls(s, 2, {0, 0, 1}, 0.1, 1e3, 0.1), InputError);
}

// Five tilted planes are as good as five upright ones.
TEST(TiltedWall, PushesAlongItsNormal) {
  const Material m = test::material(youngs, poisson, 2650);
  const double radius = 1e-3, overlap = 2e-6;
  const Vec3 normal = normalized(Vec3{1, 2, 2});
  GrainSystem s = test::free_grains(
      make_particles(std::vector<Vec3>{(radius - overlap) * normal}, std::vector<double>{radius}, m), m, {}, 0.1);
  Wall wall;
  wall.normal = normal;
  s.walls.push_back(wall);
  evaluate_forces(s);
  const double expected = 4.0 / 3.0 * youngs / (2 * (1 - poisson * poisson)) * std::sqrt(radius) * std::pow(overlap, 1.5);
  EXPECT_LT(norm(s.walls[0].force + expected * normal), 1e-9 * expected);
}

std::string stopped(GrainSystem s) {
  try {
    advance_grains(s, 1000);
  } catch (const NumericalError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Guards, NameGrainPlaceAndNeighbours) {
  GrainSystem crushed = cubic({true, true, true});
  set_box_rate(crushed, {0, 0, -5.0});
  EXPECT_THAT(stopped(crushed),
              ::testing::AllOf(HasSubstr("overlap by"), HasSubstr("smaller radius"), HasSubstr("touches grain")));

  GrainSystem fast = cubic({false, false, false});
  fast.record[13].drift[0] = 200.0;
  EXPECT_THAT(stopped(fast), ::testing::AllOf(HasSubstr("radii in one step"), HasSubstr("grain 13")));

  GrainSystem lost = cubic({false, false, false});
  lost.walls[5].point.z = 0.8 * lost.walls[5].point.z;
  EXPECT_THAT(stopped(lost), HasSubstr("through wall 5"));
}

}  // namespace
}  // namespace puadem
