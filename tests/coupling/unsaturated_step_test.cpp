// Two fluids in the pores of grains that move: what new networks carry over, forces, and rounds to rest.
#include "puadem/coupling/unsaturated_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/base/random.hpp"
#include "puadem/coupling/fluid_transfer.hpp"
#include "puadem/coupling/vanishing_pores.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/stress.hpp"
#include "puadem/network/network_geometry.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

constexpr double radius = 0.2e-3;  // [m], of the largest grain

/// A bed half drained from the top.
struct Bed {
  std::vector<Material> materials{Material{.name = "glass", .density = 2500.0, .youngs_modulus = 1e8, .friction_angle = 0.4}};
  Particles particles;
  GrainSystem grains;
  PoreNetwork network;
  UnsaturatedOptions options;
  UnsaturatedCache cache;
  UnsaturatedState state;

  explicit Bed(int count = 160) {
    const Spheres s = scaled_to(radius, random_spheres(count, 1.5, {1, 1, 1.2}, {true, true, false}, 9, 0.33));
    particles = make_particles(s.centre, s.radius, materials.front());
    ContactOptions contact;
    contact.law = ContactOptions::Law::linear_spring;
    grains = make_grain_system(particles, s.domain, materials, contact, {});
    grains.time_step = 1e-7;
    options.flow.gas = GasKind::connected;
    options.remesh_displacement = 0.02 * radius;
    network = build_pore_network(particles.position, particles.radius, grains.domain, options.network);
    state = start_unsaturated(options, network, particles, grains, cache);
  }

  const TwoPhaseModel& model() const { return *cache.model; }
  double saturation_now() const { return totals(network, model(), state.flow).saturation; }

  /// Lets air in until about half of the water is left.
  void drain() {
    state.capillary_pressure = 400.0;
    for (; saturation_now() > 0.6; state.capillary_pressure += 100.0)
      rest_fluids(options, network, particles, grains, state, cache);
    state.capillary_pressure -= 100.0;
  }
  double water() const {
    double sum = 0.0;
    for (const double w : state.flow.wetting_volume) sum += w;
    return sum;
  }
  /// Moves grains as a slow shear does, and a little at random; the engine takes the places over.
  void shear(double step, std::uint64_t seed) {
    Random random(seed);
    for (GrainRecord& r : grains.record) {
      if (mass_of(r) <= 0.0) continue;
      r.place[0] += step * r.place[2] / grains.domain.size().z;
      for (int axis = 0; axis < 3; ++axis) r.place[axis] += random.uniform(-0.05, 0.05) * step;
    }
    collect(grains, particles);
  }
};

}  // namespace

TEST(WettedFraction, IsThatOfTheInsetFacesOfAPolyhedron) {
  EXPECT_EQ(wetted_fraction(1.0), 1.0);
  EXPECT_NEAR(wetted_fraction(1e-9), 0.0, 1e-8);
  // A meniscus of radius r_e in the edges leaves (1 - r_e / R)^2 of each face dry.
  for (const double x : {0.2, 0.5, 0.9}) EXPECT_NEAR(wetted_fraction(x), 1.0 - std::pow(1.0 - x / (2.0 - x), 2), 1e-14);
}

TEST(ForceFabric, IsSevenAndAHalfForOneDirectionAndNothingForAll) {
  EXPECT_NEAR(force_fabric(std::vector<Vec3>{{0, 0, 2}, {0, 0, -5}}).anisotropy, 7.5, 1e-12);
  EXPECT_NEAR(force_fabric(std::vector<Vec3>{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}).anisotropy, 0.0, 1e-12);
  EXPECT_NEAR(force_fabric(std::vector<Vec3>{{3, 0, 0}, {0, -1, 0}}).mean, 2.0, 1e-12);
}

TEST(FluidStress, OfOnePressureIsThatPressure) {
  const Spheres s = random_spheres(100, 1.5, {1, 1, 1}, {false, false, false}, 3, 0.3);
  const PoreNetwork network = build_pore_network(s.centre, s.radius, s.domain, {});
  const PackingSites sites(s.centre, s.radius, s.domain);
  const PushedAreas areas = pushed_areas(network, sites, ThroatShare::contact_line, {});
  const std::vector<double> pressure(to_size(network.pores()), 1500.0);
  const FluidForces forces = pressure_forces(network, areas, pressure, {}, size_of(s.radius));
  const Tensor stress = fluid_stress(forces, s.centre, s.domain);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_NEAR(stress[to_size(a)][b], a == b ? 1500.0 : 0.0, 1e-9);
}

TEST(CarryFluids, WithoutMotionNothingChanges) {
  Bed bed;
  bed.drain();
  const TwoPhaseState before = bed.state.flow;
  for (int k = 0; k < 100; ++k) {
    const auto centre = followed_centres(bed.state.place, bed.particles, bed.grains.domain);
    const MovedVoids voids = moved_voids(bed.network, bed.state.place, centre, bed.particles.radius, bed.grains.domain);
    const RebuiltNetwork now = remesh(bed.network, fluid_kinds(bed.state.flow), centre, bed.particles, bed.grains.domain,
                                      bed.options.network, bed.state.place);
    bed.state.flow = carry_fluids(bed.network, voids.cell, bed.model(), now, bed.model(), bed.state.flow);
    bed.network = now.network;
  }
  EXPECT_EQ(bed.state.flow.wetting_volume, before.wetting_volume);
  EXPECT_EQ(bed.state.flow.wetting_pressure, before.wetting_pressure);
  EXPECT_EQ(bed.state.flow.nonwetting, before.nonwetting);
  EXPECT_EQ(bed.state.flow.wetting, before.wetting);
  EXPECT_EQ(bed.state.flow.ledger.wetting_in.value(), before.ledger.wetting_in.value());
}

TEST(CarryFluids, KeepsBothFluidsThroughManyNewNetworks) {
  Bed bed;
  bed.drain();
  ASSERT_GT(bed.saturation_now(), 0.2);
  long cells = 0;
  for (std::uint64_t k = 1; k <= 100; ++k) {
    bed.shear(0.04 * radius, k);
    const Domain& domain = bed.grains.domain;
    const auto centre = followed_centres(bed.state.place, bed.particles, domain);
    const MovedVoids voids = moved_voids(bed.network, bed.state.place, centre, bed.particles.radius, domain);
    // As if each pore had kept its saturation while its grains moved.
    for (std::size_t p = 0; p < voids.pore.size(); ++p)
      bed.state.flow.wetting_volume[p] *= voids.pore[p] / bed.network.pore_volume[p];
    bed.network.pore_volume = voids.pore;
    double fullest = 1.0;  // the flow itself may leave a full pore 1e-9 too full
    for (std::size_t p = 0; p < voids.pore.size(); ++p)
      fullest = std::max(fullest, bed.state.flow.wetting_volume[p] / voids.pore[p]);
    const double water = bed.water();
    const auto pores_of_gas = std::accumulate(bed.state.flow.nonwetting.holds.begin(), bed.state.flow.nonwetting.holds.end(), 0);
    RebuiltNetwork now =
        remesh(bed.network, fluid_kinds(bed.state.flow), centre, bed.particles, domain, bed.options.network, bed.state.place);
    std::vector<FlowBoundary> boundaries = bed.model().boundaries;
    for (FlowBoundary& b : boundaries) b.pores = face_pores(now.network, b.fluid == FluidPhase::wetting ? 4 : 5);
    TwoPhaseModel model =
        make_two_phase_model(now.network, bed.options.fluids, bed.options.flow, boundaries, usual_throat_films(now.network));
    const double in = bed.state.flow.ledger.wetting_in.value() - bed.state.flow.ledger.wetting_out.value();
    double counted = 0.0, counted_now = 0.0;
    for (int p = 0; p < bed.network.pores(); ++p)
      if (bed.model().is_counted(p)) counted += bed.state.flow.wetting_volume[to_size(p)];
    bed.state.flow = carry_fluids(bed.network, voids.cell, bed.model(), now, model, bed.state.flow);
    for (int p = 0; p < now.network.pores(); ++p)
      if (model.is_counted(p)) counted_now += bed.state.flow.wetting_volume[to_size(p)];
    const double booked = bed.state.flow.ledger.wetting_in.value() - bed.state.flow.ledger.wetting_out.value() - in;
    cells += static_cast<long>(now.match.appeared.index.size());
    bed.network = std::move(now.network);
    bed.cache.model = std::move(model);

    EXPECT_NEAR(counted_now - counted, booked, 1e-12 * water);
    for (int p = 0; p < bed.network.pores(); ++p)
      ASSERT_LE(bed.state.flow.wetting_volume[to_size(p)], bed.network.pore_volume[to_size(p)] * fullest * (1.0 + 1e-12));
    const auto now_of_gas = std::accumulate(bed.state.flow.nonwetting.holds.begin(), bed.state.flow.nonwetting.holds.end(), 0);
    EXPECT_NEAR(now_of_gas, pores_of_gas, 0.15 * pores_of_gas);
  }
  EXPECT_GT(cells, 200) << "the motion is too small to test it";
}

TEST(CarryFluids, CavitiesHoldTheirVoidThoughCellsHaveTurnedInsideOut) {
  int turned = 0;
  for (std::uint64_t k = 1; k <= 60; ++k) {
    Bed bed(120);
    bed.shear(3.0 * radius, k);
    const Domain& domain = bed.grains.domain;
    const auto centre = followed_centres(bed.state.place, bed.particles, domain);
    const MovedVoids voids = moved_voids(bed.network, bed.state.place, centre, bed.particles.radius, domain);
    if (voids.inverted < 0) continue;
    NetworkPlace place = bed.state.place;
    const RebuiltNetwork now = remesh(bed.network, {}, centre, bed.particles, domain, bed.options.network, place);
    EXPECT_TRUE(std::ranges::all_of(now.match.before, [&](int c) { return c < 0 || voids.cell[to_size(c)] > 0.0; }));
    const double scale = domain.volume();
    for (int cavity = 0; cavity < now.match.vanished.rows(); ++cavity) {
      double before = 0.0, after = 0.0;
      for (const int c : now.match.vanished[cavity]) {
        before += voids.cell[to_size(c)];
        turned += voids.cell[to_size(c)] < 0.0;
      }
      for (const int c : now.match.appeared[cavity]) after += now.network.tetrahedron_void[to_size(c)];
      EXPECT_NEAR(after, before, 1e-12 * scale);
    }
  }
  EXPECT_GT(turned, 10) << "the motion is too small to test it";
}

TEST(CarryFluids, KeepsBothFluidsThoughCellsHaveTurnedInsideOut) {
  long cells = 0;
  for (std::uint64_t k = 1; k <= 10; ++k) {
    Bed bed;
    bed.drain();
    for (std::uint64_t step = 0; step < 3; ++step) {
      bed.shear(1.0 * radius, 10 * k + step);
      follow_grains(bed.options, bed.grains, bed.particles, bed.network, bed.state, bed.cache);
      const auto [water, gas] = ledger_errors(bed.network, bed.state, bed.cache);
      EXPECT_LT(std::abs(water), 1e-9);
      EXPECT_LT(std::abs(gas), 1e-9);
      for (int p = 0; p < bed.network.pores(); ++p) {
        const double s = bed.state.flow.wetting_volume[to_size(p)] / bed.network.pore_volume[to_size(p)];
        EXPECT_GE(s, 0.0);
        EXPECT_LE(s, 1.0 + 1e-6);
      }
    }
    cells += bed.state.cells_renewed;
  }
  EXPECT_GT(cells, 1000);
}

TEST(VanishingPores, BorrowRoomFromANeighbourAndGiveItBack) {
  Bed bed;
  bed.drain();
  const TwoPhaseState before = bed.state.flow;
  std::vector<double> volume = bed.network.pore_volume;
  const auto counted = std::ranges::find_if(bed.model().is_reservoir, [](auto r) { return !r; });
  const auto gone = to_size(static_cast<int>(counted - bed.model().is_reservoir.begin()) + 5);
  ASSERT_TRUE(bed.model().is_counted(static_cast<int>(gone)));
  volume[gone] = -0.1 * bed.network.pore_volume[gone];
  const std::vector<double> asked = volume;
  const auto sum = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
  const auto borrowed = borrow_room(bed.network, bed.model(), bed.state.flow, volume);
  ASSERT_EQ(borrowed.size(), 1u);
  EXPECT_EQ(borrowed[0].pore, static_cast<int>(gone));
  EXPECT_NEAR(volume[gone], 0.02 * bed.network.pore_volume[gone], 1e-12 * bed.network.pore_volume[gone]);
  EXPECT_NEAR(sum(volume), sum(asked), 1e-12 * sum(asked));
  TwoPhaseState flow = before;
  for (std::size_t p = 0; p < volume.size(); ++p) flow.wetting_volume[p] *= volume[p] / bed.network.pore_volume[p];
  const double water = sum(flow.wetting_volume);
  give_back_room(borrowed, volume, flow);
  const auto from = to_size(borrowed[0].from);
  EXPECT_NEAR(volume[gone], asked[gone], 1e-12 * bed.network.pore_volume[gone]);
  EXPECT_NEAR(volume[from], asked[from], 1e-12 * asked[from]);
  EXPECT_NEAR(sum(flow.wetting_volume), water, 1e-12 * water);
  EXPECT_NEAR(flow.wetting_volume[gone] / volume[gone], flow.wetting_volume[from] / volume[from], 1e-12);
  EXPECT_LE(flow.wetting_volume[from], volume[from] * (1.0 + 1e-12));
}

TEST(UnsaturatedRound, FluidsFollowGrainsAndTheBooksClose) {
  Bed bed;
  bed.drain();
  for (std::uint64_t k = 1; k <= 10; ++k) {
    bed.shear(0.015 * radius, k);
    follow_grains(bed.options, bed.grains, bed.particles, bed.network, bed.state, bed.cache);
    rest_fluids(bed.options, bed.network, bed.particles, bed.grains, bed.state, bed.cache);
    const auto [water, gas] = ledger_errors(bed.network, bed.state, bed.cache);
    EXPECT_LT(std::abs(water), 1e-9);
    EXPECT_LT(std::abs(gas), 1e-9);
  }
  EXPECT_GT(bed.state.remeshes, 2);
}

TEST(UnsaturatedRound, ForcesOnGrainsAndWallsAddToNothing) {
  Bed bed;
  bed.drain();
  Vec3 sum;
  double size = 0.0;
  for (const Vec3& f : bed.state.forces.grain) {
    sum += f;
    size += norm(f);
  }
  for (const Vec3& f : bed.state.forces.wall) sum += f;
  EXPECT_LT(norm(sum), 1e-12 * size);
}
