#include "puadem/dem/packing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/dem/sphere_in_box.hpp"

namespace puadem {
namespace {

using ::testing::HasSubstr;

PackingSource beads(int count, std::array<bool, 3> periodic = {false, false, false}) {
  PackingSource source;
  source.grading = {Grading::By::mass, {{0.60e-3, 0.60e-3, 0.35}, {0.85e-3, 0.85e-3, 0.35}, {1.0e-3, 1.4e-3, 0.30}}};
  source.count = count;
  source.periodic = periodic;
  source.seed = 7;
  return source;
}

std::vector<Material> glass() { return {Material{}}; }

TEST(Cloud, HasNoOverlapAndKeepsInsideTheBox) {
  const Packing cloud = random_cloud(beads(600, {true, false, false}), glass());
  const Particles& p = cloud.particles;
  const Vec3 size = cloud.domain.size();
  for (int i = 0; i < p.size(); ++i) {
    for (int axis = 1; axis < 3; ++axis) {
      EXPECT_GE(p.position[to_size(i)][axis], p.radius[to_size(i)]);
      EXPECT_LE(p.position[to_size(i)][axis], size[axis] - p.radius[to_size(i)]);
    }
    for (int j = i + 1; j < p.size(); ++j) {
      Vec3 d = p.position[to_size(j)] - p.position[to_size(i)];
      d.x -= size.x * std::round(d.x / size.x);
      ASSERT_GE(norm(d), p.radius[to_size(i)] + p.radius[to_size(j)]);
    }
  }
  EXPECT_NEAR(cloud.report.porosity_box, 0.7, 1e-12);
}

struct Target {
  int count;
  std::array<bool, 3> periodic;
  std::optional<double> porosity;
  CompactionOptions::Region region;
};

class Compaction : public ::testing::TestWithParam<Target> {};

TEST_P(Compaction, ReachesStressPorosityAndRest) {
  const Target& target = GetParam();
  CompactionOptions options;
  options.porosity = target.porosity;
  options.region = target.region;
  const PackingSource source = beads(target.count, target.periodic);
  Packing packing = make_packing(source, glass(), {}, options);
  const CompactionReport& report = packing.report;

  EXPECT_NEAR(report.mean_stress, 10e3, 100);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(report.axis_stress[axis], 10e3, 200);
  EXPECT_LT(report.unbalanced, 1e-3);
  EXPECT_LT(report.largest_overlap, 0.06);

  // What the report says is found again from the grains alone.
  const Particles& p = packing.particles;
  const Domain& box = packing.domain;
  EXPECT_EQ(box.lower, (Vec3{0, 0, 0}));
  EXPECT_NEAR(porosity_of(p.position, p.radius, core_of(box, 1.4e-3)), report.porosity_core, 1e-3);
  EXPECT_NEAR(porosity_of(p.position, p.radius, box), report.porosity_box, 1e-12);
  const double porosity = target.region == CompactionOptions::Region::core ? report.porosity_core : report.porosity_box;
  EXPECT_NEAR(porosity, target.porosity.value_or(porosity), 2e-3);
  for (int k = 0; k < p.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(p.position[to_size(k)][axis], 0.0);
      EXPECT_LE(p.position[to_size(k)][axis], box.upper[axis]);
    }

  // No grain has changed its size on the way.
  EXPECT_EQ(p.radius, grain_radii(source.grading, source.count, source.seed));
  EXPECT_LT(report.grading_error, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Targets, Compaction,
                         ::testing::Values(Target{700, {false, false, false}, 0.37, CompactionOptions::Region::core},
                                           Target{500, {true, true, true}, 0.36, CompactionOptions::Region::box},
                                           Target{500, {true, true, false}, {}, CompactionOptions::Region::core}));

TEST(Compaction, LeavesFrictionAsGivenWithoutATarget) {
  CompactionOptions options;
  Packing packing = make_packing(beads(300), glass(), {}, options);
  EXPECT_NEAR(packing.report.friction_used, std::tan(std::numbers::pi / 6), 1e-12);
}

// Friction on the side walls carries part of the stress, so that two opposite walls need not bear the same.
TEST(Compaction, ComesToRestBetweenRoughWalls) {
  ContactOptions contact;
  contact.wall_friction = 0.4;
  CompactionOptions options;
  options.unbalanced = 5e-3;
  options.max_steps = 100'000;
  Packing packing = make_packing(beads(300), glass(), contact, options);
  const GrainMeasures m = measure(*packing.system);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(m.stress[to_size(axis)][axis], options.stress, 0.015 * options.stress);
}

std::string refusal(double porosity) {
  CompactionOptions options;
  options.porosity = porosity;
  try {
    make_packing(beads(300, {true, true, true}), glass(), {}, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Compaction, RefusesWhatGrainsCannotReachWithTheFigureTheyCan) {
  EXPECT_THAT(refusal(0.25), HasSubstr("frictionless grains of this grading pack to 0.3"));
  EXPECT_THAT(refusal(0.60), HasSubstr("raise the friction angle"));
}

TEST(Compaction, StopsWhenAsked) {
  int calls = 0;
  const Packing packing = make_packing(beads(300), glass(), {}, {}, [&](const CompactionProgress&) { return ++calls < 3; });
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(packing.particles.size(), 300);
}

TEST(Compaction, BadOptionsAreNamed) {
  const auto message = [](auto change) -> std::string {
    CompactionOptions options;
    PackingSource source = beads(300);
    change(options, source);
    try {
      make_packing(source, glass(), {}, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message([](auto& o, auto&) { o.stress = -1; }), HasSubstr("stress -1 Pa"));
  EXPECT_THAT(message([](auto& o, auto&) { o.porosity = 1.5; }), HasSubstr("porosity 1.5"));
  EXPECT_THAT(message([](auto& o, auto&) { o.damping = 2; }), HasSubstr("damping 2"));
  EXPECT_THAT(message([](auto&, auto& s) { s.shape = {1, 0, 1}; }), HasSubstr("proportion 0"));
  EXPECT_THAT(message([](auto&, auto& s) { s.count = 20; }), HasSubstr("more grains"));
  EXPECT_THAT(message([](auto&, auto& s) { s.materials[0].material = 3; }), HasSubstr("material 3"));
}

// A packing read back has the forces it was left with: contacts without shear, since history is not read.
TEST(EvaluatePacking, FindsTheNormalStressOfAPackingAgain) {
  ContactOptions contact;
  Material smooth;
  smooth.friction_angle = 0.0;
  Packing packing = make_packing(beads(300), std::vector{smooth}, contact, {});
  const GrainMeasures m = evaluate_packing(packing.particles, packing.domain, std::vector{smooth}, contact);
  EXPECT_NEAR(m.mean_stress, packing.report.mean_stress, 1e-3 * m.mean_stress);
  EXPECT_NEAR(m.unbalanced, packing.report.unbalanced, 2e-4);
}

}  // namespace
}  // namespace puadem
