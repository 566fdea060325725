// Liquid bridges that come and go with the water in the pores around them.
#include "puadem/coupling/bridge_pores.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "puadem/coupling/unsaturated_step.hpp"
#include "puadem/dem/bridge_measures.hpp"
#include "puadem/dem/motion.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;

namespace {

constexpr double radius = 0.2e-3;  // [m], of the largest grain

/// A bed that begins dry, with its bridges.
struct DryBed {
  std::vector<Material> materials{Material{.name = "glass", .density = 2500.0, .youngs_modulus = 1e8, .friction_angle = 0.4}};
  Particles particles;
  GrainSystem grains;
  PoreNetwork network;
  UnsaturatedOptions options;
  UnsaturatedCache cache;
  UnsaturatedState state;
  PendularOptions pendular{.model = bridge_model(0.0728, 0.0, BridgeControl::suction),
                           .formation = BridgeFormation::at_any_distance};
  double water_start = 0.0, bridge_water = 0.0;

  explicit DryBed(double capillary_pressure) {
    const Spheres s = scaled_to(radius, random_spheres(160, 1.5, {1, 1, 1.2}, {true, true, false}, 9, 0.33));
    particles = make_particles(s.centre, s.radius, materials.front());
    grains = make_grain_system(particles, s.domain, materials, {}, {});
    grains.time_step = 1e-7;
    evaluate_forces(grains);
    options.flow.gas = GasKind::connected;
    options.flow.touching_first = true;
    network = build_pore_network(particles.position, particles.radius, grains.domain, options.network);
    state = start_unsaturated(options, network, particles, grains, cache);
    state.flow = start_dry(network, *cache.model, capillary_pressure);
    water_start = in_pores();
    rest_at(capillary_pressure);
  }

  double in_pores() const {
    double sum = 0.0;
    for (int p = 0; p < network.pores(); ++p)
      if (cache.model->is_counted(p)) sum += state.flow.wetting_volume[to_size(p)];
    return sum;
  }
  void rest_at(double capillary_pressure) {
    state.capillary_pressure = capillary_pressure;
    rest_fluids(options, network, particles, grains, state, cache);
    bridge_water = follow_pores(pendular, capillary_pressure, network, *cache.model, state.flow, grains);
  }
  /// What was there and came in, less what left and is there now, over the void.
  double error() const {
    const FluidLedger& l = state.flow.ledger;
    return (water_start + l.wetting_in.value() - l.wetting_out.value() - in_pores() - bridge_water) / cache.model->void_volume;
  }
  int bridges() const { return grains.bridges->bridges.size(); }
};

TEST(BridgePores, EveryEdgeKnowsThePoresAroundIt) {
  const DryBed bed(4e3);
  const EdgePores edges = edge_pores(bed.network, bed.grains);
  ASSERT_TRUE(std::ranges::is_sorted(edges.ends));
  std::map<std::array<int, 2>, std::set<int>> slow;
  for (int c = 0; c < bed.network.triangulation.cells(); ++c)
    for (const Vertex& a : bed.network.triangulation.vertices[to_size(c)])
      for (const Vertex& b : bed.network.triangulation.vertices[to_size(c)])
        if (!a.is_wall() && !b.is_wall() && a.index < b.index)
          slow[{a.index, b.index}].insert(bed.network.tetrahedron_pore[to_size(c)]);
  int between_grains = 0;
  for (int row = 0; row < edges.pores.rows(); ++row) {
    double share = 0.0;
    for (int e = edges.pores.start[to_size(row)]; e < edges.pores.start[to_size(row) + 1]; ++e) share += edges.share[to_size(e)];
    EXPECT_NEAR(share, 1.0, 1e-14);
    if (edges.ends[to_size(row)][1] >= bed.grains.owned) continue;
    ++between_grains;
    const auto pores = edges.pores[row];
    EXPECT_EQ(std::set<int>(pores.begin(), pores.end()), slow.at(edges.ends[to_size(row)]));
  }
  EXPECT_EQ(between_grains, size_of(slow));
}

TEST(BridgePores, StandBetweenDryPoresAlone) {
  DryBed bed(4e3);
  EXPECT_GT(bed.bridges(), 50);
  for (const double pc : {4e3, 1500.0, 700.0}) {
    bed.rest_at(pc);
    const std::vector<char> dry = dry_pores(bed.network, *bed.cache.model, bed.state.flow, bed.pendular.coalescence);
    const EdgePores edges = edge_pores(bed.network, bed.grains);
    for (const auto& ends : bed.grains.bridges->bridges.pairs.ends) {
      const auto row = static_cast<int>(std::ranges::lower_bound(edges.ends, ends) - edges.ends.begin());
      for (const int p : edges.pores[row]) EXPECT_TRUE(dry[to_size(p)]);
    }
  }
}

TEST(BridgePores, OnlyWetPoresPushOtherwiseThanTheGas) {
  DryBed bed(4e3);
  int wet = 0, of_water = 0;
  for (const double pc : {4e3, 400.0}) {
    bed.rest_at(pc);
    const std::vector<char> dry = dry_pores(bed.network, *bed.cache.model, bed.state.flow, bed.pendular.coalescence);
    const std::vector<double> pressure =
        pendular_pressures(bed.network, *bed.cache.model, bed.state.flow, bed.pendular.coalescence);
    const std::vector<double> corners = effective_pressures(bed.network, *bed.cache.model, bed.state.flow);
    for (int p = 0; p < bed.network.pores(); ++p) {
      EXPECT_EQ(pressure[to_size(p)], dry[to_size(p)] ? 0.0 : corners[to_size(p)]);
      wet += dry[to_size(p)] ? 0 : 1;
      // At 4 kPa gas would have entered the pores of the water's reservoir too.
      if (bed.cache.model->is_counted(p) || bed.state.flow.nonwetting.holds[to_size(p)]) continue;
      ++of_water;
      EXPECT_TRUE(pc < 4e3 || dry[to_size(p)]);
    }
  }
  EXPECT_GT(wet, 10);
  EXPECT_GT(of_water, 10);
}

TEST(BridgePores, MayBeTakenInWhereTheGasLeavesTheWalls) {
  DryBed bed(4e3);
  bed.rest_at(700.0);
  const TwoPhaseModel& model = *bed.cache.model;
  const std::vector<char> dry = dry_pores(bed.network, model, bed.state.flow, std::numeric_limits<double>::infinity());
  int with_gas = 0;
  for (int p = 0; p < bed.network.pores(); ++p) {
    if (!model.is_counted(p)) continue;
    const bool holds = bed.state.flow.nonwetting.holds[to_size(p)];
    // A bubble touches the walls while the capillary pressure is above the threshold of its pore.
    const bool is_known = !holds || 700.0 > 1.001 * model.thresholds.unit[to_size(p)].threshold;
    EXPECT_TRUE(!is_known || dry[to_size(p)] == static_cast<char>(holds));
    with_gas += holds ? 1 : 0;
  }
  EXPECT_GT(with_gas, 10);
  EXPECT_LT(with_gas, bed.network.pores() - 10);
}

TEST(BridgePores, WaterIsKeptThroughWettingAndDrying) {
  DryBed bed(4e3);
  const int dry = bed.bridges();
  EXPECT_GT(bed.bridge_water, 0.0);
  EXPECT_LT(std::abs(bed.error()), 1e-12);
  for (const double pc : {3e3, 2e3, 1.2e3, 800.0, 400.0, 0.0}) {
    bed.rest_at(pc);
    EXPECT_LT(std::abs(bed.error()), 1e-12) << pc;
  }
  EXPECT_EQ(bed.bridges(), 0);
  for (const double pc : {1e3, 2e3, 3e3, 4e3}) {
    bed.rest_at(pc);
    EXPECT_LT(std::abs(bed.error()), 1e-12) << pc;
  }
  EXPECT_GT(bed.bridges(), dry / 2);
}

TEST(BridgePores, MoreOfThemGoTheLessWaterAPoreNeedsToTakeThemIn) {
  const auto left = [](double coalescence) {
    DryBed bed(4e3);
    bed.pendular.coalescence = coalescence;
    bed.rest_at(900.0);
    return bed.bridges();
  };
  const int few = left(0.02), many = left(0.5);
  EXPECT_LT(few, many);
}

}  // namespace
