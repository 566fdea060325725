// Voids of many cells at once against those of one after the other.
#include "puadem/geometry/cell_voids.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/random.hpp"
#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/cell_match.hpp"
#include "support/packings.hpp"

namespace puadem {
namespace {

TEST(VectorAngles, AreThoseOfTheLibrary) {
  std::vector<double> y{0, 0, 0, 1, 1e-300, 1, 1, 1e200}, x{0, 1, -1, 0, 1, 1, -1, -1e-200};
  Random random(3);
  for (int k = 0; k < 20000; ++k) {
    const double angle = random.uniform(0.0, 3.14159), length = std::exp(random.uniform(-50.0, 50.0));
    y.push_back(length * std::sin(angle));
    x.push_back(length * std::cos(angle));
  }
  std::vector<double> angle(y.size());
  vector_angles(y, x, angle);
  for (std::size_t k = 0; k < y.size(); ++k)
    EXPECT_NEAR(angle[k], std::atan2(y[k], x[k]), 9e-16 * std::atan2(y[k], x[k])) << y[k] << ", " << x[k];
}

TEST(CellVoids, AreThoseOfOneCellAfterTheOther) {
  for (const std::array<bool, 3> periodic :
       {std::array{true, true, true}, std::array{true, true, false}, std::array{false, false, false}}) {
    testing::Spheres s = testing::random_spheres(300, 2.0, {1, 1.2, 0.9}, periodic, 4, 0.33);
    const Triangulation t = triangulate(s.centre, s.radius, s.domain);
    Random random(1);
    for (Vec3& x : s.centre)  // far enough that some cells turn inside out
      for (int axis = 0; axis < 3; ++axis) x[axis] += random.uniform(-0.03, 0.03);
    const PackingSites sites(s.centre, s.radius, s.domain);
    const CellVoids all = cell_voids(t, sites);
    EXPECT_EQ(all.orientation, cell_orientations(t, sites));
    for (int c = 0; c < t.cells(); ++c) {
      const auto of_cell = sites(t.vertices[to_size(c)]);
      double scale = cell_volume(of_cell);
      for (const Site& site : of_cell) scale += site.is_wall ? 0.0 : std::pow(site.radius, 3);
      EXPECT_NEAR(all.space[to_size(c)], cell_void_volume(of_cell), 1e-14 * scale);
    }
  }
}

}  // namespace
}  // namespace puadem
