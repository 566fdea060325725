#include "puadem/network/pore_network.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

PoreNetwork network_of(const Spheres& s, const NetworkOptions& options = {}) {
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

NetworkOptions unmerged() { return {MayerStowePrincen{}, 0.0, std::numeric_limits<double>::infinity(), 20}; }

std::vector<double> sorted(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double relative) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], relative * std::abs(b[i])) << i;
}

}  // namespace

TEST(PoreNetwork, FaceCentredCubic) {
  // Per sphere two tetrahedral pores and one octahedral hole; the hole comes as four tetrahedra.
  const PoreNetwork n = network_of(face_centred(1.0, 3), unmerged());
  const int spheres = 4 * 27;
  EXPECT_EQ(n.pores(), spheres * 6);
  const std::vector<double> volume = sorted(n.pore_volume);
  for (int k = 0; k < 2 * spheres; ++k) EXPECT_NEAR(volume[to_size(k)], 0.20776, 0.6e-5);
  for (int k = 2 * spheres; k < 6 * spheres; ++k) EXPECT_NEAR(volume[to_size(k)], 1.05254 / 4, 0.6e-5);
  // All facets of a tetrahedral pore are touching triples.
  int triples = 0;
  for (int t = 0; t < n.throats(); ++t)
    if (std::abs(n.throat_facet_area[to_size(t)] - std::sqrt(3.0)) < 1e-12) {
      ++triples;
      EXPECT_NEAR(n.throat_area[to_size(t)], 0.161254, 0.6e-6);
      EXPECT_NEAR(n.throat_length[to_size(t)], 1.224745, 0.6e-6);
      EXPECT_NEAR(1.0 / n.throat_entry_radius[to_size(t)], 11.3198, 0.6e-4);
    }
  EXPECT_EQ(triples, 8 * spheres);
}

TEST(PoreNetwork, BodyCentredCubic) {
  const PoreNetwork n = network_of(body_centred(1.0, 3), unmerged());
  EXPECT_EQ(n.pores(), 2 * 27 * 6);
  for (const double v : n.pore_volume) EXPECT_NEAR(v, 0.328269, 0.6e-6);
  for (int t = 0; t < n.throats(); ++t) {
    EXPECT_NEAR(n.throat_area[to_size(t)], 0.314822, 0.6e-6);
    EXPECT_NEAR(n.throat_length[to_size(t)], std::sqrt(6.0) / 3, 1e-12);
    EXPECT_NEAR(n.throat_radius[to_size(t)], 0.224745, 0.6e-6);
    EXPECT_EQ(n.throat_entry_kind[to_size(t)], EntryKind::half_gap);
    EXPECT_NEAR(n.throat_entry_radius[to_size(t)], 0.154701, 0.6e-6);
  }
}

TEST(PoreNetwork, SimpleCubicMergesToItsCubes) {
  // The cells of a cube meet over throats wider than the square windows of the lattice, which stay.
  NetworkOptions options;
  options.entry_law = Haines{};
  options.merge_ratio = 0.5;
  const PoreNetwork n = network_of(simple_cubic(1.0, 3), options);
  EXPECT_EQ(n.pores(), 27);
  for (const double v : n.pore_volume) EXPECT_NEAR(v, 8 - 4 * std::numbers::pi / 3, 1e-12);
  EXPECT_EQ(n.throats(), 27 * 3 * 2);  // each window is two facets, kept as parallel throats
  for (const int f : n.pore_faces) EXPECT_EQ(f, 12);
}

TEST(PoreNetwork, DescribesEveryThroatConsistently) {
  const Spheres s = random_spheres(200, 2.0, {1, 1, 1}, {true, false, true}, 4);
  const PoreNetwork n = network_of(s);
  std::vector<int> seen(to_size(n.throats()), 0);
  for (int p = 0; p < n.pores(); ++p)
    for (const int t : n.pore_throats[p]) {
      EXPECT_TRUE(n.throat_pores[to_size(t)][0] == p || n.throat_pores[to_size(t)][1] == p);
      ++seen[to_size(t)];
    }
  const Vec3 period = s.domain.size();
  int backwards = 0;
  for (int t = 0; t < n.throats(); ++t) {
    const auto [i, j] = n.throat_pores[to_size(t)];
    EXPECT_LE(i, j);
    EXPECT_EQ(seen[to_size(t)], i == j ? 1 : 2);
    EXPECT_NEAR(norm(n.throat_normal[to_size(t)]), 1.0, 1e-14);
    EXPECT_LE(n.throat_area[to_size(t)], n.throat_facet_area[to_size(t)]);
    EXPECT_LE(n.throat_entry_radius[to_size(t)], n.throat_radius[to_size(t)] * (1 + 1e-12));
    const auto& shift = n.throat_shift[to_size(t)];
    EXPECT_EQ(shift[1], 0);  // walls along y
    const Vec3 across = n.pore_centre[to_size(j)] + Vec3{shift[0] * period.x, shift[1] * period.y, shift[2] * period.z} -
                        n.pore_centre[to_size(i)];
    backwards += dot(across, n.throat_normal[to_size(t)]) < 0;
    EXPECT_LT(norm(across), 1.0);
  }
  EXPECT_LT(backwards, n.throats() / 20);  // a merged unit may wrap around a throat, seldom
}

TEST(PoreNetwork, FacetsOfAPoreAreClosedSurfaces) {
  // The area vectors of all facets around a pore, walls included, add to zero.
  const Spheres s = random_spheres(150, 2.0, {1, 1, 1}, {true, true, true}, 8);
  const PoreNetwork n = network_of(s);
  std::vector<Vec3> sum(to_size(n.pores()));
  std::vector<double> size(to_size(n.pores()), 0.0);
  for (int t = 0; t < n.throats(); ++t) {
    const auto [i, j] = n.throat_pores[to_size(t)];
    const Vec3 a = n.throat_facet_area[to_size(t)] * n.throat_normal[to_size(t)];
    sum[to_size(i)] += a;
    sum[to_size(j)] -= a;
    size[to_size(i)] += norm(a);
    size[to_size(j)] += norm(a);
  }
  for (int p = 0; p < n.pores(); ++p) EXPECT_LT(norm(sum[to_size(p)]), 1e-12 * size[to_size(p)]);
}

TEST(PoreNetwork, WallPoresTouchTheirWalls) {
  const Spheres s = random_spheres(200, 2.0, {1, 1, 1}, {false, false, false}, 4);
  const PoreNetwork n = network_of(s);
  std::array<int, 6> at{};
  for (const auto walls : n.pore_walls)
    for (int f = 0; f < 6; ++f) at[to_size(f)] += walls >> f & 1;
  for (const int count : at) EXPECT_GT(count, 10);
  int wall_throats = 0;
  for (int t = 0; t < n.throats(); ++t) {
    int walls = 0;
    for (const Vertex& v : n.throat_vertices(t)) walls += v.is_wall();
    EXPECT_EQ(n.throat_at_wall[to_size(t)], walls > 0 ? 1 : 0) << t;
    wall_throats += walls > 0;
  }
  EXPECT_GT(wall_throats, 200);
}

TEST(PoreNetwork, DoesNotDependOnThreadsOrGrainOrder) {
  const Spheres s = random_spheres(300, 2.5, {1, 1, 1}, {false, true, false}, 12);
  set_threads(1);
  const PoreNetwork one = network_of(s);
  set_threads(2);
  const PoreNetwork two = network_of(s);
  set_threads(0);
  EXPECT_EQ(one.pore_volume, two.pore_volume);
  EXPECT_EQ(one.throat_entry_radius, two.throat_entry_radius);
  EXPECT_EQ(one.throat_pores, two.throat_pores);

  Spheres reversed = s;
  std::reverse(reversed.centre.begin(), reversed.centre.end());
  std::reverse(reversed.radius.begin(), reversed.radius.end());
  const PoreNetwork other = network_of(reversed);
  expect_near(sorted(other.pore_volume), sorted(one.pore_volume), 1e-10);
  expect_near(sorted(other.throat_entry_radius), sorted(one.throat_entry_radius), 1e-9);
}

TEST(PoreNetwork, ScalesWithUnitsAndMoves) {
  const Spheres s = random_spheres(200, 2.0, {1, 1, 1}, {true, false, false}, 21);
  const PoreNetwork reference = network_of(s);
  Spheres moved = s;
  const double scale = 1e-3;
  for (std::size_t i = 0; i < s.radius.size(); ++i) {
    moved.centre[i] = scale * (s.centre[i] + Vec3{3, -2, 5});
    moved.radius[i] *= scale;
  }
  moved.domain.lower = scale * Vec3{3, -2, 5};
  moved.domain.upper = scale * Vec3{4, -1, 6};
  const PoreNetwork n = network_of(moved);
  ASSERT_EQ(n.pores(), reference.pores());
  for (int p = 0; p < n.pores(); ++p) EXPECT_NEAR(n.pore_volume[to_size(p)] / 1e-9, reference.pore_volume[to_size(p)], 1e-9);
  for (int t = 0; t < n.throats(); ++t)
    EXPECT_NEAR(n.throat_entry_radius[to_size(t)] / scale, reference.throat_entry_radius[to_size(t)], 1e-9);
}

TEST(PoreNetwork, RejectsWhatIsNotAPacking) {
  const Domain box{{0, 0, 0}, {1, 1, 1}, {false, false, false}};
  const auto message = [&](std::vector<Vec3> c, std::vector<double> r) -> std::string {
    try {
      build_pore_network(c, r, box, {});
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message({}, {}).find("at least one grain"), std::string::npos);
  EXPECT_NE(message({{0.5, 0.5, 1.5}}, {0.1}).find("outside the box"), std::string::npos);
  EXPECT_NE(message({{0.5, 0.5, 0.5}}, {-0.1}).find("must be positive"), std::string::npos);
  EXPECT_NE(message({{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.2, 0.2, 0.2}}, {0.1, 0.1, 0.1}).find("hidden"), std::string::npos);
  EXPECT_NE(message({{0.5, 0.5, 0.5}, {0.51, 0.5, 0.5}}, {0.4, 0.01}).find("grain 1"), std::string::npos);
}

// The spheres in the cells of one hole of a lattice coincide, those of neighbouring holes do not meet.
TEST(PoreNetwork, OverlappingInspheresMakeTheHolesOfLattices) {
  NetworkOptions options;
  options.merge_criterion = MergeCriterion::insphere_overlap;
  const PoreNetwork cubes = network_of(simple_cubic(1.0, 3), options);
  EXPECT_EQ(cubes.pores(), 27);
  for (const double v : cubes.pore_volume) EXPECT_NEAR(v, 8 - 4 * std::numbers::pi / 3, 1e-12);
  const PoreNetwork holes = network_of(face_centred(1.0, 2), options);
  EXPECT_EQ(holes.pores(), 4 * 8 * 3);  // per sphere two tetrahedra and one octahedron
  EXPECT_NEAR(sorted(holes.pore_volume).back(), 1.05254, 0.6e-5);
}

TEST(PoreNetwork, ASquareWindowIsEnteredAsAWhole) {
  NetworkOptions options;
  options.merge_criterion = MergeCriterion::insphere_overlap;
  for (const std::array<bool, 3>& periodic : {std::array{true, true, true}, {false, false, false}}) {
    const Spheres s = simple_cubic(1.0, 3, periodic);
    options.throat_section = ThroatOutline::facet;
    const PoreNetwork facets = network_of(s, options);
    options.throat_section = ThroatOutline::window;
    const PoreNetwork windows = network_of(s, options);
    ASSERT_EQ(windows.throat_pores, facets.throat_pores);
    int squares = 0;
    for (int t = 0; t < windows.throats(); ++t) {
      if (windows.throat_at_wall[to_size(t)]) continue;
      ++squares;
      EXPECT_NEAR(1.0 / facets.throat_entry_radius[to_size(t)], 2.41421, 0.6e-5);
      EXPECT_NEAR(1.0 / windows.throat_entry_radius[to_size(t)], 4.49244, 0.6e-5);
      EXPECT_EQ(windows.throat_entry_kind[to_size(t)], EntryKind::meniscus);
      EXPECT_NEAR(windows.throat_radius[to_size(t)], std::sqrt(2.0) - 1, 1e-12);
      EXPECT_NEAR(windows.throat_snap_off_radius[to_size(t)], std::sqrt(2.0) - 1, 1e-12);
    }
    EXPECT_EQ(facets.windows, 0);
    if (periodic[0]) {
      EXPECT_EQ(windows.windows, 27 * 3);
    }
    EXPECT_EQ(squares, periodic[0] ? 27 * 3 * 2 : 2 * 2 * 3 * 3 * 2);
  }
}

TEST(PoreNetwork, ThroatsOfOneWindowShareItsRadii) {
  const Spheres s = random_spheres(200, 2.0, {1, 1, 1}, {true, false, true}, 14, 0.35);
  NetworkOptions options;
  const PoreNetwork facets = network_of(s, options);
  options.throat_section = ThroatOutline::window;
  const PoreNetwork windows = network_of(s, options);
  int changed = 0;
  for (int t = 0; t < facets.throats(); ++t) {
    const double entry = windows.throat_entry_radius[to_size(t)];
    if (entry == facets.throat_entry_radius[to_size(t)]) continue;
    ++changed;
    EXPECT_GT(entry, 0.0);
    int sharing = 0;
    for (const int other : windows.pore_throats[windows.throat_pores[to_size(t)][0]])
      sharing += windows.throat_pores[to_size(other)] == windows.throat_pores[to_size(t)] &&
                 windows.throat_entry_radius[to_size(other)] == entry &&
                 windows.throat_snap_off_radius[to_size(other)] == windows.throat_snap_off_radius[to_size(t)];
    EXPECT_GE(sharing, 2);
  }
  EXPECT_GT(changed, 10);
  EXPECT_LT(changed, facets.throats() / 2);
}
