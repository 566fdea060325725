// Swelling grains among pores of two fluids, and grains and fluids that move each other in time.
#include "puadem/coupling/swelling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "puadem/base/error.hpp"
#include "puadem/coupling/run.hpp"
#include "puadem/coupling/unsaturated_motion.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/stress.hpp"
#include "puadem/geometry/cell.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using ::testing::HasSubstr;

namespace {

constexpr double radius = 0.2e-3;  // [m], of the largest grain

/// Grains that do not touch, every eighth of a gel.
struct Cloud {
  std::vector<Material> materials{
      Material{.name = "glass", .density = 2650.0, .youngs_modulus = 1e8, .friction_angle = 0.5},
      Material{.name = "gel",
               .density = 1200.0,
               .youngs_modulus = 1e7,
               .friction_angle = 0.2,
               .swelling = SwellingLaw{.diffusivity = 5e-7, .largest_ratio = 3.0, .largest_stress = {}}}};
  Particles particles;
  GrainSystem grains;
  PoreNetwork network;
  UnsaturatedOptions options;
  UnsaturatedCache cache;
  UnsaturatedState state;

  Cloud() {
    const Spheres s = scaled_to(radius, random_spheres(160, 1.5, {1, 1, 1.2}, {true, true, false}, 9, 0.33));
    std::vector<int> material(s.radius.size());
    for (std::size_t k = 0; k < material.size(); k += 8) material[k] = 1;
    particles = make_particles(s.centre, s.radius, materials, material);
    ContactOptions contact;
    contact.law = ContactOptions::Law::linear_spring;
    grains = make_grain_system(particles, s.domain, materials, contact, {});
    grains.time_step = 1e-6;
    options.flow.gas = GasKind::connected;
    options.remesh_displacement = 0.05 * radius;
    network = build_pore_network(particles.position, particles.radius, grains.domain, options.network);
    state = start_unsaturated(options, network, particles, grains, cache);
    state.swelling = start_swelling(particles, materials);
  }

  /// Lets air in as far as a pressure does.
  void drain(double pressure) {
    state.capillary_pressure = pressure;
    rest_fluids(options, network, particles, grains, state, cache);
  }
  SwellingShares wet() {
    return set_wetting(network, *cache.model, state.flow, particles.position, particles.radius, grains.domain, state.swelling);
  }
};

double volume_of(double r) { return 4.0 / 3.0 * std::numbers::pi * r * r * r; }

}  // namespace

TEST(Swelling, GrainsInWaterAreWetAllAround) {
  Cloud c;
  const SwellingShares shares = c.wet();
  ASSERT_EQ(c.state.swelling.size(), 20);
  for (int k = 0; k < 20; ++k) {
    EXPECT_NEAR(c.state.swelling.wetted[to_size(k)], 1.0, 1e-12);
    double sum = 0.0;
    for (const auto [pore, part] : shares.of_grain[to_size(k)]) sum += part;
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(Swelling, TheSharesAreThoseOfTheSurfaceInEachPore) {
  Cloud c;
  const SwellingShares shares = c.wet();
  // The first gel grain again, cell by cell.
  const int grain = c.state.swelling.grain.front();
  const PackingSites sites(c.particles.position, c.particles.radius, c.grains.domain);
  std::map<int, double> area, given;
  double whole = 0.0;
  for (int cell = 0; cell < c.network.triangulation.cells(); ++cell) {
    const auto& vertices = c.network.triangulation.vertices[to_size(cell)];
    const auto angles = grain_solid_angles(sites(vertices));
    for (std::size_t v = 0; v < 4; ++v)
      if (vertices[v].index == grain) {
        area[c.network.tetrahedron_pore[to_size(cell)]] += angles[v];
        whole += angles[v];
      }
  }
  EXPECT_NEAR(whole, 4.0 * std::numbers::pi, 1e-9);
  for (const auto [pore, part] : shares.of_grain.front()) given[pore] += part;
  ASSERT_EQ(given.size(), area.size());
  for (const auto& [pore, part] : given) EXPECT_NEAR(part, area.at(pore) / whole, 1e-12);
}

TEST(Swelling, DryGrainsDoNotSwellAndHalfDryOnesLess) {
  Cloud c;
  c.drain(3e3);
  c.wet();
  double least = 1.0, most = 0.0;
  for (const double wetted : c.state.swelling.wetted) {
    least = std::min(least, wetted);
    most = std::max(most, wetted);
  }
  EXPECT_LT(least, 0.9);
  EXPECT_GE(least, 0.0);
  EXPECT_LE(most, 1.0 + 1e-12);
  c.state.swelling.wetted.assign(c.state.swelling.wetted.size(), 0.0);
  evaluate_forces(c.grains);
  move_grains(c.grains);
  const auto before = swelling_radii(c.particles, c.state.swelling);
  swell_grains(c.materials, 998.0, 1e-3, c.grains, c.particles, c.state.swelling);
  EXPECT_EQ(swelling_radii(c.particles, c.state.swelling), before);
}

TEST(Swelling, MassGrowsByTheWaterTakenUp) {
  Cloud c;
  c.wet();
  evaluate_forces(c.grains);
  move_grains(c.grains);
  swell_grains(c.materials, 1000.0, 5e-3, c.grains, c.particles, c.state.swelling);
  for (std::size_t k = 0; k < c.state.swelling.grain.size(); ++k) {
    const auto g = to_size(c.state.swelling.grain[k]);
    const double start = c.state.swelling.start_radius[k], now = c.particles.radius[g];
    EXPECT_GT(now, start);
    EXPECT_NEAR((c.particles.mass[g] - c.state.swelling.start_mass[k]) / (1000.0 * (volume_of(now) - volume_of(start))), 1.0,
                1e-9);
  }
  EXPECT_GT(c.state.swelling.grown, 0.0);
}

TEST(Swelling, WaterGoesFromPoresIntoGrainsAndNothingIsLost) {
  for (const double pressure : {0.0, 2.5e3}) {
    Cloud c;
    if (pressure > 0.0) c.drain(pressure);
    const double start_time = c.state.flow.time;
    double time = 0.0;
    for (int k = 0; k < 20; ++k)
      time += move_in_time(c.options, c.materials, 5e-5, Schedule{{0.0, 1e-2}, {pressure, pressure + 500.0}}, time, c.grains,
                           c.particles, c.network, c.state, c.cache);
    EXPECT_NEAR(c.state.flow.time - start_time, time, 1e-9 * start_time + 1e-12);
    const SwellingState& s = c.state.swelling;
    double grown = 0.0;
    for (std::size_t k = 0; k < s.grain.size(); ++k)
      grown += volume_of(c.particles.radius[to_size(s.grain[k])]) - volume_of(s.start_radius[k]);
    double space = 0.0;
    for (const double v : c.network.pore_volume) space += v;
    EXPECT_GT(grown, 1e-4 * space) << "the test swells too little";
    EXPECT_NEAR(grown, s.from_pores.value() + s.from_reservoirs.value(), 1e-12 * space);
    EXPECT_GT(c.state.remeshes, 0);
    const auto [water, gas] = ledger_errors(c.network, c.state, c.cache);
    EXPECT_LT(std::abs(water), 1e-12);
    EXPECT_LT(std::abs(gas), 1e-12);
  }
}

TEST(Swelling, StressHindersAGrainThatIsPressed) {
  // A grain between two walls, pressed by a known overlap.
  std::vector<Material> materials{Material{.name = "gel", .density = 1200.0, .youngs_modulus = 1e7, .friction_angle = 0.0}};
  materials[0].swelling = SwellingLaw{.diffusivity = 5e-8, .largest_ratio = 3.0, .largest_stress = {}};
  const std::vector<Vec3> centre{{1e-3, 1e-3, 0.249e-3}};
  const std::vector<double> size{0.25e-3};
  Particles particles = make_particles(centre, size, materials, std::vector<int>{0});
  Domain box;
  box.upper = {2e-3, 2e-3, 0.498e-3};
  ContactOptions contact;
  contact.law = ContactOptions::Law::linear_spring;
  GrainSystem grains = make_grain_system(particles, box, materials, contact, {});
  grains.time_step = 1e-8;
  evaluate_forces(grains);
  double push = 0.0;
  for (const Wall& wall : grains.walls) push += norm(wall.force);
  ASSERT_GT(push, 0.0);
  const double stress = push / (4.0 * std::numbers::pi * 0.25e-3 * 0.25e-3);
  const auto growth = [&](std::optional<double> largest) {
    materials[0].swelling->largest_stress = largest;
    SwellingState state = start_swelling(particles, materials);
    state.wetted = {1.0};
    GrainSystem moved = grains;
    move_grains(moved);
    Particles copy = particles;
    swell_grains(materials, 998.0, 1e-6, moved, copy, state);
    return copy.radius[0] - size[0];
  };
  const double free = growth({});
  EXPECT_GT(free, 0.0);
  EXPECT_NEAR(growth(2.0 * stress) / free, 0.5, 1e-4);
  EXPECT_EQ(growth(0.5 * stress), 0.0);
}

TEST(UnsaturatedInTime, GrainsAtRestUnderAConstantPressureStay) {
  Case c;
  c.seed = 4;
  c.domain.periodic = {true, true, false};
  c.materials = {Material{.name = "glass", .density = 2650.0, .youngs_modulus = 1.5e8, .friction_angle = 0.52}};
  c.grains.count = 150;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::number, {{0.26e-3, 0.54e-3, 1.0}}};
  c.contact.law = ContactOptions::Law::linear_spring;
  CompactStage compact;
  compact.stress = 10e3;
  compact.friction_angle = 0.0;
  UnsaturatedStage stage;
  stage.path = {200.0, 200.0, 3000.0};
  stage.times = {0.0, 2e-3, 6e-3};
  stage.loaded[5] = true;
  stage.stress = 10e3;
  c.stages = {compact, stage};
  c.output.history_rows = 30;
  State state;
  const RunResults results = run(c, state, {});
  const auto& rows = state.unsaturated_flows.back().rows;
  ASSERT_GE(rows.size(), 31u);
  EXPECT_FALSE(rows.front().time.has_value());
  for (const UnsaturatedRow& r : rows) {
    EXPECT_LT(std::abs(r.wetting_error), 1e-10);
    EXPECT_LT(std::abs(r.nonwetting_error), 1e-10);
    EXPECT_NEAR(r.total_stress, 10e3, 300.0);
    if (!r.time) continue;
    const double t = *r.time;
    EXPECT_NEAR(r.capillary_pressure, t < 2e-3 ? 200.0 : 200.0 + 2800.0 * (t - 2e-3) / 4e-3, 1e-6 * r.capillary_pressure);
    if (t > 2e-3) continue;
    EXPECT_NEAR(r.strain, rows.front().strain, 1e-5) << "at " << t;
    EXPECT_NEAR(r.saturation, rows.front().saturation, 1e-9);
  }
  EXPECT_LT(rows.back().saturation, 0.5);
  EXPECT_NEAR(*rows.back().time, 6e-3, 1e-6);
  EXPECT_GT(rows.back().contact_stress.z, rows.front().contact_stress.z);
}

TEST(UnsaturatedInTime, AnIntervalBeyondTheLimitIsRefused) {
  Case c;
  c.domain.periodic = {true, true, false};
  c.materials = {Material{.name = "glass", .density = 2650.0, .youngs_modulus = 1.5e8, .friction_angle = 0.52}};
  c.grains.count = 100;
  c.grains.material = "glass";
  c.grains.grading = {Grading::By::number, {{0.26e-3, 0.54e-3, 1.0}}};
  UnsaturatedStage stage;
  stage.path = {0.0, 100.0};
  stage.times = {0.0, 1e-3};
  stage.coupling_interval = 1.0;
  c.stages = {CompactStage{}, stage};
  State state;
  EXPECT_THAT([&] { run(c, state, {}); }, ::testing::ThrowsMessage<InputError>(HasSubstr("coupling_interval = 1 s")));
}
