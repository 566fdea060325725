#include "puadem/geometry/cell_match.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "puadem/network/network_geometry.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

struct Mesh {
  Triangulation triangulation;
  CellGeometry cells;
};

Mesh mesh(const Spheres& s) {
  Mesh m;
  m.triangulation = triangulate(s.centre, s.radius, s.domain);
  m.cells = measure_cells(m.triangulation, PackingSites(s.centre, s.radius, s.domain));
  return m;
}

/// The same cells where the grains stand now.
CellGeometry moved(const Mesh& m, const Spheres& s) {
  return measure_cells(m.triangulation, PackingSites(s.centre, s.radius, s.domain));
}

void shake(Spheres& s, double amplitude, Random& random) {
  for (std::size_t k = 0; k < s.centre.size(); ++k)
    for (int a = 0; a < 3; ++a) {
      const double margin = s.domain.periodic[to_size(a)] ? 0.0 : s.radius[k];
      s.centre[k][a] =
          std::clamp(s.centre[k][a] + amplitude * s.radius[k] * random.uniform(-1.0, 1.0), margin, s.domain.size()[a] - margin);
    }
}

int turned(const Mesh& m, const Spheres& before, const Spheres& now) {
  const auto a = cell_orientations(m.triangulation, PackingSites(before.centre, before.radius, before.domain));
  const auto b = cell_orientations(m.triangulation, PackingSites(now.centre, now.radius, now.domain));
  int count = 0;
  for (std::size_t c = 0; c < a.size(); ++c) count += a[c] != b[c];
  return count;
}

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

}  // namespace

TEST(CellMatch, WithoutMotionEveryCellKeepsItsAmountToTheBit) {
  const Spheres s = random_spheres(150, 2.0, {1, 1, 1}, {true, false, true}, 1, 0.3);
  const Mesh a = mesh(s), b = mesh(s);
  const CellMatch match = match_cells(a.triangulation, b.triangulation);
  EXPECT_EQ(match.appeared.rows(), 0);
  EXPECT_EQ(carry_over(match, a.cells.void_volume, b.cells.void_volume), a.cells.void_volume);
}

TEST(CellMatch, CavitiesHaveTheSameVoidBeforeAndNow) {
  for (const auto& periodic : {std::array{true, true, true}, std::array{false, false, false}, std::array{true, false, true}}) {
    Spheres s = random_spheres(300, 2.0, {1, 1.1, 0.9}, periodic, 2, 0.35);
    const Spheres start = s;
    const Mesh before = mesh(s);
    Random random(5);
    shake(s, 0.01, random);
    const Mesh now = mesh(s);
    ASSERT_EQ(turned(before, start, s), 0);
    const CellGeometry old = moved(before, s);
    const CellMatch match = match_cells(before.triangulation, now.triangulation);
    EXPECT_GT(match.appeared.rows(), 2);
    EXPECT_LT(match.appeared.index.size(), 0.05 * now.triangulation.cells());
    const double mean = sum(now.cells.void_volume) / now.triangulation.cells();
    for (int c = 0; c < match.appeared.rows(); ++c) {
      EXPECT_GE(match.vanished[c].size(), 1u);
      double a = 0.0, b = 0.0;
      for (const int k : match.vanished[c]) a += old.void_volume[to_size(k)];
      for (const int k : match.appeared[c]) b += now.cells.void_volume[to_size(k)];
      EXPECT_NEAR(a, b, 1e-12 * mean);
    }
    for (int c = 0; c < now.triangulation.cells(); ++c)
      if (const int b = match.before[to_size(c)]; b >= 0) {
        EXPECT_EQ(before.triangulation.vertices[to_size(b)], now.triangulation.vertices[to_size(c)]);
        EXPECT_EQ(old.void_volume[to_size(b)], now.cells.void_volume[to_size(c)]);
      }
  }
}

TEST(CellMatch, EveryCellIsInOneCavityOrStays) {
  Spheres s = random_spheres(200, 2.0, {1, 1, 1}, {true, true, true}, 3, 0.35);
  const Mesh before = mesh(s);
  Random random(6);
  shake(s, 0.02, random);
  const Mesh now = mesh(s);
  const CellMatch match = match_cells(before.triangulation, now.triangulation);
  std::multiset<int> old(match.vanished.index.begin(), match.vanished.index.end()),
      fresh(match.appeared.index.begin(), match.appeared.index.end());
  for (int c = 0; c < now.triangulation.cells(); ++c) {
    if (match.before[to_size(c)] < 0) continue;
    old.insert(match.before[to_size(c)]);
    fresh.insert(c);
  }
  EXPECT_EQ(size_of(old), before.triangulation.cells());
  EXPECT_EQ(std::set<int>(old.begin(), old.end()).size(), old.size());
  EXPECT_EQ(size_of(fresh), now.triangulation.cells());
  EXPECT_EQ(std::set<int>(fresh.begin(), fresh.end()).size(), fresh.size());
}

TEST(CellMatch, ManyRemeshesKeepTheSumAndOverfillNothing) {
  Spheres s = random_spheres(40, 2.0, {1, 1, 1}, {true, false, true}, 4, 0.3);
  Random random(7);
  Mesh mesh_now = mesh(s);
  std::vector<double> water;  // the lower half is full
  for (std::size_t c = 0; c < mesh_now.cells.volume.size(); ++c)
    water.push_back(mesh_now.cells.centroid[c].y < 0.5 ? mesh_now.cells.void_volume[c] : 0.0);
  const double scale = sum(mesh_now.cells.void_volume);
  int remeshed = 0;
  for (int k = 0; k < 200; ++k) {
    Spheres next = s;
    shake(next, 0.003, random);
    ASSERT_EQ(turned(mesh_now, s, next), 0);
    s = next;
    // The cells bring their fluid to where the grains stand: saturation stays, what the void lost or won is booked.
    const CellGeometry old = moved(mesh_now, s);
    for (std::size_t c = 0; c < water.size(); ++c) {
      const double share = water[c] / mesh_now.cells.void_volume[c];
      water[c] = share * old.void_volume[c];
    }
    const double before = sum(water);
    Mesh next_mesh = mesh(s);
    const CellMatch match = match_cells(mesh_now.triangulation, next_mesh.triangulation);
    remeshed += match.appeared.rows() > 0;
    water = carry_over(match, water, next_mesh.cells.void_volume);
    mesh_now = std::move(next_mesh);
    EXPECT_NEAR(sum(water), before, 1e-14 * scale);
    for (std::size_t c = 0; c < water.size(); ++c) EXPECT_LE(water[c] / mesh_now.cells.void_volume[c], 1.0 + 1e-10) << k;
  }
  EXPECT_GT(remeshed, 20);
}
