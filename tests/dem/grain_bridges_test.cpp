// Liquid bridges in the grain engine against slow sums, energies and the ledger of their water.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "puadem/base/error.hpp"
#include "puadem/bridges/bridge_formulas.hpp"
#include "puadem/dem/bridge_exchange.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/bridge_pairs.hpp"
#include "puadem/dem/energy.hpp"
#include "puadem/dem/growth.hpp"
#include "puadem/dem/motion.hpp"
#include "puadem/dem/neighbour_list.hpp"
#include "puadem/dem/stress.hpp"
#include "support.hpp"

namespace puadem {
namespace {

using std::numbers::pi;

constexpr double spacing = 1e-3, gamma = 0.0728;
constexpr double infinity = std::numeric_limits<double>::infinity();

const BridgeModel& model_of(BridgeControl control) {
  static const BridgeModel suction = bridge_model(gamma, 0.2, BridgeControl::suction);
  static const BridgeModel volume = bridge_model(gamma, 0.2, BridgeControl::volume);
  return control == BridgeControl::suction ? suction : volume;
}

BridgeRules everywhere() { return {.formation = BridgeFormation::at_any_distance}; }

/// Grains on a shaken lattice, some of which touch, between walls or in a periodic box.
GrainSystem lattice(bool periodic, double speed = 0.0, int n = 5) {
  static const Material m = test::material(1e7, 0.3, 2650, 0.4);
  const Particles p = test::shaken_lattice(n, spacing, m, 7, speed);
  Domain box;
  box.upper = n * spacing * Vec3{1, 1, 1};
  box.periodic = {periodic, periodic, periodic};
  GrainSystem s = make_grain_system(p, box, std::span(&m, 1), {}, {});
  s.time_step = 2e-7;
  evaluate_forces(s);
  return s;
}

std::vector<Vec3> forces_of(const GrainSystem& s) {
  Particles p;
  p.position.resize(to_size(s.owned));
  p.velocity = p.angular_velocity = p.force = p.torque = p.position;
  collect(s, p);
  return p.force;
}

Vec3 nearest(const GrainSystem& s, Vec3 d) {
  const Vec3 size = s.domain.size();
  for (int axis = 0; axis < 3; ++axis)
    if (s.domain.periodic[to_size(axis)]) d[axis] -= size[axis] * std::round(d[axis] / size[axis]);
  return d;
}

struct SlowBridges {
  std::vector<Vec3> force;  ///< by identity
  std::vector<Vec3> wall;
  int count = 0;
};

/// All pairs one by one: bridges of one amount wherever the gap allows one.
SlowBridges slow_bridges(const GrainSystem& s, const BridgeModel& model, double amount) {
  SlowBridges slow;
  slow.force.resize(to_size(s.owned));
  slow.wall.resize(s.walls.size());
  const double scaled = model.table.control == BridgeControl::suction ? amount / gamma : amount;
  const auto pull = [&](double r, double other, double gap) {
    const BridgeCurve curve = bridge_curve(model.table, {r, other}, scaled);
    if (gap > curve.reach) return 0.0;
    ++slow.count;
    return 2.0 * pi * gamma * bridge_pull(curve, gap);
  };
  for (int a = 0; a < s.owned; ++a) {
    const GrainRecord& i = s.record[to_size(a)];
    Vec3& force = slow.force[to_size(s.identity[to_size(a)])];
    for (int b = 0; b < a; ++b) {
      const GrainRecord& j = s.record[to_size(b)];
      const Vec3 d = nearest(s, vec3(j.place - i.place));
      const Vec3 f = pull(radius_of(i), radius_of(j), norm(d) - radius_of(i) - radius_of(j)) * normalized(d);
      force += f;
      slow.force[to_size(s.identity[to_size(b)])] -= f;
    }
    for (std::size_t w = 0; w < s.walls.size(); ++w) {
      const Wall& wall = s.walls[w];
      const double gap = dot(vec3(i.place) - wall.point, wall.normal) - radius_of(i);
      const Vec3 f = pull(radius_of(i), infinity, gap) * wall.normal;
      force -= f;
      slow.wall[w] += f;
    }
  }
  return slow;
}

class EveryBox : public ::testing::TestWithParam<std::tuple<bool, BridgeControl>> {};

TEST_P(EveryBox, PullsAsTheSumOfAllPairs) {
  const auto [periodic, control] = GetParam();
  GrainSystem s = lattice(periodic);
  const double amount = control == BridgeControl::suction ? 2e3 : 4e-12;
  const std::vector<Vec3> dry = forces_of(s);
  std::vector<Vec3> dry_walls;
  for (const Wall& wall : s.walls) dry_walls.push_back(wall.force);
  const SlowBridges slow = slow_bridges(s, model_of(control), amount);
  wet_grains(s, model_of(control), everywhere(), {.suction = amount, .each = amount});
  const std::vector<Vec3> wet = forces_of(s);
  const double scale = 2.0 * pi * gamma * spacing;
  EXPECT_EQ(measure_bridges(s).bridges, slow.count);
  EXPECT_GT(slow.count, s.owned);
  for (std::size_t k = 0; k < wet.size(); ++k) EXPECT_LT(norm(wet[k] - dry[k] - slow.force[k]), 1e-12 * scale) << k;
  for (std::size_t w = 0; w < s.walls.size(); ++w)
    EXPECT_LT(norm(s.walls[w].force - dry_walls[w] - slow.wall[w]), 1e-11 * scale) << w;
}

TEST(GrainBridges, StressIsThatOfTheWorkOfAStrain) {
  // Straining a periodic box with all its grains changes the energy of the bridges by -V sigma : d(epsilon).
  for (const auto control : {BridgeControl::suction, BridgeControl::volume}) {
    const double amount = control == BridgeControl::suction ? 2e3 : 4e-12, strain = 1e-6;
    const auto energy = [&](double stretch) {
      GrainSystem s = lattice(true);
      wet_grains(s, model_of(control), everywhere(), {.suction = amount, .each = amount});
      s.domain.upper.x *= 1.0 + stretch;
      for (GrainRecord& r : s.record) r.place[0] *= 1.0 + stretch;
      s.is_evaluated = false;
      evaluate_forces(s);
      return std::pair{-bridge_energy(s), bridge_stress(s)[0].x * s.domain.volume()};
    };
    const double slope = (energy(strain).first - energy(-strain).first) / (2.0 * strain);
    const double stress = energy(0.0).second;
    EXPECT_LT(stress, 0.0);
    EXPECT_NEAR(slope, -stress, 2e-3 * std::abs(stress));
  }
}

INSTANTIATE_TEST_SUITE_P(Bridges, EveryBox,
                         ::testing::Combine(::testing::Bool(), ::testing::Values(BridgeControl::suction, BridgeControl::volume)));

/// Two grains in contact, at rest, the force of the contact balancing that of the bridge.
GrainSystem pair_at_rest(const BridgeModel& model, const BridgeSupply& supply, const std::array<double, 2>& radius) {
  static const Material m = test::material(1e8, 0.3, 2650);
  const Particles p = make_particles(std::vector<Vec3>{{0, 0, 0}, {radius[0] + radius[1] - 1e-9, 0, 0}},
                                     std::vector<double>{radius[0], radius[1]}, m);
  GrainSystem s = test::free_grains(p, m, {}, 0.1);
  s.motion.damping = 0.5;
  s.time_step = 2e-7;
  evaluate_forces(s);
  wet_grains(s, model, {}, supply);
  advance_grains(s, 4000);
  evaluate_forces(s);
  s.motion.damping = 0.0;
  return s;
}

TEST(GrainBridges, PullingAPairApartCostsTheEnergyOfItsBridge) {
  const std::array<double, 2> radius{0.5e-3, 0.8e-3};
  for (const auto control : {BridgeControl::suction, BridgeControl::volume}) {
    const BridgeModel& model = model_of(control);
    const double amount = control == BridgeControl::suction ? 3e3 : 2e-12;
    GrainSystem s = pair_at_rest(model, {.suction = amount, .each = amount}, radius);
    open_energy_book(s);
    const Energies start = energies(s);
    const BridgeCurve curve = bridge_curve(model.table, radius, control == BridgeControl::suction ? amount / gamma : amount);
    const double overlap = radius[0] + radius[1] - std::abs(s.record[1].place[0] - s.record[0].place[0]);
    const double work = gamma * (bridge_work(curve, 0.0) + 2.0 * pi * bridge_pull(curve, 0.0) * overlap);
    EXPECT_NEAR(start.bridges, -work, 1e-12 * work);
    // Fast enough to part, slow enough for many steps on the way.
    const double mass = mass_of(s.record[0]) * mass_of(s.record[1]) / (mass_of(s.record[0]) + mass_of(s.record[1]));
    const double speed = 2.0 * std::sqrt(2.0 * work / mass);
    for (GrainRecord& r : s.record)
      if (r.place[0] > 0.5e-3) r.drift[0] += speed;
    const Energies moving = energies(s);
    advance_grains(s, static_cast<long>(2.0 * curve.reach / speed / s.time_step / 50 + 1) * 50);
    evaluate_forces(s);
    const Energies end = energies(s);
    EXPECT_EQ(measure_bridges(s).bridges, 0);
    EXPECT_EQ(measure_bridges(s).ruptured, 1);
    EXPECT_EQ(end.bridges, 0.0);
    EXPECT_NEAR(moving.kinetic - end.kinetic, work - start.normal, 1e-3 * work);
  }
}

TEST(GrainBridges, EnergyOfAShakenPackingIsAccountedFor) {
  for (const auto exchange : {BridgeRules::Exchange::neighbours, BridgeRules::Exchange::films}) {
    GrainSystem s = lattice(false, 0.2);
    wet_grains(s, model_of(BridgeControl::volume), {.exchange = exchange}, {.each = 1e-12});
    open_energy_book(s);
    const Energies start = energies(s);
    advance_grains(s, 10000);
    evaluate_forces(s);
    const Energies end = energies(s);
    const BridgeMeasures m = measure_bridges(s);
    EXPECT_GT(m.formed, m.bridges);
    EXPECT_GT(m.ruptured, 10);
    EXPECT_LT(std::abs(m.water_error), 1e-14);
    EXPECT_EQ(m.bridges, m.formed - m.ruptured);
    EXPECT_GT(end.wetting, 0.0);
    const double gained = end.stored() + end.taken() - start.stored() - start.taken() - (end.input - start.input);
    EXPECT_LT(std::abs(gained), 3e-3 * start.kinetic);
  }
}

TEST(GrainBridges, SameBitsHoweverListsAreMadeAndOnAnyNumberOfThreads) {
  const auto run = [](int threads, bool rebuilds) {
    set_threads(threads);
    GrainSystem s = lattice(false, 0.05);
    wet_grains(s, model_of(BridgeControl::volume), everywhere(), {.each = 4e-12});
    for (int k = 0; k < 30; ++k) {
      advance_grains(s, 37);
      if (rebuilds) build_neighbour_list(s);
    }
    evaluate_forces(s);
    set_threads(1);
    std::vector<double> bits;
    for (const Vec3& f : forces_of(s)) bits.insert(bits.end(), {f.x, f.y, f.z});
    bits.insert(bits.end(), s.bridges->bridges.volume.begin(), s.bridges->bridges.volume.end());
    bits.insert(bits.end(), s.bridges->film.begin(), s.bridges->film.end());
    return bits;
  };
  const std::vector<double> one = run(1, false);
  EXPECT_EQ(run(2, false), one);
  EXPECT_EQ(run(1, true), one);
}

TEST(GrainBridges, ATouchShorterThanAnExchangeLeavesABridge) {
  static const Material m = test::material(1e9, 0.3, 2650);
  const Particles p = make_particles(std::vector<Vec3>{{0, 0, 0}, {0.99e-3, 0, 0}, {-1.05e-3, 0, 0}},
                                     std::vector<double>{0.5e-3, 0.5e-3, 0.5e-3}, m);
  GrainSystem s = test::free_grains(p, m, {}, 0.1);
  s.time_step = 1e-7;
  evaluate_forces(s);
  wet_grains(s, model_of(BridgeControl::suction), {}, {.suction = 500.0});
  ASSERT_EQ(measure_bridges(s).bridges, 1);
  for (int k = 0; k < 3; ++k)
    if (s.identity[to_size(k)] == 2) s.record[to_size(k)].drift[0] = 3.0;
  int touches = 0;
  for (int step = 0; step < 1000 && s.bridges->formed < 2; ++step) {
    advance_grains(s, 1);
    evaluate_forces(s);
    touches += measure(s).contacts > 1 ? 1 : 0;
  }
  EXPECT_EQ(s.bridges->formed, 2);
  EXPECT_LT(touches, 50);
}

TEST(GrainBridges, FollowGrainsThatGrow) {
  GrainSystem s = lattice(false);
  wet_grains(s, model_of(BridgeControl::volume), everywhere(), {.each = 1e-12});
  std::vector<double> radius(to_size(s.owned));
  for (int k = 0; k < s.owned; ++k) radius[to_size(s.identity[to_size(k)])] = 0.95 * radius_of(s.record[to_size(k)]);
  s.is_evaluated = false;
  set_radii(s, radius);
  evaluate_forces(s);
  const auto& b = s.bridges->bridges;
  ASSERT_GT(b.size(), 100);
  for (int k = 0; k < b.size(); ++k) {
    const std::size_t at = to_size(k);
    EXPECT_EQ(b.pairs.radius[at][0], radius[to_size(b.pairs.ends[at][0])]);
    EXPECT_EQ(b.curve[at].reach, bridge_curve(model_of(BridgeControl::volume).table, b.pairs.radius[at], b.volume[at]).reach);
  }
}

TEST(GrainBridges, APublishedFitPullsAsItsFormula) {
  const BridgeModel model = bridge_model(gamma, 0.2, BridgeControl::volume, BridgeModel::Law::willett);
  GrainSystem s = pair_at_rest(model, {.each = 2e-12}, {0.5e-3, 0.5e-3});
  const double expected = 2.0 * pi * gamma * willett_pull({0.5e-3, 0.5e-3}, 0.2, 2e-12, 0.0);
  EXPECT_NEAR(measure_bridges(s).mean_force, expected, 1e-12 * expected);
}

TEST(GrainBridges, WaterIsSharedAtOneSuction) {
  BridgePairs pairs;
  pairs.ends = {{0, 1}, {0, 2}, {1, 3}};
  pairs.radius = {{1e-3, 1e-3}, {1e-3, 0.5e-3}, {1e-3, infinity}};
  pairs.gap = {0.0, -1e-6, 0.0};
  const double total = 5e-12;
  const std::vector<double> v = shared_volume(model_of(BridgeControl::volume), pairs, total);
  EXPECT_NEAR(std::accumulate(v.begin(), v.end(), 0.0), total, 1e-15 * total);
  EXPECT_NEAR(v[1] / v[0], 2.0 / 3.0, 1e-12);  // as R*
  EXPECT_NEAR(v[2] / v[0], 2.0, 1e-12);
  pairs.gap[1] = 1e-3;
  EXPECT_EQ(shared_volume(model_of(BridgeControl::volume), pairs, total)[1], 0.0);
}

std::string error_of(const auto& call) {
  try {
    call();
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

TEST(GrainBridges, SayWhatTheyCannotDo) {
  GrainSystem s = lattice(true);
  const BridgeModel& model = model_of(BridgeControl::volume);
  EXPECT_NE(error_of([&] { wet_grains(s, model, {}, {.total = 1e-7}); }).find("give less water"), std::string::npos);
  s.domain.upper.x = 2.0 * spacing;
  EXPECT_NE(error_of([&] { wet_grains(s, model, {}, {.each = 1e-12}); }).find("periodic box"), std::string::npos);
  static const Material m = test::material(1e9, 0.3, 2650);
  GrainSystem apart = test::free_grains(
      make_particles(std::vector<Vec3>{{0, 0, 0}, {5e-3, 0, 0}}, std::vector<double>{0.5e-3, 0.5e-3}, m), m, {}, 0.1);
  apart.time_step = 1e-7;
  evaluate_forces(apart);
  EXPECT_NE(error_of([&] { wet_grains(apart, model, {}, {.each = 1e-12}); }).find("no two grains touch"), std::string::npos);
}

}  // namespace
}  // namespace puadem
