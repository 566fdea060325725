// Grains and one fluid that move each other, step by step.
#include "puadem/coupling/saturated_step.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/motion.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;

namespace {

constexpr double radius = 1e-3;  // [m], of the order of the grains

/// Grains and one fluid, not yet moved.
struct Bed {
  std::vector<Material> materials{Material{.name = "glass", .density = 2500.0, .youngs_modulus = 1e7, .friction_angle = 0.0}};
  Particles particles;
  GrainSystem grains;
  PoreNetwork network;
  SaturatedOptions options;
  SaturatedCache cache;
  SaturatedState state;

  Bed(Spheres s, double viscosity, bool is_drained = false, const Vec3& gravity = {}) {
    s = scaled_to(radius, std::move(s));
    particles = make_particles(s.centre, s.radius, materials.front());
    ContactOptions contact;
    contact.law = ContactOptions::Law::linear_spring;
    MotionOptions motion;
    motion.gravity = gravity;
    grains = make_grain_system(particles, s.domain, materials, contact, motion);
    options.viscosity = viscosity;
    options.remesh_displacement = 0.02 * radius;
    options.network.merge_ratio = std::numeric_limits<double>::infinity();
    if (is_drained) options.faces[5] = {FaceCondition::Kind::pressure, 0.0};
    network = build_pore_network(particles.position, particles.radius, grains.domain, options.network);
    state = start_saturated(options, network, particles, grains, cache);
  }

  void shake(double speed, std::uint64_t seed = 1) {
    Random random(seed);
    for (GrainRecord& r : grains.record)
      for (int axis = 0; axis < 3; ++axis) r.drift[axis] = random.uniform(-speed, speed);
  }
  void step(long substeps = 1) { saturated_step(options, substeps, grains, particles, network, state, cache); }
  double kinetic() const {
    double sum = 0.0;
    for (int k = 0; k < grains.owned; ++k) {
      const GrainRecord& r = grains.record[to_size(k)];
      sum += 0.5 * mass_of(r) * squared_norm(vec3(r.drift));
    }
    return sum;
  }
};

Spheres bed_of(int count, std::array<bool, 3> periodic, double solid = 0.33) {
  return random_spheres(count, 1.5, {1, 1, 1}, periodic, 7, solid);
}

constexpr std::array<bool, 3> all_periodic{true, true, true}, all_walls{false, false, false}, layer{true, true, false};

}  // namespace

TEST(SaturatedStep, VoidsOfMovedGrainsAreThoseOfANewNetworkEvenWhereCellsTurnInsideOut) {
  for (const auto& periodic : {all_periodic, all_walls}) {
    Bed bed(bed_of(200, periodic), 1e-3);
    const double space = std::accumulate(bed.network.pore_volume.begin(), bed.network.pore_volume.end(), 0.0);
    Random random(3);
    std::vector<Vec3> centre = bed.particles.position;
    for (Vec3& x : centre)
      for (int axis = 0; axis < 3; ++axis) x[axis] += random.uniform(-0.3, 0.3) * radius;
    const MovedVoids voids = moved_voids(bed.network, bed.state.place, centre, bed.particles.radius, bed.grains.domain);
    EXPECT_GE(voids.inverted, 0) << "the motion is too small to test it";
    EXPECT_NEAR(std::accumulate(voids.pore.begin(), voids.pore.end(), 0.0), space, 1e-12 * space);
  }
}

TEST(SaturatedStep, WithoutMotionAThousandNewNetworksChangeNoBit) {
  Bed bed(bed_of(30, layer), 1e-3, true);
  const PoreNetwork before = bed.network;
  NetworkPlace place = bed.state.place;
  PoreNetwork network = before;
  for (int k = 0; k < 1000; ++k) {
    const auto centre = followed_centres(place, bed.particles, bed.grains.domain);
    network = remesh(network, {}, centre, bed.particles, bed.grains.domain, bed.options.network, place).network;
  }
  EXPECT_EQ(network.pore_volume, before.pore_volume);
  EXPECT_EQ(network.throat_conductance, before.throat_conductance);
  EXPECT_EQ(network.triangulation.vertices, before.triangulation.vertices);
  EXPECT_EQ(place.centre, bed.state.place.centre);
}

TEST(SaturatedStep, FluidThatLeavesIsVoidThatCloses) {
  Bed bed(bed_of(150, layer), 0.1, true);
  bed.grains.motion.damping = 0.0;
  bed.shake(0.02);
  bed.grains.time_step = 2e-6;
  for (Wall& wall : bed.grains.walls)
    if (wall.face == 5) wall.velocity = {0, 0, -0.2};
  bed.grains.box_rate = {0, 0, -0.2};
  for (int k = 0; k < 200; ++k) {
    bed.step(2);
    ASSERT_LT(std::abs(bed.state.ledger_error()), 1e-12);
  }
  EXPECT_GT(bed.state.remeshes, 3);
  EXPECT_LT(bed.state.inflow[5].value(), -0.01 * bed.state.void_start);
  const PoreNetwork now =
      build_pore_network(bed.particles.position, bed.particles.radius, bed.grains.domain, bed.options.network);
  const double space = std::accumulate(now.pore_volume.begin(), now.pore_volume.end(), 0.0);
  EXPECT_NEAR(bed.state.void_now, space, 1e-12 * space);
}

TEST(SaturatedStep, AYieldingFluidIsKeptToo) {
  Bed bed(bed_of(150, all_walls), 0.1);
  bed.options.bulk_modulus = 1e7;
  bed.shake(0.02);
  bed.grains.time_step = 2e-6;
  for (Wall& wall : bed.grains.walls)
    if (wall.face == 5) wall.velocity = {0, 0, -0.02};
  bed.grains.box_rate = {0, 0, -0.02};
  for (int k = 0; k < 100; ++k) bed.step(2);
  EXPECT_LT(std::abs(bed.state.ledger_error()), 1e-12);
  EXPECT_GT(bed.state.stored.value(), 0.0);
}

TEST(SaturatedStep, AClosedBoxWhoseWallMovesIsRefused) {
  Bed bed(bed_of(100, all_walls), 0.1);
  bed.grains.time_step = 2e-6;
  for (Wall& wall : bed.grains.walls)
    if (wall.face == 5) wall.velocity = {0, 0, -0.02};
  bed.grains.box_rate = {0, 0, -0.02};
  EXPECT_THAT([&] { bed.step(2); }, ::testing::ThrowsMessage<InputError>(HasSubstr("compressible")));
}

TEST(SaturatedStep, WaterAtRestCarriesEachGrainByItsOwnWeightOfWater) {
  Bed bed(bed_of(120, layer), 1e-3, true, {0, 0, -9.81});
  const double weight = bed.options.density * 9.81;
  Vec3 sum;
  double whole = 0.0;
  for (int k = 0; k < bed.particles.size(); ++k) {
    const double r = bed.particles.radius[to_size(k)], volume = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    const Vec3& f = bed.grains.external_force[to_size(k)];
    EXPECT_NEAR(f.z, weight * volume, 1e-12 * weight * volume);
    EXPECT_LT(std::hypot(f.x, f.y), 1e-12 * weight * volume);
    sum += f;
    whole += weight * volume;
  }
  EXPECT_NEAR(sum.z, whole, 1e-12 * whole);
}

TEST(SaturatedStep, TheFluidBringsGrainsToRestAtTheRateThatLimitsTheInterval) {
  // Grains that touch nothing: below the limit their motion dies out, above it grows.
  for (const auto& periodic : {all_periodic, layer}) {
    const Spheres spheres = bed_of(120, periodic, 0.3);
    const auto speed_after = [&](double share) {
      Bed bed(spheres, 1.0);
      const double limit = coupling_limit(bed.options, bed.network, bed.particles, bed.grains.domain, bed.cache);
      bed.shake(1e-9);
      const double before = bed.kinetic();
      bed.grains.time_step = share * limit;
      for (int k = 0; k < 25; ++k) bed.step();
      return bed.kinetic() / before;
    };
    EXPECT_LT(speed_after(0.9), 1.0);
    EXPECT_GT(speed_after(1.2), 1e3);
  }
}

TEST(SaturatedStep, AFluidGivesNoEnergyToGrains) {
  // Closed, without damping or friction: energy only falls, and what that depends on the interval falls with it, at least
  // linearly.
  const auto left = [](long substeps) {
    Bed bed(bed_of(250, all_walls), 0.02);
    bed.shake(0.05);
    evaluate_forces(bed.grains);
    bed.grains.time_step = 2e-6;
    open_energy_book(bed.grains);
    const double start = bed.kinetic();
    double energy = 1.0;
    for (long k = 0; k < 800 / substeps; ++k) {
      bed.step(substeps);
      evaluate_forces(bed.grains);
      const double now = energies(bed.grains).stored() / start;
      EXPECT_LT(now, energy);
      energy = now;
    }
    return energy;
  };
  const double four = left(4), eight = left(8), sixteen = left(16);
  EXPECT_LT(four, 0.95) << "the fluid takes too little to test it";
  EXPECT_GT((sixteen - eight) / (eight - four), 1.5);
}

TEST(SaturatedStep, AnswersDoNotDependOnTheNumberOfThreads) {
  const auto moved = [](int threads) {
    set_threads(threads);
    Bed bed(bed_of(300, layer), 0.1, true, {0, 0, -9.81});
    bed.shake(0.02);
    bed.grains.time_step = 2e-6;
    for (int k = 0; k < 50; ++k) bed.step(2);
    return std::pair(bed.particles.position, bed.state.pressure);
  };
  const auto one = moved(1), three = moved(3);
  set_threads(0);
  EXPECT_EQ(one.first, three.first);
  EXPECT_EQ(one.second, three.second);
}

TEST(SaturatedStep, AStepFromASavedStateIsTheStepThatWouldHaveBeen) {
  using Method = PressureSolverOptions::Method;
  for (const Method method : {Method::cholesky, Method::multigrid}) {
    Bed bed(bed_of(200, layer), 0.1, true, {0, 0, -9.81});
    bed.cache.memory.solver.method = method;
    bed.shake(0.02);
    bed.grains.time_step = 2e-6;
    for (int k = 0; k < 5; ++k) bed.step(2);
    GrainSystem grains = bed.grains;
    Particles particles = bed.particles;
    PoreNetwork network = bed.network;
    SaturatedState state = bed.state;
    SaturatedCache cache;
    cache.memory.solver = bed.cache.memory.solver;
    renew_cache(bed.options, network, particles.radius, state.place, cache);
    bed.step(2);
    saturated_step(bed.options, 2, grains, particles, network, state, cache);
    EXPECT_EQ(bed.state.pressure, state.pressure);
    EXPECT_EQ(bed.grains.external_force, grains.external_force);
  }
}

TEST(SaturatedStep, AGrainThatHasEscapedStopsTheRunWithItsPlace) {
  Bed bed(bed_of(100, layer), 0.1, true);
  bed.grains.time_step = 2e-6;
  bed.step();
  bed.grains.record[7].place[2] = bed.grains.domain.upper.z + 0.2 * radius;
  EXPECT_THAT([&] { bed.step(); }, ::testing::ThrowsMessage<NumericalError>(
                                       AllOf(HasSubstr(fmt::format("step 2: grain {} of radius", bed.grains.identity[7])),
                                             HasSubstr("the top wall, to ("))));
}

TEST(SaturatedStep, AVanishedPoreJoinsAnotherOneThatIsClosedOffStopsTheRunWithItsPlace) {
  Bed bed(bed_of(100, layer), 0.1, true);
  const int pores = bed.network.pores();
  bed.grains.time_step = 2e-6;
  for (double& r : bed.particles.radius) r *= 1.2;  // in the eyes of the fluid alone
  bed.options.remesh_strain = 10.0;
  bed.step();
  EXPECT_EQ(bed.state.remeshes, 1);
  EXPECT_LT(bed.network.pores(), pores);
  EXPECT_LT(std::abs(bed.state.ledger_error()), 1e-12);
  EXPECT_THAT([&] { bed.step(); }, ::testing::ThrowsMessage<NumericalError>(
                                       AllOf(HasSubstr("cut off from every given pressure"), HasSubstr("around pore 243 at ("))));
  Bed full(bed_of(100, layer), 0.1, true);
  full.grains.time_step = 2e-6;
  for (double& r : full.particles.radius) r *= 1.6;
  EXPECT_THAT([&] { full.step(); }, ::testing::ThrowsMessage<NumericalError>(
                                        AllOf(HasSubstr("no void is left between them"), HasSubstr("grains 0 and 99 at ("))));
}

TEST(SaturatedStep, ATurnedCellThatANewNetworkDoesNotMendStopsTheRunWithItsPlace) {
  Bed bed(bed_of(100, layer), 0.1, true);
  bed.grains.time_step = 2e-6;
  bed.state.place.orientation[11] = static_cast<std::int8_t>(-bed.state.place.orientation[11]);
  EXPECT_THAT([&] { bed.step(); }, ::testing::ThrowsMessage<NumericalError>(
                                       AllOf(HasSubstr("step 1: tetrahedron 11 beside grain"), HasSubstr("does not mend it"))));
}
