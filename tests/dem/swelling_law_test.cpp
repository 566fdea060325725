// Growth of swelling grains, and engines that are told of it.
#include "puadem/dem/swelling_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/dem/growth.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/packing.hpp"

using namespace puadem;

namespace {

const SwellingLaw hydrogel{.diffusivity = 5e-8, .largest_ratio = 3.6, .largest_stress = {}};
constexpr double start = 0.25e-3;

/// dR/dt as it is printed.
double rate(double radius, double wetted) {
  return 3.0 * hydrogel.diffusivity * radius / (start * start * start) * wetted * (hydrogel.largest_ratio * start - radius);
}

double by_runge_kutta(double time, double wetted, int steps) {
  double r = start;
  const double h = time / steps;
  for (int k = 0; k < steps; ++k) {
    const double a = rate(r, wetted), b = rate(r + 0.5 * h * a, wetted), c = rate(r + 0.5 * h * b, wetted),
                 d = rate(r + h * c, wetted);
    r += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return r;
}

}  // namespace

TEST(SwellingLaw, SolvesItsEquation) {
  for (const double wetted : {0.2, 0.5, 1.0})
    for (const double time : {0.01, 0.1, 0.5})
      EXPECT_NEAR(swollen_radius(hydrogel, start, start, wetted * time) / by_runge_kutta(time, wetted, 4000), 1.0, 1e-11);
}

TEST(SwellingLaw, ManyStepsMakeOne) {
  double radius = start;
  constexpr int steps = 100'000;
  for (int k = 0; k < steps; ++k) radius = swollen_radius(hydrogel, start, radius, 0.1 / steps);
  EXPECT_NEAR(radius / swollen_radius(hydrogel, start, start, 0.1), 1.0, 1e-11);
}

TEST(SwellingLaw, StaysWhereNothingWetsAndEndsAtTheLargestRadius) {
  EXPECT_EQ(swollen_radius(hydrogel, start, start, 0.0), start);
  EXPECT_NEAR(swollen_radius(hydrogel, start, start, 100.0) / (3.6 * start), 1.0, 1e-12);
}

TEST(SwellingLaw, StressHindersIfAsked) {
  SwellingLaw law = hydrogel;
  EXPECT_EQ(unhindered_share(law, 1e9), 1.0);
  law.largest_stress = 2e3;
  EXPECT_DOUBLE_EQ(unhindered_share(law, 500.0), 0.75);
  EXPECT_EQ(unhindered_share(law, 3e3), 0.0);
}

TEST(Growth, TakesMassesFromOutside) {
  const std::vector<Material> glass{Material{}};
  const std::vector<Vec3> centre{{1e-3, 1e-3, 1e-3}, {3e-3, 1e-3, 1e-3}};
  const std::vector<double> radius{0.3e-3, 0.4e-3};
  Domain box;
  box.upper = {4e-3, 4e-3, 4e-3};
  GrainSystem grains = make_grain_system(make_particles(centre, radius, glass.front()), box, glass, {}, {});
  const std::vector<double> larger{0.35e-3, 0.4e-3}, mass{3e-7, 5e-7};
  set_radii(grains, larger, mass);
  for (int k = 0; k < grains.owned; ++k) {
    const auto id = to_size(grains.identity[to_size(k)]);
    const GrainRecord& r = grains.record[to_size(k)];
    EXPECT_EQ(radius_of(r), larger[id]);
    EXPECT_EQ(mass_of(r), mass[id]);
    EXPECT_NEAR(inertia_of(r) / (0.4 * mass[id] * larger[id] * larger[id]), 1.0, 1e-12);
  }
  EXPECT_THROW(set_radii(grains, larger, std::vector{1.0}), InputError);
  EXPECT_THROW(set_radii(grains, larger, std::vector{1.0, 0.0}), InputError);
}

TEST(Cloud, HoldsAddedGrainsWhereTheyAreAsked) {
  const std::vector<Material> materials{Material{}, Material{.name = "gel", .density = 1200.0}};
  PackingSource source;
  source.count = 600;
  source.grading = {Grading::By::number, {{0.2e-3, 0.3e-3, 1.0}}};
  source.added = {{.radius = 0.3e-3, .material = 1, .count = 1, .at = Vec3{0.5, 0.5, 0.25}},
                  {.radius = 0.25e-3, .material = 1, .count = 4, .at = {}}};
  const Packing cloud = random_cloud(source, materials);
  ASSERT_EQ(cloud.particles.size(), 605);
  const Vec3 size = cloud.domain.size(), at = cloud.particles.position[600];
  EXPECT_NEAR(at.x / size.x, 0.5, 1e-12);
  EXPECT_NEAR(at.z / size.z, 0.25, 1e-12);
  for (int k = 0; k < 605; ++k) {
    EXPECT_EQ(cloud.particles.material[to_size(k)], k < 600 ? 0 : 1);
    for (int j = 0; j < k; ++j)
      EXPECT_GE(norm(cloud.particles.position[to_size(k)] - cloud.particles.position[to_size(j)]),
                cloud.particles.radius[to_size(k)] + cloud.particles.radius[to_size(j)]);
  }
  EXPECT_EQ(cloud.particles.radius[600], 0.3e-3);
  EXPECT_EQ(cloud.particles.radius[604], 0.25e-3);
  source.added[0].count = 2;
  EXPECT_THROW(random_cloud(source, materials), InputError);
  source.added[0] = {.radius = 0.3e-3, .material = 2, .count = 1, .at = {}};
  EXPECT_THROW(random_cloud(source, materials), InputError);
}
