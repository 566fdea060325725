#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "flow/sample_networks.hpp"
#include "puadem/base/error.hpp"
#include "puadem/flow/capillary_laws/regular_polyhedron.hpp"
#include "puadem/flow/flow_numbers.hpp"
#include "puadem/flow/fluid_topology.hpp"
#include "puadem/flow/interfacial_area.hpp"
#include "puadem/flow/invasion_pattern.hpp"

namespace puadem {
namespace {

using namespace testing;
using std::numbers::pi;

/// Pores numbered 0 .. n - 1 and throats between the pairs.
PoreNetwork graph(int pores, const std::vector<std::array<int, 2>>& throats) {
  PoreNetwork network;
  for (int i = 0; i < pores; ++i) add_pore(network, 1.0, 6);
  for (const auto& [i, j] : throats) add_throat(network, i, j, 1.0, 2.0);
  network.pore_throats = throats_of_pores(network.throat_pores, pores);
  network.throat_conductance.assign(throats.size(), 1.0);
  return network;
}

std::vector<std::uint8_t> all(int n) { return std::vector<std::uint8_t>(to_size(n), 1); }

FluidTopology topology(const PoreNetwork& network) {
  return fluid_topology(network, all(network.pores()), all(network.throats()));
}

TEST(FluidTopology, TreesHaveNoLoopsAndRingsOne) {
  const FluidTopology tree = topology(graph(5, {{0, 1}, {0, 2}, {2, 3}, {2, 4}}));
  EXPECT_EQ(tree.euler(), 1);
  EXPECT_EQ(tree.loops(), 0);
  const FluidTopology ring = topology(graph(4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}}));
  EXPECT_EQ(ring.euler(), 0);
  EXPECT_EQ(ring.loops(), 1);
  const FluidTopology two = topology(graph(6, {{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}}));
  EXPECT_EQ(two.clusters, 2);
  EXPECT_EQ(two.euler(), 0);
}

TEST(FluidTopology, ParallelThroatsAndThroatsToAnImageAreLoops) {
  EXPECT_EQ(topology(graph(2, {{0, 1}, {0, 1}, {0, 1}})).loops(), 2);
  EXPECT_EQ(topology(graph(1, {{0, 0}})).loops(), 1);
}

TEST(FluidTopology, OfAGrid) {  // m x n nodes: V - E = mn - m(n-1) - n(m-1)
  constexpr int m = 5, n = 7;
  std::vector<std::array<int, 2>> throats;
  for (int y = 0; y < m; ++y)
    for (int x = 0; x < n; ++x) {
      if (x + 1 < n) throats.push_back({y * n + x, y * n + x + 1});
      if (y + 1 < m) throats.push_back({y * n + x, (y + 1) * n + x});
    }
  const FluidTopology grid = topology(graph(m * n, throats));
  EXPECT_EQ(grid.euler(), 1 - (m - 1) * (n - 1));
  EXPECT_EQ(grid.loops(), (m - 1) * (n - 1));
}

TEST(FluidTopology, OnlyThroatsThatPassBetweenPoresThatHoldCount) {
  const PoreNetwork network = graph(4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}});
  const std::vector<std::uint8_t> holds{1, 1, 0, 1}, passes{1, 1, 1, 0};
  const FluidTopology found = fluid_topology(network, holds, passes);
  EXPECT_EQ(found.pores, 3);
  EXPECT_EQ(found.throats, 1);
  EXPECT_EQ(found.clusters, 2);
}

TEST(FluidClusters, ComeLargestFirst) {
  const PoreNetwork network = graph(6, {{0, 1}, {2, 3}, {3, 4}});
  const std::vector<std::uint8_t> holds{1, 1, 1, 1, 1, 0};
  const std::vector<double> volume{1.0, 1.0, 1.0, 2.0, 3.0, 99.0};
  const auto clusters = fluid_cluster_sizes(network, holds, all(3), volume);
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_EQ(clusters[0].first, 2);
  EXPECT_EQ(clusters[0].pores, 3);
  EXPECT_DOUBLE_EQ(clusters[0].volume, 6.0);
  EXPECT_EQ(clusters[1].pores, 2);
  EXPECT_THAT(fluid_cluster_numbers(network, holds, all(3), volume), ::testing::ElementsAre(1, 1, 0, 0, 0, -1));
}

TEST(InterfacialArea, OfABubbleThatTouchesNothing) {
  const CapillaryUnit unit{1000.0, 6};
  const double volume = 2e-12, radius = 0.3 * std::cbrt(volume);
  const double saturation = 1.0 - 4.0 / 3.0 * pi * 0.3 * 0.3 * 0.3;
  EXPECT_NEAR(interfacial_area(unit, volume, saturation, ExponentialRetention{}), 4.0 * pi * radius * radius,
              1e-12 * radius * radius);
}

// In a cube of side a the edge menisci at high suction are twelve quarter cylinders of radius gamma / p_c and length a.
TEST(InterfacialArea, OfEdgeMenisciInACube) {
  const double side = 1e-4, tension = 0.07, radius = 0.5 * side;
  const CapillaryUnit unit{2.0 * tension / radius, 6};
  const double pressure = 500.0 * unit.threshold, edge = tension / pressure;
  const double saturation = PolyhedronRetention{}.saturation(unit, pressure);
  EXPECT_NEAR(interfacial_area(unit, side * side * side, saturation, PolyhedronRetention{}) / (12.0 * side * 0.5 * pi * edge),
              1.0, 2e-3);
}

TEST(InterfacialArea, IsContinuousWhereTheBubbleTouchesTheFaces) {
  for (const int faces : {4, 6, 8, 12, 20}) {
    const double saturation = regular_polyhedron(faces).touching_saturation();
    const CapillaryUnit unit{1.0, faces};
    const double below = interfacial_area(unit, 1.0, saturation * (1.0 - 1e-9), PolyhedronRetention{});
    const double above = interfacial_area(unit, 1.0, saturation * (1.0 + 1e-9), PolyhedronRetention{});
    EXPECT_NEAR(below / above, 1.0, 1e-6) << faces;
  }
}

TEST(InterfacialArea, IsNoneWithoutTwoFluids) {
  EXPECT_EQ(interfacial_area({1.0, 6}, 1.0, 1.0, ExponentialRetention{}), 0.0);
  EXPECT_EQ(interfacial_area({1.0, 6}, 1.0, 0.0, ExponentialRetention{}), 0.0);
}

TEST(FlowNumbers, FollowTheirDefinitions) {
  const Fluids fluids;
  EXPECT_DOUBLE_EQ(capillary_number(fluids, 0.0728), 1e-3);
  EXPECT_DOUBLE_EQ(viscosity_ratio(fluids), 0.018);
  EXPECT_NEAR(bond_number(fluids, 9.81, 1e-3), 996.8 * 9.81e-6 / 0.0728, 1e-12);
}

TEST(FlowNumbers, ConductanceOfThroatsInSeriesAndBeside) {
  PoreNetwork network = graph(5, {{0, 1}, {1, 2}, {2, 3}, {0, 3}, {1, 4}});
  network.throat_conductance = {1.0, 2.0, 4.0, 3.0, 7.0};  // the last is a dead end
  EXPECT_NEAR(conductance_between(network, std::vector{0}, std::vector{3}), 3.0 + 1.0 / (1.0 + 0.5 + 0.25), 1e-12);
}

TEST(FlowNumbers, ConductanceWithoutAWayIsNone) {
  PoreNetwork network = graph(4, {{0, 1}, {1, 2}, {2, 3}});
  network.throat_conductance[1] = 0.0;
  EXPECT_EQ(conductance_between(network, std::vector{0}, std::vector{3}), 0.0);
  EXPECT_THROW(conductance_between(network, std::vector{0}, std::vector{0}), InputError);
  EXPECT_THROW(conductance_between(network, std::vector<int>{}, std::vector{0}), InputError);
}

TEST(FlowNumbers, BreakthroughTakesTheEasiestWay) {
  // Upper way: throats 5 and 3; lower way: throats 2 and 4, but a body of 6 between them.
  const PoreNetwork network = graph(4, {{0, 1}, {1, 3}, {0, 2}, {2, 3}});
  const std::vector<double> entry{5.0, 3.0, 2.0, 4.0};
  const std::vector<double> easy{9.0, 1.0, 1.0, 9.0}, tight{9.0, 1.0, 6.0, 9.0};
  EXPECT_EQ(breakthrough_pressure(network, entry, easy, std::vector{0}, std::vector{3}), 4.0);
  EXPECT_EQ(breakthrough_pressure(network, entry, tight, std::vector{0}, std::vector{3}), 5.0);
  const double closed = std::numeric_limits<double>::infinity();
  const std::vector<double> shut{5.0, closed, 2.0, closed};
  EXPECT_EQ(breakthrough_pressure(network, shut, easy, std::vector{0}, std::vector{3}), closed);
}

template <class Inside>
PatternImage image(int columns, int rows, const Inside& inside) {
  PatternImage out{columns, rows, 1e-3, {}};
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) out.invaded.push_back(inside(x, y) ? 1 : 0);
  return out;
}

PatternImage disc(double radius, int pixels) {
  return image(pixels, pixels, [=](int x, int y) { return std::hypot(x + 0.5 - 0.5 * pixels, y + 0.5 - 0.5 * pixels) < radius; });
}

TEST(BoxDimension, OfALineAndOfAPlane) {
  EXPECT_NEAR(count_boxes(image(256, 256, [](int, int y) { return y == 100; })).dimension, 1.0, 1e-12);
  EXPECT_NEAR(count_boxes(image(256, 256, [](int, int) { return true; })).dimension, 2.0, 1e-12);
}

TEST(BoxDimension, OfADisc) { EXPECT_NEAR(count_boxes(disc(230.0, 512)).dimension, 2.0, 0.1); }

// Pascal's triangle modulo 2 is Sierpinski's triangle: 3^k odd numbers in 2^k rows, dimension ln 3 / ln 2.
TEST(BoxDimension, OfSierpinskisTriangle) {
  const BoxCount count = count_boxes(image(256, 256, [](int x, int y) { return (x & y) == 0; }));
  EXPECT_NEAR(count.dimension, std::log(3.0) / std::log(2.0), 0.01);
  ASSERT_EQ(count.boxes.size(), 7u);  // 1 to 64 pixels
  EXPECT_EQ(count.boxes[0], std::pow(3.0, 8));
  EXPECT_DOUBLE_EQ(count.size[3], 8e-3);
}

TEST(BoxDimension, OfNothing) {
  EXPECT_EQ(count_boxes(image(32, 32, [](int, int) { return false; })).dimension, 0.0);
}

TEST(FingerWidth, OfStripsAndDiscs) {
  // Two strips of 12 pixels across the whole picture, upright and oblique: Crofton in four directions is good to 6 %.
  EXPECT_NEAR(finger_width(image(300, 300, [](int x, int) { return x % 100 < 12 && x > 50; })), 12e-3, 0.06 * 12e-3);
  EXPECT_NEAR(finger_width(image(300, 300, [](int x, int y) { return std::abs(x - y) <= 14; })), 29e-3 / std::sqrt(2.0), 2e-3);
  EXPECT_NEAR(finger_width(disc(100.0, 300)), 100e-3, 0.02 * 100e-3);
  EXPECT_EQ(finger_width(image(10, 10, [](int, int) { return false; })), 0.0);
}

TEST(PatternProjection, CountsTheVoidOverAPixel) {
  PoreNetwork network;
  Domain domain;
  domain.upper = {4.0, 2.0, 1.0};
  for (const double z : {0.2, 0.5, 0.8}) add_pore(network, 1.0, 6, 0, {0.5, 1.5, z});  // one column of three
  add_pore(network, 1.0, 6, 0, {3.5, 0.5, 0.5});
  const std::vector<std::uint8_t> invaded{1, 0, 0, 1};
  const PatternImage any = project_pattern(network, domain, 2, invaded, 1.0, 0.0);
  EXPECT_EQ(any.columns, 4);
  EXPECT_EQ(any.rows, 2);
  EXPECT_TRUE(any.at(0, 1));
  EXPECT_TRUE(any.at(3, 0));
  EXPECT_EQ(std::ranges::count(any.invaded, 1), 2);
  const PatternImage most = project_pattern(network, domain, 2, invaded, 1.0, 0.5);
  EXPECT_FALSE(most.at(0, 1));
  EXPECT_TRUE(most.at(3, 0));
  EXPECT_THROW(project_pattern(network, domain, 2, invaded, 0.0, 0.5), InputError);
  EXPECT_NEAR(pore_spacing(network, domain), std::cbrt(2.0), 1e-15);
}

}  // namespace
}  // namespace puadem
