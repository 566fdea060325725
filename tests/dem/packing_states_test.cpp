// How dense a packing gets, set by the friction between grains while it is compacted.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/packing.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

PackingSource sand(int count, std::array<bool, 3> periodic) {
  PackingSource source;
  source.grading = {Grading::By::mass, {{1.0e-3, 2.0e-3, 1.0}}};
  source.count = count;
  source.periodic = periodic;
  source.seed = 3;
  return source;
}

Packing compact(std::optional<double> angle, std::array<bool, 3> periodic, const Vec3& shape = {1, 1, 1}) {
  CompactionOptions options;
  options.stress = 50e3;
  options.friction_angle = angle;
  PackingSource source = sand(400, periodic);
  source.shape = shape;
  return make_packing(source, std::vector<Material>(1), {}, options);
}

struct Box {
  std::array<bool, 3> periodic;
  Vec3 shape;
};
class DenseAndLoose : public ::testing::TestWithParam<Box> {};

TEST_P(DenseAndLoose, StatesComeOfTheFrictionWhileCompacting) {
  const auto [periodic, shape] = GetParam();
  const Packing dense = compact(0.0, periodic, shape), loose = compact({}, periodic, shape);
  for (const Packing* packing : {&dense, &loose}) {
    const CompactionReport& report = packing->report;
    EXPECT_NEAR(report.mean_stress, 50e3, 500);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(report.axis_stress[axis], 50e3, 1000);
    EXPECT_LT(report.unbalanced, 1e-3);
    EXPECT_EQ(packing->system->pairs.grains[0].friction, std::tan(Material{}.friction_angle));
  }
  EXPECT_LT(dense.report.porosity_box, loose.report.porosity_box - 0.02);
  EXPECT_GT(dense.report.coordination, loose.report.coordination + 0.5);
  EXPECT_EQ(dense.report.friction_used, 0.0);
  EXPECT_EQ(loose.report.friction_used, std::tan(Material{}.friction_angle));
}

INSTANTIATE_TEST_SUITE_P(Boxes, DenseAndLoose,
                         ::testing::Values(Box{{true, true, true}, {1, 1, 1}}, Box{{false, false, false}, {1, 1, 2}},
                                           Box{{true, false, true}, {2, 1.5, 1}}));

// A loading stage goes on from here: contacts, forces and box as the compaction left them, nothing moving.
TEST(Packing, HandsOnTheGrainsAtRest) {
  const Packing packing = compact(0.1, {true, true, false});
  GrainSystem s = *packing.system;
  EXPECT_EQ(s.domain, packing.domain);
  Particles p = packing.particles;
  collect(s, p);
  EXPECT_EQ(p.position, packing.particles.position);
  EXPECT_EQ(p.force, packing.particles.force);
  for (const Vec3& v : p.velocity) ASSERT_EQ(v, (Vec3{}));
  const GrainMeasures before = measure(s);
  EXPECT_NEAR(before.mean_stress, packing.report.mean_stress, 0.02 * before.mean_stress);
  advance_grains(s, 300);
  EXPECT_EQ(s.domain, packing.domain);
  const GrainMeasures after = measure(s);
  EXPECT_LT(after.unbalanced, 2e-3);
  EXPECT_NEAR(after.mean_stress, before.mean_stress, 1e-3 * before.mean_stress);
}

TEST(Compaction, RefusesAFrictionAngleBesideAPorosityAndOutOfRange) {
  const auto message = [](std::optional<double> porosity, double angle) -> std::string {
    CompactionOptions options;
    options.porosity = porosity;
    options.friction_angle = angle;
    try {
      make_packing(sand(300, {}), std::vector<Material>(1), {}, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message(0.4, 0.1), HasSubstr("exclude each other"));
  EXPECT_THAT(message({}, -0.1), HasSubstr("friction_angle -0.1 rad"));
  EXPECT_THAT(message({}, 1.6), HasSubstr("friction_angle 1.6 rad"));
}

}  // namespace
}  // namespace puadem
