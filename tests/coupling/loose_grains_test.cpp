#include "puadem/coupling/loose_grains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "puadem/coupling/run.hpp"
#include "puadem/dem/fabric.hpp"
#include "puadem/dem/stress.hpp"

using namespace puadem;

namespace {

State packed_bed() {
  Case c;
  c.seed = 3;
  c.domain.periodic = {true, true, false};
  c.domain.shape = {1, 1, 2};
  c.materials = {Material{.name = "glass", .density = 2500.0, .youngs_modulus = 1.5e8, .friction_angle = 0.4}};
  c.grains.count = 200;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::mass, {{0.8e-3, 1.2e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  CompactStage compact;
  compact.stress = 100e3;
  compact.friction_angle = 0.1;
  c.stages = {compact};
  State state;
  run(c, state, {});
  return state;
}

}  // namespace

TEST(LooseGrains, AreLaidAgainstTheirNeighboursWhileTheOthersStay) {
  State state = packed_bed();
  GrainSystem& grains = *state.grains;
  grains.motion.damping = 0.15;
  const GrainContacts before = count_contacts(grains);
  ASSERT_GT(before.rattlers, 2);
  std::vector<char> is_loose(to_size(grains.owned));
  int loose = 0;
  for (int k = 0; k < grains.owned; ++k)
    if (before.is_rattler[to_size(k)] != 0 || before.count[to_size(k)] < 4) {
      is_loose[to_size(grains.identity[to_size(k)])] = 1;
      ++loose;
    }
  const double stress = measure(grains).wall_stress[5];
  const std::vector<Vec3> start = state.particles.position;

  EXPECT_EQ(seat_loose_grains({0, 0, 1}, grains), loose);

  EXPECT_LE(count_contacts(grains).rattlers, before.rattlers / 3);
  EXPECT_NEAR(measure(grains).wall_stress[5], stress, 0.01 * stress);
  EXPECT_EQ(grains.motion.damping, 0.15);
  EXPECT_TRUE(grains.external_force.empty());
  collect(grains, state.particles);
  double up = 0.0, held = 0.0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double rise = state.particles.position[i].z - start[i].z;
    if (is_loose[i] != 0)
      up += rise;
    else
      held = std::max(held, std::abs(rise));
  }
  EXPECT_GT(up / loose, 1e-6);  // gaps are a few thousandths of a radius
  EXPECT_LT(held, 1e-7);
}

TEST(LooseGrains, GrainsThatBearNothingHaveNothingToLeanOn) {
  Domain domain;
  domain.upper = {1, 1, 1};
  const std::vector<Material> materials{Material{.name = "glass"}};
  const std::vector<Vec3> centre{{0.5, 0.5, 0.5}};
  const std::vector<double> radius{0.1};
  const Particles particles = make_particles(centre, radius, materials.front());
  GrainSystem grains = make_grain_system(particles, domain, materials, {}, {});
  EXPECT_EQ(seat_loose_grains({0, 0, 1}, grains), 0);
  EXPECT_EQ(norm(vec3(grains.record[0].place) - centre[0]), 0.0);
}
