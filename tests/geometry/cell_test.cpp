#include "puadem/geometry/cell.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/base/random.hpp"
#include "puadem/geometry/solid_angle.hpp"
#include "puadem/geometry/throat_section.hpp"

using namespace puadem;

namespace {

std::array<Site, 4> regular_tetrahedron() {  // FCC: four touching spheres of radius 1
  const double s = std::sqrt(2.0);
  return {Site::grain({0, 0, 0}, 1), Site::grain({s, s, 0}, 1), Site::grain({s, 0, s}, 1), Site::grain({0, s, s}, 1)};
}

std::array<Site, 4> bcc_tetrahedron() {  // two cube centres, two corners of the edge between them
  const double a = 4 / std::sqrt(3.0);
  return {Site::grain({0, 0, 0}, 1), Site::grain({a, 0, 0}, 1), Site::grain({a / 2, a / 2, a / 2}, 1),
          Site::grain({a / 2, a / 2, -a / 2}, 1)};
}

}  // namespace

// Closed forms of the regular packings, lengths in radii.
TEST(Cell, FaceCentredTetrahedron) {
  const auto sites = regular_tetrahedron();
  EXPECT_NEAR(cell_volume(sites), 2 * std::sqrt(2.0) / 3, 1e-14);
  EXPECT_NEAR(cell_void_volume(sites), 0.20776, 0.6e-5);
  EXPECT_NEAR(cell_void_volume(sites) / cell_volume(sites), 0.2204, 0.6e-4);
  EXPECT_NEAR(inscribed_sphere(sites)->radius, std::sqrt(1.5) - 1, 1e-14);
  EXPECT_NEAR(inscribed_sphere(sites)->radius, 0.22474, 0.6e-5);
}

TEST(Cell, FaceCentredOctahedronFromItsQuarters) {
  // Six spheres around a hole, cut into four tetrahedra along one diagonal.
  const double s = std::sqrt(2.0);
  const Site top = Site::grain({0, 0, s}, 1), bottom = Site::grain({0, 0, -s}, 1);
  const std::array<Site, 4> ring{Site::grain({s, 0, 0}, 1), Site::grain({0, s, 0}, 1), Site::grain({-s, 0, 0}, 1),
                                 Site::grain({0, -s, 0}, 1)};
  double volume = 0, space = 0;
  for (unsigned k = 0; k < 4; ++k) {
    const std::array<Site, 4> quarter{top, bottom, ring[k], ring[(k + 1) % 4]};
    volume += cell_volume(quarter);
    space += cell_void_volume(quarter);
    EXPECT_NEAR(inscribed_sphere(quarter)->radius, s - 1, 1e-14);
  }
  EXPECT_NEAR(volume, 3.77124, 0.6e-5);
  EXPECT_NEAR(space, 1.05254, 0.6e-5);
}

TEST(Cell, SimpleCubicInsphere) {
  const auto sphere = inscribed_sphere(
      {Site::grain({0, 0, 0}, 1), Site::grain({2, 0, 0}, 1), Site::grain({0, 2, 0}, 1), Site::grain({0, 0, 2}, 1)});
  EXPECT_NEAR(sphere->radius, std::sqrt(3.0) - 1, 1e-14);
  EXPECT_NEAR(norm(sphere->centre - Vec3{1, 1, 1}), 0.0, 1e-14);
}

TEST(Cell, BodyCentredTetrahedronAndFacet) {
  const auto sites = bcc_tetrahedron();
  EXPECT_NEAR(cell_volume(sites), 1.026400, 0.6e-6);
  EXPECT_NEAR(cell_void_volume(sites), 0.328269, 0.6e-6);
  EXPECT_NEAR(inscribed_sphere(sites)->radius, 0.290994, 0.6e-6);
  const ThroatSection facet = throat_section({sites[0], sites[1], sites[2]});
  EXPECT_NEAR(facet.facet_area, 4 * std::sqrt(2.0) / 3, 1e-14);
  EXPECT_NEAR(facet.void_area, 0.314822, 0.6e-6);
  EXPECT_NEAR(facet.inscribed_radius, 0.224745, 0.6e-6);
}

TEST(Cell, PowerCentreHasEqualPowerAndLiesOnItsWalls) {
  const std::array<Site, 4> grains{Site::grain({0, 0, 0}, 1), Site::grain({2.2, 0.1, 0}, 0.7), Site::grain({1, 2, 0.2}, 1.1),
                                   Site::grain({0.8, 0.6, 1.9}, 0.5)};
  const Vec3 c = *power_centre(grains);
  const double power = squared_norm(c - grains[0].centre) - 1.0;
  for (const Site& g : grains) EXPECT_NEAR(squared_norm(c - g.centre) - g.radius * g.radius, power, 1e-13);
  const Vec3 w = *power_centre({grains[0], grains[1], Site::wall({0, -1, 0}, 1.5), Site::wall({0, 0, -1}, 1.2)});
  EXPECT_NEAR(w.y, -1.5, 1e-14);
  EXPECT_NEAR(w.z, -1.2, 1e-14);
  EXPECT_NEAR(squared_norm(w - grains[0].centre) - 1.0, squared_norm(w - grains[1].centre) - 0.49, 1e-13);
}

// Cells at walls against what they are: a prism, a wedge-shaped beam, a box.
TEST(Cell, WallPolyhedra) {
  const Site a = Site::grain({0.3, 0.2, 1.0}, 0.1), b = Site::grain({1.4, 0.5, 1.3}, 0.2), c = Site::grain({0.6, 1.7, 0.8}, 0.15);
  const Site floor = Site::wall({0, 0, -1}, 0), side = Site::wall({0, -1, 0}, 0), front = Site::wall({-1, 0, 0}, 0);
  const double base = 0.5 * ((1.4 - 0.3) * (1.7 - 0.2) - (0.5 - 0.2) * (0.6 - 0.3));
  EXPECT_NEAR(cell_volume({a, b, c, floor}), base * (1.0 + 1.3 + 0.8) / 3, 1e-14);
  // Beam along x whose rectangular section y(x) z(x) is a quadratic: Simpson's rule is exact.
  EXPECT_NEAR(cell_volume({a, b, floor, side}), 1.1 / 6 * (0.2 * 1.0 + 4 * 0.35 * 1.15 + 0.5 * 1.3), 1e-14);
  EXPECT_NEAR(cell_volume({a, floor, side, front}), 0.3 * 0.2 * 1.0, 1e-15);
  EXPECT_NEAR(facet_area({a, b, floor}), 0.5 * (1.0 + 1.3) * std::hypot(1.1, 0.3), 1e-14);
  EXPECT_NEAR(facet_area({a, floor, side}), 0.2 * 1.0, 1e-15);
  EXPECT_NEAR(grain_solid_angles({a, floor, side, front})[0], std::numbers::pi / 2, 1e-14);
  const Vec3 centroid = cell_centroid({a, floor, side, front});
  EXPECT_NEAR(norm(centroid - Vec3{0.15, 0.1, 0.5}), 0.0, 1e-14);
}

TEST(SolidAngle, OpenCornersAndMonteCarloFreeSums) {
  EXPECT_NEAR(solid_angle({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), std::numbers::pi / 2, 1e-15);
  // Three edges almost in a plane around the corner: nearly a hemisphere.
  const double z = 1e-6;
  EXPECT_NEAR(solid_angle({1, 0, z}, {-0.5, 0.8, z}, {-0.5, -0.8, z}), 2 * std::numbers::pi, 1e-4);
  // The angles around a point inside a tetrahedron fill the sphere.
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    std::array<Vec3, 4> p;
    Vec3 inside;
    double weight = 0;
    for (Vec3& x : p) {
      x = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      const double w = random.uniform(0.1, 1);
      inside += w * x;
      weight += w;
    }
    inside = inside / weight;
    double sum = 0;
    for (unsigned k = 0; k < 4; ++k) sum += solid_angle(p[k] - inside, p[(k + 1) % 4] - inside, p[(k + 2) % 4] - inside);
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-11);
  }
}
