// What must not change the answer: the orientation of space, the unit of length, a rigid motion of everything.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "puadem/dem/contacts.hpp"
#include "puadem/dem/motion.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using Rotation = std::array<Vec3, 3>;  // rows

Vec3 operator*(const Rotation& q, const Vec3& v) { return {dot(q[0], v), dot(q[1], v), dot(q[2], v)}; }

/// Turn by `angle` about `axis` (Rodrigues).
Rotation turn(const Vec3& about, double angle) {
  const Vec3 n = normalized(about);
  const double c = std::cos(angle), s = std::sin(angle);
  const auto image = [&](const Vec3& v) { return c * v + s * cross(n, v) + (1 - c) * dot(n, v) * n; };
  const Vec3 x = image({1, 0, 0}), y = image({0, 1, 0}), z = image({0, 0, 1});
  return {Vec3{x.x, y.x, z.x}, Vec3{x.y, y.y, z.y}, Vec3{x.z, y.z, z.z}};
}

/// What the heap stands in: the unit of length, time and mass, and the orientation of space.
struct Frame {
  double length = 1.0, time = 1.0, mass = 1.0;
  Rotation q{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  double speed() const { return length / time; }
  double stress() const { return mass / (length * time * time); }
};

/// A heap that is shaken between six rough walls of its own, one of them moving and one holding a stress.
GrainSystem heap(const Frame& f, ContactOptions::Law law) {
  const double spacing = 1e-3;
  const int n = 4;
  const Material m = test::material(1e8 * f.stress(), 0.3, 2650 * f.mass / std::pow(f.length, 3), 0.5);
  const Particles shaken = test::shaken_lattice(n, spacing, test::material(1e8, 0.3, 2650, 0.5), 21, 0.2);
  std::vector<Vec3> position;
  std::vector<double> radius;
  for (std::size_t k = 0; k < shaken.radius.size(); ++k) {
    position.push_back(f.length * (f.q * shaken.position[k]));
    radius.push_back(f.length * shaken.radius[k]);
  }
  Particles p = make_particles(position, radius, m);
  for (std::size_t k = 0; k < radius.size(); ++k) {
    p.velocity[k] = f.speed() * (f.q * shaken.velocity[k]);
    p.angular_velocity[k] = 1 / f.time * (f.q * shaken.angular_velocity[k]);
  }
  ContactOptions contact;
  contact.law = law;
  contact.restitution = 0.8;
  contact.rolling_stiffness = 1.0;
  contact.rolling_friction = 0.1;
  contact.twisting_stiffness = 0.5;
  contact.twisting_friction = 0.05;
  MotionOptions motion;
  motion.gravity = f.length / (f.time * f.time) * (f.q * Vec3{3, -2, -9});
  GrainSystem s = test::free_grains(p, m, contact, 0.02 * f.length, motion);
  s.time_step = 2e-7 * f.time;
  for (int face = 0; face < 6; ++face) {
    Wall wall;
    wall.normal = f.q * -outward_normal(face);
    Vec3 point;
    if (is_upper(face)) point[axis_of(face)] = n * spacing;
    wall.point = f.length * (f.q * point);
    wall.friction = 0.3;
    if (face == 1) wall.velocity = f.speed() * (f.q * Vec3{-0.05, 0.02, 0.01});
    if (face == 5) {
      wall.target = 50e3 * f.stress();
      wall.area = n * n * spacing * spacing * f.length * f.length;
      wall.speed_limit = 0.1 * f.speed();
      wall.slide = f.speed() * (f.q * Vec3{0.03, -0.01, 0.0});
    }
    s.walls.push_back(wall);
  }
  return s;
}

/// Places, velocities and spins by identity, in the frame of the heap.
std::array<std::vector<Vec3>, 3> state(const GrainSystem& s, const Frame& f) {
  std::array<std::vector<Vec3>, 3> all;
  for (auto& field : all) field.resize(to_size(s.owned));
  const Rotation back{Vec3{f.q[0].x, f.q[1].x, f.q[2].x}, Vec3{f.q[0].y, f.q[1].y, f.q[2].y}, Vec3{f.q[0].z, f.q[1].z, f.q[2].z}};
  for (int k = 0; k < s.owned; ++k) {
    const std::size_t id = to_size(s.identity[to_size(k)]);
    const GrainRecord& r = s.record[to_size(k)];
    all[0][id] = 1 / f.length * (back * vec3(r.place));
    all[1][id] = 1 / f.speed() * (back * vec3(r.drift));
    all[2][id] = f.time * (back * vec3(r.spin));
  }
  return all;
}

double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double scale = 0.0, worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    scale = std::max(scale, norm(a[k]));
    worst = std::max(worst, norm(a[k] - b[k]));
  }
  return worst / scale;
}

class EveryLaw : public ::testing::TestWithParam<ContactOptions::Law> {};
INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         ::testing::Values(ContactOptions::Law::linear_spring, ContactOptions::Law::hertz_mindlin));

// Walls in any orientation: the same heap, turned. Rounding grows with every impact.
TEST_P(EveryLaw, DoesNotKnowTheOrientationOfSpace) {
  for (const Vec3& axis : {Vec3{1, 2, -1}, Vec3{-0.3, 0.2, 1}}) {
    const Frame turned{.q = turn(axis, 0.9)};
    GrainSystem a = heap({}, GetParam()), b = heap(turned, GetParam());
    for (const auto& [steps, tolerance] : {std::pair{20L, 1e-12}, std::pair{500L, 1e-9}}) {
      advance_grains(a, steps);
      advance_grains(b, steps);
      const auto one = state(a, {}), other = state(b, turned);
      for (std::size_t field = 0; field < 3; ++field) EXPECT_LT(difference(one[field], other[field]), tolerance) << field;
    }
    EXPECT_GT(size_of(contacts_of(a)), 50);
  }
}

// Powers of two scale without rounding: in other units every bit is the same, or some number has a unit hidden in it.
TEST_P(EveryLaw, DoesNotKnowTheUnits) {
  const Frame other{.length = 0x1p10, .time = 0x1p-6, .mass = 0x1p21};
  GrainSystem a = heap({}, GetParam()), b = heap(other, GetParam());
  advance_grains(a, 500);
  advance_grains(b, 500);
  EXPECT_EQ(state(a, {}), state(b, other));
}

/// A contact with itself driven from outside: places and turns of both grains are set, forces evaluated.
struct Drive {
  GrainSystem s;
  Vec3 d{};  ///< from the first centre to the second

  void step(const Vec3& next, const Vec3& turn_first, const Vec3& turn_second) {
    GrainRecord &a = s.record[0], &b = s.record[1];
    const Vec3 change = next - d;
    for (int axis = 0; axis < 3; ++axis) {
      b.place[axis] = a.place[axis] + next[axis];
      b.drift[axis] = change[axis] / s.time_step;
      a.turn[axis] = std::tan(norm(turn_first) / 2) * (norm(turn_first) > 0 ? turn_first[axis] / norm(turn_first) : 0.0);
      b.turn[axis] = std::tan(norm(turn_second) / 2) * (norm(turn_second) > 0 ? turn_second[axis] / norm(turn_second) : 0.0);
    }
    d = next;
    ++s.steps;
    s.is_evaluated = false;
    evaluate_forces(s);
  }
};

// A closed cycle of overlaps and turns, as waves send through a bed, leaves no shear force: no ratcheting.
TEST(Ratcheting, ClosedCyclesLeaveNoShearForce) {
  const Material m = test::material(1e8, 0.3, 2500, 10.0);  // no sliding
  const std::vector<double> radius{1.0e-3, 1.3e-3};
  ContactOptions contact;
  contact.law = ContactOptions::Law::linear_spring;
  Particles p = make_particles(std::vector<Vec3>{{0, 0, 0}, {2.28e-3, 0, 0}}, radius, m);
  Drive drive{.s = test::free_grains(p, m, contact, 0.1)};
  drive.s.time_step = 1e-6;
  evaluate_forces(drive.s);
  drive.d = {2.28e-3, 0, 0};
  double largest = 0.0;
  const double amplitude = 2e-3;
  const auto turned = [&](int k) { return amplitude * std::sin(2 * std::numbers::pi * k / 100.0); };
  for (int k = 1; k <= 100 * 50; ++k) {
    const double phase = 2 * std::numbers::pi * k / 100.0, rolled = turned(k) - turned(k - 1);
    drive.step({2.28e-3 + 8e-6 * (1 - std::cos(phase)), 0, 0}, {0, 0, rolled}, {0, 0, -rolled * radius[0] / radius[1] * 0.9});
    largest = std::max(largest, norm(contacts_of(drive.s)[0].shear));
  }
  EXPECT_GT(largest, 1e-3 * contacts_of(drive.s)[0].normal_force);
  EXPECT_LT(norm(contacts_of(drive.s)[0].shear), 1e-9 * largest);
}

}  // namespace
}  // namespace puadem
