#include "puadem/geometry/power_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "puadem/base/parallel.hpp"
#include "puadem/base/random.hpp"

namespace puadem {
namespace {

struct Spheres {
  std::vector<Vec3> centre;
  std::vector<double> radius;
};

/// Random centres with radii that differ by up to eight times, overlaps allowed.
Spheres random_spheres(int count, const Domain& box, std::uint64_t seed) {
  Random random(seed);
  Spheres s;
  const double scale = 0.5 * std::cbrt(box.volume() / count);
  for (int k = 0; k < count; ++k) {
    s.radius.push_back(scale * random.uniform(0.1, 0.8));
    Vec3 x;
    for (int axis = 0; axis < 3; ++axis)
      x[axis] = random.uniform(box.lower[axis] + s.radius.back(), box.upper[axis] - s.radius.back());
    s.centre.push_back(x);
  }
  return s;
}

std::vector<double> volumes(const Spheres& s, const Domain& box) {
  return power_cell_volumes(triangulate(s.centre, s.radius, box), s.centre, s.radius, box);
}

class PowerCells : public ::testing::TestWithParam<std::array<bool, 3>> {};

TEST_P(PowerCells, TileTheBox) {
  Domain box{{-1, 0, 2}, {2, 2, 4.5}, GetParam()};
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Spheres s = random_spheres(300, box, seed);
    const std::vector<double> v = volumes(s, box);
    EXPECT_NEAR(std::accumulate(v.begin(), v.end(), 0.0), box.volume(), 1e-12 * box.volume());
  }
}

// Each volume against a count of random points whose power is the least.
TEST_P(PowerCells, AreWhereThePowerIsLeast) {
  Domain box{{0, 0, 0}, {2, 1, 1.5}, GetParam()};
  const Spheres s = random_spheres(40, box, 5);
  const std::vector<double> v = volumes(s, box);
  Random random(7);
  std::vector<double> share(s.radius.size(), 0.0);
  constexpr int points = 200'000;
  for (int k = 0; k < points; ++k) {
    const Vec3 x{random.uniform(0, 2), random.uniform(0, 1), random.uniform(0, 1.5)};
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < s.radius.size(); ++i) {
      Vec3 d = x - s.centre[i];
      for (int axis = 0; axis < 3; ++axis)
        if (box.periodic[to_size(axis)]) d[axis] -= box.size()[axis] * std::round(d[axis] / box.size()[axis]);
      const double power = squared_norm(d) - s.radius[i] * s.radius[i];
      if (power < least) {
        least = power;
        best = i;
      }
    }
    share[best] += 1.0 / points;
  }
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double exact = v[i] / box.volume();
    EXPECT_NEAR(exact, share[i], 5.0 * std::sqrt(exact / points)) << "grain " << i;  // five standard deviations
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, PowerCells,
                         ::testing::Values(std::array{false, false, false}, std::array{true, false, true},
                                           std::array{true, true, true}));

// Equal spheres on a cubic lattice, where every tie is exact: a cube each.
TEST(PowerCells, OfACubicLatticeAreCubes) {
  for (const bool periodic : {false, true}) {
    Domain box{{0, 0, 0}, {4, 4, 4}, {periodic, periodic, periodic}};
    Spheres s;
    for (int k = 0; k < 64; ++k) {
      s.centre.push_back({k % 4 + 0.5, k / 4 % 4 + 0.5, k / 16 + 0.5});
      s.radius.push_back(0.5);
    }
    for (const double v : volumes(s, box)) EXPECT_NEAR(v, 1.0, 1e-12);
  }
}

// Two spheres between two walls: the plane of equal power is where the difference of the squared tangents says.
TEST(PowerCells, OfTwoSpheresMeetAtTheRadicalPlane) {
  const Domain box{{0, 0, 0}, {3, 1, 1}, {false, false, false}};
  const Spheres s{{{0.5, 0.5, 0.5}, {2.0, 0.5, 0.5}}, {0.5, 0.2}};
  const double plane = 0.5 + (1.5 * 1.5 + 0.5 * 0.5 - 0.2 * 0.2) / (2 * 1.5);
  const std::vector<double> v = volumes(s, box);
  EXPECT_NEAR(v[0], plane, 1e-13);
  EXPECT_NEAR(v[1], 3 - plane, 1e-13);
}

}  // namespace
}  // namespace puadem
