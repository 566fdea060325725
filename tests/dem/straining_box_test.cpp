// Boxes that strain with their grains: the time step, the work put in, stresses held without a lag.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/dem/boundary_program.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/time_step.hpp"
#include "support.hpp"

namespace puadem {
namespace {

constexpr double spacing = 1e-3;

ContactOptions linear() {
  ContactOptions contact;
  contact.law = ContactOptions::Law::linear_spring;
  return contact;
}

/// Grains of a jittered lattice, in a box that they follow.
GrainSystem lattice(std::array<bool, 3> periodic, const ContactOptions& contact, double speed, double damping) {
  const int n = 5;
  const Material m = test::material(1e7, 0.3, 2650, 0.4);
  Particles p = test::shaken_lattice(n, spacing, m, 5, speed);
  Domain box;
  box.upper = n * spacing * Vec3{1, 1, 1};
  box.periodic = periodic;
  MotionOptions motion;
  motion.damping = damping;
  motion.strain_with_box = true;
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), contact, motion);
  s.time_step = 2e-7;
  return s;
}

// The rate of the box changes all the time, grains cross periodic faces, and damping acts.
TEST(StrainingBox, InputIsWhatIsStoredAndTaken) {
  for (const auto periodic : {std::array<bool, 3>{true, true, true}, {false, false, false}, {true, true, false}}) {
    GrainSystem s = lattice(periodic, linear(), 0.05, 0.3);
    evaluate_forces(s);
    open_energy_book(s);
    const Energies start = energies(s);
    for (int k = 0; k < 400; ++k) {
      const double rate = -8.0 * (1.0 + 0.5 * std::sin(0.3 * k));
      set_box_rate(s, {rate * s.domain.size().x, 0.5 * rate * s.domain.size().y, -0.3 * rate * s.domain.size().z});
      advance_grains(s, 10);
      evaluate_forces(s);
    }
    const Energies end = energies(s);
    EXPECT_GT(end.input, 0.02 * start.stored());
    EXPECT_GT(end.damping, 0.01 * end.input);
    EXPECT_NEAR(end.stored() + end.taken() - start.stored() - start.taken(), end.input, 1e-3 * end.input);
  }
}

/// Mean error of a lateral stress that is held while the packing keeps straining, with or without memory.
double lag(bool remembers) {
  GrainSystem s = lattice({true, true, true}, linear(), 0.0, 0.3);
  s.time_step = 1e-6;
  BoxProgram program = triaxial(20e3, 5.0, 100.0);
  program.strain_rate.y = -2.5;  // shortening along z and stretching along y change the area of the column along x
  program.stress[1].reset();
  BoxServo servo;
  double error = 0.0;
  constexpr int settings = 1800, last = 200;
  for (int k = 0; k < settings; ++k) {
    evaluate_forces(s);
    const GrainMeasures m = measure(s);
    if (k >= settings - last) error += (m.stress[0].x / 20e3 - 1.0) / last;
    if (remembers)
      steer_box(s, program, m, servo);
    else
      steer_box(s, program, m);
    advance_grains(s, program.interval);
  }
  return error;
}

TEST(HeldStress, DoesNotLagWhereThePackingKeepsStraining) {
  EXPECT_LT(std::abs(lag(true)), 3e-3);
  EXPECT_GT(std::abs(lag(false)), 1e-2);
}

TEST(TimeStep, GrowsByATwentiethAtMostAndKeepsToItsShare) {
  GrainSystem s = lattice({true, true, true}, linear(), 0.0, 0.0);
  s.motion.safety = 0.4;
  evaluate_forces(s);
  const double critical = critical_time_step(s).critical;
  s.time_step = 0.0;
  EXPECT_EQ(renew_time_step(s).critical, critical);
  EXPECT_EQ(s.time_step, 0.4 * critical);
  s.time_step = 0.1 * critical;
  renew_time_step(s);
  EXPECT_EQ(s.time_step, 1.05 * 0.1 * critical);
  s.time_step = critical;
  renew_time_step(s, 0.2 * critical);
  EXPECT_EQ(s.time_step, 0.2 * critical);
}

TEST(TimeStep, OfGrainsThatDoNotTouchNeedsABound) {
  const Material m = test::material(1e7, 0.3, 2650);
  const double radius = 0.5e-3;
  GrainSystem s = test::free_grains(
      make_particles(std::vector<Vec3>{{0, 0, 0}, {5e-3, 0, 0}}, std::vector<double>{radius, 2 * radius}, m), m, linear(), 0.1);
  evaluate_forces(s);
  EXPECT_THROW(renew_time_step(s), NumericalError);
  // The linear law is as stiff at every stress: k_n = E R, of six contacts a third each.
  const double expected = std::sqrt(2.0 * 2650.0 * 4.0 / 3.0 * std::numbers::pi * radius * radius / (3.0 * 1e7));
  EXPECT_NEAR(critical_time_step_at(s, 1e3), expected, 1e-9 * expected);
  EXPECT_NEAR(critical_time_step_at(s, 1e5), expected, 1e-9 * expected);
}

}  // namespace
}  // namespace puadem
