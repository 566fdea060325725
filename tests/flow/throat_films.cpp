// Corner films of the throat between three touching spheres, in closed form.
#include "puadem/flow/throat_films.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace puadem {
namespace {

TEST(ThroatFilms, ThreeTouchingSpheres) {
  // A meniscus of radius r stands between two spheres of radius 1 at the angle alpha = acos(1 / (1 + r)) of each; behind it lies
  // the triangle of the two centres and its own, less three sectors.
  const auto wetting = [](double r) {
    const double alpha = std::acos(1.0 / (1.0 + r)), opening = std::numbers::pi - 2.0 * alpha;
    const double area = 3.0 * (std::tan(alpha) - alpha - 0.5 * r * r * opening);
    const double whole = std::sqrt(3.0) - std::numbers::pi / 2.0;
    return std::pow(area / whole, 3) * std::pow(std::numbers::pi / (6.0 * alpha), 2);
  };
  const double entry = 0.0883408;  // of Mayer, Stowe and Princen
  PoreNetwork network;
  network.throat_pores = {{0, 1}};
  network.throat_entry_radius = {entry};
  network.triangulation.vertices = {{Vertex{0, {}}, Vertex{1, {}}, Vertex{2, {}}, Vertex{3, {}}}};
  network.throat_facet = {{0, 0, {}, 3}};
  const std::vector<Vec3> centre{{2, 2, 2}, {4, 2, 2}, {3, 2 + std::sqrt(3.0), 2}};
  const std::vector<double> radius{1, 1, 1};
  const Domain box{{0, 0, 0}, {8, 8, 8}, {}};
  const ThroatFilms films = throat_films(network, PackingSites(centre, radius, box), 0.0);
  EXPECT_EQ(films.without_menisci, 0);
  EXPECT_NEAR(films.wetting_at_entry[0] / wetting(entry), 1.0, 1e-9);
  EXPECT_NEAR(films.wetting_at_entry[0] * std::pow(1.0 / 3.0, films.exponent[0]) / wetting(entry / 3.0), 1.0, 1e-9);
  EXPECT_NEAR(films.exponent[0], 3.0, 0.3);
  EXPECT_GT(films.nonwetting[0], 0.5);
  EXPECT_LE(films.nonwetting[0], 1.0);
}

}  // namespace
}  // namespace puadem
