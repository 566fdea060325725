// The neighbour search: nothing missed, and work that grows with the number of grains alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "puadem/base/error.hpp"
#include "puadem/dem/cell_grid.hpp"
#include "puadem/dem/contacts.hpp"
#include "puadem/dem/growth.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/neighbour_list.hpp"
#include "support.hpp"

namespace puadem {
namespace {

/// Random places in a cube of solid fraction 0.5; as much volume in each of four sizes from 1 to `ratio`.
std::vector<Lanes> mixture(int count, double ratio, std::uint64_t seed) {
  Random random(seed);
  std::array<double, 4> radius{}, share{};
  double shares = 0.0, volume = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    radius[k] = std::pow(ratio, static_cast<double>(k) / 3.0);
    shares += share[k] = std::pow(radius[k], -3.0);
  }
  std::vector<Lanes> place;
  for (int n = 0; n < count; ++n) {
    double pick = random.uniform() * shares;
    std::size_t k = 0;
    while (k < 3 && pick > share[k]) pick -= share[k++];
    if (n < 3) k = 3;  // the largest are there in every mixture
    place.push_back(Lanes{0, 0, 0, radius[k]});
    volume += 4.0 / 3.0 * std::numbers::pi * std::pow(radius[k], 3);
  }
  const double width = std::cbrt(2.0 * volume);
  for (Lanes& p : place)
    for (int axis = 0; axis < 3; ++axis) p[axis] = width * random.uniform();
  return place;
}

/// Distances that the search looks at, a sphere.
double looks(const SizedGrids& grids, const std::vector<Lanes>& place) {
  long sum = 0;
  for (int a = 0; a < size_of(place); ++a)
    for (int level = 0; level <= grids.level[to_size(a)]; ++level) {
      const CellGrid& g = grids.grid[to_size(level)];
      const Lanes& p = place[to_size(a)];
      const int i = g.cell_x(p[0]), j = g.cell_y(p[1]), k = g.cell_z(p[2]);
      for (int z = std::max(k - 1, 0); z <= std::min(k + 1, g.nz - 1); ++z)
        for (int y = std::max(j - 1, 0); y <= std::min(j + 1, g.ny - 1); ++y)
          for (int x = std::max(i - 1, 0); x <= std::min(i + 1, g.nx - 1); ++x) {
            const int cell = g.index(x, y, z);
            sum += g.start[to_size(cell) + 1] - g.start[to_size(cell)];
          }
    }
  return static_cast<double>(sum) / static_cast<double>(place.size());
}

TEST(NeighbourSearch, FindsWhatAllPairsFind) {
  for (const double ratio : {1.0, 5.0, 20.0}) {
    const std::vector<Lanes> place = mixture(1000, ratio, 4);
    const double margin = 0.3;
    std::set<std::pair<int, int>> found, expected;
    for_each_close_pair(make_sized_grids(place, margin), place, margin,
                        [&](int a, int b) { EXPECT_TRUE(found.insert(std::minmax(a, b)).second) << "twice"; });
    for (int a = 0; a < size_of(place); ++a)
      for (int b = a + 1; b < size_of(place); ++b) {
        const Lanes d = place[to_size(a)] - place[to_size(b)];
        const double reach = place[to_size(a)][3] + place[to_size(b)][3] + margin;
        if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach) expected.insert({a, b});
      }
    EXPECT_GT(expected.size(), 400u);
    EXPECT_EQ(found, expected) << ratio;
  }
}

TEST(NeighbourSearch, LooksAtAsManyPairsAGrainHoweverManyThereAre) {
  for (const double ratio : {1.0, 5.0, 20.0}) {
    const auto looks_of = [&](int count) {
      const std::vector<Lanes> place = mixture(count, ratio, 5);
      return looks(make_sized_grids(place, 0.2), place);
    };
    for (const int count : {1000, 8000, 64000}) EXPECT_LT(looks_of(count), 80.0) << ratio << ", " << count;
  }
}

// Fast grains ask for a wide skin; it must not fill the lists of the small ones.
TEST(NeighbourList, StaysShortWhereSmallGrainsFlyAmongLargeOnes) {
  const std::vector<Lanes> place = mixture(4000, 20.0, 6);
  std::vector<Vec3> position;
  std::vector<double> radius;
  double width = 0.0;
  for (const Lanes& p : place) {
    position.push_back(vec3(p));
    radius.push_back(p[3]);
    width = std::max({width, p[0], p[1], p[2]});
  }
  const Material m = test::material(1.0, 0.3, 1e6);
  Particles p = make_particles(position, radius, m);
  Random random(8);
  for (Vec3& v : p.velocity) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  Domain box;
  box.upper = width * Vec3{1, 1, 1};
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), {}, {});
  s.time_step = 0.02;
  for (int step = 0; step < 600; ++step) {
    evaluate_forces(s);
    move_grains(s);
  }
  EXPECT_GT(s.list_builds, 10);
  EXPECT_LE(s.skin, 1.0);  // smallest radius
  EXPECT_LT(lane_count * s.grain_contacts.size(), 4 * s.owned);
}

int contacts_by_brute_force(const GrainSystem& s) {
  const Vec3 size = s.domain.size();
  int count = 0;
  for (int i = 0; i < s.owned; ++i)
    for (int j = i + 1; j < s.owned; ++j) {
      const GrainRecord &a = s.record[to_size(i)], &b = s.record[to_size(j)];
      Vec3 d = vec3(b.place) - vec3(a.place);
      for (int axis = 0; axis < 3; ++axis)
        if (s.domain.periodic[to_size(axis)]) d[axis] -= size[axis] * std::round(d[axis] / size[axis]);
      if (norm(d) < radius_of(a) + radius_of(b)) ++count;
    }
  for (const GrainRecord& r : std::span(s.record).first(to_size(s.owned)))
    for (const Wall& wall : s.walls)
      if (dot(vec3(r.place) - wall.point, wall.normal) < radius_of(r)) ++count;
  return count;
}

TEST(NeighbourList, MissesNothingWhileGrainsGrow) {
  const double spacing = 1e-3;
  const Material m = test::material(1e6, 0.3, 2650);
  Particles p = test::shaken_lattice(7, spacing, m, 12, 0.01);
  for (double& r : p.radius) r *= 0.7;
  Domain box;
  box.upper = 7 * spacing * Vec3{1, 1, 1};
  box.periodic = {true, false, true};
  MotionOptions motion;
  motion.damping = 0.5;
  GrainSystem s = make_grain_system(make_particles(p.position, p.radius, m), box, std::span(&m, 1), {}, motion);
  s.time_step = 1e-6;
  std::vector<double> radius = p.radius;
  int first = 0, last = 0;
  for (int step = 0; step < 400; ++step) {
    evaluate_forces(s);
    last = size_of(contacts_of(s));
    if (step == 0) first = last;
    if (step % 5 == 0) {
      ASSERT_EQ(last, contacts_by_brute_force(s)) << step;
    }
    move_grains(s);
    for (std::size_t k = 0; k < radius.size(); ++k) radius[k] *= 1.0 + 1e-3 * static_cast<double>(k % 3 + 1) / 2;
    set_radii(s, radius);
  }
  EXPECT_LT(first, 20);
  EXPECT_GT(last, 700);
  EXPECT_LT(s.list_builds, 300);
}

TEST(Growth, KeepsTheDensity) {
  const Material m = test::material(1e6, 0.3, 2650);
  GrainSystem s = test::free_grains(
      make_particles(std::vector<Vec3>{{0, 0, 0}, {5e-3, 0, 0}}, std::vector<double>{1e-3, 2e-3}, m), m, {}, 0.1);
  set_radii(s, std::vector<double>{1.5e-3, 2e-3});
  const double mass = 4.0 / 3.0 * std::numbers::pi * std::pow(1.5e-3, 3) * 2650;
  EXPECT_NEAR(mass_of(s.record[0]), mass, 1e-12 * mass);
  EXPECT_NEAR(inertia_of(s.record[0]), 0.4 * mass * 1.5e-3 * 1.5e-3, 1e-12 * mass * 1e-6);
  EXPECT_THROW(set_radii(s, std::vector<double>{1e-3}), InputError);
  EXPECT_THROW(set_radii(s, std::vector<double>{1e-3, -1e-3}), InputError);
}

}  // namespace
}  // namespace puadem
