#include "puadem/network/merging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "puadem/network/pore_shape.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

struct Problem {
  int cells = 0;
  std::vector<Facet> facets;
  std::vector<double> cell_void, wide, area;
  std::vector<int> cell_faces;
};

/// The merging problem of a random packing.
Problem problem_of(int count, std::uint64_t seed, std::array<bool, 3> periodic = {false, false, false}) {
  const Spheres s = random_spheres(count, 2.0, {1, 1, 1}, periodic, seed, 0.3);
  const PoreNetwork n = build_pore_network(s.centre, s.radius, s.domain, {MayerStowePrincen{}, 0.0, 1e300, 20});
  Problem p;
  p.cells = n.triangulation.cells();
  EXPECT_EQ(n.pores(), p.cells);  // no cell of this packing is nil, so pores are cells
  p.facets = find_facets(n.triangulation);
  p.cell_void = n.pore_volume;
  p.cell_faces = n.pore_faces;
  for (const double r : n.throat_entry_radius) p.wide.push_back(2 * r);
  p.area = n.throat_area;
  return p;
}

/// The same rule, straight from its words: in each round look at every facet of every unit, merge all
/// pairs whose worst facet is the worst of both, until there is none. For units that do not reach their own images.
std::vector<int> brute_force(const Problem& p, const MergeOptions& options) {
  std::vector<int> unit(static_cast<std::size_t>(p.cells));
  std::iota(unit.begin(), unit.end(), 0);
  for (;;) {
    std::map<int, double> volume;
    std::map<int, int> cells, faces;
    for (int c = 0; c < p.cells; ++c) {
      volume[unit[to_size(c)]] += p.cell_void[to_size(c)];
      ++cells[unit[to_size(c)]];
      faces[unit[to_size(c)]] += p.cell_faces[to_size(c)];
    }
    for (const Facet& f : p.facets)
      if (unit[to_size(f.cell)] == unit[to_size(f.neighbour)]) faces[unit[to_size(f.cell)]] -= 2;
    const auto radius = [&](int u) { return inscribed_radius_coefficient(faces[u], options.shape) * std::cbrt(volume[u]); };
    std::map<int, std::pair<float, int>> worst;  // unit -> ratio, facet; larger areas win ties
    for (int f = 0; f < size_of(p.facets); ++f) {
      const int a = unit[to_size(p.facets[to_size(f)].cell)], b = unit[to_size(p.facets[to_size(f)].neighbour)];
      if (a == b || cells[a] + cells[b] > options.limit) continue;
      const double exact = options.rank.empty() ? p.wide[to_size(f)] / std::min(radius(a), radius(b)) : options.rank[to_size(f)];
      if (exact <= options.ratio) continue;
      const auto ratio = static_cast<float>(exact);
      for (const int u : {a, b})
        if (!worst.contains(u) || ratio > worst[u].first ||
            (ratio == worst[u].first && p.area[to_size(f)] > p.area[to_size(worst[u].second)]))
          worst[u] = {ratio, f};
    }
    std::vector<std::pair<int, int>> pairs;
    for (const auto& [u, w] : worst) {
      const Facet& f = p.facets[to_size(w.second)];
      const int a = unit[to_size(f.cell)], b = unit[to_size(f.neighbour)];
      if (u == std::min(a, b) && worst[a].second == w.second && worst[b].second == w.second)
        pairs.emplace_back(std::minmax(a, b));
    }
    if (pairs.empty()) return unit;
    for (const auto& [keep, gone] : pairs)
      for (int& x : unit)
        if (x == gone) x = keep;
  }
}

bool same_partition(const std::vector<int>& a, const std::vector<int>& b) {
  std::map<int, int> forth, back;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (forth.emplace(a[i], b[i]).first->second != b[i]) return false;
    if (back.emplace(b[i], a[i]).first->second != a[i]) return false;
  }
  return true;
}

}  // namespace

TEST(Merging, EqualsBruteForce) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Problem p = problem_of(60, seed);
    for (const MergeOptions options : {MergeOptions{0.9, 20, PoreShape::faces, {}}, MergeOptions{0.7, 6, PoreShape::faces, {}},
                                       MergeOptions{0.5, 40, PoreShape::faces, {}}}) {
      const MergedCells fast = merge_cells(p.cells, p.facets, p.cell_void, p.cell_faces, p.wide, p.area, options);
      EXPECT_TRUE(same_partition(fast.unit, brute_force(p, options))) << "seed " << seed;
      EXPECT_LT(fast.units, p.cells);
    }
  }
}

TEST(Merging, EqualsBruteForceByVerticesByRankAndInPeriodicBoxes) {
  for (const std::array<bool, 3>& periodic : {std::array{false, false, false}, {true, true, true}})
    for (std::uint64_t seed = 11; seed <= 12; ++seed) {
      const Problem p = problem_of(80, seed, periodic);
      std::vector<double> rank = p.area;  // any number a facet has
      for (double& r : rank) r = r / p.area[0] - 1.0;
      for (const MergeOptions& options :
           {MergeOptions{0.8, 20, PoreShape::vertices, {}}, MergeOptions{0.0, 12, PoreShape::faces, rank}}) {
        const MergedCells fast = merge_cells(p.cells, p.facets, p.cell_void, p.cell_faces, p.wide, p.area, options);
        EXPECT_TRUE(same_partition(fast.unit, brute_force(p, options))) << "seed " << seed;
        EXPECT_LT(fast.units, p.cells);
      }
    }
}

TEST(Merging, LeavesNoThroatWiderThanAllowedUnlessTheUnitIsFull) {
  const Problem p = problem_of(200, 9);
  const MergeOptions options{};
  const MergedCells m = merge_cells(p.cells, p.facets, p.cell_void, p.cell_faces, p.wide, p.area, options);
  std::vector<double> volume(to_size(m.units));
  std::vector<int> cells(to_size(m.units)), faces(to_size(m.units));
  for (int c = 0; c < p.cells; ++c) {
    volume[to_size(m.unit[to_size(c)])] += p.cell_void[to_size(c)];
    ++cells[to_size(m.unit[to_size(c)])];
    faces[to_size(m.unit[to_size(c)])] += p.cell_faces[to_size(c)];
  }
  for (const Facet& f : p.facets)
    if (m.unit[to_size(f.cell)] == m.unit[to_size(f.neighbour)]) faces[to_size(m.unit[to_size(f.cell)])] -= 2;
  for (int f = 0; f < size_of(p.facets); ++f) {
    const auto a = to_size(m.unit[to_size(p.facets[to_size(f)].cell)]),
               b = to_size(m.unit[to_size(p.facets[to_size(f)].neighbour)]);
    if (a == b || cells[a] + cells[b] > options.limit) continue;
    const auto radius = [&](std::size_t u) { return inscribed_radius_coefficient(faces[u]) * std::cbrt(volume[u]); };
    EXPECT_LE(p.wide[to_size(f)] / std::min(radius(a), radius(b)), options.ratio);
  }
}

TEST(Merging, NilCellsJoinANeighbourEvenWithoutMerging) {
  // Three cells in a row, the middle one flat: it goes with the wider of its two throats.
  const std::vector<Facet> facets{{0, 1, {}, 0}, {1, 2, {}, 0}};
  const std::vector<double> space{1.0, -1e-18, 1.0}, wide{0.1, 0.2};
  const std::vector<int> faces{4, 4, 4};
  const MergedCells m = merge_cells(3, facets, space, faces, wide, wide, {std::numeric_limits<double>::infinity(), 1, {}, {}});
  EXPECT_EQ(m.units, 2);
  EXPECT_EQ(m.forced, 1);
  EXPECT_EQ(m.unit, (std::vector<int>{0, 1, 1}));
}

TEST(Merging, KeepsTrackOfPeriodicImages) {
  // Two cells around a ring of one period: they merge over the first facet, the second leads to the
  // unit's own image and stays.
  const std::vector<Facet> facets{{0, 1, {}, 0}, {0, 1, {-1, 0, 0}, 1}};
  const std::vector<double> space{1.0, 1.0}, wide{3.0, 2.9};
  const std::vector<int> faces{2, 2};
  const MergedCells m = merge_cells(2, facets, space, faces, wide, wide, {});
  EXPECT_EQ(m.units, 1);
  EXPECT_EQ(m.cell_shift[0], m.cell_shift[1]);
}

TEST(Merging, LeavesNoPoreBetweenOppositeWalls) {
  // All would merge: two cells at one wall, two at the other, one between them.
  const std::vector<Facet> facets{{0, 1, {}, 0}, {1, 2, {}, 0}, {2, 3, {}, 0}, {3, 4, {}, 0}};
  const std::vector<double> space(5, 1.0), wide(4, 9.0), area{4.0, 3.0, 2.0, 1.0};
  const std::vector<int> faces(5, 4);
  const std::vector<std::uint8_t> walls{1u << 4, 1u << 4 | 1u << 0, 0, 1u << 5, 1u << 5 | 1u << 0};
  MergeOptions options;
  EXPECT_EQ(merge_cells(5, facets, space, faces, wide, area, options).units, 1);
  options.walls = walls;
  EXPECT_EQ(merge_cells(5, facets, space, faces, wide, area, options).unit, (std::vector<int>{0, 0, 0, 1, 1}));
}

TEST(Merging, KeepsTheFacesOfALowBoxApart) {
  NetworkOptions options;
  options.merge_ratio = 0.2;
  options.merge_limit = 1000;
  const Spheres s = random_spheres(60, 2.0, {4, 4, 1.2}, {true, true, false}, 3, 0.35);
  const PoreNetwork n = build_pore_network(s.centre, s.radius, s.domain, options);
  EXPECT_LT(n.pores(), n.triangulation.cells() / 4);
  for (const std::uint8_t walls : n.pore_walls) EXPECT_NE(walls >> 4 & 3u, 3u);
  const RebuiltNetwork again = rebuild_pore_network(n, {}, {}, s.centre, s.radius, s.domain, options);
  EXPECT_EQ(again.network.tetrahedron_pore, n.tetrahedron_pore);
}

TEST(PoreShape, RegularPolyhedra) {
  const std::map<int, double> expected{{4, 0.4163}, {6, 0.5}, {8, 0.5246}, {12, 0.5648}, {20, 0.5827}};
  for (const auto& [faces, coefficient] : expected)
    EXPECT_NEAR(inscribed_radius_coefficient(faces), coefficient, 0.6e-4) << faces;
  for (int n = 4; n < 200; ++n) EXPECT_LE(inscribed_radius_coefficient(n), inscribed_radius_coefficient(n + 1));
  EXPECT_LE(inscribed_radius_coefficient(100000), 0.605);
}

TEST(PoreShape, ByVertices) {
  // Published line: 0.0893 ln n_v + 0.326 (Sweijen et al. 2018).
  for (const int vertices : {4, 6, 8, 12, 20})
    EXPECT_NEAR(inscribed_radius_coefficient(2 * (vertices - 2), PoreShape::vertices), 0.0893 * std::log(vertices) + 0.326,
                1.5e-4);
  EXPECT_LE(inscribed_radius_coefficient(100000, PoreShape::vertices), 0.605);
}
