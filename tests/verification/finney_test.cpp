// The random close packing of 4,021 steel balls that Finney measured (Proc. R. Soc. A 319, 479, 1970): pores and throats of
// a real packing against a computation of their distributions that shares no code with this one.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "puadem/geometry/cell.hpp"
#include "puadem/geometry/facets.hpp"
#include "puadem/geometry/packing_sites.hpp"
#include "puadem/geometry/throat_section.hpp"

using namespace puadem;

namespace {

/// Centres of the balls; empty where the file is not there.
std::vector<Vec3> read_balls() {
  std::ifstream file(std::filesystem::path(PUADEM_DIGITISED) / "finney_packing_4021.csv");
  std::vector<Vec3> centre;
  for (std::string line; std::getline(file, line);) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream row(line);
    int id = 0;
    if (Vec3 c; row >> id >> c.x >> c.y >> c.z) centre.push_back(c);
  }
  return centre;
}

void expect_percentiles(std::vector<double> radii, const std::array<double, 7>& expected) {
  constexpr std::array percent{5, 10, 25, 50, 75, 90, 95};
  std::ranges::sort(radii);
  for (std::size_t k = 0; k < percent.size(); ++k)
    EXPECT_NEAR(radii[radii.size() * static_cast<std::size_t>(percent[k]) / 100], expected[k], 0.003) << percent[k] << " %";
}

}  // namespace

TEST(FinneyPacking, PoresAndThroatsOfTheInnerBalls) {
  const std::vector<Vec3> centre = read_balls();
  if (centre.empty()) GTEST_SKIP() << "no packing in " << PUADEM_DIGITISED;
  ASSERT_EQ(centre.size(), 4021u);
  const std::vector<double> radius(centre.size(), 1.0);
  Vec3 middle;
  Domain box{centre[0], centre[0], {false, false, false}};
  for (const Vec3& c : centre) {
    middle += c / 4021.0;
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], c[axis] - 1.5);
      box.upper[axis] = std::max(box.upper[axis], c[axis] + 1.5);
    }
  }
  const Triangulation triangulation = triangulate(centre, radius, box);
  const PackingSites sites_of(centre, radius, box);
  const auto is_inside = [&](const auto& vertices) {  // within 14 radii of the middle
    Vec3 mean;
    for (const Vertex& v : vertices) {
      if (v.is_wall()) return false;
      mean += centre[to_size(v.index)] / static_cast<double>(vertices.size());
    }
    return norm(mean - middle) < 14.0;
  };
  std::vector<double> pores, throats;
  for (const auto& vertices : triangulation.vertices)
    if (is_inside(vertices)) pores.push_back(inscribed_sphere(sites_of(vertices))->radius);
  for (const Facet& facet : find_facets(triangulation))
    if (const auto vertices = facet_vertices(triangulation, facet); is_inside(vertices))
      throats.push_back(inscribed_circle_radius(sites_of(vertices)));
  expect_percentiles(throats, {0.157, 0.1631, 0.1939, 0.2792, 0.3801, 0.4483, 0.4902});
  expect_percentiles(pores, {0.2544, 0.2746, 0.3226, 0.3818, 0.4389, 0.5019, 0.5364});
}
