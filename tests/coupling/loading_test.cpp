// Stages that load the grains, on small packings.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/dem/motion.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using ::testing::HasSubstr;

namespace {

constexpr double confinement = 100e3;

Case sand(std::array<bool, 3> periodic) {
  Case c;
  c.seed = 5;
  c.domain.periodic = periodic;
  c.materials = {Material{.name = "sand", .youngs_modulus = 2e8, .friction_angle = std::atan(0.5)}};
  c.grains.count = 250;
  c.grains.material = "sand";
  c.grains.grading = {Grading::By::mass, {{0.8e-3, 1.2e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  c.contact.stiffness_ratio = 0.5;
  c.contact.wall_friction = periodic[0] && !periodic[2] ? 0.4 : 0.0;
  c.output.history_rows = 40;
  return c;
}

/// A dense packing, made once for each kind of box.
const State& packed(std::array<bool, 3> periodic) {
  static std::map<std::array<bool, 3>, State> made;
  const auto [entry, is_new] = made.try_emplace(periodic);
  if (is_new) {
    Case c = sand(periodic);
    CompactStage compact;
    compact.stress = confinement;
    compact.friction_angle = 0.0;
    compact.unbalanced = 3e-3;
    c.stages = {compact};
    run(c, entry->second, {});
  }
  return entry->second;
}

constexpr std::array<bool, 3> all_periodic{true, true, true}, all_walls{false, false, false}, layer{true, true, false};

struct Outcome {
  State state;
  RunResults results;
};

Outcome load(std::array<bool, 3> periodic, std::vector<Stage> stages) {
  Case c = sand(periodic);
  c.stages = std::move(stages);
  Outcome outcome{packed(periodic), {}};
  outcome.results = run(c, outcome.state, {});
  return outcome;
}

TriaxialStage triaxial_to(double strain, double rate = 8.0) {
  TriaxialStage stage;
  stage.stress = confinement;
  stage.strain = strain;
  stage.strain_rate = rate;
  return stage;
}

double solid_volume(const State& state) {
  double volume = 0.0;
  for (const double r : state.particles.radius) volume += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  return volume;
}

struct Threads {
  explicit Threads(int n) { set_threads(n); }
  ~Threads() { set_threads(0); }
};

}  // namespace

TEST(Triaxial, HoldsTheLateralStressAndReachesTheStrain) {
  for (const auto periodic : {all_periodic, all_walls}) {
    const Outcome o = load(periodic, {triaxial_to(0.05)});
    const auto& rows = o.state.history;
    ASSERT_NEAR(static_cast<double>(rows.size()), 41.0, 1.0);
    EXPECT_EQ(rows.front().strain, Vec3{});
    EXPECT_NEAR(rows.back().strain.z, 0.05, 2e-4);
    EXPECT_EQ(rows.back().fraction, 1.0);
    EXPECT_LT(o.results.scalars.at("triaxial_stress_error"), 0.01);
    EXPECT_LT(o.results.scalars.at("triaxial_stress_fluctuation"), 0.05);  // few grains, and fast
    EXPECT_GT(o.results.scalars.at("triaxial_peak_q_over_p"), 0.8);
    EXPECT_LT(rows.back().volumetric, -0.005);  // a dense packing dilates
    EXPECT_LT(o.results.scalars.at("triaxial_energy_residual"), 1e-3);
    for (const HistoryRow& row : rows) {
      EXPECT_NEAR(row.mean, (row.stress.x + row.stress.y + row.stress.z) / 3.0, 1e-9 * row.mean);
      EXPECT_EQ(row.stage, "triaxial");
    }
    const Vec3 size = o.state.domain.size(), start = packed(periodic).domain.size();
    EXPECT_NEAR(rows.back().strain.z, std::log(start.z / size.z), 1e-12);
    EXPECT_NEAR(rows.back().porosity, 1.0 - solid_volume(o.state) / o.state.domain.volume(), 1e-12);
    EXPECT_NEAR(o.results.scalars.at("porosity_box"), rows.back().porosity, 1e-5);  // less what overlaps with walls
  }
}

TEST(Triaxial, ForcesOnWallsAreTheStressesTimesTheirAreas) {
  const Outcome o = load(all_walls, {triaxial_to(0.02)});
  for (const HistoryRow& row : o.state.history) {
    const Vec3 size{row.wall_position[1] - row.wall_position[0], row.wall_position[3] - row.wall_position[2],
                    row.wall_position[5] - row.wall_position[4]};
    for (int axis = 0; axis < 3; ++axis) {
      const double area = size.x * size.y * size.z / size[axis];
      const double lower = -row.wall_force[to_size(2 * axis)][axis], upper = row.wall_force[to_size(2 * axis + 1)][axis];
      EXPECT_NEAR(0.5 * (lower + upper), row.stress[axis] * area, 1e-9 * upper);
      EXPECT_NEAR(lower, upper, 0.1 * upper);
    }
  }
}

TEST(Triaxial, PathsOfConstantMeanStressAndConstantVolume) {
  TriaxialStage mean = triaxial_to(0.03), volume = triaxial_to(0.01);
  mean.path = TriaxialStage::StressPath::constant_mean;
  volume.path = TriaxialStage::StressPath::constant_volume;
  const Outcome a = load(all_periodic, {mean});
  EXPECT_LT(a.results.scalars.at("triaxial_stress_error"), 0.01);
  EXPECT_GT(a.state.history.back().deviator, 0.5 * confinement);
  EXPECT_NEAR(a.state.history.back().mean, confinement, 0.05 * confinement);
  const Outcome b = load(all_periodic, {volume});
  EXPECT_NEAR(b.state.history.back().volumetric, 0.0, 1e-5);
  EXPECT_NEAR(b.state.history.back().strain.x, -0.005, 1e-4);
  EXPECT_GT(b.state.history.back().mean, 1.5 * confinement);  // it would dilate, and cannot
}

TEST(Triaxial, WithoutARateIsQuasiStatic) {
  TriaxialStage stage = triaxial_to(0.002);
  stage.strain_rate.reset();
  const Outcome o = load(all_periodic, {stage});
  EXPECT_NEAR(o.results.scalars.at("triaxial_inertial_number"), 5e-4, 1e-15);
  const auto& rows = o.state.history;
  const double diameter = 2.0 * o.results.scalars.at("radius_mean_m");
  const double rate = (rows.back().strain.z - rows.front().strain.z) / (rows.back().time - rows.front().time);
  EXPECT_NEAR(diameter * rate * std::sqrt(2650.0 / confinement), 5e-4, 1e-6);
}

TEST(Isotropic, StepsFromOneStressToAnother) {
  IsotropicStage up;
  up.stress = 150e3;
  up.unbalanced = 5e-3;
  for (const auto periodic : {all_periodic, all_walls}) {
    const Outcome o = load(periodic, {up});
    const HistoryRow& last = o.state.history.back();
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(last.stress[axis], up.stress, 1e-3 * up.stress);
    EXPECT_LT(last.unbalanced, up.unbalanced);
    EXPECT_GT(last.volumetric, 0.0);
  }
}

TEST(Oedometer, FollowsItsPathWithStandingSides) {
  OedometerStage stage;
  stage.path = {200e3, 100e3, 300e3};
  stage.strain_rate = 5.0;
  const Outcome o = load(all_periodic, {stage});
  const auto& rows = o.state.history;
  for (const HistoryRow& row : rows) {
    EXPECT_EQ(row.strain.x, 0.0);
    EXPECT_EQ(row.strain.y, 0.0);
    EXPECT_EQ(row.volumetric, row.strain.z);
  }
  const auto third = rows.size() / 3;
  EXPECT_NEAR(std::ranges::max_element(rows.begin(), rows.begin() + static_cast<long>(third) + 2, {},
                                       [](const auto& r) { return r.stress.z; })
                  ->stress.z,
              200e3, 4e3);
  EXPECT_NEAR(rows.back().stress.z, 300e3, 5e3);
  EXPECT_NEAR(o.results.scalars.at("oedometer_top_stress_Pa"), 300e3, 5e3);
  EXPECT_GT(o.results.scalars.at("oedometer_k0"), 0.2);
  EXPECT_LT(o.results.scalars.at("oedometer_k0"), 1.0);
  EXPECT_GT(o.results.scalars.at("oedometer_compression_index"), 0.0);

  OedometerStage by_strain;
  by_strain.strain = -1e-4;
  by_strain.strain_rate = 5.0;
  const Outcome p = load(all_periodic, {by_strain});
  EXPECT_NEAR(p.state.history.back().strain.z, -1e-4, 5e-5);
  EXPECT_LT(p.state.history.back().stress.z, confinement);
}

TEST(Shear, OfALayerBetweenRoughWalls) {
  ShearStage stage;
  stage.normal_stress = confinement;
  stage.strain = 0.05;
  stage.shear_rate = 10.0;
  const Outcome o = load(layer, {stage});
  const HistoryRow& last = o.state.history.back();
  EXPECT_NEAR(last.shear_strain, 0.05, 1e-3);
  EXPECT_NEAR(last.normal_stress, confinement, 0.05 * confinement);
  EXPECT_GT(last.shear_stress, 0.1 * confinement);
  EXPECT_LT(last.shear_stress, 0.42 * confinement);  // the walls have no more friction
  EXPECT_NEAR(last.strain.x, 0.0, 1e-15);
  EXPECT_LT(o.results.scalars.at("shear_energy_residual"), 1e-3);
  EXPECT_GT(o.state.history.back().energy.input, 0.0);
}

TEST(Settle, BringsGrainsToRestOnTheFloorUnderTheirWeight) {
  Case c = sand(all_walls);
  c.contact.wall_friction = 0.3;
  c.motion.gravity = {0, 0, -981.0};  // in a centrifuge, to save time
  SettleStage stage;
  stage.time = 0.05;
  stage.damping = 0.5;
  stage.unbalanced = 2e-2;
  c.stages = {stage};
  const Spheres s = random_spheres(60, 1.2, {3e-3, 3e-3, 8e-3}, all_walls, 4, 0.25);
  State state;
  state.particles = make_particles(s.centre, s.radius, c.materials[0]);
  state.domain = s.domain;
  std::vector<std::string> messages;
  Observer observer;
  observer.message = [&](std::string_view text) { messages.emplace_back(text); };
  const RunResults results = run(c, state, observer);
  double weight = 0.0;
  for (const double m : state.particles.mass) weight += 981.0 * m;
  const HistoryRow& last = state.history.back();
  EXPECT_LT(last.unbalanced, stage.unbalanced);
  double carried = 0.0;  // by the floor, and by friction of the sides
  for (const Vec3& force : last.wall_force) carried -= force.z;
  EXPECT_NEAR(carried, weight, 0.05 * weight);
  EXPECT_EQ(last.wall_force[5].z, 0.0);
  EXPECT_LT(results.scalars.at("settle_energy_residual"), 2e-2);
  ASSERT_FALSE(messages.empty());
  EXPECT_THAT(messages.front(), HasSubstr("contacts begin without shear"));

  stage.time = 1e-4;  // not enough to fall
  c.stages = {stage};
  State again;
  again.particles = make_particles(s.centre, s.radius, c.materials[0]);
  again.domain = s.domain;
  messages.clear();
  run(c, again, observer);
  EXPECT_THAT(messages.back(), HasSubstr("not at rest after its time"));
}

TEST(Strain, DoesWhatItIsToldAxisByAxis) {
  StrainStage stage;
  stage.strain_rate = {0.0, -2.0, 4.0};
  stage.stress[0] = confinement;
  stage.time = 2e-3;
  const Outcome o = load(all_periodic, {stage});
  const HistoryRow& last = o.state.history.back();
  EXPECT_NEAR(last.strain.y, -4e-3, 1e-4);
  EXPECT_NEAR(last.strain.z, 8e-3, 1e-4);
  EXPECT_NEAR(last.stress.x, confinement, 0.05 * confinement);
}

TEST(Loading, GoesOnWhereTheStageBeforeEnded) {
  const Outcome o = load(all_periodic, {triaxial_to(0.01), triaxial_to(-0.005)});
  const auto& rows = o.state.history;
  const auto second = std::ranges::find(rows, "triaxial-2", &HistoryRow::stage);
  ASSERT_NE(second, rows.end());
  EXPECT_NEAR(second->stress.z, (second - 1)->stress.z, 0.02 * second->stress.z);  // the shear history was kept
  EXPECT_EQ(second->strain.z, 0.0);
  EXPECT_NEAR(rows.back().strain.z, -0.005, 2e-4);
  EXPECT_TRUE(o.results.scalars.contains("triaxial-2_end_q_Pa"));
}

TEST(Loading, KeepsParticlesAndBoxInStepForWhoeverLooks) {
  Case c = sand(all_periodic);
  c.stages = {triaxial_to(0.004)};
  State state = packed(all_periodic);
  int rows = 0;
  Observer observer;
  observer.history = [&](const State& s, const HistoryRow& row) {
    ++rows;
    EXPECT_EQ(s.domain, s.grains->domain);
    EXPECT_EQ(size_of(s.history), rows);
    EXPECT_NEAR(row.porosity, 1.0 - solid_volume(s) / s.domain.volume(), 1e-12);
    Particles copy = s.particles;
    collect(*s.grains, copy);
    EXPECT_EQ(copy.position, s.particles.position);
  };
  run(c, state, observer);
  EXPECT_GT(rows, 30);
}

TEST(Loading, StopsWhenTheObserverAsks) {
  Case c = sand(all_periodic);
  c.stages = {triaxial_to(0.02)};
  State state = packed(all_periodic);
  Observer observer;
  observer.progress = [](const Progress& p) { return p.fraction < 0.3; };
  EXPECT_TRUE(run(c, state, observer).interrupted);
  EXPECT_GT(state.history.size(), 8u);
  EXPECT_LT(state.history.size(), 20u);
  EXPECT_EQ(state.domain, state.grains->domain);
}

TEST(Loading, DoesNotDependOnThreads) {
  Case c = sand(layer);
  ShearStage shear;
  shear.strain = 0.01;
  shear.shear_rate = 10.0;
  c.stages = {triaxial_to(0.003), shear};
  State one = packed(layer), two = packed(layer);
  {
    const Threads guard(1);
    run(c, one, {});
  }
  {
    const Threads guard(2);
    run(c, two, {});
  }
  EXPECT_EQ(one.particles.position, two.particles.position);
  EXPECT_EQ(one.particles.velocity, two.particles.velocity);
  EXPECT_EQ(one.history.back().stress, two.history.back().stress);
  EXPECT_EQ(one.history.back().energy.input, two.history.back().energy.input);
}

TEST(Loading, WarnsWhereItIsNotQuasiStatic) {
  Case c = sand(all_periodic);
  c.stages = {triaxial_to(0.002, 20.0)};
  State state = packed(all_periodic);
  std::string warning;
  Observer observer;
  observer.message = [&](std::string_view text) {
    if (text.starts_with("warning: ")) warning = text;
  };
  run(c, state, observer);
  EXPECT_THAT(warning, HasSubstr("stage triaxial: inertial number 0.0031"));  // 0.96 mm * 20 / s * sqrt(2650 / 1e5)
}

TEST(Loading, NeedsGrains) {
  Case c = sand(all_periodic);
  c.stages = {triaxial_to(0.01)};
  State state;
  EXPECT_THROW(run(c, state, {}), InputError);
}
