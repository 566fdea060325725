// Chains of strong contacts: what they hold and which sides they join.
#include "puadem/dem/force_chains.hpp"

#include <gtest/gtest.h>

#include "puadem/dem/motion.hpp"
#include "support.hpp"

using namespace puadem;
using puadem::test::material;

namespace {

/// Columns of grains of radius 1 mm along one axis; each is pressed together by its own overlap.
GrainSystem columns(int axis, std::array<bool, 3> periodic, const std::vector<double>& overlap, int length) {
  const double radius = 1e-3, pitch = 2.0 * radius - overlap.front();
  std::vector<Vec3> position;
  std::vector<double> radii;
  Domain box;
  box.periodic = periodic;
  box.upper = {0.01, 0.01, 0.01};
  box.upper[axis] = length * pitch;
  const int other = (axis + 1) % 3;
  for (std::size_t c = 0; c < overlap.size(); ++c)
    for (int k = 0; k < length; ++k) {
      Vec3 x{0.005, 0.005, 0.005};
      x[other] = 1.5e-3 + 3e-3 * static_cast<double>(c);
      x[axis] = (k + 0.5) * pitch;
      position.push_back(x);
      radii.push_back(radius - 0.5 * (overlap.front() - overlap[c]));
    }
  ContactOptions contact;
  contact.law = ContactOptions::Law::linear_spring;
  const Material m = material(1e8, 0.2, 2500.0);
  const Particles particles = make_particles(position, radii, m);
  GrainSystem s = make_grain_system(particles, box, std::span(&m, 1), contact, {});
  evaluate_forces(s);
  return s;
}

}  // namespace

TEST(ForceChains, AStrongColumnJoinsTheWallsAtItsEnds) {
  for (const int axis : {0, 1, 2}) {
    const ForceChains chains = find_force_chains(columns(axis, {false, false, false}, {1e-5, 1e-6, 1e-6}, 4));
    for (int a = 0; a < 3; ++a) EXPECT_EQ(chains.spans[to_size(a)], a == axis);
    EXPECT_DOUBLE_EQ(chains.strong_share, 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(chains.largest_share, 4.0 / 12.0);
  }
}

TEST(ForceChains, AStrongColumnReachesItsImageAcrossThePeriod) {
  for (const int axis : {0, 1, 2}) {
    const ForceChains chains = find_force_chains(columns(axis, {true, true, true}, {1e-5, 1e-6, 1e-6}, 4));
    for (int a = 0; a < 3; ++a) EXPECT_EQ(chains.spans[to_size(a)], a == axis);
  }
}

TEST(ForceChains, EqualForcesAreNoneAboveTheirMean) {
  const ForceChains chains = find_force_chains(columns(2, {false, false, false}, {1e-5}, 1));
  EXPECT_EQ(chains.mean_force, 0.0) << "no contact between grains";
  EXPECT_EQ(chains.largest_share, 0.0);
}

TEST(ForceChains, ABrokenColumnJoinsNothing) {
  // The strong pair in the middle leans on no wall.
  const double r = 1e-3;
  const std::vector<Vec3> position{
      {5e-3, 5e-3, 4e-3}, {5e-3, 5e-3, 5.99e-3}, {5e-3, 5e-3, 1e-3}, {5e-3, 5e-3, 2.9999e-3}, {5e-3, 5e-3, 9.0e-3}};
  const std::vector<double> radii(position.size(), r);
  Domain box;
  box.upper = {0.01, 0.01, 0.01};
  ContactOptions contact;
  contact.law = ContactOptions::Law::linear_spring;
  const Material m = material(1e8, 0.2, 2500.0);
  GrainSystem s = make_grain_system(make_particles(position, radii, m), box, std::span(&m, 1), contact, {});
  evaluate_forces(s);
  const ForceChains chains = find_force_chains(s);
  EXPECT_EQ(chains.spans, (std::array<bool, 3>{}));
  EXPECT_DOUBLE_EQ(chains.largest_share, 2.0 / 5.0);
}
