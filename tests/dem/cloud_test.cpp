// Random clouds: wide gradings, and grains in clumps.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"
#include "puadem/dem/packing.hpp"

namespace puadem {
namespace {

PackingSource source_of(const Grading& grading, int count, std::array<bool, 3> periodic) {
  PackingSource source;
  source.grading = grading;
  source.count = count;
  source.periodic = periodic;
  source.seed = 5;
  return source;
}

/// Distance of the surfaces of two grains over the sum of their radii, the nearest images.
double gap(const Packing& p, int i, int j) {
  Vec3 d = p.particles.position[to_size(j)] - p.particles.position[to_size(i)];
  const Vec3 size = p.domain.size();
  for (int axis = 0; axis < 3; ++axis)
    if (p.domain.periodic[to_size(axis)]) d[axis] -= size[axis] * std::round(d[axis] / size[axis]);
  return norm(d) / (p.particles.radius[to_size(i)] + p.particles.radius[to_size(j)]) - 1.0;
}

void expect_no_overlap(const Packing& p) {
  const int n = p.particles.size();
  const Vec3 size = p.domain.size();
  for (int i = 0; i < n; ++i) {
    const double r = p.particles.radius[to_size(i)];
    for (int axis = 0; axis < 3; ++axis) {
      const double x = p.particles.position[to_size(i)][axis], margin = p.domain.periodic[to_size(axis)] ? 0.0 : r;
      ASSERT_GE(x, margin);
      ASSERT_LE(x, size[axis] - margin);
    }
    for (int j = i + 1; j < n; ++j) ASSERT_GE(gap(p, i, j), -1e-12) << i << " " << j;
  }
}

class Clouds : public ::testing::TestWithParam<std::array<bool, 3>> {};

TEST_P(Clouds, OfSizesOneToTwentyHaveNoOverlap) {
  const Grading wide{Grading::By::number, {{0.1e-3, 0.1e-3, 0.6}, {0.4e-3, 0.8e-3, 0.39}, {2e-3, 2e-3, 0.01}}};
  const Packing p = random_cloud(source_of(wide, 4000, GetParam()), std::vector<Material>(1));
  expect_no_overlap(p);
  EXPECT_NEAR(p.report.porosity_box, 0.7, 1e-12);
}

TEST_P(Clouds, InClumpsHoldTogetherWithoutOverlap) {
  PackingSource source = source_of({Grading::By::mass, {{0.8e-3, 1.2e-3, 1.0}}}, 600, GetParam());
  source.cloud = PackingSource::Cloud::clumped;
  source.clump_size = 15;
  const Packing p = random_cloud(source, std::vector<Material>(1));
  expect_no_overlap(p);
  DisjointSets sets(p.particles.size());
  for (int i = 0; i < p.particles.size(); ++i)
    for (int j = i + 1; j < p.particles.size(); ++j)
      if (gap(p, i, j) < 1.1e-6) sets.join(i, j);
  int clumps = 0;
  for (int i = 0; i < p.particles.size(); ++i) clumps += sets.find(i) == i ? 1 : 0;
  EXPECT_EQ(clumps, 600 / 15);
  // The same seed, the same cloud.
  EXPECT_EQ(random_cloud(source, std::vector<Material>(1)).particles.position, p.particles.position);
}

INSTANTIATE_TEST_SUITE_P(Boxes, Clouds,
                         ::testing::Values(std::array{false, false, false}, std::array{true, false, true},
                                           std::array{true, true, true}));

// Clumps leave large pores between them, and rolling resistance holds these open.
TEST(Clouds, InClumpsEndLooserThanUniformOnes) {
  ContactOptions contact;
  contact.rolling_stiffness = 1.0;
  contact.rolling_friction = 0.3;
  CompactionOptions options;
  options.stress = 2e3;
  const auto void_ratio = [&](PackingSource::Cloud cloud) {
    PackingSource source = source_of({Grading::By::mass, {{0.8e-3, 1.2e-3, 1.0}}}, 700, {true, true, true});
    source.cloud = cloud;
    const double n = make_packing(source, std::vector<Material>(1), contact, options).report.porosity_box;
    return n / (1 - n);
  };
  const double uniform = void_ratio(PackingSource::Cloud::uniform), clumped = void_ratio(PackingSource::Cloud::clumped);
  EXPECT_GT(clumped, uniform + 0.02) << uniform;
}

TEST(Clouds, OfClumpsTooLargeForTheBoxAreRefused) {
  PackingSource source = source_of({Grading::By::mass, {{1e-3, 1e-3, 1.0}}}, 200, {true, true, true});
  source.cloud = PackingSource::Cloud::clumped;
  source.clump_size = 0.5;
  EXPECT_THROW(random_cloud(source, std::vector<Material>(1)), InputError);
  source.shape = {1, 1, 0.3};
  source.clump_size = 200;
  EXPECT_THROW(random_cloud(source, std::vector<Material>(1)), InputError);
}

}  // namespace
}  // namespace puadem
