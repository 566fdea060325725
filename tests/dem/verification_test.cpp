// Single contacts against exact solutions: rigid rotation, sliding, rolling, the shear loop. Impacts: tests/verification.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/dem/contacts.hpp"
#include "puadem/dem/motion.hpp"
#include "support.hpp"

namespace puadem {
namespace {

Vec3 rotate(const Vec3& v, const Vec3& axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
}

Lanes with(const Vec3& v, const Lanes& scalar) { return Lanes{v.x, v.y, v.z, scalar[3]}; }

// A stressed and sheared pair turned as one body about any axis: every force turns with it. What is left is
// the rounding of the places.
TEST(RigidRotation, TurnsTheForcesOfAStressedPair) {
  const Material m = test::material(1e8, 0.3, 2500, 0.5);
  const std::vector<Vec3> position{{0, 0, 0}, {2.19e-3, 0, 0}};
  const std::vector<double> radius{1.0e-3, 1.2e-3};
  Particles p = make_particles(position, radius, m);
  p.velocity[1] = {0, 0.4, -0.3};
  p.angular_velocity[0] = {30, 20, -10};
  GrainSystem s = test::free_grains(p, m, {}, 0.1);
  s.time_step = 1e-6;
  evaluate_forces(s);
  const Contact before = contacts_of(s)[0];
  ASSERT_GT(norm(before.shear), 0.01 * before.normal_force);

  const Vec3 axis = normalized(Vec3{0.3, -0.5, 0.8}), centre{1e-3, 2e-4, 0};
  constexpr int steps = 150;
  const double angle = 1.0 / steps;
  const std::vector<Vec3> start{vec3(s.record[0].place), vec3(s.record[1].place)};
  for (int step = 0; step < steps; ++step) {
    for (int k = 0; k < s.owned; ++k) {
      GrainRecord& r = s.record[to_size(k)];
      const Vec3 old = vec3(r.place), now = centre + rotate(start[to_size(k)] - centre, axis, angle * (step + 1));
      r.place = with(now, r.place);
      r.drift = with((now - old) / s.time_step, r.drift);
      r.turn = with(std::tan(angle / 2) * axis, r.turn);
    }
    ++s.steps;
    s.is_evaluated = false;
    evaluate_forces(s);
    const Contact now = contacts_of(s)[0];
    const double turned = angle * (step + 1);
    ASSERT_LT(norm(rotate(before.force, axis, turned) - now.force), 1e-12 * norm(before.force)) << step;
    ASSERT_LT(norm(rotate(before.shear, axis, turned) - now.shear), 1e-12 * norm(before.force)) << step;
  }
}

/// One sphere on the floor, pressed by gravity to its static overlap, gravity tilted by `slope` about y.
GrainSystem on_floor(double friction, double slope, double gravity = 10.0) {
  const Material m = test::material(1e9, 0.3, 2500, friction);
  ContactOptions contact;
  contact.wall_friction = friction;
  const double radius = 1e-3, youngs = 1e9 / (2 * 0.91);
  Particles p = make_particles(std::vector<Vec3>{{1e-2, 5e-3, radius}}, std::vector<double>{radius}, m);
  const double weight = p.mass[0] * gravity * std::cos(slope);
  p.position[0].z -= std::pow(weight / (4.0 / 3.0 * youngs * std::sqrt(radius)), 2.0 / 3.0);
  Domain box;
  box.upper = {1.0, 1e-2, 1e-2};
  MotionOptions motion;
  motion.gravity = {gravity * std::sin(slope), 0, -gravity * std::cos(slope)};
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), contact, motion);
  s.time_step = 1e-6;
  return s;
}

TEST(SlidingBlock, SlowsByFrictionAndStopsWhereItMust) {
  const double friction = 0.4, speed = 0.02, gravity = 10.0;
  GrainSystem s = on_floor(friction, 0.0, gravity);
  s.record[0].spin[3] *= 1e9;  // a block does not turn
  s.record[0].drift[0] = speed;
  const double time = speed / (friction * gravity);
  advance_grains(s, static_cast<long>(0.5 * time / s.time_step));
  EXPECT_NEAR(s.record[0].drift[0], speed / 2, 2e-3 * speed);
  advance_grains(s, static_cast<long>(0.6 * time / s.time_step));
  EXPECT_NEAR(s.record[0].place[0] - 1e-2, speed * speed / (2 * friction * gravity),
              1e-3 * speed * speed / (2 * friction * gravity));
}

// A sphere thrown without spin slides, then rolls at 5/7 of its speed.
TEST(ThrownSphere, EndsRollingAtFiveSeventhsOfItsSpeed) {
  const double speed = 0.02;
  GrainSystem s = on_floor(0.4, 0.0);
  s.record[0].drift[0] = speed;
  advance_grains(s, static_cast<long>(1.5 * 2.0 / 7.0 * speed / (0.4 * 10.0) / s.time_step));
  const double forward = s.record[0].drift[0], turning = 1e-3 * s.record[0].spin[1];
  EXPECT_NEAR(forward + 0.4 * turning, speed, 1e-6 * speed);  // momentum about the line of contact
  EXPECT_NEAR(forward, 5.0 / 7.0 * speed, 5e-3 * speed);
  EXPECT_NEAR(turning, forward, 1e-2 * speed);
}

// On a slope a sphere rolls while tan(slope) < 7/2 mu, and slips above.
TEST(SphereOnASlope, RollsBelowTheSlipLimitAndSlipsAbove) {
  const double friction = 0.2, gravity = 10.0, radius = 1e-3;
  const double limit = std::atan(3.5 * friction);
  for (const double slope : {0.5 * limit, 0.9 * limit, 1.1 * limit, 1.5 * limit}) {
    GrainSystem s = on_floor(friction, slope, gravity);
    const double duration = 5e-2;
    advance_grains(s, static_cast<long>(duration / s.time_step));
    const bool rolls = slope < limit;
    const double acceleration =
        rolls ? 5.0 / 7.0 * gravity * std::sin(slope) : gravity * (std::sin(slope) - friction * std::cos(slope));
    const double spin_up = rolls ? acceleration / radius : 2.5 * friction * gravity * std::cos(slope) / radius;
    EXPECT_NEAR(s.record[0].drift[0] / duration, acceleration, 5e-3 * acceleration) << slope;
    EXPECT_NEAR(s.record[0].spin[1] / duration, spin_up, 5e-3 * spin_up) << slope;
  }
}

// Shear to and fro at a fixed overlap: stiffness 8 G* a until mu N, the way back from there.
TEST(MindlinLoop, FollowsStiffnessAndCoulombLimit) {
  const Material m = test::material(1e8, 0.3, 2500, 0.5);
  ContactOptions contact;
  contact.wall_friction = 0.3;
  const double radius = 1e-3, overlap = 2e-6;
  Domain box;
  box.upper = {1e-2, 1e-2, 1e-2};
  GrainSystem s =
      make_grain_system(make_particles(std::vector<Vec3>{{5e-3, 5e-3, radius - overlap}}, std::vector<double>{radius}, m), box,
                        std::span(&m, 1), contact, {});
  s.time_step = 1e-6;
  evaluate_forces(s);
  const double contact_radius = std::sqrt(radius * overlap);
  const double stiffness = 8 * (1e8 / 2.6 / (2 * 1.7)) * contact_radius;
  const double limit = 0.3 * (4.0 / 3.0 * 1e8 / 1.82 * contact_radius * overlap);
  const double yield = limit / stiffness, increment = yield / 100;
  double expected = 0.0;
  const auto push = [&](double way, int increments) {
    for (int k = 0; k < increments; ++k) {
      s.record[0].place[0] += way * increment;
      s.record[0].drift[0] = way * increment / s.time_step;
      s.is_evaluated = false;
      evaluate_forces(s);
      expected = std::clamp(expected - way * stiffness * increment, -limit, limit);
      ASSERT_NEAR(contacts_of(s)[0].shear.x, expected, 1e-10 * limit);
    }
  };
  push(1, 250);
  EXPECT_NEAR(expected, -limit, 1e-12 * limit);
  push(-1, 150);
  EXPECT_NEAR(expected, 0.5 * limit, 1e-6 * limit);
  push(1, 30);
  push(-1, 300);
  EXPECT_NEAR(expected, limit, 1e-12 * limit);
}

}  // namespace
}  // namespace puadem
