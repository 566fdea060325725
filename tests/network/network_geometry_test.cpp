#include "puadem/network/network_geometry.hpp"

#include <gtest/gtest.h>

#include "puadem/base/error.hpp"
#include "puadem/base/random.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

PoreNetwork network_of(const Spheres& s, const NetworkOptions& options = {}) {
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

Spheres shaken(Spheres s, double amplitude) {
  Random random(77);
  for (std::size_t i = 0; i < s.centre.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      double& x = s.centre[i][axis];
      const double to = x + random.uniform(-amplitude, amplitude);
      if (to > s.domain.lower[axis] && to < s.domain.upper[axis]) x = to;
    }
    s.radius[i] *= 1.0 + random.uniform(-0.1, 0.1) * amplitude;
  }
  return s;
}

}  // namespace

TEST(NetworkGeometry, UpdatedInPlaceItIsThatOfANewBuild) {
  for (const std::array<bool, 3>& periodic : {std::array{false, false, false}, {true, true, true}, {true, false, false}}) {
    const Spheres before = random_spheres(200, 2.0, {1, 1, 1}, periodic, 4);
    const Spheres after = shaken(before, 1e-5);
    PoreNetwork updated = network_of(before);
    const PoreNetwork rebuilt = network_of(after);
    ASSERT_EQ(updated.triangulation.vertices, rebuilt.triangulation.vertices) << "choose a smaller displacement";
    ASSERT_EQ(updated.tetrahedron_pore, rebuilt.tetrahedron_pore);
    EXPECT_NE(updated.pore_volume, rebuilt.pore_volume);
    update_network_geometry(updated, after.centre, after.radius, after.domain, {});
    EXPECT_EQ(updated.pore_centre, rebuilt.pore_centre);
    EXPECT_EQ(updated.pore_volume, rebuilt.pore_volume);
    EXPECT_EQ(updated.pore_radius, rebuilt.pore_radius);
    EXPECT_EQ(updated.throat_normal, rebuilt.throat_normal);
    EXPECT_EQ(updated.throat_area, rebuilt.throat_area);
    EXPECT_EQ(updated.throat_facet_area, rebuilt.throat_facet_area);
    EXPECT_EQ(updated.throat_length, rebuilt.throat_length);
    EXPECT_EQ(updated.throat_conductance, rebuilt.throat_conductance);
    EXPECT_EQ(updated.throat_radius, rebuilt.throat_radius);
    EXPECT_EQ(updated.throat_entry_radius, rebuilt.throat_entry_radius);
    EXPECT_EQ(updated.throat_snap_off_radius, rebuilt.throat_snap_off_radius);
    EXPECT_EQ(updated.throat_entry_kind, rebuilt.throat_entry_kind);
    EXPECT_EQ(updated.tetrahedron_void, rebuilt.tetrahedron_void);
  }
}

TEST(NetworkGeometry, NamesAPoreThatTheGrainsHaveFilled) {
  const Spheres s = random_spheres(30, 1.5, {1, 1, 1}, {true, true, true}, 3);
  PoreNetwork network = network_of(s);
  std::vector<double> swollen = s.radius;
  for (double& r : swollen) r *= 2.5;
  try {
    update_network_geometry(network, s.centre, swollen, s.domain, {});
    FAIL();
  } catch (const NumericalError& e) {
    EXPECT_NE(std::string(e.what()).find("no void left"), std::string::npos) << e.what();
  }
}

TEST(NetworkGeometry, WallsThatHoldTheFluidLowerTheirThroatsOnly) {
  const Spheres s = random_spheres(100, 2.0, {1, 1, 1}, {false, true, true}, 6);
  NetworkOptions options;
  const PoreNetwork slip = network_of(s, options);
  options.no_slip[0] = true;  // left
  const PoreNetwork held = network_of(s, options);
  int lower = 0;
  for (int t = 0; t < slip.throats(); ++t) {
    bool at_left = false;
    for (const Vertex& v : slip.throat_vertices(t)) at_left = at_left || (v.is_wall() && v.face() == 0);
    const double g = slip.throat_conductance[to_size(t)];
    if (at_left) {
      EXPECT_LT(held.throat_conductance[to_size(t)], g);
      ++lower;
    } else {
      EXPECT_EQ(held.throat_conductance[to_size(t)], g);
    }
  }
  EXPECT_GT(lower, 10);
}
