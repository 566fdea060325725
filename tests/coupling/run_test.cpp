#include "puadem/coupling/run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "puadem/base/error.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

Case small_case() {
  Case c;
  c.seed = 3;
  c.materials = {Material{}};
  c.grains.count = 200;
  c.grains.material = c.materials[0].name;
  c.grains.grading = {Grading::By::mass, {{0.6e-3, 0.6e-3, 0.35}, {0.85e-3, 0.85e-3, 0.35}, {1.0e-3, 1.4e-3, 0.30}}};
  CompactStage compact;
  compact.unbalanced = 5e-3;
  RetentionStage retention;
  retention.path = {400.0, 1300.0, 0.0, 1300.0};
  c.stages = {compact, retention};
  return c;
}

struct Threads {
  explicit Threads(int n) { set_threads(n); }
  ~Threads() { set_threads(0); }
};

}  // namespace

TEST(Run, FromAGradingToARetentionCurve) {
  const Case c = small_case();
  State state;
  int packed = 0, rows = 0, events = 0;
  double compacted = 0.0;
  Observer observer;
  observer.packed = [&](const State& s) {
    ++packed;
    EXPECT_GT(s.network.pores(), 50);
  };
  observer.equilibrium = [&](const State& s, const RetentionRow& row) {
    ++rows;
    EXPECT_EQ(row.step, rows - 1);
    for (const double saturation : s.saturation) {
      EXPECT_GE(saturation, 0.0);
      EXPECT_LE(saturation, 1.0);
    }
  };
  observer.event = [&](const State&, const InvasionEvent&) { ++events; };
  observer.progress = [&](const Progress& p) {
    if (p.stage == "compact") compacted = p.stress;
    return true;
  };
  const RunResults results = run(c, state, observer);

  EXPECT_EQ(packed, 1);
  EXPECT_EQ(rows, 10 + 13 + 13);  // 400 to 1300, down to 0, up again, in steps of 100
  EXPECT_EQ(static_cast<std::size_t>(rows), state.retention.size());
  EXPECT_GT(events, 100);
  EXPECT_NEAR(compacted, 10e3, 2e3);
  EXPECT_NEAR(results.scalars.at("stress_mean_Pa"), 10e3, 100.0);
  EXPECT_LT(results.scalars.at("grading_error"), 0.05);  // 200 grains have few large ones
  EXPECT_EQ(results.scalars.at("grains"), 200);
  EXPECT_LT(std::abs(results.ledger.wetting_error()), 1e-12);
  EXPECT_LT(std::abs(results.ledger.nonwetting_error()), 1e-12);
  EXPECT_GT(results.ledger.wetting_out, 0.5 * results.ledger.void_volume);
  EXPECT_EQ(state.retention.back().branch, "drainage-2");
  EXPECT_TRUE(std::isfinite(results.scalars.at("pc_star_half_drainage-1")));

  double pores = 0.0, solid = 0.0;
  for (const double v : state.network.pore_volume) pores += v;
  for (const double r : state.particles.radius) solid += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  EXPECT_NEAR((pores + solid) / state.domain.volume(), 1.0, 1e-12);
}

TEST(Run, DoesNotDependOnThreads) {
  const Case c = small_case();
  State one, two;
  {
    const Threads guard(1);
    run(c, one, {});
  }
  {
    const Threads guard(2);
    run(c, two, {});
  }
  EXPECT_EQ(one.particles.position, two.particles.position);
  EXPECT_EQ(one.network.pore_volume, two.network.pore_volume);
  EXPECT_EQ(one.saturation, two.saturation);
}

TEST(Run, StopsWhenTheObserverAsks) {
  const Case c = small_case();
  State state;
  Observer observer;
  observer.progress = [](const Progress& p) { return p.stage != "retention" || p.step < 5; };
  const RunResults results = run(c, state, observer);
  EXPECT_TRUE(results.interrupted);
  EXPECT_EQ(state.retention.size(), 5u);

  State early;
  observer.progress = [](const Progress&) { return false; };
  EXPECT_TRUE(run(c, early, observer).interrupted);
  EXPECT_TRUE(early.retention.empty());
}

TEST(Run, OnGivenGrains) {
  Case c = small_case();
  c.stages.erase(c.stages.begin());
  State state;
  EXPECT_THROW(run(c, state, {}), InputError);  // nothing to invade

  const Spheres s = random_spheres(100, 2.0, {5e-3, 5e-3, 5e-3}, {true, true, false}, 4, 0.3);
  state.particles = make_particles(s.centre, s.radius, c.materials[0]);
  state.domain = s.domain;
  const RunResults results = run(c, state, {});
  EXPECT_EQ(results.scalars.at("grains"), 100);
  EXPECT_NEAR(results.scalars.at("porosity_box"), 0.7, 1e-9);

  State twice = state;
  Case compact = small_case();
  EXPECT_THROW(run(compact, twice, {}), InputError);  // grains from a file and from a grading
}

TEST(Run, PackingAlone) {
  Case c = small_case();
  c.stages.pop_back();
  State state;
  int packed = 0;
  Observer observer;
  observer.packed = [&](const State&) { ++packed; };
  const RunResults results = run(c, state, observer);
  EXPECT_EQ(packed, 1);
  EXPECT_EQ(state.network.pores(), 0);
  EXPECT_LT(results.scalars.at("unbalanced_force"), 5e-3);
}
