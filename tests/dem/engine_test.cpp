// The fast engine against the slow one, and what must not change its result.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "puadem/dem/contacts.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/neighbour_list.hpp"
#include "puadem/dem/stress.hpp"
#include "slow_reference.hpp"
#include "support.hpp"

namespace puadem {
namespace {

constexpr double spacing = 1e-3;

Material sand() { return test::material(1e8, 0.3, 2650, 0.5); }

Domain lattice_box(int n, std::array<bool, 3> periodic) {
  Domain box;
  box.upper = n * spacing * Vec3{1, 1, 1};
  box.periodic = periodic;
  return box;
}

GrainSystem lattice_system(int n, std::array<bool, 3> periodic, double damping = 0.2) {
  const Material m = sand();
  ContactOptions contact;
  contact.wall_friction = 0.3;
  MotionOptions motion;
  motion.damping = damping;
  GrainSystem s =
      make_grain_system(test::shaken_lattice(n, spacing, m, 11), lattice_box(n, periodic), std::span(&m, 1), contact, motion);
  s.time_step = 2e-7;
  return s;
}

/// Largest difference of two vector fields, as a share of the largest entry of the first.
double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double scale = 0.0, worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    scale = std::max(scale, norm(a[k]));
    worst = std::max(worst, norm(a[k] - b[k]));
  }
  return worst / scale;
}

class FastAndSlow : public ::testing::TestWithParam<std::array<bool, 3>> {};

TEST_P(FastAndSlow, Agree) {
  const int n = 4;
  GrainSystem fast = lattice_system(n, GetParam());
  fast.motion.gravity = {0, 0, -9.81};
  test::SlowDem slow{.p = test::shaken_lattice(n, spacing, sand(), 11),
                     .box = fast.domain,
                     .material = sand(),
                     .wall_friction = 0.3,
                     .damping = 0.2,
                     .dt = fast.time_step,
                     .gravity = fast.motion.gravity,
                     .old_position = {},
                     .history = {}};
  Particles p = slow.p;
  for (int step = 0; step < 300; ++step) {
    evaluate_forces(fast);
    slow.forces();
    if (step % 50 == 0 || step == 299) {
      collect(fast, p);
      ASSERT_LT(difference(slow.p.force, p.force), 1e-9) << step;
      ASSERT_LT(difference(slow.p.torque, p.torque), 1e-9) << step;
      ASSERT_LT(difference(slow.p.velocity, p.velocity), 1e-10) << step;
    }
    move_grains(fast);
    slow.move();
  }
  EXPECT_GT(fast.list_builds, 1);
  EXPECT_GT(size_of(slow.history), 50);
}

INSTANTIATE_TEST_SUITE_P(Boxes, FastAndSlow,
                         ::testing::Values(std::array{false, false, false}, std::array{true, true, true},
                                           std::array{true, false, false}));

struct End {
  std::vector<Vec3> position, force;
  std::array<double, 6> work;
  bool operator==(const End&) const = default;
};

End after(GrainSystem s, int n, int steps) {
  Particles p = test::shaken_lattice(n, spacing, sand(), 11);
  evaluate_forces(s);
  if (s.energy.is_kept) open_energy_book(s);
  advance_grains(s, steps);
  evaluate_forces(s);
  collect(s, p);
  const EnergyBook& e = s.energy;
  return {p.position, p.force, {e.shear, e.roll, e.viscous, e.damping, e.walls, e.box}};
}

void expect_same_bits(const GrainSystem& s, int n) {
  set_threads(1);
  const End one = after(s, n, 30);
  for (const int threads : {2, 8}) {
    set_threads(threads);
    EXPECT_TRUE(after(s, n, 30) == one) << threads;
  }
  set_threads(0);
}

TEST(Engine, GivesTheSameBitsOnAnyNumberOfThreads) {
  const int n = 21;  // enough for the threads to share
  expect_same_bits(lattice_system(n, {true, false, false}), n);
}

/// Everything that has a history or a sum: dashpots, rolling, a servo wall, a straining box, the energy book.
GrainSystem loaded_system(int n) {
  const Material m = sand();
  ContactOptions contact;
  contact.wall_friction = 0.3;
  contact.restitution = 0.6;
  contact.rolling_stiffness = contact.twisting_stiffness = 1.0;
  contact.rolling_friction = contact.twisting_friction = 0.1;
  MotionOptions motion;
  motion.damping = 0.1;
  motion.strain_with_box = true;
  GrainSystem s = make_grain_system(test::shaken_lattice(n, spacing, m, 11), lattice_box(n, {true, true, false}),
                                    std::span(&m, 1), contact, motion);
  s.time_step = 2e-7;
  s.energy.is_kept = true;
  s.walls[1].target = 50e3;
  s.walls[1].area = n * n * spacing * spacing;
  s.walls[1].speed_limit = 0.1;
  set_box_rate(s, {-0.5, 0.2, 0.0});
  return s;
}

TEST(Engine, GivesTheSameBitsOfAllThatHasAHistoryOnAnyNumberOfThreads) { expect_same_bits(loaded_system(21), 21); }

TEST(Engine, GivesTheSameBitsWheneverTheListIsMade) {
  for (const GrainSystem& start : {lattice_system(6, {true, false, false}), loaded_system(6)}) {
    GrainSystem rarely = start, always = start;
    for (int step = 0; step < 200; ++step) {
      build_neighbour_list(always);
      update_images(always);
      advance_grains(always, 1);
      advance_grains(rarely, 1);
    }
    Particles a = test::shaken_lattice(6, spacing, sand(), 11), b = a;
    collect(rarely, a);
    collect(always, b);
    EXPECT_LT(rarely.list_builds, 150);
    EXPECT_EQ(a.velocity, b.velocity);
    EXPECT_EQ(a.angular_velocity, b.angular_velocity);
    EXPECT_EQ(a.force, b.force);
  }
}

TEST(Engine, FindsEveryPairOfACloudWithAWideRangeOfSizes) {
  Random random(3);
  std::vector<Vec3> position;
  std::vector<double> radius;
  for (int k = 0; k < 800; ++k) {
    radius.push_back(0.1e-3 * std::pow(10.0, random.uniform()));
    position.push_back({random.uniform() * 1e-2, random.uniform() * 1e-2, random.uniform() * 1e-2});
  }
  const Material m = sand();
  Domain box;
  box.upper = {1e-2, 1e-2, 1e-2};
  box.periodic = {true, true, false};
  GrainSystem s = make_grain_system(make_particles(position, radius, m), box, std::span(&m, 1), {}, {});
  evaluate_forces(s);
  int expected = 0;
  for (std::size_t i = 0; i < radius.size(); ++i)
    for (std::size_t j = i + 1; j < radius.size(); ++j) {
      Vec3 d = position[j] - position[i];
      d.x -= 1e-2 * std::round(d.x / 1e-2);
      d.y -= 1e-2 * std::round(d.y / 1e-2);
      if (norm(d) < radius[i] + radius[j]) ++expected;
    }
  int found = 0;
  for (const Contact& c : contacts_of(s)) found += c.wall < 0 ? 1 : 0;
  EXPECT_GT(expected, 500);
  EXPECT_EQ(found, expected);
}

TEST(Engine, ConservesMomentumInAPeriodicBox) {
  GrainSystem s = lattice_system(5, {true, true, true}, 0.0);
  Particles p = test::shaken_lattice(5, spacing, sand(), 11);
  const auto momentum = [&] {
    Vec3 sum;
    collect(s, p);
    for (int k = 0; k < p.size(); ++k) sum += p.mass[to_size(k)] * p.velocity[to_size(k)];
    return sum;
  };
  const Vec3 before = momentum();
  advance_grains(s, 300);
  EXPECT_LT(norm(momentum() - before), 1e-13 * p.mass[0] * p.size());
}

// In a box that strains, an image moves with the box: a pair feels the same wherever it stands, also where one
// grain has just crossed the face.
TEST(Engine, PairsMoveAlikeInsideAndAcrossAPeriodicFaceOfAStrainingBox) {
  const Material m = sand();
  ContactOptions contact;
  contact.restitution = 0.5;  // a force that knows the speed of approach
  Domain box;
  box.upper = {1e-2, 1e-2, 1e-2};
  box.periodic = {true, true, true};
  const Vec3 rate{-0.3, 0.2, 0.1};
  const auto force_at = [&](double x, bool crosses) {
    const std::vector<Vec3> position{{x, 5e-3, 5e-3}, {crosses ? 5e-3 : x + 1.99e-3, 5e-3, 5e-3}};
    GrainSystem s =
        make_grain_system(make_particles(position, std::vector<double>{1e-3, 1e-3}, m), box, std::span(&m, 1), contact, {});
    s.motion.strain_with_box = true;
    s.time_step = 1e-7;
    s.record[1].place[0] = x + 1.99e-3;  // beyond the upper face where the pair crosses it
    set_box_rate(s, rate);
    evaluate_forces(s);
    const auto contacts = contacts_of(s);
    EXPECT_EQ(contacts.size(), 1u);
    return contacts.empty() ? 0.0 : contacts[0].normal_force;
  };
  const double inside = force_at(4e-3, false), across = force_at(9e-3, true);
  EXPECT_NEAR(across, inside, 1e-9 * std::abs(inside));
}

// The mean stress of the contacts and of the walls are one number at rest: divergence theorem.
TEST(Stress, OfTheContactsIsThatOfTheWallsAtRest) {
  GrainSystem s = lattice_system(5, {false, false, false}, 0.6);
  for (Wall& wall : s.walls) wall.friction = 0.0;
  s.time_step = 1e-6;
  advance_grains(s, 40000);
  evaluate_forces(s);
  const GrainMeasures m = measure(s);
  ASSERT_LT(m.unbalanced, 1e-5);
  for (int axis = 0; axis < 3; ++axis) {
    const double wall = 0.5 * (m.wall_stress[to_size(2 * axis)] + m.wall_stress[to_size(2 * axis + 1)]);
    EXPECT_NEAR(m.stress[to_size(axis)][axis], wall, 1e-4 * wall);
  }
}

TEST(Stress, OfTwoGrainsBetweenPlatesIsTheForceOverTheArea) {
  const Material m = sand();
  const std::vector<Vec3> position{
      {2e-3, 2e-3, 1e-3 - 1e-6}, {2e-3, 2e-3, 3e-3 - 3e-6}, {3.5e-3, 3.5e-3, 3.5e-3}};  // the third touches nothing
  const std::vector<double> radius{1e-3, 1e-3, 1e-4};
  Domain box;
  box.upper = {4e-3, 4e-3, 4e-3};
  GrainSystem s = make_grain_system(make_particles(position, radius, m), box, std::span(&m, 1), {}, {});
  evaluate_forces(s);
  const auto contacts = contacts_of(s);
  ASSERT_EQ(contacts.size(), 2u);
  const double youngs = 1e8 / (2 * 0.91);
  const double pair = 4.0 / 3.0 * youngs * std::sqrt(0.5e-3) * std::pow(2e-6, 1.5),
               plane = 4.0 / 3.0 * youngs * std::sqrt(1e-3) * std::pow(1e-6, 1.5);
  const GrainMeasures q = measure(s);
  EXPECT_NEAR(q.pair_stress[2].z, pair * (2e-3 - 2e-6) / 64e-9, 1e-9 * q.pair_stress[2].z);
  EXPECT_NEAR(q.wall_stress[4], plane / 16e-6, 1e-9 * q.wall_stress[4]);
  EXPECT_EQ(q.wall_stress[5], 0.0);
  EXPECT_EQ(q.contacts, 2);
  EXPECT_DOUBLE_EQ(q.coordination, 1.0);
  EXPECT_NEAR(q.unbalanced, (pair - plane + pair) / 3 / ((pair + plane) / 2), 1e-9);
}

}  // namespace
}  // namespace puadem
