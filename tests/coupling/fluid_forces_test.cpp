#include "puadem/coupling/fluid_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "puadem/base/random.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

constexpr std::array<bool, 6> all_faces{true, true, true, true, true, true};

struct Bed {
  Spheres spheres;
  PoreNetwork network;
  PackingSites sites;

  explicit Bed(Spheres s, double merge_ratio = 0.9)
      : spheres(std::move(s)), sites(spheres.centre, spheres.radius, spheres.domain) {
    NetworkOptions options;
    options.merge_ratio = merge_ratio;
    network = build_pore_network(spheres.centre, spheres.radius, spheres.domain, options);
  }
  int grains() const { return size_of(spheres.radius); }
  FluidForces forces(const std::vector<double>& pressure, ThroatShare share, const Vec3& jump = {},
                     const std::array<bool, 6>& no_slip = all_faces) const {
    return pressure_forces(network, pushed_areas(network, sites, share, no_slip), pressure, jump, grains());
  }
  std::vector<double> random_pressures(std::uint64_t seed) const {
    Random random(seed);
    std::vector<double> p(to_size(network.pores()));
    for (double& v : p) v = random.uniform(-1e3, 1e3);
    return p;
  }
};

Vec3 sum_of(const std::vector<Vec3>& forces) {
  Vec3 sum;
  for (const Vec3& f : forces) sum += f;
  return sum;
}
double size_sum(const std::vector<Vec3>& forces) {
  double sum = 0.0;
  for (const Vec3& f : forces) sum += norm(f);
  return sum;
}

class EveryShare : public ::testing::TestWithParam<ThroatShare> {};

}  // namespace

TEST_P(EveryShare, AnyPressuresInAPeriodicBoxAddToNothing) {
  const Bed bed(random_spheres(200, 3.0, {1, 1.2, 0.9}, {true, true, true}, 3, 0.35));
  const FluidForces f = bed.forces(bed.random_pressures(1), GetParam());
  EXPECT_LT(norm(sum_of(f.grain)), 1e-12 * size_sum(f.grain));
  EXPECT_GT(size_sum(f.grain), 0.0);
}

TEST_P(EveryShare, AnyPressuresBetweenWallsAddToNothingWithTheWalls) {
  for (const auto& slip : {all_faces, std::array<bool, 6>{}}) {
    const Bed bed(random_spheres(150, 2.0, {1, 1, 1}, {false, true, false}, 8, 0.3));
    const FluidForces f = bed.forces(bed.random_pressures(2), GetParam(), {}, slip);
    Vec3 sum = sum_of(f.grain);
    for (const Vec3& w : f.wall) sum += w;
    EXPECT_LT(norm(sum), 1e-12 * size_sum(f.grain));
  }
}

TEST_P(EveryShare, AGradientPushesWithItsProductWithTheWholeVolume) {
  const Bed bed(random_spheres(200, 2.0, {1, 1.2, 0.9}, {true, true, true}, 5, 0.35));
  const Vec3 gradient{300.0, -200.0, 100.0};
  const Vec3 size = bed.spheres.domain.size();
  const Vec3 jump{gradient.x * size.x, gradient.y * size.y, gradient.z * size.z};
  const FluidForces f = bed.forces(bed.random_pressures(3), GetParam(), jump);
  const Vec3 expected = -bed.spheres.domain.volume() * gradient;
  EXPECT_LT(norm(sum_of(f.grain) - expected), 1e-12 * size_sum(f.grain));
}

TEST_P(EveryShare, OnePressurePushesNoGrainAndEveryWall) {
  const Bed bed(random_spheres(150, 2.0, {1, 1.5, 0.8}, {false, false, false}, 4, 0.3));
  const double p = 2.5e4;
  const FluidForces f = bed.forces(std::vector<double>(to_size(bed.network.pores()), p), GetParam());
  for (const Vec3& force : f.grain) EXPECT_EQ(norm(force), 0.0);
  for (int face = 0; face < 6; ++face) {
    const Vec3 size = bed.spheres.domain.size();
    const double area = bed.spheres.domain.volume() / size[axis_of(face)];
    EXPECT_LT(norm(f.wall[to_size(face)] - p * area * outward_normal(face)), 1e-12 * p * area) << face;
  }
}

TEST_P(EveryShare, EqualGrainsOfALatticeBearEqualShares) {
  // Body-centred cubic, two grains a cell: a mean gradient pushes each with its product with half the cell.
  const Bed bed(body_centred(0.5, 3), std::numeric_limits<double>::infinity());
  const Vec3 gradient{1.0, -2.0, 0.5};
  const Vec3 size = bed.spheres.domain.size();
  std::vector<double> p;
  for (const Vec3& c : bed.network.pore_centre) p.push_back(dot(gradient, c));
  const FluidForces f = bed.forces(p, GetParam(), size.x * gradient);
  const Vec3 share = -bed.spheres.domain.volume() / bed.grains() * gradient;
  for (const Vec3& force : f.grain) EXPECT_LT(norm(force - share), 1e-12 * norm(share));
}

INSTANTIATE_TEST_SUITE_P(FluidForces, EveryShare, ::testing::Values(ThroatShare::surface, ThroatShare::contact_line),
                         [](const auto& test) { return test.param == ThroatShare::surface ? "surface" : "contact_line"; });

TEST(FluidForces, SectorsIntegrateThePressureOverTheGrain) {
  // The part of the force that is no throat's: each point of a grain feels the pressure of the pore around it. Summed over a
  // fine, even set of directions, each looked up in the corners of the tetrahedra around the grain.
  const Bed bed(random_spheres(40, 2.0, {1, 1, 1}, {true, true, true}, 6, 0.3), std::numeric_limits<double>::infinity());
  const std::vector<double> p = bed.random_pressures(7);
  PushedAreas sectors = pushed_areas(bed.network, bed.sites, ThroatShare::surface, all_faces);
  for (int t = 0; t < bed.network.throats(); ++t)
    for (unsigned k = 0; k < 3; ++k) {
      const auto sites = bed.sites(bed.network.throat_vertices(t));
      sectors.throat[to_size(t)][k] = 0.5 * sites[k].radius * sites[k].radius * throat_section(sites).side[k].extent;
    }
  const FluidForces f = pressure_forces(bed.network, sectors, p, {}, bed.grains());

  const int points = 20000;
  for (const int grain : {0, 17, 39}) {
    const double radius = bed.spheres.radius[to_size(grain)];
    Vec3 force;
    int found = 0;
    for (int c = 0; c < bed.network.triangulation.cells(); ++c) {
      const auto& vertices = bed.network.triangulation.vertices[to_size(c)];
      for (unsigned k = 0; k < 4; ++k) {
        if (vertices[k].index != grain) continue;
        const auto sites = bed.sites(vertices);
        std::array<Vec3, 3> e;
        for (unsigned m = 0; m < 3; ++m) e[m] = sites[(k + 1 + m) % 4].centre - sites[k].centre;
        const double whole = triple(e[0], e[1], e[2]);
        for (int i = 0; i < points; ++i) {  // golden spiral
          const double z = 1.0 - (2.0 * i + 1.0) / points, angle = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
          const double r = std::sqrt(1.0 - z * z);
          const Vec3 n{r * std::cos(angle), r * std::sin(angle), z};
          if (triple(n, e[1], e[2]) / whole <= 0 || triple(e[0], n, e[2]) / whole <= 0 || triple(e[0], e[1], n) / whole <= 0)
            continue;
          force -= 4.0 * std::numbers::pi * radius * radius / points * p[to_size(bed.network.tetrahedron_pore[to_size(c)])] * n;
          ++found;
        }
      }
    }
    EXPECT_NEAR(found, points, 2);
    EXPECT_LT(norm(f.grain[to_size(grain)] - force), 5e-3 * radius * radius * 1e3 * 4 * std::numbers::pi);
  }
}

TEST(FluidForces, ArchimedesWithThePiezometricPressure) {
  // Water at rest: the piezometric pressure is one number, and what is left is the weight of the water displaced.
  const Bed bed(random_spheres(100, 3.0, {1, 1, 1}, {false, false, false}, 9, 0.3));
  const Vec3 gravity{0.3, 0.0, -9.81};
  FluidForces f = bed.forces(std::vector<double>(to_size(bed.network.pores()), 7e4), ThroatShare::surface);
  add_buoyancy(bed.spheres.radius, 998.0, gravity, {}, f.grain);
  for (int k = 0; k < bed.grains(); ++k) {
    const double displaced = 4.0 / 3.0 * std::numbers::pi * std::pow(bed.spheres.radius[to_size(k)], 3);
    EXPECT_LT(norm(f.grain[to_size(k)] + 998.0 * displaced * gravity), 1e-12 * 998.0 * displaced * norm(gravity));
  }
  EXPECT_LT(norm(sum_of(f.grain) + 998.0 * bed.spheres.solid_volume() * gravity),
            1e-12 * 998.0 * bed.spheres.solid_volume() * norm(gravity));
}

TEST(FluidForces, HalfWetGrainsFloatHalf) {
  std::vector<Vec3> force(2);
  const std::vector<double> radius{1.0, 1.0}, wetted{1.0, 0.5};
  add_buoyancy(radius, 2.0, {0, 0, -1}, wetted, force);
  EXPECT_DOUBLE_EQ(force[1].z, 0.5 * force[0].z);
  EXPECT_DOUBLE_EQ(force[0].z, 8.0 / 3.0 * std::numbers::pi);
}
