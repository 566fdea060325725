// The box in blocks: porosity, water and motion of the grains in each (theory 7.10).

#include "puadem/coupling/local_porosity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "puadem/coupling/pore_space.hpp"
#include "puadem/dem/sphere_in_box.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

namespace puadem {
namespace {

using testing::Spheres;

/// Spheres of all sizes, over each other or not, some across the faces.
Spheres scattered(int count, std::array<bool, 3> periodic) {
  Spheres s;
  s.domain = {{-1.0, 2.0, 0.5}, {2.0, 4.0, 4.5}, periodic};
  Random random(7);
  for (int k = 0; k < count; ++k) {
    Vec3 x;
    for (int a = 0; a < 3; ++a) x[a] = random.uniform(s.domain.lower[a], s.domain.upper[a]);
    s.centre.push_back(x);
    s.radius.push_back(random.uniform(0.05, 0.3));
  }
  return s;
}

TEST(LocalPorosity, BlocksAreNearToCubesOfGrains) {
  const Domain box{{0, 0, 0}, {2.0, 2.0, 4.0}};
  EXPECT_EQ(block_counts(box, 384), (std::array<int, 3>{2, 2, 4}));
  EXPECT_EQ(block_counts(box, 383), (std::array<int, 3>{1, 1, 3}));
  EXPECT_EQ(block_counts(box, 10), (std::array<int, 3>{1, 1, 1}));
}

TEST(LocalPorosity, BlocksAddToTheBox) {
  const Spheres walls = scattered(60, {false, false, false});
  const std::array<int, 3> blocks{3, 2, 4};
  const auto mean = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0) / size_of(v); };
  EXPECT_NEAR(mean(block_porosities(walls.centre, walls.radius, walls.domain, blocks)),
              porosity_of(walls.centre, walls.radius, walls.domain), 1e-13);
  // Where a grain leaves through a periodic face, it comes in again: no volume is lost.
  for (const std::array<int, 3>& n : {blocks, std::array{1, 1, 1}, std::array{7, 1, 2}}) {
    const Spheres s = scattered(60, {true, true, true});
    EXPECT_NEAR(mean(block_porosities(s.centre, s.radius, s.domain, n)), 1.0 - s.solid_volume() / s.domain.volume(), 1e-13);
  }
}

TEST(LocalPorosity, ABlockIsAsPorousAsAGridOfPointsSays) {
  const Spheres s = scattered(12, {true, false, true});
  const std::array<int, 3> blocks{2, 3, 2};
  const std::vector<double> porosity = block_porosities(s.centre, s.radius, s.domain, blocks);
  const Vec3 size = s.domain.size();
  constexpr int points = 60;  // along each side of a block
  for (int b = 0; b < size_of(porosity); ++b) {
    const std::array<int, 3> at{b % 2, b / 2 % 3, b / 6};
    double inside = 0.0;  // of all spheres, each counted
    for (int p = 0; p < points * points * points; ++p) {
      const std::array<int, 3> place{p % points, p / points % points, p / points / points};
      for (std::size_t k = 0; k < s.centre.size(); ++k) {
        double squared = 0.0;
        for (std::size_t a = 0; a < 3; ++a) {
          const int axis = static_cast<int>(a);
          double way = s.domain.lower[axis] + (at[a] + (place[a] + 0.5) / points) / blocks[a] * size[axis] - s.centre[k][axis];
          if (s.domain.periodic[a]) way -= size[axis] * std::nearbyint(way / size[axis]);
          squared += way * way;
        }
        if (squared < s.radius[k] * s.radius[k]) inside += 1.0;
      }
    }
    EXPECT_NEAR(porosity[to_size(b)], 1.0 - inside / std::pow(points, 3), 3e-3) << b;
  }
}

TEST(LocalPorosity, WaterIsSharedByTheVoidOfCells) {
  const Spheres s = testing::simple_cubic(1.0, 6, {true, true, false});
  const PoreNetwork network = build_pore_network(s.centre, s.radius, s.domain, {});
  const CellGeometry cells = measure_cells(network.triangulation, PackingSites(s.centre, s.radius, s.domain));
  std::vector<double> saturation(to_size(network.pores()), 1.0);
  std::vector<std::uint8_t> counted(saturation.size(), 1);
  for (const double one : block_saturations(network, cells, saturation, counted, s.domain, {2, 2, 3}))
    EXPECT_NEAR(one, 1.0, 1e-14);
  // Water up to the height of the third layer of grains: pores between the layers are alike, 4 in each of the blocks.
  for (int p = 0; p < network.pores(); ++p) saturation[to_size(p)] = network.pore_centre[to_size(p)].z < 5.0 ? 0.75 : 0.0;
  const std::vector<double> local = block_saturations(network, cells, saturation, counted, s.domain, {1, 1, 3});
  EXPECT_NEAR(local[0], 0.75, 1e-12);
  EXPECT_GT(local[1], 0.0);
  EXPECT_LT(local[1], 0.75);
  EXPECT_EQ(local[2], 0.0);
  double water = 0.0, space = 0.0;
  for (std::size_t p = 0; p < saturation.size(); ++p) {
    water += saturation[p] * network.pore_volume[p];
    space += network.pore_volume[p];
  }
  EXPECT_NEAR(block_saturations(network, cells, saturation, counted, s.domain, {1, 1, 1})[0], water / space, 1e-13);
  // Without the wet pores, which are a reservoir, all is dry but where there is nothing else.
  for (int p = 0; p < network.pores(); ++p) counted[to_size(p)] = saturation[to_size(p)] == 0.0;
  EXPECT_EQ(block_saturations(network, cells, saturation, counted, s.domain, {1, 1, 1})[0], 0.0);
  EXPECT_NEAR(block_saturations(network, cells, saturation, counted, s.domain, {1, 1, 3})[0], 0.75, 1e-12);
}

TEST(LocalPorosity, AnEvenDeformationIsTheBoxs) {
  const Spheres s = scattered(40, {false, true, false});
  Domain after = s.domain;
  after.lower = {-1.5, 2.0, 0.5};
  after.upper = {1.7, 4.2, 3.9};
  std::vector<Vec3> now = s.centre;
  for (Vec3& x : now)
    for (int a = 0; a < 3; ++a) x[a] = after.lower[a] + (x[a] - s.domain.lower[a]) / s.domain.size()[a] * after.size()[a];
  const Displacements even = displacements(s.centre, s.domain, now, after);
  for (std::size_t k = 0; k < now.size(); ++k) {
    EXPECT_NEAR(norm(even.beyond_box[k]), 0.0, 1e-13);
    EXPECT_NEAR(norm(even.total[k] - (now[k] - s.centre[k])), 0.0, 1e-13);
  }
  // A step of one's own is beyond the box, also through a periodic face.
  const Vec3 step{0.02, 0.3, -0.01};
  for (Vec3& x : now) {
    x += step;
    if (x.y >= after.upper.y) x.y -= after.size().y;
  }
  for (const Vec3& own : displacements(s.centre, s.domain, now, after).beyond_box) EXPECT_NEAR(norm(own - step), 0.0, 1e-12);
}

TEST(LocalPorosity, GrainsOfABlockMoveByTheirMean) {
  const Domain box{{0, 0, 0}, {1, 1, 2}};
  const std::vector<Vec3> centre{{0.5, 0.5, 0.1}, {0.2, 0.3, 0.9}, {0.5, 0.5, 1.1}}, moved{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  std::vector<LocalBlock> blocks(3);
  add_grains(centre, moved, box, {1, 1, 3}, blocks);
  EXPECT_EQ(blocks[0].grains, 1);
  EXPECT_EQ(blocks[1].grains, 2);
  EXPECT_EQ(blocks[2].grains, 0);
  EXPECT_EQ(blocks[0].displacement, (Vec3{1, 0, 0}));
  EXPECT_EQ(blocks[1].displacement, (Vec3{0, 1, 1.5}));
  EXPECT_EQ(blocks[2].displacement, (Vec3{}));
}

TEST(LocalPorosity, RanksCorrelate) {
  const std::vector<double> a{0.1, 0.5, 0.2, 9.0}, b{1.0, 30.0, 2.0, 40.0}, c{4.0, 2.0, 3.0, 1.0}, same(4, 0.3);
  EXPECT_NEAR(*rank_correlation(a, b), 1.0, 1e-15);
  EXPECT_NEAR(*rank_correlation(a, c), -1.0, 1e-15);
  // Without ties 1 - 6 sum d^2 / (n (n^2 - 1)): ranks 0 1 2 3 4 against 1 0 3 2 4.
  EXPECT_NEAR(*rank_correlation(std::vector<double>{1, 2, 3, 4, 5}, std::vector<double>{2, 1, 4, 3, 5}), 0.8, 1e-15);
  // Ranks 0.5 0.5 2 against 0 1 2: covariance 1.5 over sqrt(1.5 * 2).
  EXPECT_NEAR(*rank_correlation(std::vector<double>{1, 1, 2}, std::vector<double>{1, 2, 3}), 1.5 / std::sqrt(3.0), 1e-15);
  EXPECT_FALSE(rank_correlation(a, same));
}

// Between touching spheres of radius 1 a regular tetrahedron has four corners of 3 acos(1/3) - pi; the octahedra have the rest.
TEST(UnitPorosity, IsThatOfTetrahedraAndOctahedraOfALattice) {
  const Spheres s = testing::face_centred(1.0, 3);
  const PoreNetwork network = build_pore_network(s.centre, s.radius, s.domain, {});
  const CellGeometry cells = measure_cells(network.triangulation, PackingSites(s.centre, s.radius, s.domain));
  const double tetrahedron = 2.0 * std::sqrt(2.0) / 3.0;
  const double dense = 1.0 - 4.0 / 3.0 * (3.0 * std::acos(1.0 / 3.0) - std::numbers::pi) / tetrahedron;
  // An octahedron has four times the volume; beside each lie two tetrahedra.
  const double loose = 1.0 - 1.5 * std::numbers::pi / std::sqrt(18.0) + 0.5 * (1.0 - dense);
  int tetrahedra = 0, octahedra = 0;
  for (const double n : unit_porosities(network, cells)) {
    if (std::abs(n - dense) < 1e-10) ++tetrahedra;
    if (std::abs(n - loose) < 1e-10) ++octahedra;
  }
  EXPECT_EQ(tetrahedra, 8 * 27);
  EXPECT_EQ(octahedra, 4 * 27);
  EXPECT_EQ(network.pores(), 12 * 27);
}

}  // namespace
}  // namespace puadem
