#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "puadem/network/network_checks.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

const std::array<std::array<bool, 3>, 3> boxes{{{true, true, true}, {false, false, false}, {true, false, true}}};

PoreNetwork built(const Spheres& s, const NetworkOptions& options = {}) {
  return build_pore_network(s.centre, s.radius, s.domain, options);
}
RebuiltNetwork rebuilt(const PoreNetwork& before, const Spheres& s, const std::vector<int>& kind = {},
                       const NetworkOptions& options = {}) {
  return rebuild_pore_network(before, kind, {}, s.centre, s.radius, s.domain, options);
}

using Shift = std::array<std::int8_t, 3>;

/// Moves grains at random, back inside from walls; in periodic directions as far as they go.
Spheres shaken(Spheres s, double amplitude, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t k = 0; k < s.centre.size(); ++k)
    for (int a = 0; a < 3; ++a) {
      double& x = s.centre[k][a];
      x += amplitude * s.radius[k] * random.uniform(-1.0, 1.0);
      if (!s.domain.periodic[to_size(a)]) x = std::clamp(x, s.radius[k], s.domain.size()[a] - s.radius[k]);
    }
  return s;
}

/// Brings grains back into the periodic box; returns by how many periods.
std::vector<Shift> wrap(Spheres& s) {
  std::vector<Shift> wraps(s.centre.size());
  for (std::size_t k = 0; k < s.centre.size(); ++k)
    for (int a = 0; a < 3; ++a) {
      const double periods = std::floor(s.centre[k][a] / s.domain.size()[a]);
      if (!s.domain.periodic[to_size(a)] || periods == 0.0) continue;
      s.centre[k][a] -= periods * s.domain.size()[a];
      wraps[k][to_size(a)] = static_cast<std::int8_t>(periods);
    }
  return wraps;
}

double void_of(const PoreNetwork& n) { return std::accumulate(n.pore_volume.begin(), n.pore_volume.end(), 0.0); }

}  // namespace

TEST(Rebuild, WithoutMotionNothingChanges) {
  for (const auto& periodic : boxes)
    for (const MergeCriterion criterion : {MergeCriterion::entry_ratio, MergeCriterion::insphere_overlap}) {
      const Spheres s = random_spheres(250, 2.0, {1, 1, 1}, periodic, 11, 0.35);
      NetworkOptions options;
      options.merge_criterion = criterion;
      PoreNetwork before = built(s, options);
      ASSERT_LT(before.pores(), before.triangulation.cells());
      for (int k = 0; k < 3; ++k) {
        PoreNetwork now = rebuilt(before, s, {}, options).network;
        EXPECT_EQ(now.tetrahedron_pore, before.tetrahedron_pore);
        EXPECT_EQ(now.tetrahedron_shift, before.tetrahedron_shift);
        EXPECT_EQ(now.throat_pores, before.throat_pores);
        EXPECT_EQ(now.pore_volume, before.pore_volume);
        EXPECT_EQ(now.throat_conductance, before.throat_conductance);
        before = std::move(now);
      }
    }
}

TEST(Rebuild, ThroughThePeriodicFaceNothingChanges) {
  // All grains move by the same way, some through the faces of the box: the same units, listed elsewhere.
  Spheres s = random_spheres(250, 2.0, {1, 1, 1}, {true, true, true}, 11, 0.35);
  const PoreNetwork before = built(s);
  for (Vec3& x : s.centre) x += Vec3{0.3, -0.45, 0.2};
  const auto wraps = wrap(s);
  ASSERT_GT(std::ranges::count_if(wraps, [](const Shift& w) { return w != Shift{}; }), 50);
  const RebuiltNetwork now = rebuild_pore_network(before, {}, wraps, s.centre, s.radius, s.domain, {});
  EXPECT_EQ(now.match.appeared.rows(), 0);
  ASSERT_EQ(now.network.pores(), before.pores());
  std::vector<int> was(to_size(before.pores()), -1);
  for (int c = 0; c < now.network.triangulation.cells(); ++c) {
    int& w = was[to_size(now.network.tetrahedron_pore[to_size(c)])];
    const int old = before.tetrahedron_pore[to_size(now.match.before[to_size(c)])];
    if (w < 0) w = old;
    EXPECT_EQ(w, old);
  }
  for (int p = 0; p < now.network.pores(); ++p)
    EXPECT_NEAR(now.network.pore_volume[to_size(p)], before.pore_volume[to_size(was[to_size(p)])], 1e-15);
}

TEST(Rebuild, UnitsKeepTheirCellsUnderSmallMotion) {
  const Spheres s = random_spheres(250, 2.0, {1, 1, 1}, {true, true, true}, 12, 0.35);
  const PoreNetwork before = built(s);
  Spheres moved = shaken(s, 0.005, 1);
  const auto wraps = wrap(moved);
  const RebuiltNetwork now = rebuild_pore_network(before, {}, wraps, moved.centre, moved.radius, moved.domain, {});
  // Pairs of neighbouring cells that stay: together or apart as before, but for a few. A network built without history
  // changes its mind on many times as many.
  const auto changes = [&](const PoreNetwork& n) {
    int count = 0;
    for (int c = 0; c < n.triangulation.cells(); ++c)
      for (const auto& neighbour : n.triangulation.neighbours[to_size(c)]) {
        if (neighbour.cell < 0) continue;
        const int a = now.match.before[to_size(c)], b = now.match.before[to_size(neighbour.cell)];
        if (a < 0 || b < 0) continue;
        const bool were = before.tetrahedron_pore[to_size(a)] == before.tetrahedron_pore[to_size(b)];
        const bool are = n.tetrahedron_pore[to_size(c)] == n.tetrahedron_pore[to_size(neighbour.cell)];
        count += were != are;
      }
    return count;
  };
  const int sticky = changes(now.network), fresh = changes(built(moved));
  EXPECT_GT(fresh, 10);
  EXPECT_LT(sticky, fresh / 2);
}

TEST(Rebuild, VoidClosesAndTheNetworkIsSound) {
  for (const auto& periodic : boxes) {
    Spheres s = random_spheres(200, 2.0, {1, 1, 1}, periodic, 13, 0.35);
    PoreNetwork network = built(s);
    for (std::uint64_t k = 1; k <= 20; ++k) {
      s = shaken(s, 0.02, k);
      const auto wraps = wrap(s);
      network = rebuild_pore_network(network, {}, wraps, s.centre, s.radius, s.domain, {}).network;
      EXPECT_NEAR(void_of(network) + s.solid_volume(), s.domain.volume(), 1e-12 * s.domain.volume());
      EXPECT_TRUE(find_network_faults(network, s.centre, s.radius, s.domain).empty());
    }
  }
}

TEST(Rebuild, UnitsOfDifferentKindsStayApart) {
  const Spheres s = random_spheres(250, 2.0, {1, 1, 1}, {true, true, true}, 14, 0.35);
  const PoreNetwork before = built(s);
  std::vector<int> kind;
  for (int p = 0; p < before.pores(); ++p) kind.push_back(p % 2);
  Spheres moved = shaken(s, 0.06, 2);
  const auto wraps = wrap(moved);
  const RebuiltNetwork now = rebuild_pore_network(before, kind, wraps, moved.centre, moved.radius, moved.domain, {});
  ASSERT_GT(now.match.appeared.rows(), 0);
  // Every cell of a unit has one kind: its own, or the highest of its cavity.
  std::vector<int> cell_kind(to_size(now.network.triangulation.cells()));
  for (std::size_t c = 0; c < cell_kind.size(); ++c)
    if (const int b = now.match.before[c]; b >= 0) cell_kind[c] = kind[to_size(before.tetrahedron_pore[to_size(b)])];
  int mixed = 0;
  for (int cavity = 0; cavity < now.match.appeared.rows(); ++cavity) {
    int highest = 0, lowest = 1;
    for (const int c : now.match.vanished[cavity]) {
      highest = std::max(highest, kind[to_size(before.tetrahedron_pore[to_size(c)])]);
      lowest = std::min(lowest, kind[to_size(before.tetrahedron_pore[to_size(c)])]);
    }
    mixed += highest != lowest;
    for (const int c : now.match.appeared[cavity]) cell_kind[to_size(c)] = highest;
  }
  EXPECT_GT(mixed, 0);
  for (int p = 0; p < now.network.pores(); ++p)
    for (const int c : now.network.pore_tetrahedra[p])
      EXPECT_EQ(cell_kind[to_size(c)], cell_kind[to_size(now.network.pore_tetrahedra[p].front())]) << p;
}
