#include "puadem/flow/single_phase_flow.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "flow/sample_networks.hpp"
#include "puadem/base/error.hpp"
#include "puadem/network/pore_units.hpp"
#include "support/packings.hpp"

using namespace puadem;
using namespace puadem::testing;
using Kind = FaceCondition::Kind;

namespace {

constexpr Domain walled{{0, 0, 0}, {1, 1, 1}, {false, false, false}};
constexpr int bottom = 4, top = 5;

void connect(PoreNetwork& network, int i, int j, double conductance, std::array<std::int8_t, 3> shift = {}) {
  network.throat_pores.push_back({i, j});
  network.throat_shift.push_back(shift);
  network.throat_conductance.push_back(conductance);
}

PoreNetwork finished(PoreNetwork network) {
  network.pore_throats = throats_of_pores(network.throat_pores, network.pores());
  return network;
}

/// Pores in a row from the bottom face to the top face.
PoreNetwork column(const std::vector<double>& conductance) {
  PoreNetwork network;
  const int pores = size_of(conductance) + 1;
  for (int i = 0; i < pores; ++i) add_pore(network, 1.0, 6, i == 0 ? at_bottom : i + 1 == pores ? at_top : std::uint8_t{0});
  for (int k = 0; k + 1 < pores; ++k) connect(network, k, k + 1, conductance[to_size(k)]);
  return finished(std::move(network));
}

SinglePhaseFlow solve(const PoreNetwork& network, const SinglePhaseProblem& problem, const Domain& domain = walled) {
  SinglePhaseMemory memory;
  return solve_single_phase(network, domain, problem, memory);
}

SinglePhaseProblem between(double at_the_bottom, double at_the_top) {
  SinglePhaseProblem problem;
  problem.viscosity = 1.0;
  problem.faces[bottom] = {Kind::pressure, at_the_bottom};
  problem.faces[top] = {Kind::pressure, at_the_top};
  return problem;
}

PoreNetwork packed(const Spheres& s) {
  NetworkOptions options;
  options.merge_ratio = std::numeric_limits<double>::infinity();
  return build_pore_network(s.centre, s.radius, s.domain, options);
}

template <class Error>
std::string error_of(const PoreNetwork& network, const SinglePhaseProblem& problem, const Domain& domain = walled) {
  try {
    solve(network, problem, domain);
  } catch (const Error& e) {
    return e.what();
  }
  return "no such error";
}

}  // namespace

TEST(SinglePhaseFlow, ThroatsInSeriesShareThePressureDrop) {
  const std::vector<double> g{1e-12, 4e-12, 2e-12, 8e-12};
  SinglePhaseProblem problem = between(1000.0, 0.0);
  problem.viscosity = 2e-3;
  const SinglePhaseFlow flow = solve(column(g), problem);
  double resistance = 0.0;
  for (const double k : g) resistance += 2e-3 / k;
  const double q = 1000.0 / resistance;
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(flow.throat_flow[k], q, 1e-12 * q);
    EXPECT_NEAR(flow.pressure[k] - flow.pressure[k + 1], q * 2e-3 / g[k], 1e-9);
  }
  EXPECT_NEAR(flow.face_inflow[bottom], q, 1e-12 * q);
  EXPECT_NEAR(flow.face_inflow[top], -q, 1e-12 * q);
}

TEST(SinglePhaseFlow, ThroatsWithoutResistanceMakeOnePore) {
  const double inf = std::numeric_limits<double>::infinity();
  const SinglePhaseFlow joined = solve(column({1.0, inf, 1.0}), between(2.0, 0.0));
  EXPECT_EQ(joined.joined, 1);
  EXPECT_NEAR(joined.pressure[1], 1.0, 1e-14);
  EXPECT_EQ(joined.pressure[1], joined.pressure[2]);
  EXPECT_NEAR(joined.face_inflow[bottom], 1.0, 1e-14);
}

TEST(SinglePhaseFlow, ASqueezedPoreDrainsBothWays) {
  const std::vector<double> rate{0.0, 0.0, -3.0, 0.0};  // pore 2 loses volume
  SinglePhaseProblem problem = between(0.0, 0.0);
  problem.volume_rate = rate;
  const SinglePhaseFlow flow = solve(column({1.0, 1.0, 1.0}), problem);
  EXPECT_NEAR(flow.pressure[2], 2.0, 1e-13);  // one throat up, two down
  EXPECT_NEAR(flow.face_inflow[bottom], -1.0, 1e-13);
  EXPECT_NEAR(flow.face_inflow[top], -2.0, 1e-13);
}

TEST(SinglePhaseFlow, AnInflowFindsThePressureOfItsReservoir) {
  PoreNetwork network = column({1.0, 1.0});
  const int beside = add_pore(network, 1.0, 6, at_bottom);  // a second pore at the bottom, with a throat twice as wide
  connect(network, 1, beside, 2.0);
  network = finished(std::move(network));
  SinglePhaseProblem problem = between(0.0, 5.0);
  problem.faces[bottom] = {Kind::inflow, 6.0};
  const SinglePhaseFlow flow = solve(network, problem);
  EXPECT_NEAR(flow.pressure[1], 5.0 + 6.0, 1e-12);
  EXPECT_NEAR(flow.pressure[0], 11.0 + 2.0, 1e-12);
  EXPECT_EQ(flow.pressure[0], flow.pressure[to_size(beside)]);
  EXPECT_NEAR(flow.throat_flow[2], -4.0, 1e-12);
  EXPECT_NEAR(flow.face_inflow[top], -6.0, 1e-12);
}

TEST(SinglePhaseFlow, InflowMayLeaveThroughAnInflow) {
  SinglePhaseProblem problem = between(0, 0);
  problem.faces[bottom] = {Kind::inflow, 2.0};
  problem.faces[top] = {Kind::inflow, -2.0};
  const SinglePhaseFlow flow = solve(column({1.0, 1.0, 4.0}), problem);
  EXPECT_EQ(flow.pressure[0], 0.0);  // no pressure is given: relative to the first pore
  EXPECT_NEAR(flow.pressure[3], -4.5, 1e-13);
}

TEST(SinglePhaseFlow, CompressibleFluidInAClosedBoxKeepsItsVolume) {
  // Two pores of volumes 1 and 3, implicit Euler: with c = V / (K dt), c1 (p - 8) + g (p - q) = 0 and likewise for q.
  PoreNetwork network;
  add_pore(network, 1.0, 6);
  add_pore(network, 3.0, 6);
  connect(network, 0, 1, 2.0);
  network = finished(std::move(network));
  const std::vector<double> before{8.0, 0.0};
  SinglePhaseProblem problem;
  problem.viscosity = 0.5;
  problem.compressibility = SlightCompressibility{10.0, 0.1, before};
  const SinglePhaseFlow flow = solve(network, problem);
  const double c = 1.0 / (10.0 * 0.1), g = 2.0 / 0.5;
  // Volume stays: c p + 3 c q = 8 c; the difference falls by 1 + g (1/c + 1/(3c)).
  const double difference = 8.0 / (1.0 + g * (1.0 / c + 1.0 / (3.0 * c)));
  EXPECT_NEAR(flow.pressure[0] - flow.pressure[1], difference, 1e-13);
  EXPECT_NEAR(flow.pressure[0] + 3.0 * flow.pressure[1], 8.0, 1e-13);
  EXPECT_NEAR(flow.throat_flow[0], g * difference, 1e-12);
}

TEST(SinglePhaseFlow, MeanGradientDrivesARingOfPores) {
  // Two pores and their images along x: a period of pressure is lost over both throats.
  PoreNetwork network;
  add_pore(network, 1.0, 6);
  add_pore(network, 1.0, 6);
  connect(network, 0, 1, 1.0);
  connect(network, 0, 1, 3.0, {-1, 0, 0});
  network = finished(std::move(network));
  const Domain ring{{0, 0, 0}, {2, 1, 1}, {true, true, true}};
  SinglePhaseProblem problem;
  problem.viscosity = 1.0;
  problem.pressure_gradient = {-10.0, 0.0, 0.0};
  const SinglePhaseFlow flow = solve(network, problem, ring);
  const double q = 20.0 / (1.0 + 1.0 / 3.0);
  EXPECT_NEAR(flow.throat_flow[0], q, 1e-12);
  EXPECT_NEAR(flow.throat_flow[1], -q, 1e-12);
}

TEST(SinglePhaseFlow, DarcyColumn) {
  // Pressure along the flow against the straight line, for beds of more and more grains across the same box.
  double last = 1.0;
  for (const int grains : {60, 300, 1500}) {
    const Spheres s = random_spheres(grains, 1.3, {1, 1, 2}, {true, true, false}, 17, 0.3);
    const PoreNetwork network = packed(s);
    const SinglePhaseFlow flow = solve(network, between(1.0, 0.0), s.domain);
    double squares = 0.0;
    for (int p = 0; p < network.pores(); ++p)
      squares += std::pow(flow.pressure[to_size(p)] - (1.0 - network.pore_centre[to_size(p)].z / 2.0), 2);
    const double error = std::sqrt(squares / network.pores());
    EXPECT_LT(error, 0.85 * last) << grains;
    last = error;
    EXPECT_NEAR(flow.face_inflow[bottom] + flow.face_inflow[top], 0.0, 1e-10 * flow.face_inflow[bottom]);
    EXPECT_LT(flow.imbalance, 1e-14);
  }
  EXPECT_LT(last, 0.05);
}

TEST(SinglePhaseFlow, ShortThroatCarriesWhatEntersIt) {
  // Three throats in a row beside a side branch without an end; the middle one conducts 1e10 times better. Its flow is that
  // of the others, which the pressures at its ends, equal but for the last digits, do not tell.
  PoreNetwork network = column({1.0, 1e10, 2.0, 3.0});
  add_pore(network, 1.0, 6, 0);
  connect(network, 2, 5, 1.0);
  const SinglePhaseFlow flow = solve(finished(std::move(network)), between(1.0 / 3.0, 0.0));
  const double q = 1.0 / 3.0 / (1.0 + 1e-10 + 1.0 / 2.0 + 1.0 / 3.0);
  EXPECT_NEAR(flow.throat_flow[0], q, 1e-6 * q);  // 1e10 and 1 share a diagonal entry
  for (int t = 1; t < 4; ++t) EXPECT_NEAR(flow.throat_flow[to_size(t)], flow.throat_flow[0], 1e-15 * q) << t;
  EXPECT_NEAR(flow.throat_flow[4], 0.0, 1e-15 * q);
  EXPECT_GT(flow.carried, 1e-9);
  EXPECT_LT(flow.imbalance, 1e-15);
}

TEST(SinglePhaseFlow, ExcessGoesToTheRootsAlongTheBestConductors) {
  // A ring of four nodes hung on a root by two links; node 4 stands alone and is left out.
  FlowGraph graph;
  graph.node_pore = {0, 1, 2, 3, 4, 5};
  graph.link = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {5, 1}, {3, 5}};
  graph.link_throat = {0, 1, 2, 3, 4, 5};
  const std::vector<double> conductance{5.0, 1.0, 4.0, 3.0, 2.0, 0.5};
  const FlowTree tree = make_flow_tree(graph, conductance, std::vector<char>{0, 0, 0, 0, 0, 1});
  EXPECT_THAT(tree.link, ::testing::UnorderedElementsAre(0, 2, 3, 4));
  std::vector<double> excess{1.0, 2.0, 4.0, 8.0, 16.0, 0.0}, flow(6, 0.0);
  carry_excess(graph, tree, excess, flow);
  EXPECT_THAT(excess, ::testing::ElementsAre(0.0, 0.0, 0.0, 0.0, 16.0, 15.0));
  EXPECT_THAT(flow, ::testing::ElementsAre(-13.0, 0.0, -4.0, -12.0, 15.0, 0.0));
}

TEST(SinglePhaseFlow, EveryPoreBalances) {
  const Spheres s = random_spheres(200, 2.5, {1, 1, 1}, {false, true, false}, 2, 0.3);
  const PoreNetwork network = packed(s);
  SinglePhaseMemory memory;
  const SinglePhaseFlow flow = solve_single_phase(network, s.domain, between(2e5, 1e5), memory);
  std::vector<double> net(to_size(memory.graph.nodes()), 0.0);
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    net[to_size(memory.graph.pore_node[to_size(i)])] += flow.throat_flow[to_size(t)];
    net[to_size(memory.graph.pore_node[to_size(j)])] -= flow.throat_flow[to_size(t)];
  }
  for (int p = 0; p < network.pores(); ++p) {
    if (network.pore_walls[to_size(p)] & (at_bottom | at_top)) continue;
    EXPECT_NEAR(net[to_size(memory.graph.pore_node[to_size(p)])], 0.0, 1e-13 * flow.face_inflow[bottom]);
  }
}

TEST(SinglePhaseFlow, FlowIsProportionalToTheDropAndTheFluidity) {
  const Spheres s = random_spheres(100, 2.0, {1, 1, 1}, {false, false, false}, 4, 0.3);
  const PoreNetwork network = packed(s);
  const double q = solve(network, between(1.0, 0.0), s.domain).face_inflow[bottom];
  EXPECT_NEAR(solve(network, between(1e5 + 7.0, 1e5), s.domain).face_inflow[bottom], 7.0 * q, 1e-10 * q);
  SinglePhaseProblem water = between(1.0, 0.0);
  water.viscosity = 1e-3;
  EXPECT_NEAR(solve(network, water, s.domain).face_inflow[bottom], 1e3 * q, 1e-9 * q);
}

TEST(SinglePhaseFlow, MemoryChangesNoResult) {
  const Spheres s = random_spheres(150, 2.0, {1, 1, 1}, {false, false, false}, 6, 0.3);
  PoreNetwork network = packed(s);
  SinglePhaseMemory memory;
  const auto expect_same = [&](const SinglePhaseProblem& problem) {
    const SinglePhaseFlow kept = solve_single_phase(network, s.domain, problem, memory),
                          fresh = solve(network, problem, s.domain);
    for (std::size_t p = 0; p < fresh.pressure.size(); ++p) EXPECT_NEAR(kept.pressure[p], fresh.pressure[p], 1e-11);
  };
  expect_same(between(1.0, 0.0));
  expect_same(between(0.0, 2.0));  // a new right-hand side
  for (double& g : network.throat_conductance) g *= 1.5;
  network.throat_conductance[3] *= 7.0;
  expect_same(between(0.0, 2.0));  // new numbers
  network.throat_conductance[5] = 0.0;
  expect_same(between(1.0, 0.0));  // a throat closes
  SinglePhaseProblem sideways = between(0.0, 0.0);
  sideways.faces = {};
  sideways.faces[0] = {Kind::pressure, 1.0};
  sideways.faces[1] = {Kind::inflow, -1e-6};
  expect_same(sideways);  // other faces
}

TEST(SinglePhaseFlow, NamesAClusterThatIsCutOff) {
  PoreNetwork network = column({1.0, 1.0});
  const int a = add_pore(network, 1.0, 6, 0, {0.25, 0.5, 0.75}), b = add_pore(network, 1.0, 6);
  connect(network, a, b, 1.0);
  connect(network, 1, a, 0.0);  // closed
  network = finished(std::move(network));
  const std::string message = error_of<NumericalError>(network, between(1.0, 0.0));
  EXPECT_THAT(message, ::testing::HasSubstr("1 part of the network is cut off"));
  EXPECT_THAT(message, ::testing::HasSubstr("cluster of 2 pores around pore 3 at (0.25, 0.5, 0.75) m"));
}

TEST(SinglePhaseFlow, RefusesImpossibleConditions) {
  const PoreNetwork network = column({1.0, 1.0});
  const Domain sideways{{0, 0, 0}, {1, 1, 1}, {true, false, false}};
  SinglePhaseProblem problem = between(1.0, 0.0);
  problem.faces[0] = {Kind::pressure, 1.0};
  EXPECT_THAT(error_of<InputError>(network, problem), ::testing::HasSubstr("no pore touches the left face"));
  EXPECT_THAT(error_of<InputError>(network, problem, sideways), ::testing::HasSubstr("the left face is periodic"));
  problem = between(1.0, 0.0);
  problem.pressure_gradient = {0.0, 1.0, 0.0};
  EXPECT_THAT(error_of<InputError>(network, problem, sideways), ::testing::HasSubstr("along y needs that axis periodic"));
  problem = between(1.0, 0.0);
  problem.viscosity = 0.0;
  EXPECT_THAT(error_of<InputError>(network, problem), ::testing::HasSubstr("must be > 0"));
  problem = between(1.0, 0.0);
  problem.faces[top] = {};
  problem.faces[bottom] = {Kind::inflow, 1.0};
  EXPECT_THAT(error_of<InputError>(network, problem), ::testing::HasSubstr("more fluid enters than leaves"));
  PoreNetwork thin;
  add_pore(thin, 1.0, 6, at_bottom | at_top);
  thin = finished(std::move(thin));
  EXPECT_THAT(error_of<InputError>(thin, between(1.0, 0.0)), ::testing::HasSubstr("a pore has one pressure"));
}

TEST(SinglePhaseFlow, RefusesAGradientAcrossAShortCircuit) {
  PoreNetwork network;
  add_pore(network, 1.0, 6);
  connect(network, 0, 0, std::numeric_limits<double>::infinity(), {1, 0, 0});
  network = finished(std::move(network));
  const Domain ring{{0, 0, 0}, {1, 1, 1}, {true, true, true}};
  SinglePhaseProblem problem;
  problem.pressure_gradient = {1.0, 0.0, 0.0};
  EXPECT_THAT(error_of<NumericalError>(network, problem, ring), ::testing::HasSubstr("crosses the periodic box along x"));
}
