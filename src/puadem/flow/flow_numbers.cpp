#include "puadem/flow/flow_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "puadem/base/disjoint_sets.hpp"
#include "puadem/base/error.hpp"
#include "puadem/flow/flow_graph.hpp"
#include "puadem/flow/pressure_system.hpp"

namespace puadem {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
enum Group { inner = 0, at_start = 1, at_end = 2 };

std::vector<int> groups_of(const PoreNetwork& network, std::span<const int> from, std::span<const int> to) {
  require(!from.empty() && !to.empty(), "a way through the network needs pores at both its ends");
  std::vector<int> group(to_size(network.pores()), inner);
  for (const int i : from) group[to_size(i)] = at_start;
  for (const int i : to) {
    require(group[to_size(i)] != at_start, "pore {} lies at both ends of the way through the network", i);
    group[to_size(i)] = at_end;
  }
  return group;
}

/// Nodes from which the fluid comes to one of the two groups: the others have no pressure.
std::vector<bool> reached_from(const FlowGraph& graph, std::span<const int> node_group) {
  DisjointSets sets(graph.nodes() + 1);
  for (int n = 0; n < graph.nodes(); ++n)
    if (node_group[to_size(n)] != inner) sets.join(n, graph.nodes());
  for (const auto& [a, b] : graph.link) sets.join(a, b);
  std::vector<bool> reached(to_size(graph.nodes()));
  for (int n = 0; n < graph.nodes(); ++n) reached[to_size(n)] = sets.find(n) == sets.find(graph.nodes());
  return reached;
}

}  // namespace

double capillary_number(const Fluids& fluids, double velocity) {
  return fluids.wetting.viscosity * velocity / fluids.surface_tension;
}

double viscosity_ratio(const Fluids& fluids) { return fluids.nonwetting.viscosity / fluids.wetting.viscosity; }

double bond_number(const Fluids& fluids, double gravity, double radius) {
  return (fluids.wetting.density - fluids.nonwetting.density) * gravity * radius * radius / fluids.surface_tension;
}

double conductance_between(const PoreNetwork& network, std::span<const int> from, std::span<const int> to) {
  const std::vector<int> group = groups_of(network, from, to);
  const FlowGraph graph = make_flow_graph(network, network.throat_conductance, 0);
  std::vector<int> node_group(to_size(graph.nodes()), inner), unknown(to_size(graph.nodes()), -1);
  for (int i = 0; i < network.pores(); ++i) {
    int& at = node_group[to_size(graph.pore_node[to_size(i)])];
    if (group[to_size(i)] == inner) continue;
    if (at != inner && at != group[to_size(i)]) return infinity;
    at = group[to_size(i)];
  }
  const std::vector<bool> reached = reached_from(graph, node_group);
  int unknowns = 0;
  for (int n = 0; n < graph.nodes(); ++n)
    if (node_group[to_size(n)] == inner && reached[to_size(n)]) unknown[to_size(n)] = unknowns++;

  std::vector<std::array<int, 2>> links;
  std::vector<double> conductance, diagonal(to_size(unknowns)), source(to_size(unknowns)), pressure(to_size(unknowns), 0.5);
  const auto fixed = [&](int n) { return node_group[to_size(n)] == at_start ? 1.0 : 0.0; };
  for (int k = 0; k < graph.links(); ++k) {
    const auto [a, b] = graph.link[to_size(k)];
    const double g = network.throat_conductance[to_size(graph.link_throat[to_size(k)])];
    const int ua = unknown[to_size(a)], ub = unknown[to_size(b)];
    if (a == b || (ua < 0 && ub < 0)) continue;
    if (ua >= 0 && ub >= 0) {
      links.push_back({ua, ub});
      conductance.push_back(g);
    } else {
      const int u = std::max(ua, ub), known = ua >= 0 ? b : a;
      diagonal[to_size(u)] += g;
      source[to_size(u)] += g * fixed(known);
    }
  }
  if (unknowns > 0) {
    PressureSystem system(unknowns, links, {});
    system.set(conductance, diagonal);
    system.solve(source, pressure);
  }
  const auto at = [&](int n) { return unknown[to_size(n)] >= 0 ? pressure[to_size(unknown[to_size(n)])] : fixed(n); };
  double flow = 0.0;
  for (int k = 0; k < graph.links(); ++k) {
    const auto [a, b] = graph.link[to_size(k)];
    const double q = network.throat_conductance[to_size(graph.link_throat[to_size(k)])] * (at(a) - at(b));
    if (node_group[to_size(a)] == at_start) flow += q;
    if (node_group[to_size(b)] == at_start) flow -= q;
  }
  return flow;
}

double breakthrough_pressure(const PoreNetwork& network, std::span<const double> entry_pressure,
                             std::span<const double> body_pressure, std::span<const int> from, std::span<const int> to) {
  const std::vector<int> group = groups_of(network, from, to);
  std::vector<double> threshold(to_size(network.throats()));
  const auto body = [&](int i) { return group[to_size(i)] == inner ? body_pressure[to_size(i)] : 0.0; };
  for (int t = 0; t < network.throats(); ++t) {
    const auto [i, j] = network.throat_pores[to_size(t)];
    threshold[to_size(t)] = std::max({entry_pressure[to_size(t)], body(i), body(j)});
  }
  std::vector<int> order(threshold.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int t) { return std::pair(threshold[to_size(t)], t); });
  const int start = network.pores(), end = network.pores() + 1;
  DisjointSets sets(network.pores() + 2);
  for (const int i : from) sets.join(i, start);
  for (const int i : to) sets.join(i, end);
  for (const int t : order) {
    if (!(threshold[to_size(t)] < infinity)) break;
    sets.join(network.throat_pores[to_size(t)][0], network.throat_pores[to_size(t)][1]);
    if (sets.find(start) == sets.find(end)) return threshold[to_size(t)];
  }
  return infinity;
}

}  // namespace puadem
