// Energy balances of short runs (long ones: tests/verification), and resistance to rolling and twisting.
#include "puadem/dem/energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "puadem/dem/boundary_program.hpp"
#include "puadem/dem/motion.hpp"
#include "support.hpp"

namespace puadem {
namespace {

constexpr double spacing = 1e-3;

ContactOptions contact_of(ContactOptions::Law law, double wall_friction = 0.0) {
  ContactOptions contact;
  contact.law = law;
  contact.wall_friction = wall_friction;
  return contact;
}

/// A frictional lattice squeezed by its top wall; returns the end and the share of the input that is missing.
struct Balance {
  Energies end;
  double residual;
};
Balance squeeze(const ContactOptions& contact, double damping) {
  const int n = 5;
  const Material m = test::material(1e7, 0.3, 2650, 0.4);
  Particles p = test::shaken_lattice(n, spacing, m, 5, 0.0);
  for (double& r : p.radius) r *= 0.95;
  Domain box;
  box.upper = n * spacing * Vec3{1, 1, 1};
  MotionOptions motion;
  motion.damping = damping;
  motion.gravity = {0, 0, -9.81};
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), contact, motion);
  s.time_step = 2e-7;
  set_box_rate(s, {0, 0, -0.1});
  evaluate_forces(s);
  open_energy_book(s);
  const Energies start = energies(s);
  advance_grains(s, 20000);
  evaluate_forces(s);
  const Energies end = energies(s);
  return {end, (end.stored() + end.taken() - start.stored() - start.taken() - end.input) / end.input};
}

TEST(Energy, TheWorkOfASuddenWallIsBookedWithItsStep) {
  const Material m = test::material(1e7, 0.3, 2650);
  const Particles p = make_particles(std::vector<Vec3>{{0, 0, 0.99e-3}}, std::vector<double>{1e-3}, m);
  GrainSystem s = test::free_grains(p, m, contact_of(ContactOptions::Law::linear_spring), 0.1);
  Wall wall;
  wall.normal = {0, 0, 1};
  s.walls.push_back(wall);
  s.time_step = 1e-8;  // the grain hardly moves
  evaluate_forces(s);
  open_energy_book(s);
  const Energies start = energies(s);
  s.walls[0].velocity = {0, 0, 100.0};
  advance_grains(s, 1);
  evaluate_forces(s);
  const Energies end = energies(s);
  const double input = end.input - start.input;
  EXPECT_GT(input, 0.1 * start.normal);
  EXPECT_NEAR(end.stored() - start.stored(), input, 1e-3 * input);
}

TEST(Energy, InputIsStoredOrLostWithEitherLaw) {
  for (const auto law : {ContactOptions::Law::linear_spring, ContactOptions::Law::hertz_mindlin}) {
    ContactOptions contact = contact_of(law, 0.2);
    contact.rolling_stiffness = 1.0;
    contact.rolling_friction = 0.1;
    contact.twisting_stiffness = 0.5;
    contact.twisting_friction = 0.05;
    const Balance b = squeeze(contact, 0.1);
    EXPECT_LT(std::abs(b.residual), 1e-4);
    EXPECT_GT(b.end.damping, 1e-3 * b.end.input);
    EXPECT_GT(b.end.shear_work, 1e-2 * b.end.input);
    EXPECT_GT(b.end.roll_work, 1e-4 * b.end.input);
    if (law == ContactOptions::Law::linear_spring) {
      EXPECT_GT(b.end.friction, 1e-3 * b.end.input);
      EXPECT_GT(b.end.shear, 0.0);
    }
  }
}

TEST(Energy, ViscousContactsBookWhatTheyTake) {
  ContactOptions contact = contact_of(ContactOptions::Law::hertz_mindlin);
  contact.restitution = 0.5;
  const Balance b = squeeze(contact, 0.0);
  EXPECT_LT(std::abs(b.residual), 1e-4);
  EXPECT_GT(b.end.viscous, 1e-3 * b.end.input);
}

// A layer between rough walls that move against each other, one of them holding a stress: the walls do all the work.
TEST(Energy, ServoAndSlidingWallsBookTheirWork) {
  const int n = 6;
  const Material m = test::material(1e7, 0.3, 2650, 0.4);
  Domain box;
  box.upper = n * spacing * Vec3{1, 1, 1};
  box.periodic = {true, true, false};
  MotionOptions motion;
  motion.damping = 0.2;
  GrainSystem s = make_grain_system(test::shaken_lattice(n, spacing, m, 5, 0.0), box, std::span(&m, 1),
                                    contact_of(ContactOptions::Law::linear_spring, 0.5), motion);
  s.time_step = 1e-6;
  shear_by_walls(s, 2, {1, 0.5, 0}, 0.3, 20e3, 0.05);
  advance_grains(s, 2000);
  evaluate_forces(s);
  open_energy_book(s);
  const Energies start = energies(s);
  advance_grains(s, 20000);
  evaluate_forces(s);
  const Energies end = energies(s);
  EXPECT_LT(std::abs(end.stored() + end.taken() - start.stored() - start.taken() - end.input), 1e-4 * end.input);
  EXPECT_GT(end.friction, 0.3 * end.input);
}

/// A sphere that rests on the floor by its own weight, gravity tilted by `slope`.
GrainSystem resting(const ContactOptions& contact, double slope) {
  const Material m = test::material(1e9, 0.3, 2500, 0.5);
  const double radius = 1e-3, youngs = 1e9 / 1.82;
  Particles p = make_particles(std::vector<Vec3>{{1e-2, 5e-3, radius}}, std::vector<double>{radius}, m);
  p.position[0].z -= std::pow(p.mass[0] * 10 * std::cos(slope) / (4.0 / 3.0 * youngs * std::sqrt(radius)), 2.0 / 3.0);
  Domain box;
  box.upper = {1.0, 1e-2, 1e-2};
  MotionOptions motion;
  motion.gravity = {10 * std::sin(slope), 0, -10 * std::cos(slope)};
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), contact, motion);
  s.time_step = 1e-6;
  return s;
}

// A sphere that rolls against the couple eta R N: (7/5) m a = m g sin - eta m g cos.
TEST(RollingResistance, HoldsASphereOnAGentleSlopeAndSlowsItOnASteepOne) {
  ContactOptions contact = contact_of(ContactOptions::Law::hertz_mindlin, 0.5);
  contact.rolling_stiffness = 1.0;
  contact.rolling_friction = 0.1;
  GrainSystem still = resting(contact, std::atan(0.05));
  advance_grains(still, 50000);
  EXPECT_LT(std::abs(still.record[0].place[0] - 1e-2), 1e-6);

  const double slope = std::atan(0.3);
  GrainSystem rolling = resting(contact, slope);
  advance_grains(rolling, 50000);
  const double acceleration = 5.0 / 7.0 * 10 * (std::sin(slope) - 0.1 * std::cos(slope));
  EXPECT_NEAR(rolling.record[0].drift[0] / 5e-2, acceleration, 1e-2 * acceleration);
}

// A top that turns about the normal against the couple eta R N.
TEST(TwistingResistance, SlowsATop) {
  ContactOptions contact = contact_of(ContactOptions::Law::hertz_mindlin, 0.5);
  contact.twisting_stiffness = 1.0;
  contact.twisting_friction = 0.05;
  GrainSystem s = resting(contact, 0.0);
  s.record[0].spin[2] = 40.0;
  advance_grains(s, 10000);
  EXPECT_NEAR(s.record[0].spin[2], 40.0 - 0.05 * 10 / (0.4 * 1e-3) * 1e-2, 0.05);
}

}  // namespace
}  // namespace puadem
