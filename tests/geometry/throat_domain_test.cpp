#include "puadem/geometry/throat_domain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/facets.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using std::numbers::pi;

namespace {

double total(const std::array<double, 3>& area) { return area[0] + area[1] + area[2]; }

struct Sums {
  double space = 0.0, grains = 0.0, walls = 0.0;
};

/// Sums of the throat domains of a packing.
Sums sum_domains(const Spheres& s) {
  const Triangulation triangulation = triangulate(s.centre, s.radius, s.domain);
  const PackingSites sites_of(s.centre, s.radius, s.domain);
  Sums sums;
  for (const Facet& f : find_facets(triangulation)) {
    const auto sites = sites_of(facet_vertices(triangulation, f));
    const Vec3 from = *power_centre(sites_of(triangulation.vertices[to_size(f.cell)]));
    const Vec3 to = *power_centre(sites_of(triangulation.vertices[to_size(f.neighbour)])) + sites_of.translation(f.shift);
    const ThroatDomain domain = throat_domain(sites, throat_section(sites), from, to);
    sums.space += domain.void_volume;
    for (std::size_t k = 0; k < 3; ++k) (sites[k].is_wall ? sums.walls : sums.grains) += domain.solid_area[k];
  }
  return sums;
}

}  // namespace

// Lengths in radii; the numbers in closed form, since the cells of these lattices share their grains evenly.
TEST(ThroatDomain, BodyCentredCubic) {
  const double a = 4 / std::sqrt(3.0);
  const std::array<Site, 3> sites{Site::grain({0, 0, 0}, 1), Site::grain({a, 0, 0}, 1), Site::grain({a / 2, a / 2, a / 2}, 1)};
  const Vec3 below = *power_centre({sites[0], sites[1], sites[2], Site::grain({a / 2, a / 2, -a / 2}, 1)});
  const Vec3 above = *power_centre({sites[0], sites[1], sites[2], Site::grain({a / 2, -a / 2, a / 2}, 1)});
  const ThroatSection section = throat_section(sites);
  const ThroatDomain domain = throat_domain(sites, section, below, above);
  EXPECT_NEAR(domain.length, std::sqrt(6.0) / 3, 1e-14);
  EXPECT_NEAR(total(domain.solid_area), pi / 3, 1e-14);
  EXPECT_NEAR(domain.void_volume, 8 * std::sqrt(3.0) / 27 - pi / 9, 1e-14);
  EXPECT_NEAR(domain.void_volume / total(domain.solid_area), 0.156737, 0.6e-6);
  EXPECT_NEAR(throat_conductance(domain, section.void_area, total(domain.solid_area), 1.0), 0.00473612, 0.6e-8);
  const ThroatDomain reversed = throat_domain({sites[2], sites[1], sites[0]}, throat_section(sites), above, below);
  EXPECT_NEAR(reversed.void_volume, domain.void_volume, 1e-14);
}

TEST(ThroatDomain, FaceCentredCubic) {
  const double s = std::sqrt(2.0);
  const std::array<Site, 3> sites{Site::grain({0, 0, 0}, 1), Site::grain({s, s, 0}, 1), Site::grain({s, 0, s}, 1)};
  const Vec3 tetrahedron = *power_centre({sites[0], sites[1], sites[2], Site::grain({0, s, s}, 1)});
  const Vec3 octahedron{s, 0, 0};
  const ThroatSection section = throat_section(sites);
  const ThroatDomain domain = throat_domain(sites, section, tetrahedron, octahedron);
  EXPECT_NEAR(domain.length, std::sqrt(1.5), 1e-14);
  EXPECT_NEAR(total(domain.solid_area), pi / 2, 1e-14);
  EXPECT_NEAR(domain.void_volume, std::sqrt(0.5) - pi / 6, 1e-14);
  EXPECT_NEAR(throat_conductance(domain, section.void_area, total(domain.solid_area), 1.0), 8.985e-4, 0.6e-7);
}

TEST(ThroatDomain, PowerCentresThatCoincideMakeOnePore) {
  const std::array<Site, 3> sites{Site::grain({0, 0, 0}, 1), Site::grain({2, 0, 0}, 1), Site::grain({0, 2, 0}, 1)};
  const Vec3 centre{1, 1, 1};
  const ThroatDomain domain = throat_domain(sites, throat_section(sites), centre, centre + Vec3{0, 0, 1e-10});
  EXPECT_TRUE(std::isinf(throat_conductance(domain, 0.4, 1.0, 1.0)));
}

TEST(ThroatDomain, GrainsWithoutVoidPassNothing) {
  EXPECT_EQ(throat_conductance({1.0, -0.1, {}}, 0.2, 1.0, 1.0), 0.0);
  EXPECT_EQ(throat_conductance({1.0, 0.1, {}}, -0.2, 1.0, 1.0), 0.0);
}

// All domains together are the void, and their surfaces all grains and walls: also where the axis of a throat
// misses its facet.
TEST(ThroatDomain, TheDomainsTileThePacking) {
  const std::array<std::array<bool, 3>, 4> boundaries{
      {{false, false, false}, {true, true, true}, {true, true, false}, {false, false, true}}};
  for (const auto& periodic : boundaries)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Spheres s = random_spheres(150, 3.0, {1.0, 1.3, 0.9}, periodic, seed);
      double surface = 0.0, walls = 0.0;
      for (const double r : s.radius) surface += 4 * pi * r * r;
      const Vec3 size = s.domain.size();
      for (int axis = 0; axis < 3; ++axis)
        if (!periodic[to_size(axis)]) walls += 2 * size[(axis + 1) % 3] * size[(axis + 2) % 3];
      const Sums sums = sum_domains(s);
      EXPECT_NEAR(sums.space, s.domain.volume() - s.solid_volume(), 1e-10);
      EXPECT_NEAR(sums.grains / surface, 1.0, 1e-10);
      EXPECT_NEAR(sums.walls, walls, 1e-10);
    }
}
