// Every guard stops a run that is made to go wrong, and says where.

#include "puadem/dem/guards.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "puadem/base/error.hpp"
#include "puadem/dem/motion.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const Material stone = test::material(1e8, 0.3, 2500);

GrainSystem pair(double distance, const Vec3& velocity = {}) {
  Particles p = make_particles(std::vector<Vec3>{{1e-3, 2e-3, 3e-3}, {1e-3 + distance, 2e-3, 3e-3}},
                               std::vector<double>{1e-3, 2e-3}, stone);
  p.velocity[0] = velocity;
  GrainSystem s = test::free_grains(p, stone, {}, 0.1);
  s.time_step = 1e-6;
  evaluate_forces(s);
  return s;
}

template <class Run>
std::string stop(const Run& run) {
  try {
    run();
  } catch (const NumericalError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Guards, LetASaneRunPass) {
  EXPECT_EQ(stop([] { guard_grains(pair(2.9e-3, {1.0, 0, 0})); }), "no error");
}

TEST(Guards, StopAtAnOverlap) {
  EXPECT_THAT(stop([] { guard_grains(pair(2.6e-3)); }),
              AllOf(HasSubstr("step 0: grains 0 and 1 overlap by 40 % of the smaller radius (limit 30 %)"),
                    HasSubstr("grain 0 of radius 0.001 m at (0.001, 0.002, 0.003) m"), HasSubstr("contact force"),
                    HasSubstr("touches grain 1 (")));
}

TEST(Guards, StopAtASpeed) {
  EXPECT_THAT(stop([] {
                guard_grains(pair(2.99e-3, {0, 150, 0}));
              }),
              AllOf(HasSubstr("moves 0.15 radii in one step (limit 0.1)"), HasSubstr("grain 0 of radius"),
                    HasSubstr("speed 150 m/s"), HasSubstr("Shorten the time step, now 1e-06 s")));
  GrainSystem lost = pair(4e-3, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  EXPECT_THAT(stop([&] { guard_grains(lost); }), HasSubstr("moves nan radii in one step"));
  EXPECT_THAT(stop([&] { move_grains(lost); }), HasSubstr("velocity is not a number"));
}

TEST(Guards, StopAtAGrainBehindAWall) {
  GrainSystem s = pair(2.99e-3);
  Wall wall;
  wall.point = {0, 0, 3.5e-3};
  wall.normal = {0, 0, 1};
  s.walls.push_back(wall);
  EXPECT_THAT(stop([&] { guard_grains(s); }),
              AllOf(HasSubstr("a grain has gone through wall 0"), HasSubstr("grain 0 of radius"), HasSubstr("touches grain 1")));
}

/// A pair pressed together, one of them shaken a little, at a share of the critical step.
std::string shake(double share) {
  Particles p = make_particles(std::vector<Vec3>{{0, 0, 0}, {1.99e-3, 0, 0}}, std::vector<double>{1e-3, 1e-3}, stone);
  p.velocity[0].x = 1e-4;
  ContactOptions linear;
  linear.law = ContactOptions::Law::linear_spring;
  GrainSystem s = test::free_grains(p, stone, linear, 0.1);
  const double press = 1e8 * 1e-3 * 1e-5;
  s.external_force = {{press, 0, 0}, {-press, 0, 0}};
  evaluate_forces(s);
  s.time_step = share * critical_time_step(s).critical;
  open_energy_book(s);
  const Energies start = energies(s);
  return stop([&] {
    for (int step = 0; step < 2000; ++step) {
      advance_grains(s, 1);
      evaluate_forces(s);
      guard_energy(s, start);
    }
  });
}

TEST(Guards, StopWhereEnergyComesFromNowhere) {
  EXPECT_EQ(shake(0.5), "no error");
  EXPECT_THAT(shake(1.02), AllOf(HasSubstr("energy"), HasSubstr("out of nothing"), HasSubstr("work done on them"),
                                 HasSubstr("of radius 0.001 m at"), HasSubstr("Shorten the time step")));
}

}  // namespace
}  // namespace puadem
