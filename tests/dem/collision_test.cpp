// Two bodies that meet head-on, against the closed forms of theory 2.5 to 2.8.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "puadem/dem/contacts.hpp"
#include "puadem/dem/motion.hpp"
#include "support.hpp"

namespace puadem {
namespace {

struct Collision {
  double deepest = 0.0;   ///< [m]
  double largest = 0.0;   ///< force [N]
  double duration = 0.0;  ///< [s]
  double rebound = 0.0;   ///< relative speed after / before [-]
};

/// Equal spheres that touch at the start and approach at the relative speed `speed`.
Collision collide(double radius, double speed, const Material& m, const ContactOptions& contact, double dt) {
  const std::vector<Vec3> position{{-radius, 0, 0}, {radius, 0, 0}};
  const std::vector<double> radii{radius, radius};
  Particles p = make_particles(position, radii, m);
  p.velocity = {{speed / 2, 0, 0}, {-speed / 2, 0, 0}};
  GrainSystem s = test::free_grains(p, m, contact, 20 * radius);
  s.time_step = dt;
  Collision c;
  double before = -1e-30;
  for (int step = 0; step < 1000000; ++step) {
    evaluate_forces(s);
    collect(s, p);
    const double overlap = 2 * radius - norm(p.position[1] - p.position[0]);
    if (step > 0 && overlap <= 0.0) {
      c.duration = dt * (step - 1 + before / (before - overlap));  // the moment between two steps
      break;
    }
    c.deepest = std::max(c.deepest, overlap);
    c.largest = std::max(c.largest, norm(p.force[1]));
    before = overlap;
    move_grains(s);
  }
  collect(s, p);
  c.rebound = (p.velocity[1].x - p.velocity[0].x) / speed;
  return c;
}

ContactOptions linear() {
  ContactOptions options;
  options.law = ContactOptions::Law::linear_spring;
  return options;
}

// Timoshenko and Goodier 1970, section 140.
TEST(HertzCollision, MatchesTheClosedForm) {
  struct Case {
    double radius, density, youngs, poisson, speed, deepest, largest;  // the last two computed elsewhere
  };
  for (const Case& q :
       {Case{0.2e-3, 2650, 70e9, 0.2, 0.1, 6.65315e-8, 8.34213e-3}, Case{1e-3, 2500, 1e8, 0.3, 1.0, 2.75818e-5, 0.237294}}) {
    const Material m = test::material(q.youngs, q.poisson, q.density);
    const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(q.radius, 3) * q.density;
    const double youngs = q.youngs / (2 * (1 - q.poisson * q.poisson)), stiffness = 4.0 / 3.0 * youngs * std::sqrt(q.radius / 2);
    const double deepest = std::pow(5 * (mass / 2) * q.speed * q.speed / (4 * stiffness), 0.4);
    const double duration = 2 * std::sqrt(std::numbers::pi) * std::tgamma(1.4) / std::tgamma(0.9) * deepest / q.speed;
    EXPECT_NEAR(deepest, q.deepest, 1e-5 * deepest);
    EXPECT_NEAR(stiffness * std::pow(deepest, 1.5), q.largest, 1e-5 * q.largest);
    const Collision c = collide(q.radius, q.speed, m, {}, duration / 2000);
    EXPECT_NEAR(c.deepest, deepest, 1e-5 * deepest);
    EXPECT_NEAR(c.largest, stiffness * std::pow(deepest, 1.5), 2e-5 * c.largest);
    EXPECT_NEAR(c.duration, duration, 1e-4 * duration);
    EXPECT_NEAR(c.rebound, 1.0, 1e-6);
  }
}

TEST(HertzCollision, KeepsItsEnergyAtAHundredStepsAContact) {
  const Material m = test::material(1e8, 0.3, 2500);
  const Collision c = collide(1e-3, 1.0, m, {}, 8.11808e-5 / 100);
  EXPECT_NEAR(c.rebound * c.rebound, 1.0, 1e-6);
}

TEST(LinearCollision, MatchesTheClosedForm) {
  const double radius = 1e-3, wanted = 1e5, density = 2500, speed = 1.0;
  const Material m = test::material(wanted / radius, 0.3, density);  // k_n = E R for equal spheres
  const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) * density / 2;
  const double duration = std::numbers::pi * std::sqrt(mass / wanted), deepest = speed * std::sqrt(mass / wanted);
  EXPECT_NEAR(duration, 2.27326e-5, 1e-10);
  EXPECT_NEAR(deepest, 7.23601e-6, 1e-11);
  const Collision c = collide(radius, speed, m, linear(), duration / 2000);
  EXPECT_NEAR(c.duration, duration, 1e-4 * duration);
  EXPECT_NEAR(c.deepest, deepest, 1e-5 * deepest);
  EXPECT_NEAR(c.rebound, 1.0, 1e-6);
}

TEST(Restitution, IsTheOneAskedForAtAWall) {
  const Material m = test::material(1e8, 0.3, 2500);
  const double radius = 1e-3;
  for (const double e : {0.9, 0.5}) {
    ContactOptions options;
    options.restitution = e;
    Domain box;
    box.upper = {1e-2, 1e-2, 1e-2};
    Particles p = make_particles(std::vector<Vec3>{{5e-3, 5e-3, radius}}, std::vector<double>{radius}, m);
    p.velocity[0] = {0, 0, -1.0};
    GrainSystem s = make_grain_system(p, box, std::span(&m, 1), options, {});
    s.time_step = 1e-8;
    do advance_grains(s, 1);
    while (s.record[0].place[2] < radius);
    EXPECT_NEAR(s.record[0].drift[2], e, 1e-5);
  }
}

double wall_force(ContactOptions::WallElasticity elasticity) {
  const Material m = test::material(1e8, 0.3, 2500);
  const double radius = 1e-3;
  const std::vector<Vec3> position{{5e-3, 5e-3, radius - 1e-6}};
  const std::vector<double> radii{radius};
  Domain box;
  box.upper = {1e-2, 1e-2, 1e-2};
  ContactOptions options;
  options.wall_elasticity = elasticity;
  GrainSystem s = make_grain_system(make_particles(position, radii, m), box, std::span(&m, 1), options, {});
  evaluate_forces(s);
  return -s.walls[4].force.z;
}

// Sphere on a plane, F = 4/3 E* sqrt(R) overlap^1.5: with E* = E / (2 (1 - nu^2)) for a plane of the same
// constants, twice that for one that does not yield.
TEST(WallContact, HertzForceIsExact) {
  const double rigid = 4.0 / 3.0 * 1e8 / (1 - 0.09) * std::sqrt(1e-3) * std::pow(1e-6, 1.5);
  EXPECT_NEAR(rigid, 4.63337e-3, 5e-9);
  EXPECT_NEAR(wall_force(ContactOptions::WallElasticity::rigid), rigid, 1e-9 * rigid);
  EXPECT_NEAR(wall_force(ContactOptions::WallElasticity::material), rigid / 2, 1e-9 * rigid);
}

}  // namespace
}  // namespace puadem
